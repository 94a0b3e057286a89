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
      [some(shapes, (one) => one.kind === "group"), icon("group"), "closed frame (click to open)"],
      [some(shapes, (one) => one.assumed), sample("assumed"), "assumed: nothing starts it"],
      [some(shapes, (one) => one.unknown), sample("unknown"), "unknown interface"],
      [some(shapes, (one) => one.doubtful), sample("doubtful"), "name not completely known"],
      [some(edges, (one) => one.dashed && one.kind !== "maybe"), sample("dashed"), "conditional or unknown name"],
      [some(edges, (one) => one.kind === "maybe"), sample("maybe"), "may be the same name"],
      [some(edges, (one) => one.kind === "mixed"), sample("mixed"), "several kinds"],
      [crowds, null, `omitted: ${crowds} that connect${crowds === 1 ? "s" : ""} many nodes with many`],
      [some(shapes, (one) => one.hub), sample("hub"), "drawn next to each of its nodes"],
    ];
    dom.fill(box, marks.filter(([there]) => there).map(([, mark, word]) => el("li", {}, mark, word)));
  }

  function start() {
    graph.listen(update);
    update();
  }

  return { start };
})();
