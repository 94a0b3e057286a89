// SPDX-License-Identifier: Apache-2.0
"use strict";
// The switches: filters beside the list, grouping and zoom above the graph. They show and change `rosward.state`, no more.
rosward.controls = (() => {
  const { model, state, route, dom, graph, names, parts, filter, elements } = rosward;
  const { el, icon } = dom;
  const refreshers = [];

  function filters() {
    const counts = model.report.summary.counts;
    const hidden = counts.topics.system + counts.services.system + counts.actions.system;
    const choice = (word, key, options) => {
      const select = el("select", { id: `filter-${key}`, onchange: (event) => state.set({ [key]: event.target.value }) },
        options.map(([value, text]) => el("option", { value }, text)));
      refreshers.push((view) => { select.value = view[key]; });
      return el("label", { class: "choice" }, el("span", {}, word), select);
    };
    const spaces = model.namespaces.map(([name, number]) => [name, name === "/" ? "all" : `${names.visible(name)} (${number})`]);
    const packages = [["", "all"], ...model.packages.map(([name, number]) => [name, `${name} (${number})`])];
    const reset = el("button", { type: "button", class: "act", onclick: () => state.reset() }, "Reset");
    refreshers.push((view) => { reset.hidden = !state.narrowed(view); });
    return [
      el("div", { class: "chips", role: "group", "aria-label": "Kinds" },
        ["topic", "service", "action"].map((kind) => chip(kind, `${kind[0].toUpperCase()}${kind.slice(1)}s`, kind))),
      el("div", { class: "selects" }, spaces.length > 1 ? choice("Namespace", "namespace", spaces) : null, packages.length > 2 ? choice("Package", "package", packages) : null),
      el("div", { class: "switches" },
        toggle("system", "System entities", hidden ? `+${hidden}` : ""),
        model.report.findings.length ? toggle("found", "Only with findings") : null,
        toggle("loose", "Loose ends")),
      focus(),
      el("p", { class: "shown" }, tally(), reset),
    ];
  }

  function chip(key, word, kind) {
    const button = el("button", { type: "button", class: `chip ${kind}`, onclick: () => state.set({ [key]: !state.get()[key] }) }, icon(kind), word);
    refreshers.push((view) => button.setAttribute("aria-pressed", String(view[key])));
    return button;
  }

  function toggle(key, word, more) {
    const box = el("input", { type: "checkbox", id: `filter-${key}`, onchange: (event) => state.set({ [key]: event.target.checked }) });
    refreshers.push((view) => { box.checked = view[key]; });
    return el("label", { class: "switch" }, box, el("span", {}, word, more ? el("span", { class: "dim" }, ` ${more}`) : null));
  }

  /** What the view is focused on, and how far it reaches. */
  function focus() {
    const line = el("div", { class: "focus-line", hidden: true });
    refreshers.push((view) => {
      const one = view.focus === null ? null : model.thing(view.focus);
      line.hidden = one === null;
      if (one === null) return;
      const depth = el("select", { "aria-label": "How far", onchange: (event) => state.set({ depth: Number(event.target.value) }) },
        [[1, "1 step"], [2, "2 steps"], [3, "3 steps"]].map(([value, text]) => el("option", { value }, text)));
      depth.value = String(view.depth);
      dom.fill(line, icon("focus"), el("span", { class: "what" }, parts.link(one)), depth, dom.button("End focus", "close", () => state.set({ focus: null })));
    });
    return line;
  }

  function tally() {
    const text = el("span", { role: "status" });
    const update = () => {
      const shown = graph.shown();
      text.textContent = `${shown.nodes.size} of ${names.plural(model.nodes.size, "node")} · ${shown.endpoints.size} of ${model.endpoints.size} topics, services and actions`;
    };
    graph.listen(update);
    update();
    return text;
  }

  function toolbar() {
    const select = (id, word, key, options) => {
      const made = el("select", { id, onchange: (event) => state.set({ [key]: event.target.value, ...(key === "group" ? { collapsed: [] } : {}) }) }, options.map(([value, text]) => el("option", { value }, text)));
      refreshers.push((view) => { made.value = view[key]; });
      return el("label", {}, el("span", {}, word), made);
    };
    const fold = dom.button("Close all frames", "collapse", () => {
      const { collapsed } = state.get();
      state.set({ collapsed: collapsed.length ? [] : graph.picture().frames.filter((one) => !one.parent).map((one) => one.key) });
    });
    refreshers.push((view) => {
      const label = view.collapsed.length ? "Open all frames" : "Close all frames";
      fold.setAttribute("aria-label", label);
      fold.title = label;
      fold.disabled = view.group === "none";
      fold.replaceChildren(icon(view.collapsed.length ? "expand" : "collapse"));
    });
    return [
      select("group", "Group by", "group", [["namespace", "namespace"], ["process", "process"], ["enclave", "enclave"], ["none", "nothing"]]),
      select("detail", "Show", "detail", [["all", "nodes and topics"], ["nodes", "nodes only"]]),
      el("span", { class: "buttons" }, fold,
        dom.button("Zoom out (-)", "minus", () => graph.zoom(1 / 1.35), { class: "tool only-wide" }), dom.button("Zoom in (+)", "plus", () => graph.zoom(1.35), { class: "tool only-wide" }), dom.button("Fit (0)", "fit", () => graph.fit()),
        dom.button("Save as picture", "picture", () => graph.painted(rosward.look.colour("page")).toBlob((blob) => dom.save(blob, "graph.png")))),
    ];
  }

  function start() {
    dom.fill(document.getElementById("filters"), filters());
    dom.fill(document.getElementById("toolbar"), toolbar());
    const refresh = (view) => refreshers.forEach((one) => one(view));
    refresh(state.get());
    state.listen(refresh);
    // what a link leads to must be seen, whatever the filters hide
    route.listen(reveal);
    reveal(route.get());
  }

  function reveal({ one }) {
    if (!one) return;
    const view = state.get();
    const drawn = (record) => {
      const shown = filter.shown(record);
      return shown.nodes.has(one.id) || shown.endpoints.has(one.id);
    };
    const { collapsed, group, detail } = view;
    const wider = { ...state.DEFAULTS, collapsed, group, detail, system: view.system || one.system === true };
    const record = drawn(view) ? view : wider;
    if (!drawn(record)) return;
    const around = collapsed.length ? elements.framesAround(one.id, filter.shown(record), record) : [];
    const open = collapsed.filter((frame) => !around.includes(frame));
    if (record !== view || open.length < collapsed.length) state.set({ ...record, collapsed: open });
  }

  return { start };
})();
