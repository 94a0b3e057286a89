// SPDX-License-Identifier: Apache-2.0
"use strict";
// Where does each shape stand when the real layout is not ready, or cannot run? Columns along the data flow, frame by frame.
rosward.quick = (() => {
  const GAP_X = 70;
  const GAP_Y = 14;
  const FRAME = 26;

  /** Positions (centres) by key. */
  function layout(picture, ratio) {
    const blocks = [...blocksOf(picture).values()].map((shapes) => columns(shapes, picture.edges));
    const packed = rosward.packing.pack(blocks.map(({ width, height }) => ({ width: width + FRAME, height: height + 2 * FRAME })), ratio);
    const places = new Map();
    blocks.forEach((block, number) => {
      const { x, y } = packed.at[number];
      for (const [key, at] of block.places) places.set(key, { x: x + at.x, y: y + at.y });
    });
    return places;
  }

  function blocksOf(picture) {
    const blocks = new Map();
    for (const shape of picture.shapes) {
      const key = shape.parent || "";
      if (!blocks.has(key)) blocks.set(key, []);
      blocks.get(key).push(shape);
    }
    return blocks;
  }

  function columns(shapes, edges) {
    const inside = new Set(shapes.map((shape) => shape.key));
    const next = new Map(shapes.map((shape) => [shape.key, []]));
    const entering = new Map(shapes.map((shape) => [shape.key, 0]));
    for (const { source, target } of edges) {
      if (!inside.has(source) || !inside.has(target)) continue;
      next.get(source).push(target);
      entering.set(target, entering.get(target) + 1);
    }
    const column = new Map();
    const order = [...shapes].sort((a, b) => entering.get(a.key) - entering.get(b.key));
    for (const start of order) { // breadth first from what nothing leads to; a cycle is cut where it is met again
      if (column.has(start.key)) continue;
      column.set(start.key, 0);
      for (let border = [start.key]; border.length;) {
        const reached = [];
        for (const key of border) for (const other of next.get(key)) {
          if (column.has(other)) continue;
          column.set(other, column.get(key) + 1);
          reached.push(other);
        }
        border = reached;
      }
    }
    const stacks = [];
    for (const shape of shapes) (stacks[column.get(shape.key)] ||= []).push(shape);
    const places = new Map();
    let x = 0;
    let height = 0;
    for (const stack of stacks) {
      const width = Math.max(...stack.map((shape) => shape.width));
      let y = 0;
      for (const shape of stack) {
        places.set(shape.key, { x: x + width / 2, y: y + shape.height / 2 });
        y += shape.height + GAP_Y;
      }
      height = Math.max(height, y - GAP_Y);
      x += width + GAP_X;
    }
    return { places, width: x - GAP_X, height };
  }

  return { layout };
})();
