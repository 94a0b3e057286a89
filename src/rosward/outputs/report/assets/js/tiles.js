// SPDX-License-Identifier: Apache-2.0
"use strict";
// Where does each shape stand when it is to be seen with as many others as there is room for? Side by side in rows, frame by frame,
// along the data flow; edges go where they go. It takes no time, so it is also what is seen until the real layout is ready.
rosward.tiles = (() => {
  const { packing } = rosward;
  const GAP = 16;
  const FRAME = { top: 30, side: 12 };

  /** {places: key to centre, ways: none, width, height}. */
  function layout(picture, ratio) {
    const inside = new Map([[null, []], ...picture.frames.map((one) => [one.key, []])]);
    const order = alongTheFlow(picture);
    for (const one of [...picture.shapes].sort((a, b) => order.get(a.key) - order.get(b.key))) inside.get(one.parent || null).push(one);
    for (const one of picture.frames) inside.get(one.parent || null).push({ key: one.key, frame: true });
    const whole = filled(inside, null, ratio);
    const places = new Map();
    const place = (box, x, y) => {
      if (!box.content) places.set(box.key, { x: x + box.width / 2, y: y + box.height / 2 });
      else box.content.forEach((one, number) => place(one, x + box.left + box.at[number].x, y + box.top + box.at[number].y));
    };
    place(whole, 0, 0);
    return { places, ways: new Map(), width: whole.width, height: whole.height };
  }

  function filled(inside, key, ratio) {
    const content = inside.get(key).map((one) => (one.frame ? filled(inside, one.key, ratio) : { key: one.key, width: one.width, height: one.height }));
    const packed = packing.pack(content, ratio, GAP);
    const [left, top] = key === null ? [0, 0] : [FRAME.side, FRAME.top];
    return { key, content, at: packed.at, left, top, width: packed.width + 2 * left, height: packed.height + top + left };
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
