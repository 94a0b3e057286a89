// SPDX-License-Identifier: Apache-2.0
"use strict";
// The head of the page: what was read, how many of what, and whether anything is left open. And the three views.
rosward.summary = (() => {
  const { model, route, dom, parts, names } = rosward;
  const { el, icon } = dom;
  const VIEWS = [["graph", "Graph"], ["policies", "Policies"], ["findings", "Findings"]];

  function facts() {
    const { summary } = model.report;
    const { counts } = summary;
    const open = (counts.names.pattern || 0) + (counts.names.unknown || 0);
    const kinds = [["node", counts.nodes], ["topic", counts.topics.total - counts.topics.system], ["service", counts.services.total - counts.services.system], ["action", counts.actions.total - counts.actions.system]];
    return [
      el("ul", { class: "counts" }, kinds.map(([kind, number]) => el("li", { title: kind === "node" ? null : "without those that the client library creates" },
        icon(kind), " ", el("b", {}, number.toLocaleString("en")), names.plural(number, kind).replace(/^[\d,]+/, ""))),
      el("li", {}, summary.complete
        ? el("span", { class: "complete yes", title: "No findings are errors: everything requested was analysed" }, icon("ok"), "complete")
        : el("a", { class: "complete no", href: "#findings", title: "Some findings are errors: parts of the system may be missing here" }, icon("warning"), "not complete")),
      open ? el("li", {}, el("a", { class: "complete no", href: "#findings", title: "Names that the sources do not determine completely" }, icon("warning"), `${names.plural(open, "name")} open`)) : null),
      el("p", { class: "read" }, `Read from ${names.plural(summary.files, "file")} (${names.plural(summary.lines, "line")}), ${names.plural(summary.processes, "process")}, for ROS 2 ${summary.distro}. `, el("strong", {}, "Nothing was executed.")),
    ];
  }

  function tabs() {
    const marks = parts.SEVERITIES.map((severity) => [severity, model.causes.filter((one) => one.severity === severity).length]).filter(([, number]) => number);
    return VIEWS.map(([view, word]) => el("a", { href: `#${view}`, "data-view": view }, word,
      view === "findings" ? marks.map(([severity, number]) => parts.severityMark(severity, number)) : null,
      view === "policies" ? el("span", { class: "number" }, model.enclaves.size) : null));
  }

  function update({ view }) {
    document.body.dataset.view = view;
    for (const link of document.querySelectorAll("#tabs a")) {
      if (link.dataset.view === view) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    for (const [name] of VIEWS) document.getElementById(name).hidden = name !== view;
  }

  function start() {
    dom.fill(document.getElementById("facts"), facts());
    dom.fill(document.getElementById("tabs"), tabs());
    update(route.get());
    route.listen(update);
  }

  return { start };
})();
