// SPDX-License-Identifier: Apache-2.0
"use strict";
// What do the shapes and lines mean? One line under the drawing, with those marks only that occur in it.
rosward.legend = (() => {
  const { dom, graph } = rosward;
  const { el, icon } = dom;
  const KINDS = ["node", "topic", "service", "action"];
  const box = document.getElementById("legend");

  function update() {
    const { shapes, edges, crowds } = graph.picture();
    const some = (list, test) => list.some(test);
    const sample = (kind) => el("i", { class: `sample ${kind}` });
    const marks = [
      ...KINDS.map((kind) => [some(shapes, (one) => one.kind === kind), icon(kind), kind]),
      [some(shapes, (one) => one.kind === "group"), icon("group"), "closed frame (a click opens it)"],
      [some(shapes, (one) => one.assumed), sample("assumed"), "assumed: nothing starts it"],
      [some(shapes, (one) => one.unknown), sample("unknown"), "interface not known"],
      [some(shapes, (one) => one.doubtful), sample("doubtful"), "name not wholly known"],
      [some(edges, (one) => one.dashed && one.kind !== "maybe"), sample("dashed"), "conditional, or name not known"],
      [some(edges, (one) => one.kind === "maybe"), sample("maybe"), "may be the same"],
      [some(edges, (one) => one.kind === "mixed"), sample("mixed"), "of several kinds"],
      [crowds, null, `without ${crowds} that join${crowds === 1 ? "s" : ""} many with many`],
      [some(shapes, (one) => one.hub), sample("hub"), "drawn at each of its many nodes"],
    ];
    dom.fill(box, marks.filter(([there]) => there).map(([, mark, word]) => el("li", {}, mark, word)));
  }

  function start() {
    graph.listen(update);
    update();
  }

  return { start };
})();
