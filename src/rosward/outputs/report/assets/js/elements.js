// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which shapes, frames and edges make the picture of what is shown? No positions yet, and nothing of the drawing library.
rosward.elements = (() => {
  const { model, names, frames, bundles } = rosward;
  // used by more nodes than this, an endpoint is drawn beside each of them: one knot would hide the rest; of different frames, by fewer
  const HUB = 12;
  const HUB_ACROSS = 4;
  const MOST_MATCHES = 4; // a pattern that may be more endpoints than this says nothing by its edges
  const RANK = { error: 3, warning: 2, note: 1, null: 0 };
  const measure = document.createElement("canvas").getContext("2d");
  const ROOM = { node: 34, topic: 18, service: 34, action: 34, group: 30 };

  /** {shapes, frames, edges, crowds} for the sets of `rosward.filter` and the record of `rosward.state`. */
  function picture(shown, view) {
    const around = frames.around(shown.nodes, view);
    const entities = model.report.entities.filter((one) => shown.entities.has(one.id));
    const drawing = { shapes: new Map(), edges: new Map() };
    for (const id of shown.nodes) addShape(drawing, id, model.nodes.get(id), around.homes.get(id));
    if (view.detail === "all") addEndpoints(drawing, entities, around);
    if (view.group === "namespace") frames.dissolve(around.all, [...drawing.shapes.values()]);
    const standsFor = close(drawing, around.all, view);
    const { edges, crowds } = view.detail === "all" ? { edges: joined(drawing.edges.values(), standsFor), crowds: 0 } : bundles.between(entities, standsFor);
    label(drawing, around.all, view);
    return { shapes: [...drawing.shapes.values()], frames: [...around.all.values()], edges, crowds };
  }

  /** The keys of the frames that a thing is in, were they all open. */
  function framesAround(id, shown, view) {
    const { shapes, frames: all } = picture(shown, { ...view, collapsed: [] });
    const parents = new Map(all.map((one) => [one.key, one.parent]));
    const around = [];
    for (let at = shapes.find((one) => one.ref === id)?.parent; at; at = parents.get(at)) around.push(at);
    return around;
  }

  /** The keys of the frames in a frame. */
  function framesIn(key, shown, view) {
    const { all } = frames.around(shown.nodes, view);
    const within = (one) => one !== null && (one === key || within(all.get(one).parent));
    return [...all.keys()].filter((one) => one !== key && within(one));
  }

  function addShape(drawing, key, thing, parent) {
    drawing.shapes.set(key, {
      key, ref: thing.id, kind: model.kindOf(thing), name: model.nameOf(thing), hub: false, parent: parent || null,
      doubtful: model.doubtful(thing) || model.nameOf(thing).includes("*"), severity: model.severityOf(thing.id), system: thing.system === true, assumed: thing.assumed === true,
      unknown: thing.interface !== "unknown" ? "" : thing.lacks.some((why) => why.includes("C++")) ? "C++, unknown" : "unknown",
    });
  }

  function isHub(entities, around) {
    const nodes = [...new Set(entities.map((one) => one.node))];
    if (nodes.length > HUB) return true;
    return nodes.length > HUB_ACROSS && new Set(nodes.map((id) => around.homes.get(id))).size > 1;
  }

  function addEndpoints(drawing, entities, around) {
    const users = new Map();
    for (const entity of entities) {
      if (!users.has(entity.endpoint)) users.set(entity.endpoint, []);
      users.get(entity.endpoint).push(entity);
    }
    for (const [id, list] of users) {
      const endpoint = model.endpoints.get(id);
      const hub = isHub(list, around);
      for (const entity of list) {
        // of two names of which nothing is known nobody can say that they are one name: each node has its own
        const own = hub || endpoint.resolution === "unknown";
        const key = own ? `${id} at ${entity.node}` : id;
        if (!drawing.shapes.has(key)) {
          addShape(drawing, key, endpoint, own ? around.homes.get(entity.node) : around.endpoint(endpoint, list));
          drawing.shapes.get(key).hub = hub;
        }
        addEdge(drawing.edges, model.towardsNode(entity) ? [key, entity.node] : [entity.node, key], endpoint.kind, entity);
      }
    }
    for (const id of users.keys()) {
      const matches = (model.endpoints.get(id).matches || []).filter((one) => drawing.shapes.has(one) && drawing.shapes.has(id));
      if (matches.length > MOST_MATCHES) continue;
      for (const other of matches) {
        const key = `${id} may be ${other}`;
        if (!drawing.edges.has(`${other} may be ${id}`)) drawing.edges.set(key, { key, source: id, target: other, kind: "maybe", entities: new Set(), dashed: true });
      }
    }
  }

  function addEdge(edges, [source, target], kind, entity) {
    const key = `${source} > ${target} ${kind}`;
    const edge = edges.get(key) || { key, source, target, kind, entities: new Set(), dashed: true };
    edge.entities.add(entity.id);
    edge.dashed = edge.dashed && (entity.conditional || model.doubtful(entity));
    edges.set(key, edge);
  }

  /** Closed frames become one shape each; gives for each shape that there was what stands for it now. */
  function close(drawing, all, view) {
    const closed = new Set(view.collapsed.filter((key) => all.has(key)));
    const outermost = new Map();
    const closedAround = (key) => {
      if (!key) return null;
      if (!outermost.has(key)) outermost.set(key, closedAround(all.get(key).parent) || (closed.has(key) ? key : null));
      return outermost.get(key);
    };
    const standsFor = new Map();
    const inside = new Map();
    for (const shape of [...drawing.shapes.values()]) {
      const frame = closedAround(shape.parent);
      standsFor.set(shape.key, frame || shape.key);
      if (!frame) continue;
      drawing.shapes.delete(shape.key);
      if (!inside.has(frame)) inside.set(frame, { nodes: 0, severity: null });
      const one = inside.get(frame);
      if (shape.kind === "node") one.nodes += 1;
      if (RANK[shape.severity] > RANK[one.severity]) one.severity = shape.severity;
    }
    for (const [key, { nodes, severity }] of inside) {
      const { name, parent } = all.get(key);
      drawing.shapes.set(key, { key, ref: key, kind: "group", name, parent, hub: false, doubtful: false, severity, count: nodes, inside: names.plural(nodes, "node") });
    }
    for (const key of [...all.keys()]) if (closedAround(key)) all.delete(key);
    return standsFor;
  }

  /** The edges between what stands for their ends. */
  function joined(edges, standsFor) {
    const between = new Map();
    for (const edge of edges) {
      const source = standsFor.get(edge.source);
      const target = standsFor.get(edge.target);
      if (source === target) continue;
      const key = `${source} > ${target} ${edge.kind}`;
      const one = between.get(key) || { ...edge, key, source, target, entities: new Set(), dashed: true };
      edge.entities.forEach((id) => one.entities.add(id));
      one.dashed = one.dashed && edge.dashed;
      between.set(key, one);
    }
    return [...between.values()];
  }

  function label(drawing, all, view) {
    measure.font = rosward.look.FONT;
    const within = (parent) => (view.group === "namespace" && parent ? all.get(parent).space : null);
    for (const shape of drawing.shapes.values()) {
      const seen = names.relative(shape.name, within(shape.parent));
      const lines = [names.shortened(names.visible(seen), 38) + (shape.doubtful ? " ?" : "")];
      if (shape.inside) lines.push(shape.inside);
      if (shape.unknown) lines.push(shape.unknown);
      shape.label = plain(lines.join("\n"));
      shape.width = Math.ceil(Math.max(...lines.map((line) => measure.measureText(line).width)) + ROOM[shape.kind]);
      shape.height = shape.kind === "node" ? (shape.unknown ? 46 : 34) : shape.kind === "group" ? 46 : 28;
    }
    for (const frame of all.values()) {
      frame.label = plain(names.shortened(names.visible(names.relative(frame.name, within(frame.parent))), 60));
      frame.labelWidth = measure.measureText(frame.label).width;
    }
  }

  /** cytoscape takes a label such as `data(x)` for a reference to data; behind a sign without width it is text. */
  function plain(text) {
    return /^\s*\w+\s*\(/.test(text) ? "\u2060" + text : text;
  }

  return { picture, framesAround, framesIn };
})();
