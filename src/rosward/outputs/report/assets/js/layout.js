// SPDX-License-Identifier: Apache-2.0
"use strict";
// Where does each shape stand, and which way does each edge take? ELK's layered layout says it, in a worker of its own: the
// page answers while it works. Its code is in the page as plain text, and costs nothing before the first question.
rosward.layout = (() => {
  const { packing, tiles } = rosward;
  const READABLE = 0.85; // shrunk further, a label of 12 pixels is no longer read
  const AROUND = 24; // what badges and arrows need beyond the outermost shapes
  const SPACING = {
    "elk.spacing.nodeNode": 13, "elk.spacing.edgeNode": 9, "elk.spacing.edgeEdge": 7, "elk.spacing.componentComponent": 30,
    "elk.layered.spacing.nodeNodeBetweenLayers": 32, "elk.layered.spacing.edgeNodeBetweenLayers": 10, "elk.layered.spacing.edgeEdgeBetweenLayers": 7,
  };
  const ACROSS = { "elk.direction": "RIGHT" };
  const DOWN = { "elk.direction": "DOWN" };
  const FOLDED = { "elk.direction": "RIGHT", "elk.layered.wrapping.strategy": "MULTI_EDGE" };
  const ROOMY = 0.8; // a picture that is shrunk less than this is good as it is
  const WORTH = 4; // so much smaller, a picture with edges that go around everything is still the better one
  const SMALL = 250; // up to so many shapes are laid out in two ways, and the one that fits the page better is taken
  const SECONDS = 30; // then the tiles stay
  const KEPT = 24;
  const known = new Map();
  const waiting = new Map();
  let worker = null;
  let code = null; // a promise of it, since it is unpacked when it is asked for first
  let asked = 0;

  async function start() {
    code ||= unpacked.text("layout-code").then((text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" })));
    const address = await code;
    if (worker !== null) return;
    worker = new Worker(address);
    worker.onmessage = ({ data }) => {
      waiting.get(data.id)?.(data.error ? null : data.data);
      waiting.delete(data.id);
    };
    worker.onerror = (event) => { event.preventDefault?.(); stop(); };
    worker.postMessage({ id: 0, cmd: "register", algorithms: ["layered"] });
  }

  function ask(message) {
    return new Promise((resolve) => {
      const id = ++asked;
      waiting.set(id, resolve);
      worker.postMessage({ id, ...message });
    });
  }

  function stop() {
    worker?.terminate();
    worker = null;
    for (const resolve of waiting.values()) resolve(null);
    waiting.clear();
  }

  /** How much a layout has to shrink to be seen as a whole. */
  function scale(answer, room) {
    return Math.min(room.width / (answer.width + AROUND), room.height / (answer.height + AROUND));
  }

  /** As `drawn` says; where that cannot be read as a whole, tiles. Endpoints are explained by their edges, so with them it may be smaller. */
  async function layout(picture, room, detail) {
    const best = await drawn(picture, room);
    if (best && scale(best, room) >= READABLE) return best;
    const packed = tiles.layout(picture, room.width / room.height);
    return best && scale(best, room) * (detail === "all" ? WORTH : 1) >= scale(packed, room) ? best : packed;
  }

  /** {places: key to centre, ways: key to points, width, height}, or null where no layout could be made. */
  async function drawn(picture, room) {
    const { width, height } = room;
    const key = JSON.stringify([Math.round(10 * width / height), question(picture, ACROSS)]);
    if (known.has(key)) return known.get(key);
    if (waiting.size > 0) stop(); // what was asked before is not wanted any more
    try {
      if (worker === null) await start();
    } catch {
      return null;
    }
    const timer = setTimeout(stop, SECONDS * 1000);
    const pictures = packing.apart(picture);
    let best = await packed(pictures, width / height, ACROSS);
    if (best && scale(best, room) < ROOMY && picture.shapes.length <= SMALL) {
      const other = await packed(pictures, width / height, picture.frames.length ? DOWN : FOLDED);
      if (other && scale(other, room) > scale(best, room)) best = other;
    }
    clearTimeout(timer);
    if (best === null) return null;
    if (known.size >= KEPT) known.delete(known.keys().next().value);
    known.set(key, best);
    return best;
  }

  /** The layouts of all parts, put side by side. */
  async function packed(pictures, ratio, way) {
    const answers = await Promise.all(pictures.map((one) => worker && ask({ cmd: "layout", graph: question(one, way), layoutOptions: {}, options: {} })));
    if (!answers.every(Boolean)) return null;
    const whole = packing.pack(answers, ratio);
    const read = { places: new Map(), ways: new Map(), width: whole.width, height: whole.height };
    answers.forEach((answer, number) => reading(answer, whole.at[number], read));
    return read;
  }

  function question(picture, way) {
    const boxes = new Map([["", { id: "root", children: [] }]]);
    for (const frame of picture.frames) {
      boxes.set(frame.key, { id: frame.key, children: [], layoutOptions: { "elk.padding": "[top=34,left=16,bottom=16,right=16]", ...SPACING } });
    }
    for (const frame of picture.frames) boxes.get(frame.parent || "").children.push(boxes.get(frame.key));
    for (const { key, parent, width, height } of picture.shapes) boxes.get(parent || "").children.push({ id: key, width, height });
    const framed = picture.frames.length > 0;
    return {
      ...boxes.get(""),
      edges: picture.edges.map(({ key, source, target }) => ({ id: key, sources: [source], targets: [target] })),
      layoutOptions: {
        "elk.algorithm": "layered", ...way, "elk.edgeRouting": "ORTHOGONAL",
        "elk.hierarchyHandling": framed ? "INCLUDE_CHILDREN" : "SEPARATE_CHILDREN",
        "elk.json.edgeCoords": "ROOT", "elk.json.shapeCoords": "ROOT", "elk.layered.thoroughness": picture.shapes.length > 400 ? 3 : 10,
        "elk.layered.nodePlacement.strategy": "BRANDES_KOEPF", "elk.layered.nodePlacement.bk.fixedAlignment": "BALANCED", ...SPACING,
      },
    };
  }

  function reading(answer, by, read) {
    const moved = ({ x, y }) => ({ x: x + by.x, y: y + by.y });
    const walk = (box) => {
      for (const child of box.children || []) {
        if (!child.children) read.places.set(child.id, moved({ x: child.x + child.width / 2, y: child.y + child.height / 2 }));
        walk(child);
      }
    };
    walk(answer);
    for (const edge of answer.edges || []) {
      const [section] = edge.sections || [];
      if (section) read.ways.set(edge.id, [section.startPoint, ...(section.bendPoints || []), section.endPoint].map(moved));
    }
  }

  /** Starts the worker, so that it is ready when the first question comes. */
  function warm() {
    start().catch(() => { /* then the tiles have to do */ });
  }

  return { layout, scale, warm, READABLE };
})();
