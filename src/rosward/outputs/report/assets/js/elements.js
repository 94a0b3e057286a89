// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which shapes, frames and edges make the picture of what is shown? No positions yet, and nothing of the drawing library.
rosward.elements = (() => {
  const { model, names } = rosward;
  // used by more nodes than this, an endpoint is drawn beside each of them: one knot would hide the rest; of different frames, by fewer
  const HUB = 12;
  const HUB_ACROSS = 4;
  const MOST_MATCHES = 4; // a pattern that may be more endpoints than this says nothing by its edges
  const measure = document.createElement("canvas").getContext("2d");
  const ROOM = { node: 34, topic: 18, service: 34, action: 34, group: 30 };

  /** {shapes, frames, edges} for the sets of `rosward.filter` and the record of `rosward.state`. */
  function picture(shown, view) {
    const drawing = { shapes: new Map(), frames: new Map(), edges: new Map() };
    const homes = homesOf(shown, view);
    const entities = model.report.entities.filter((one) => shown.entities.has(one.id));
    for (const id of shown.nodes) addShape(drawing, id, model.nodes.get(id), homes);
    if (view.detail === "nodes") addShortcuts(drawing, entities);
    else addEndpoints(drawing, entities, homes);
    addFrames(drawing, homes, view);
    for (const id of view.collapsed) if (drawing.frames.has(id)) collapse(drawing, id);
    dissolveSmall(drawing, view);
    label(drawing, view);
    return { shapes: [...drawing.shapes.values()], frames: [...drawing.frames.values()], edges: [...drawing.edges.values()] };
  }

  /** The ids of the frames that a thing is in, were they all open. */
  function framesAround(id, shown, view) {
    const { shapes, frames } = picture(shown, { ...view, collapsed: [] });
    const parents = new Map(frames.map((one) => [one.key, one.parent]));
    const around = [];
    for (let at = shapes.find((one) => one.ref === id)?.parent; at; at = parents.get(at)) around.push(at);
    return around;
  }

  /** In which frame does a node belong, and in which an endpoint with these users? */
  function homesOf(shown, view) {
    if (view.group === "none") return { of: () => null, endpoint: () => null };
    if (view.group === "namespace") {
      const spaces = new Set([...shown.nodes].map((id) => model.nodes.get(id).namespace));
      const innermost = (name) => names.above(name).find((space) => space !== name && spaces.has(space) && space !== "/") || null;
      return { of: (node) => innermost(node.fqn), endpoint: (endpoint) => innermost(endpoint.name), spaces };
    }
    const of = view.group === "process" ? (node) => node.process || "unknown process" : (node) => model.enclaves.get(node.enclave)?.path || null;
    const endpoint = (_, users) => {
      const [first, ...more] = new Set(users.map((one) => of(model.nodes.get(one.node))));
      return more.length ? null : first;
    };
    return { of, endpoint };
  }

  function frameId(view, name) {
    return name === null ? null : `frame ${name}`;
  }

  function addShape(drawing, key, thing, homes, home) {
    drawing.shapes.set(key, {
      key, ref: thing.id, kind: model.kindOf(thing), name: model.nameOf(thing), hub: false,
      home: home === undefined ? homes.of(thing) : home,
      doubtful: model.doubtful(thing) || model.nameOf(thing).includes("*"), severity: model.severityOf(thing.id), system: thing.system === true, assumed: thing.assumed === true,
      unknown: thing.interface !== "unknown" ? "" : thing.lacks.some((why) => why.includes("C++")) ? "C++, unknown" : "unknown",
    });
  }

  function isHub(entities, homes) {
    const nodes = [...new Set(entities.map((one) => one.node))].map((id) => model.nodes.get(id));
    if (nodes.length > HUB) return true;
    return nodes.length > HUB_ACROSS && new Set(nodes.map((node) => homes.of(node))).size > 1;
  }

  function addEndpoints(drawing, entities, homes) {
    const users = new Map();
    for (const entity of entities) {
      if (!users.has(entity.endpoint)) users.set(entity.endpoint, []);
      users.get(entity.endpoint).push(entity);
    }
    for (const [id, list] of users) {
      const endpoint = model.endpoints.get(id);
      const hub = isHub(list, homes);
      for (const entity of list) {
        // of two names of which nothing is known nobody can say that they are one name: each node has its own
        const own = hub || endpoint.resolution === "unknown";
        const key = own ? `${id} at ${entity.node}` : id;
        if (!drawing.shapes.has(key)) {
          addShape(drawing, key, endpoint, homes, own ? homes.of(model.nodes.get(entity.node)) : homes.endpoint(endpoint, list));
          drawing.shapes.get(key).hub = hub;
        }
        addEdge(drawing, model.towardsNode(entity) ? [key, entity.node] : [entity.node, key], endpoint.kind, entity);
      }
    }
    for (const id of users.keys()) {
      const matches = (model.endpoints.get(id).matches || []).filter((one) => drawing.shapes.has(one) && drawing.shapes.has(id));
      if (matches.length > MOST_MATCHES) continue;
      for (const other of matches) {
        const key = `${id} may be ${other}`;
        if (!drawing.edges.has(`${other} may be ${id}`)) drawing.edges.set(key, { key, source: id, target: other, kind: "maybe", entities: [], dashed: true });
      }
    }
  }

  /** Edges straight from node to node, through every endpoint that they share. */
  function addShortcuts(drawing, entities) {
    const sides = new Map();
    for (const entity of entities) {
      for (const id of [entity.endpoint, ...(model.endpoints.get(entity.endpoint).matches || [])]) {
        if (model.endpoints.get(entity.endpoint).resolution === "unknown") continue;
        if (!sides.has(id)) sides.set(id, { from: [], to: [] });
        sides.get(id)[model.towardsNode(entity) ? "to" : "from"].push(entity);
      }
    }
    for (const [id, { from, to }] of sides) {
      const kind = model.endpoints.get(id).kind;
      if (from.length * to.length > 2000) continue; // everyone with everyone: `/parameter_events`
      for (const one of from) for (const other of to) {
        if (one.node !== other.node) addEdge(drawing, [one.node, other.node], kind, one, other);
      }
    }
  }

  function addEdge(drawing, [source, target], kind, ...entities) {
    const key = `${source} > ${target} ${kind}`;
    const dashed = entities.some((one) => one.conditional || model.doubtful(one));
    const edge = drawing.edges.get(key) || { key, source, target, kind, entities: new Set(), dashed: true };
    entities.forEach((one) => edge.entities.add(one.id));
    edge.dashed = edge.dashed && dashed;
    drawing.edges.set(key, edge);
  }

  function addFrames(drawing, homes, view) {
    for (const shape of drawing.shapes.values()) {
      shape.parent = frameId(view, shape.home);
      addFrame(drawing, shape.home, homes, view);
    }
  }

  function addFrame(drawing, name, homes, view) {
    const id = frameId(view, name);
    if (id === null || drawing.frames.has(id)) return;
    const outer = homes.spaces ? names.above(name).find((space) => space !== name && space !== "/" && homes.spaces.has(space)) || null : null;
    drawing.frames.set(id, { key: id, name, outer, parent: frameId(view, outer) });
    addFrame(drawing, outer, homes, view);
  }

  /** A frame of a namespace around a single shape says nothing that its name does not say. */
  function dissolveSmall(drawing, view) {
    if (view.group !== "namespace") return;
    const inner = new Map([...drawing.frames.keys()].map((id) => [id, 0]));
    for (const { parent } of drawing.shapes.values()) if (parent) inner.set(parent, inner.get(parent) + 1);
    for (const { parent } of drawing.frames.values()) if (parent) inner.set(parent, inner.get(parent) + 1);
    for (const [id, number] of inner) {
      if (number > 1) continue;
      const { parent, outer } = drawing.frames.get(id);
      for (const one of [...drawing.shapes.values(), ...drawing.frames.values()]) {
        if (one.parent !== id) continue;
        one.parent = parent;
        one[one.outer === undefined ? "home" : "outer"] = outer;
      }
      drawing.frames.delete(id);
    }
  }

  /** A closed frame is one shape; what its inner shapes are joined to, it is joined to. */
  function collapse(drawing, id) {
    const frame = drawing.frames.get(id);
    const within = (one) => one !== null && one !== undefined && (one === id || within(drawing.frames.get(one)?.parent));
    if (!frame || within(frame.parent)) return;
    const gone = [...drawing.shapes.values()].filter((shape) => within(shape.parent));
    const standsFor = new Map(gone.map((shape) => [shape.key, id]));
    const rank = { error: 3, warning: 2, note: 1, null: 0 };
    const severity = gone.reduce((most, shape) => (rank[shape.severity] > rank[most] ? shape.severity : most), null);
    gone.forEach((shape) => drawing.shapes.delete(shape.key));
    for (const [key, one] of drawing.frames) if (within(one.parent) || key === id) drawing.frames.delete(key);
    const nodes = new Set(gone.filter((shape) => shape.kind === "node").map((shape) => shape.key)).size;
    drawing.shapes.set(id, { key: id, ref: id, kind: "group", name: frame.name, home: frame.outer, parent: frame.parent, hub: false, doubtful: false, severity, inside: names.plural(nodes, "node") });
    const edges = [...drawing.edges.values()];
    drawing.edges.clear();
    for (const edge of edges) {
      const source = standsFor.get(edge.source) || edge.source;
      const target = standsFor.get(edge.target) || edge.target;
      if (source === target) continue;
      const key = `${source} > ${target} ${edge.kind}`;
      const one = drawing.edges.get(key) || { ...edge, key, source, target, entities: new Set(), dashed: true };
      for (const entity of edge.entities) one.entities.add(entity);
      one.dashed = one.dashed && edge.dashed;
      drawing.edges.set(key, one);
    }
  }

  function label(drawing, view) {
    measure.font = rosward.look.FONT;
    for (const shape of drawing.shapes.values()) {
      const seen = view.group === "namespace" ? names.relative(shape.name, shape.home) : shape.name;
      const lines = [names.shortened(names.visible(seen), 38) + (shape.doubtful ? " ?" : "")];
      if (shape.inside) lines.push(shape.inside);
      if (shape.unknown) lines.push(shape.unknown);
      shape.label = plain(lines.join("\n"));
      shape.width = Math.ceil(Math.max(...lines.map((line) => measure.measureText(line).width)) + ROOM[shape.kind]);
      shape.height = shape.kind === "node" ? (shape.unknown ? 46 : 34) : shape.kind === "group" ? 46 : 28;
    }
    for (const frame of drawing.frames.values()) {
      frame.label = plain(names.shortened(names.visible(view.group === "namespace" ? names.relative(frame.name, frame.outer) : frame.name), 60));
    }
  }

  /** cytoscape takes a label such as `data(x)` for a reference to data; behind a sign without width it is text. */
  function plain(label) {
    return /^\s*\w+\s*\(/.test(label) ? "\u2060" + label : label;
  }

  return { picture, framesAround };
})();
