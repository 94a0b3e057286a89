// SPDX-License-Identifier: Apache-2.0
"use strict";
// What is a sensible first view? The most of the system of which every label can be read in the room that there is: everything, else the
// nodes without their topics, else some frames closed, the largest opened first. What cannot be read when it is laid out gives way to the next.
rosward.opening = (() => {
  const { model, state, filter, elements, frames, tiles, layout, dom, names } = rosward;
  const WORTH = 0.6; // of what edges and topics take room besides
  const MOST = 150; // shapes: more are no first view in any room
  const SHAPE = 6000; // square pixels that a shape takes, about
  const HINT = 64; // pixels of height for what is told under the picture
  const hint = document.getElementById("hint");
  let left = []; // the views to try where this one cannot be read; none once the user has chosen
  let trying = false;

  function start(room) {
    left = [{}, { detail: "nodes" }, ...cuts({ ...room, height: room.height - HINT })].slice(model.nodes.size > MOST ? 2 : 0);
    state.listen(() => {
      if (trying) return;
      left = [];
      hint.hidden = true;
    });
    next({ ...room, height: room.height - HINT });
  }

  /** Goes to the next view that may be read, in the end to the last. */
  function next(room) {
    let view = left.shift();
    while (left.length && !mayFit(view, room)) view = left.shift();
    tell(view);
    trying = true;
    state.set(view);
    trying = false;
  }

  function mayFit(change, room) {
    const view = { ...state.DEFAULTS, ...change };
    const picture = elements.picture(filter.shown(view), view);
    if (picture.shapes.length > MOST) return false;
    const scale = layout.scale(tiles.layout(picture, room.width / room.height), room);
    return scale * (view.detail === "all" ? WORTH : 1) >= layout.READABLE;
  }

  /** Whether something else is drawn in place of this, since it would be too small. */
  function refuses(answer, room) {
    if (!left.length || layout.scale(answer, room) >= layout.READABLE) return false;
    next(room);
    return true;
  }

  /** Views of nodes and closed frames, with ever fewer shapes; in the last all frames are closed. */
  function* cuts(room) {
    const around = frames.around(model.nodes.keys(), state.DEFAULTS);
    const things = [...model.nodes.keys()].map((id) => ({ parent: around.homes.get(id) || null }));
    frames.dissolve(around.all, things);
    const within = new Map([[null, { shapes: 0, frames: [] }], ...[...around.all.keys()].map((key) => [key, { shapes: 0, frames: [] }])]);
    for (const { parent } of things) within.get(parent).shapes += 1;
    for (const { key, parent } of around.all.values()) within.get(parent).frames.push(key);
    const size = (key) => within.get(key).shapes + within.get(key).frames.reduce((sum, one) => sum + size(one), 0);
    const sizes = new Map([...around.all.keys()].map((key) => [key, size(key)]));
    let before = Infinity;
    const capacity = Math.min(MOST, room.width * room.height / (layout.READABLE ** 2 * SHAPE));
    for (let most = capacity; before > 0; most *= 0.85) {
      const opened = openedUpTo(most, within, sizes);
      if (opened.size < before) yield { detail: "nodes", collapsed: [...around.all.keys()].filter((key) => !opened.has(key)) };
      before = opened.size;
    }
  }

  /** The frames to open, the largest first, so that there are at most so many shapes; of those that are about equal all or none. */
  function openedUpTo(most, within, sizes) {
    const opened = new Set();
    let shapes = within.get(null).shapes + within.get(null).frames.length;
    const border = [within.get(null).frames];
    while (border.length) {
      const alike = new Map();
      for (const key of border.shift()) {
        const about = Math.round(2 * Math.log2(sizes.get(key)));
        alike.set(about, [...(alike.get(about) || []), key]);
      }
      for (const [, keys] of [...alike].sort(([a], [b]) => b - a)) {
        const more = keys.reduce((sum, key) => sum + within.get(key).shapes + within.get(key).frames.length - 1, 0);
        if (shapes + more > most) continue;
        shapes += more;
        for (const key of keys) {
          opened.add(key);
          border.push(within.get(key).frames);
        }
      }
    }
    return opened;
  }

  /** Says what is not drawn, and how to get it. */
  function tell({ detail, collapsed = [] }) {
    hint.hidden = detail === undefined;
    const closed = collapsed.length ? "some frames are closed; click one to open it" : "shown without their topics; click one to see its connections";
    const all = dom.el("button", { type: "button", class: "act", onclick: () => state.set({ collapsed: [], detail: "all" }) }, "Draw everything");
    dom.fill(hint, `${names.plural(model.nodes.size, "node")}, ${closed}.`, all, dom.button("Close", "close", () => { hint.hidden = true; }));
  }

  return { start, refuses };
})();
