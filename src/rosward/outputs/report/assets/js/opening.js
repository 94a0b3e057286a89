// SPDX-License-Identifier: Apache-2.0
"use strict";
// What is a sensible first view? Everything, if it can be read; of a large system its closed frames, or its nodes alone.
rosward.opening = (() => {
  const { model, state, filter, elements, dom, names } = rosward;
  const READABLE = 300; // shapes

  function start() {
    const view = state.get();
    const { shapes, frames } = elements.picture(filter.shown(view), view);
    if (shapes.length <= READABLE) return;
    const outer = frames.filter((one) => !one.parent).map((one) => one.key);
    const closed = elements.picture(filter.shown(view), { ...view, collapsed: outer });
    const folds = outer.length > 1 && closed.shapes.length <= READABLE;
    state.set(folds ? { collapsed: outer } : { detail: "nodes" });
    const hint = document.getElementById("hint");
    const all = dom.el("button", { type: "button", class: "act", onclick: () => state.set({ collapsed: [], detail: "all" }) }, "Draw all of it");
    dom.fill(hint, folds ? `${names.plural(model.nodes.size, "node")}: namespaces are closed at first, a double-click opens one.` : `${names.plural(model.nodes.size, "node")}: at first without their topics.`,
      all, dom.button("Close", "close", () => { hint.hidden = true; }));
    hint.hidden = false;
    state.listen(() => { hint.hidden = true; });
  }

  return { start };
})();
