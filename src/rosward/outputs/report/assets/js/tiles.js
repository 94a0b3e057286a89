// SPDX-License-Identifier: Apache-2.0
"use strict";
// Where does each shape stand when it is to be seen with as many others as there is room for? Side by side in rows, frame by frame,
// along the data flow; edges go where they go. It takes no time, so it is also what is seen until the real layout is ready.
rosward.tiles = (() => {
  const { packing, look } = rosward;
  const GAP = 16;
  const TITLE = 20;
  const SHAPES = [1, 0.6, 1.6, 2.5]; // of inner frames, as shares of that of the whole; the best is taken

  /** {places: key to centre, ways: none, width, height}. */
  function layout(picture, ratio) {
    const inside = new Map([[null, []], ...picture.frames.map((one) => [one.key, []])]);
    const order = alongTheFlow(picture);
    for (const one of [...picture.shapes].sort((a, b) => order.get(a.key) - order.get(b.key))) inside.get(one.parent || null).push(one);
    for (const one of picture.frames) inside.get(one.parent || null).push({ key: one.key, frame: true });
    const sizes = new Map(picture.frames.map((one) => [one.key, one.labelWidth]));
    const cost = (one) => Math.max(one.width / ratio, one.height);
    const whole = SHAPES.map((share) => filled(inside, sizes, null, ratio, ratio * share)).reduce((best, one) => (cost(one) < cost(best) ? one : best));
    const places = new Map();
    const place = (box, x, y) => {
      if (!box.content) places.set(box.key, { x: x + box.width / 2, y: y + box.height / 2 });
      else box.content.forEach((one, number) => place(one, x + box.left + box.at[number].x, y + box.top + box.at[number].y));
    };
    place(whole, 0, 0);
    return { places, ways: new Map(), width: whole.width, height: whole.height };
  }

  /** What is in a frame, packed; as wide as its name at least. */
  function filled(inside, labels, key, ratio, inner) {
    const content = inside.get(key).map((one) => (one.frame ? filled(inside, labels, one.key, inner, inner) : { key: one.key, width: one.width, height: one.height }));
    const packed = packing.pack(content, ratio, GAP);
    if (key === null) return { key, content, at: packed.at, left: 0, top: 0, width: packed.width, height: packed.height };
    const width = Math.max(packed.width + 2 * look.PADDING, labels.get(key));
    return { key, content, at: packed.at, left: (width - packed.width) / 2, top: look.PADDING + TITLE, width, height: packed.height + TITLE + 2 * look.PADDING };
  }

  /** For each shape how many steps it is from where data begins; a circle is cut where it is met again. */
  function alongTheFlow({ shapes, edges }) {
    const next = new Map(shapes.map((shape) => [shape.key, []]));
    const entering = new Map(shapes.map((shape) => [shape.key, 0]));
    for (const { source, target } of edges) {
      if (!next.has(source) || !next.has(target)) continue;
      next.get(source).push(target);
      entering.set(target, entering.get(target) + 1);
    }
    const steps = new Map();
    for (const start of [...shapes].sort((a, b) => entering.get(a.key) - entering.get(b.key))) {
      if (steps.has(start.key)) continue;
      steps.set(start.key, 0);
      for (let border = [start.key]; border.length;) {
        const reached = [];
        for (const key of border) for (const other of next.get(key)) {
          if (steps.has(other)) continue;
          steps.set(other, steps.get(key) + 1);
          reached.push(other);
        }
        border = reached;
      }
    }
    return steps;
  }

  return { layout };
})();
