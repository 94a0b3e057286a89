// SPDX-License-Identifier: Apache-2.0
"use strict";
// The drawing: shapes and edges on a canvas, with zoom, pan, hover and choice.
rosward.graph = (() => {
  const { model, state, route, elements, layout, tiles, look, filter, opening, labels } = rosward;
  const PATIENCE = 300; // milliseconds that the first look may wait for the real layout
  const FEW = 24; // nodes
  const LARGE = 150; // nodes: their first picture waits for nothing
  const HEAVY = 1200; // shapes and edges: from here on moving comes before detail
  const MARGIN = 24; // around the drawing, which is fitted into the rest
  const box = document.getElementById("canvas");
  const listeners = [];
  let cy = null;
  let picture = null;
  let shown = null;
  let job = 0;
  let settled = Promise.resolve();
  let opened = null; // the frame that the user has just opened
  let unseen = false; // laid out while another view was open, so for no known room

  function start() {
    cy = cytoscape({
      container: box, style: look.style(), minZoom: 0.03, maxZoom: 3, boxSelectionEnabled: false, selectionType: "single",
      autoungrabify: false, hideEdgesOnViewport: false, textureOnViewport: false, layout: { name: "preset" },
    });
    cy.on("tap", "node.shape", ({ target }) => choose(target.data("ref")));
    cy.on("tap", "edge", ({ target }) => chooseEdge(target));
    cy.on("tap", ({ target }) => { if (target === cy) route.go("#graph"); });
    cy.on("dbltap", "node.frame, node.group", ({ target }) => toggle(target.id()));
    cy.on("dbltap", "node.shape", ({ target }) => { if (!target.hasClass("group")) state.focus(target.data("ref")); });
    cy.on("mouseover", "node.shape, edge", ({ target }) => { light(target); tip(target); box.classList.add("over"); });
    cy.on("mouseout", "node.shape, edge", () => { unlight(); tip(null); box.classList.remove("over"); });
    cy.on("drag", "node", ({ target }) => target.union(target.descendants()).connectedEdges(".routed").forEach(unrouted));
    cy.on("viewport", () => tip(null));
    labels.follow(cy);
    new ResizeObserver(() => cy.resize()).observe(box);
    opening.start(room());
    update(state.get());
    state.listen(update);
    route.listen((place) => {
      if (place.view === "graph" && unseen) update(state.get());
      else mark(place);
    });
  }

  /** Draws what the filters leave. */
  function update(view) {
    shown = filter.shown(view);
    picture = elements.picture(shown, view);
    listeners.forEach((listener) => listener(shown, picture));
    settled = draw(picture, ++job);
  }

  /** The room for the drawing, in pixels; where another view is open, about that. */
  function room() {
    return { width: Math.max(200, (box.clientWidth || innerWidth) - 2 * MARGIN), height: Math.max(200, (box.clientHeight || 0.8 * innerHeight) - 2 * MARGIN) };
  }

  async function draw(wanted, number) {
    unseen = box.clientWidth === 0;
    const space = room();
    box.parentElement.setAttribute("aria-busy", "true");
    const sketch = () => place(wanted, tiles.layout(wanted, space.width / space.height));
    if (model.nodes.size > LARGE && cy.elements().empty()) sketch();
    const patience = setTimeout(() => { if (number === job) sketch(); }, PATIENCE);
    const nothing = { places: new Map(), ways: new Map(), width: 0, height: 0 };
    const answer = wanted.shapes.length ? await layout.layout(wanted, space, state.get().detail) : nothing;
    clearTimeout(patience);
    if (number !== job || (answer && opening.refuses(answer, room()))) return settled;
    box.parentElement.removeAttribute("aria-busy");
    if (answer) place(wanted, answer);
    else sketch();
    opened = null;
    return undefined;
  }

  function place(wanted, answer) {
    const classes = (...words) => words.filter(Boolean).join(" ");
    const frames = wanted.frames.map((one) => ({ group: "nodes", data: { id: one.key, name: one.label, label: one.label, labelWidth: one.labelWidth, wide: answer.ways.size === 0, size: 12, parent: one.parent || undefined }, classes: "frame", grabbable: true }));
    const shapes = wanted.shapes.map((one) => ({
      group: "nodes", position: { ...answer.places.get(one.key) }, data: { id: one.key, ref: one.ref, label: one.label, width: one.width, height: one.height, parent: one.parent || undefined },
      classes: classes("shape", one.kind, one.doubtful && "doubtful", one.hub && "hub", one.system && "system", one.assumed && "assumed", one.unknown && "unknown", one.severity),
    }));
    const behind = wanted.edges.length > wanted.shapes.length ? "behind" : ""; // so many that they would hide what they join
    const opacity = Math.max(0.1, Math.min(0.35, 20 / wanted.edges.length));
    const edges = wanted.edges.map((one) => ({
      group: "edges", data: { id: one.key, source: one.source, target: one.target, opacity, width: 1.4 + 0.5 * Math.log2(Math.max(1, one.entities.size / 2)) },
      classes: classes(one.kind, one.both && "both", one.dashed && "dashed", answer.ways.has(one.key) ? "routed" : behind),
    }));
    cy.batch(() => {
      cy.elements().remove();
      cy.add([...frames, ...shapes, ...edges]);
      for (const one of wanted.edges) if (answer.ways.has(one.key)) routed(cy.getElementById(one.key), answer.ways.get(one.key));
    });
    const blank = document.getElementById("blank");
    blank.hidden = wanted.shapes.length > 0;
    blank.textContent = model.nodes.size ? "Nothing matches the filters." : "These sources contain no ROS nodes.";
    const heavy = wanted.shapes.length + wanted.edges.length > HEAVY;
    cy.renderer().hideEdgesOnViewport = heavy;
    const frame = opened && cy.getElementById(opened);
    if (frame?.nonempty()) show(frame);
    else fit();
    labels.update(cy);
    mark(route.get());
  }

  /** Gives an edge the bends of the layout, as parts of the line between its ends. */
  function routed(edge, way) {
    const [first, last] = [way[0], way[way.length - 1]];
    const [from, to] = [edge.source(), edge.target()];
    const start = onOutline(from, first);
    const end = onOutline(to, last);
    const along = { x: end.x - start.x, y: end.y - start.y };
    const length = Math.hypot(along.x, along.y) || 1;
    const bends = way.slice(1, -1);
    const weights = bends.map((point) => ((point.x - start.x) * along.x + (point.y - start.y) * along.y) / (length * length));
    const distances = bends.map((point) => ((point.x - start.x) * along.y - (point.y - start.y) * along.x) / -length);
    const offset = (point, node) => `${point.x - node.position("x")}px ${point.y - node.position("y")}px`;
    edge.style({
      "source-endpoint": offset(start, from), "target-endpoint": offset(end, to),
      ...(bends.length ? { "segment-weights": weights.join(" "), "segment-distances": distances.join(" ") } : { "curve-style": "straight" }),
    });
  }

  /** The layout leads edges to the box around a shape; where the shape is rounder, the line goes on to its outline. */
  function onOutline(node, point) {
    const { x, y } = node.position();
    const [a, b] = [node.data("width") / 2, node.data("height") / 2]; // not width(): styles are not computed yet
    const [dx, dy] = [point.x - x, point.y - y];
    if (a - Math.abs(dx) < 1) return { x: x + Math.sign(dx) * Math.min(Math.abs(dx), a * reachAcross(node, dx, Math.min(1, Math.abs(dy) / b))), y: point.y };
    return { x: point.x, y: y + Math.sign(dy) * Math.min(Math.abs(dy), b * reachDown(node, Math.min(1, Math.abs(dx) / a))) };
  }

  function reachAcross(node, dx, share) {
    if (node.hasClass("node")) return Math.sqrt(1 - share * share);
    if (node.hasClass("service")) return 1 - 0.12 * share;
    if (node.hasClass("action")) return dx < 0 ? 0.9 + 0.1 * share : 1 - 0.14 * share;
    return 1;
  }

  function reachDown(node, share) {
    if (node.hasClass("node")) return Math.sqrt(1 - share * share);
    return node.hasClass("service") && share > 0.88 ? (1 - share) / 0.12 : 1;
  }

  function unrouted(edge) {
    edge.removeClass("routed");
    edge.removeStyle();
  }

  function fit() {
    cy.resize();
    cy.fit(undefined, MARGIN);
    if (cy.zoom() > 1.25) cy.zoom(1.25);
    cy.center();
  }

  /** Shows a frame so that what is in it can be read: as a whole, or from its upper left corner on. */
  function show(frame) {
    const at = frame.boundingBox();
    const whole = Math.min(room().width / at.w, room().height / at.h);
    cy.zoom(Math.max(layout.READABLE, Math.min(1.25, whole)));
    if (whole >= layout.READABLE) cy.center(frame);
    else cy.pan({ x: MARGIN - at.x1 * cy.zoom(), y: MARGIN - at.y1 * cy.zoom() });
  }

  const moving = () => !matchMedia("(prefers-reduced-motion: reduce)").matches;

  function zoom(factor) {
    cy.zoom({ level: cy.zoom() * factor, renderedPosition: { x: cy.width() / 2, y: cy.height() / 2 } });
  }

  function choose(ref) {
    const thing = model.thing(ref);
    if (thing) route.go(route.to(thing));
    else toggle(ref);
  }

  function chooseEdge(edge) {
    const { entities } = picture.edges.find((one) => one.key === edge.id());
    const ids = [...entities].slice(0, 200);
    if (ids.length) route.go(route.toEntities(ids));
  }

  /** Closes or opens a frame; the frames in a small one are opened with it. */
  function toggle(id) {
    const { collapsed } = state.get();
    const shape = picture.shapes.find((one) => one.key === id);
    if (!shape) {
      state.set({ collapsed: [...collapsed, id] });
      return;
    }
    opened = id;
    const inner = shape.count > FEW ? [] : elements.framesIn(id, shown, state.get());
    state.set({ collapsed: collapsed.filter((one) => one !== id && !inner.includes(one)) });
  }

  /** Shows in the drawing what the address names. */
  function mark(place) {
    cy.elements(".chosen").removeClass("chosen");
    const refs = new Set(place.one ? [place.one.id] : []);
    const ids = new Set([...place.entities, ...(place.rule ? place.rule.entities.map((id) => model.entities.get(id)) : [])].map((one) => one.id));
    for (const id of ids) refs.add(model.entities.get(id).endpoint);
    // without the endpoints in the drawing, the edges through one stand for it
    if (place.one && !picture.shapes.some((one) => one.ref === place.one.id)) (model.users.get(place.one.id) || []).forEach((one) => ids.add(one.id));
    const edges = picture.edges.filter((one) => [...one.entities].some((id) => ids.has(id))).map((one) => one.key);
    const shapes = picture.shapes.filter((one) => refs.has(one.ref) && (place.one || edges.some((key) => key.includes(one.key))));
    const chosen = cy.collection();
    for (const key of [...edges, ...shapes.map((one) => one.key)]) chosen.merge(cy.getElementById(key));
    chosen.addClass("chosen");
    if (chosen.nonempty()) bring(chosen);
  }

  /** Moves the view only as far as it must to show these. */
  function bring(chosen) {
    const seen = cy.extent();
    const at = chosen.boundingBox({ includeLabels: false });
    const inside = at.x1 >= seen.x1 && at.x2 <= seen.x2 && at.y1 >= seen.y1 && at.y2 <= seen.y2;
    const readable = cy.zoom() >= 0.55;
    if (inside && readable) return;
    const zoomed = Math.max(0.9, cy.zoom());
    const large = (at.w * zoomed > cy.width() || at.h * zoomed > cy.height());
    const target = large ? { fit: { eles: chosen, padding: 60 } } : { zoom: zoomed, center: { eles: chosen } };
    cy.stop();
    cy.animate(target, { duration: moving() ? 220 : 0 });
  }

  function light(target) {
    const near = target.isEdge() ? target.union(target.connectedNodes()) : target.closedNeighborhood();
    const kept = near.union(near.filter("node").ancestors());
    cy.batch(() => {
      cy.elements().not(kept).not(".frame").addClass("faded");
      near.addClass("lit");
    });
  }

  function unlight() {
    cy.batch(() => cy.elements(".faded, .lit").removeClass("faded lit"));
  }

  function tip(target) {
    const element = document.getElementById("tip");
    element.hidden = true;
    if (!target || target.isEdge()) return;
    const thing = model.thing(target.data("ref"));
    if (!thing) return;
    const kind = model.kindOf(thing);
    const more = kind === "node" ? [thing.package, thing.executable].filter(Boolean).join(" · ") : thing.types.join(", ") || "unknown type";
    rosward.dom.fill(element, rosward.dom.el("b", {}, model.nameOf(thing)), rosward.dom.el("span", {}, `${kind} · ${more}`));
    const at = target.renderedBoundingBox({ includeLabels: false });
    element.hidden = false;
    element.style.left = `${Math.max(4, Math.min(at.x1, box.clientWidth - element.offsetWidth - 8))}px`;
    element.style.top = `${at.y2 + 8 + element.offsetHeight > box.clientHeight ? at.y1 - element.offsetHeight - 8 : at.y2 + 8}px`;
  }

  /** Marks what a search has found; null for no search. */
  function hits(ids) {
    cy.batch(() => {
      cy.nodes(".hit").removeClass("hit");
      if (ids) cy.nodes(".shape").filter((node) => ids.has(node.data("ref"))).addClass("hit");
    });
  }

  /** The thing that stands nearest to the chosen one in a direction; without a chosen one the first. */
  function step(dx, dy) {
    const from = cy.nodes(".chosen.shape").first();
    const others = cy.nodes(".shape").not(".group");
    if (from.empty()) {
      if (others.nonempty()) choose(others.first().data("ref"));
      return;
    }
    const { x, y } = from.position();
    let best = null;
    for (const other of others.not(from).toArray()) {
      const [ox, oy] = [other.position("x") - x, other.position("y") - y];
      const ahead = ox * dx + oy * dy;
      if (ahead <= 1) continue;
      const cost = ahead + 3 * Math.abs(ox * dy + oy * dx) - (from.edgesWith(other).nonempty() ? 150 : 0);
      if (best === null || cost < best.cost) best = { cost, other };
    }
    if (best) choose(best.other.data("ref"));
  }

  /** A canvas with the whole drawing, for files and paper. */
  function painted(background) {
    const { w, h } = cy.elements().boundingBox();
    const scale = Math.max(0.2, Math.min(2, 8000 / Math.max(w, h, 1)));
    return cy.renderer().bufferCanvasImage({ full: true, scale, bg: background });
  }

  return {
    start, fit, room, zoom, hits, step, painted, toggle,
    restyle: () => cy.style(look.style()),
    settled: () => settled,
    picture: () => picture,
    shown: () => shown,
    listen: (listener) => listeners.push(listener),
    library: () => cy,
  };
})();
