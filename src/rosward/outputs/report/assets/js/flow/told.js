// SPDX-License-Identifier: Apache-2.0
"use strict";
// Flows outside of the graph: the way of a finding, and what stands on paper.
rosward.told = (() => {
  const { model, route, state, dom, names, graph, flows, choice, lit, ways, parts } = rosward;
  const LARGE = 150; // nodes: drawn with their topics they are no picture
  const { el, icon, named } = dom;
  const box = document.getElementById("findings");
  const paper = el("div", { id: "paper-flows", "aria-hidden": "true" });

  /** Adds to each finding that is listed the way that it tells of. */
  function complete() {
    for (const item of box.querySelectorAll("li[id^='finding-']:not([data-way])")) {
      item.dataset.way = "";
      const finding = model.findings.get(item.id.slice("finding-".length));
      if (!finding?.way) continue;
      item.querySelector(":scope > .source")?.remove(); // the last line of the way
      const steps = flows.told(finding);
      const show = el("button", { type: "button", class: "act", onclick: () => inGraph(finding) }, icon("graph"), "Show the way in the graph");
      item.querySelector(":scope > .subjects").after(steps.length ? el("p", {}, show) : "",
        el("div", { class: "way", role: "group", "aria-label": names.plural(finding.way.length, "line") }, ways.lines(finding.way)));
    }
  }

  /** The way in the drawing; of a system that is not too large with the topics on it. */
  async function inGraph(finding) {
    choice.set({ finding: finding.id });
    route.go("#graph");
    if (state.get().detail !== "all" && model.nodes.size <= LARGE) state.set({ detail: "all" });
    await new Promise((done) => setTimeout(done));
    await graph.settled();
    queueMicrotask(lit.fit);
  }

  /** A table for each node: what each output is made of. */
  function print() {
    const { nodes } = graph.shown();
    const texts = (sources, strength) => sources.filter((one) => one[1] === strength).map(([number]) => ways.text(number)).join(", ");
    dom.fill(paper, el("h2", {}, "What each output is made of"), model.report.nodes.filter((one) => nodes.has(one.id) && flows.ofNode.get(one.id)?.outputs.length).map((one) => el("section", {},
      el("h3", {}, named(one.fqn)),
      el("table", {}, el("thead", {}, el("tr", {}, ["Output", "Data", "Decided by", "Triggered by", "Sent at"].map((word) => el("th", {}, word)))), el("tbody", {},
        flows.ofNode.get(one.id).outputs.map(({ content, place, sources }) => el("tr", {},
          [ways.text(content), texts(sources, 0), texts(sources, 1), texts(sources, 2), parts.placeText(flows.place(place))].map((cell) => el("td", {}, named(cell, "span"))))))))));
  }

  function start() {
    new MutationObserver(complete).observe(box, { childList: true, subtree: true });
    complete();
    document.getElementById("paper").after(paper);
    addEventListener("beforeprint", print);
    addEventListener("afterprint", () => paper.replaceChildren());
  }

  return { start };
})();
