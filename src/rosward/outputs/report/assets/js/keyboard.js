// SPDX-License-Identifier: Apache-2.0
"use strict";
// The keys. All that the mouse can do goes by keys as well; `?` shows them.
rosward.keyboard = (() => {
  const { dom, graph, route, state, theme } = rosward;
  const { el } = dom;
  const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const GROUPS = ["namespace", "process", "enclave", "none"];
  const KEYS = [
    ["/", "search"], ["↑ ↓", "move through the list"], ["Enter", "open"], ["Escape", "close, or go back one step"], ["1 2 3", "graph, policies, findings"],
    ["arrows", "in the graph: move in that direction"], ["+ -", "zoom"], ["0", "fit"], ["f", "focus on the open item, or end the focus"],
    ["g", "next grouping"], ["s", "system entities"], ["t", "light or dark theme"], ["?", "show these keys"],
  ];
  const dialog = document.getElementById("keys");

  function search() {
    document.body.classList.add("with-side");
    document.getElementById("search").focus();
    document.getElementById("search").select();
  }

  function focus() {
    const { one } = route.get();
    state.focus(state.get().focus === null && one ? one.id : null);
  }

  function escape() {
    if (document.body.classList.contains("with-side")) document.body.classList.remove("with-side");
    else if (document.body.classList.contains("with-panel")) document.querySelector("#panel .close").click();
    else if (state.get().focus !== null) state.set({ focus: null });
  }

  const actions = {
    "/": search, "?": () => dialog.showModal(), "0": graph.fit, "+": () => graph.zoom(1.35), "=": () => graph.zoom(1.35), "-": () => graph.zoom(1 / 1.35),
    f: focus, g: () => state.set({ group: GROUPS[(GROUPS.indexOf(state.get().group) + 1) % GROUPS.length], collapsed: [] }),
    s: () => state.set({ system: !state.get().system }), t: theme.turn, Escape: escape,
    1: () => route.go("#graph"), 2: () => route.go("#policies"), 3: () => route.go("#findings"),
  };

  function pressed(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || dialog.open) return;
    const writing = event.target.closest("input[type=search], textarea, select");
    if (writing && event.key !== "Escape") return;
    if (event.target.id === "canvas" && ARROWS[event.key]) graph.step(...ARROWS[event.key]);
    else if (event.target.id === "canvas" && event.key === "Enter") document.querySelector("#panel h2")?.focus();
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
    if (writing) event.target.blur();
  }

  function start() {
    dom.fill(dialog, el("h2", {}, "Keys"), el("dl", {}, KEYS.map(([key, word]) => [el("dt", {}, key.split(" ").map((one) => el("kbd", {}, one))), el("dd", {}, word)])),
      el("form", { method: "dialog" }, el("button", { class: "act" }, "Close")));
    document.getElementById("buttons").append(dom.button("Keys (?)", "keys", () => dialog.showModal()));
    document.getElementById("buttons").prepend(dom.button("List and filters", "menu", () => document.body.classList.toggle("with-side"), { class: "tool only-narrow" }));
    addEventListener("keydown", pressed);
    // a narrow page shows the list over the graph: a choice in it closes it
    route.listen(() => document.body.classList.remove("with-side"));
  }

  return { start };
})();
