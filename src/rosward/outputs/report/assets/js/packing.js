// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which parts of a picture have nothing to do with each other, and how do such parts fill a page?
rosward.packing = (() => {
  const GAP = 26;
  const STRETCHES = [0.8, 0.85, 0.9, 0.95, 1, 1.05, 1.1, 1.2, 1.35, 1.5, 1.8];

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

  /** {width, height, at: offsets in the order of the boxes}: the high boxes first, each as far up as it goes, as wide as suits the page. */
  function pack(boxes, ratio, gap = GAP) {
    const order = boxes.map((_, number) => number).sort((a, b) => boxes[b].height - boxes[a].height || a - b);
    const widest = boxes.reduce((most, one) => Math.max(most, one.width), 1);
    const area = boxes.reduce((sum, one) => sum + (one.width + gap) * (one.height + gap), 0);
    let best = null;
    for (const width of new Set(STRETCHES.map((stretch) => Math.max(widest, Math.sqrt(area * ratio) * stretch)))) {
      const tried = stacked(boxes, order, width, gap);
      tried.cost = Math.max(tried.width / ratio, tried.height);
      if (best === null || tried.cost < best.cost) best = tried;
    }
    return best;
  }

  /** The boxes within a width; `line` is the lower edge of what stands there already, in parts of one height from left to right. */
  function stacked(boxes, order, most, gap) {
    const whole = { at: [], width: 0, height: 0 };
    let line = [{ x: 0, y: 0, end: most + gap }];
    for (const number of order) {
      const [width, height] = [boxes[number].width + gap, boxes[number].height + gap];
      let best = null;
      for (let first = 0; first < line.length; first++) {
        const { x } = line[first];
        if (x + width > most + gap + 0.5) break;
        let y = 0;
        for (let at = first; at < line.length && line[at].x < x + width - 0.5; at++) y = Math.max(y, line[at].y);
        if (best === null || y < best.y) best = { x, y };
      }
      whole.at[number] = best;
      whole.width = Math.max(whole.width, best.x + width - gap);
      whole.height = Math.max(whole.height, best.y + height - gap);
      const end = best.x + width;
      const left = line.filter((part) => part.x < best.x).map((part) => ({ ...part, end: Math.min(part.end, best.x) }));
      const right = line.filter((part) => part.end > end + 0.5).map((part) => ({ ...part, x: Math.max(part.x, end) }));
      line = [...left, { x: best.x, y: best.y + height, end }, ...right];
    }
    return whole;
  }

  return { apart, pack };
})();
