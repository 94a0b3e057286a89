// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which parts of a picture have nothing to do with each other, and how do such parts fill a page?
rosward.packing = (() => {
  const GAP = 26;

  /** The picture as pictures of what is joined by edges; a frame and all in it stay together. */
  function apart(picture) {
    const frames = new Map(picture.frames.map((one) => [one.key, one]));
    const parents = new Map(picture.shapes.map((one) => [one.key, one.parent]));
    const outermost = (key) => {
      let at = parents.get(key) || key;
      while (frames.get(at)?.parent) at = frames.get(at).parent;
      return at;
    };
    const leader = new Map();
    const find = (key) => {
      let at = key;
      while (leader.has(at)) at = leader.get(at);
      if (at !== key) leader.set(key, at);
      return at;
    };
    const edges = picture.edges.filter((one) => one.kind !== "maybe");
    for (const { source, target } of edges) {
      const [a, b] = [find(outermost(source)), find(outermost(target))];
      if (a !== b) leader.set(b, a);
    }
    const pictures = new Map();
    const of = (key) => {
      const at = find(outermost(key));
      if (!pictures.has(at)) pictures.set(at, { shapes: [], frames: [], edges: [] });
      return pictures.get(at);
    };
    picture.shapes.forEach((one) => of(one.key).shapes.push(one));
    picture.frames.forEach((one) => of(one.key).frames.push(one));
    edges.forEach((one) => of(one.source).edges.push(one));
    return [...pictures.values()];
  }

  /** {width, height, at: offsets in the order of the boxes}: rows of boxes, the high ones first, as wide as suits the page. */
  function pack(boxes, ratio, gap = GAP) {
    const order = boxes.map((_, number) => number).sort((a, b) => boxes[b].height - boxes[a].height || a - b);
    const widest = Math.max(1, ...boxes.map((one) => one.width));
    const area = boxes.reduce((sum, one) => sum + (one.width + gap) * (one.height + gap), 0);
    let best = null;
    for (const stretch of [0.8, 0.85, 0.9, 0.95, 1, 1.05, 1.1, 1.2, 1.35, 1.5, 1.8]) {
      const tried = rows(boxes, order, Math.max(widest, Math.sqrt(area * ratio) * stretch), gap);
      tried.cost = Math.max(tried.width / ratio, tried.height);
      if (best === null || tried.cost < best.cost) best = tried;
    }
    return best;
  }

  function rows(boxes, order, most, gap) {
    const at = [];
    let [x, y, row, width] = [0, 0, 0, 0];
    for (const number of order) {
      const box = boxes[number];
      if (x > 0 && x + box.width > most) [x, y, row] = [0, y + row + gap, 0];
      at[number] = { x, y };
      x += box.width + gap;
      row = Math.max(row, box.height);
      width = Math.max(width, x - gap);
    }
    return { at, width, height: y + row };
  }

  return { apart, pack };
})();
