// SPDX-License-Identifier: Apache-2.0
"use strict";
// On paper: the graph as a picture, each node as a table, the findings, and the policies. Made when it is asked for.
rosward.print = (() => {
  const { model, dom, graph, entity, parts, names } = rosward;
  const { el, named } = dom;
  const box = document.getElementById("paper");

  function make() {
    const { theme } = document.documentElement.dataset;
    document.documentElement.dataset.theme = "light";
    graph.restyle();
    const picture = graph.painted("#ffffff");
    if (theme) document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
    graph.restyle();
    const shown = graph.shown();
    dom.fill(box, el("h2", {}, "Graph"), picture, findings(), el("h2", {}, "Nodes"),
      model.report.nodes.filter((one) => shown.nodes.has(one.id)).map(node), el("h2", {}, "Policies"),
      model.report.enclaves.map((one) => [el("h3", {}, named(one.path)), el("pre", {}, one.policy.map((line) => line.text).map((text) => [names.visible(text), document.createTextNode("\n")]))]));
  }

  function findings() {
    if (!model.report.findings.length) return null;
    const ordered = parts.SEVERITIES.flatMap((severity) => model.report.findings.filter((one) => one.severity === severity));
    return [el("h2", {}, "Findings"), table(["Finding", "Place", "Message"], ordered.map((one) => [`${one.severity} ${one.code}`, one.place && parts.placeText(one.place), one.message]))];
  }

  function node(one) {
    const own = one.entities.map((id) => model.entities.get(id)).filter((each) => !each.system);
    return el("section", {}, el("h3", {}, named(one.fqn)),
      el("p", {}, [one.assumed ? "assumed: nothing starts it" : null, one.package, one.executable, parts.placeText(one.place)].filter(Boolean).join(" · ")),
      own.length ? table(["Kind", "Name", "Type", "QoS", "Created at"], own.map((each) => [each.kind, each.name + (each.resolution === "exact" ? "" : ` (${each.resolution})`), each.type || "unknown", entity.qosText(each.qos), each.places.map(parts.placeText).join(", ")]))
        : el("p", {}, "It creates no publishers, subscriptions, services or actions of its own."));
  }

  function table(heads, rows) {
    return el("table", {}, el("thead", {}, el("tr", {}, heads.map((word) => el("th", {}, word)))), el("tbody", {}, rows.map((row) => el("tr", {}, row.map((cell) => el("td", {}, named(cell || "", "span")))))));
  }

  function start() {
    addEventListener("beforeprint", make);
    addEventListener("afterprint", () => box.replaceChildren());
  }

  return { start };
})();
