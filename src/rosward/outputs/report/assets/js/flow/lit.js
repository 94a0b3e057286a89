// SPDX-License-Identifier: Apache-2.0
"use strict";
// What of the drawing lights up? The connections through which something flows, as strongly as it does, and what they join.
rosward.lit = (() => {
  const { model, route, graph, look, flows, choice } = rosward;
  const CLASSES = ["flow", "aside", "flow-assumed", "flow-way", "against", "along", ...flows.STRENGTHS.map((word) => `flow-${word}`)];
  const listeners = [];
  /** The entities of a node at an endpoint. */
  const entitiesAt = new Map();
  for (const one of model.report.entities) {
    const key = `${one.node} ${one.endpoint}`;
    entitiesAt.set(key, [...(entitiesAt.get(key) || []), one]);
  }
  const LARGEST = 1.25; // zoom
  let waiting = false;
  let shown = null;

  const plain = look.style; // without flows; the graph asks `look` again with each theme
  look.style = () => [...plain(), ...style()];

  function style() {
    const colour = (strength) => look.colour(`flow-${strength}`);
    const lines = { data: { "line-style": "solid", width: 3.4 }, control: { "line-style": "dashed", "line-dash-pattern": [9, 5], width: 2.8 }, trigger: { "line-style": "dashed", "line-dash-pattern": [2, 5], width: 2.4 } };
    return [
      { selector: ".aside", style: { opacity: 0.2 } },
      { selector: ".aside.lit, .aside.hit", style: { opacity: 1 } },
      { selector: "edge.flow", style: { opacity: 1, "z-index": 8, "arrow-scale": 1 } },
      ...flows.STRENGTHS.map((one) => ({ selector: `edge.flow-${one}`, style: { ...lines[one], "line-color": colour(one), "target-arrow-color": colour(one), "source-arrow-color": colour(one) } })),
      ...flows.STRENGTHS.map((one) => ({ selector: `node.shape.flow-${one}`, style: { "border-color": colour(one), "border-width": 3, "z-index": 8 } })),
      { selector: "edge.against", style: { "source-arrow-shape": "triangle", "target-arrow-shape": "none" } },
      { selector: "edge.against.along", style: { "target-arrow-shape": "triangle" } },
      { selector: "edge.flow-assumed", style: { "target-arrow-fill": "hollow", "source-arrow-fill": "hollow" } },
      { selector: "edge.flow-way", style: { width: 5, "z-index": 12, "underlay-color": colour("data"), "underlay-opacity": 0.22, "underlay-padding": 5 } },
      { selector: "node.shape.flow-way", style: { "border-width": 5 } },
      { selector: ".flow.faded", style: { opacity: 0.16 } },
    ];
  }

  /** {things, entities}: each id to how it is part of a flow; null where nothing is asked for. */
  function light() {
    const record = { things: new Map(), entities: new Map() };
    const place = route.get();
    const found = choice.found();
    const finding = !found && choice.get().finding && model.findings.get(choice.get().finding);
    if (finding) flows.told(finding).forEach((edge) => step(record, edge, edge.strength, edge.assumed, true));
    else if (!found) return null;
    for (const search of finding ? [] : [found.up, found.down]) {
      for (const [content, { strength, assumed }] of search?.reached || []) {
        for (const edge of search.edges(content)) step(record, edge, Math.max(strength, edge.strength), assumed | edge.assumed, false);
      }
    }
    for (const edge of choice.get().way) step(record, edge, 2, 1, true); // it is found as strong as it is
    if (place.one && model.kindOf(place.one) === "node") ownEnds(record, place.one, found);
    if (!record.things.size) return null;
    for (const one of place.one ? [place.one.id] : place.entities.flatMap(({ node, endpoint }) => [node, endpoint])) if (!record.things.has(one)) note(record.things, one, 0, 0, false);
    return record;
  }

  /** Of the chosen node all that it sends or uses takes part, also where the search begins there. */
  function ownEnds(record, node, found) {
    const { weakest } = choice.get();
    for (const { content, sources } of flows.ofNode.get(node.id)?.outputs || []) {
      if (found?.down) end(record, node.id, content, "sent", 0, 0, false);
      for (const [from, strength, assumed] of found?.up ? sources : []) if (strength <= weakest) end(record, node.id, from, "in", strength, assumed, false);
    }
  }

  function step(record, edge, strength, assumed, way) {
    if (edge.node === null) {
      for (const content of [edge.from, edge.to]) drawn(record, content, strength, assumed, way);
      return;
    }
    note(record.things, edge.node, strength, assumed, way);
    end(record, edge.node, edge.from, "in", strength, assumed, way);
    end(record, edge.node, edge.to, "sent", strength, assumed, way);
  }

  function drawn(record, content, strength, assumed, way) {
    for (const id of flows.contents[content].endpoints) note(record.things, id, strength, assumed, way);
  }

  /** A content at a node: its endpoint, and the entities through which it goes. */
  function end(record, node, content, side, strength, assumed, way) {
    const { kind, endpoints } = flows.contents[content];
    const kinds = side === "sent" ? flows.SENT : flows.ARRIVING;
    for (const id of endpoints) {
      const entities = (entitiesAt.get(`${node} ${id}`) || []).filter((one) => kinds[one.kind]?.includes(kind));
      if (entities.length) note(record.things, id, strength, assumed, way);
      for (const entity of entities) {
        const one = note(record.entities, entity.id, strength, assumed, way);
        if (model.towardsNode(entity) === (side === "in")) one.along = true;
        else one.against = true;
      }
    }
  }

  /** The strongest counts, and of these the surest. */
  function note(map, id, strength, assumed, way) {
    const one = map.get(id) || { rank: Infinity, way: false, along: false, against: false };
    one.rank = Math.min(one.rank, 2 * strength + assumed);
    one.way ||= way;
    map.set(id, one);
    return one;
  }

  const classes = ({ rank, way, along, against }) =>
    ["flow", `flow-${flows.STRENGTHS[rank >> 1]}`, rank & 1 && "flow-assumed", way && "flow-way", along && "along", against && "against"].filter(Boolean).join(" ");

  function update() {
    const cy = graph.library();
    const record = light();
    shown = record;
    cy.batch(() => {
      cy.elements(".flow, .aside").removeClass(CLASSES.join(" "));
      if (record === null) return;
      const edges = new Map(graph.picture().edges.map((one) => [one.key, joined(one, record)]));
      const alike = new Map(); // thousands of elements have a few looks
      const looks = (element, one) => {
        const words = one ? classes(one) : "aside";
        if (!alike.has(words)) alike.set(words, []);
        alike.get(words).push(element);
      };
      cy.edges().forEach((edge) => looks(edge, edges.get(edge.id())));
      cy.nodes(".shape").forEach((node) => looks(node, ofShape(node, record, edges)));
      for (const [words, elements] of alike) cy.collection(elements).addClass(words);
    });
    listeners.forEach((listener) => listener());
  }

  /** How an edge of the drawing takes part; one that joins two nodes only where both of its sides do, at one endpoint. */
  function joined(edge, record) {
    const found = [...edge.entities].map((id) => [model.entities.get(id), record.entities.get(id)]).filter(([, one]) => one);
    const between = model.nodes.has(edge.source) && model.nodes.has(edge.target);
    const sides = new Map();
    for (const [entity] of found) {
      for (const id of [entity.endpoint, ...(model.endpoints.get(entity.endpoint).matches || [])]) sides.set(id, (sides.get(id) || 0) | (model.towardsNode(entity) ? 1 : 2));
    }
    const kept = between ? found.filter(([entity]) => [entity.endpoint, ...(model.endpoints.get(entity.endpoint).matches || [])].some((id) => sides.get(id) === 3)) : found;
    if (!kept.length) return edge.kind === "maybe" && [edge.source, edge.target].every((id) => record.things.has(id)) ? { rank: 0, way: false } : null;
    return {
      rank: Math.min(...kept.map(([, one]) => one.rank)), way: kept.some(([, one]) => one.way),
      along: kept.some(([, one]) => one.along), against: kept.some(([, one]) => one.against),
    };
  }

  /** A closed frame takes part where something goes in or out; a topic that is drawn beside each of its nodes, where its edge does. */
  function ofShape(node, record, edges) {
    const one = record.things.get(node.data("ref"));
    if (one && !node.hasClass("hub")) return one;
    const through = node.connectedEdges().toArray().map((edge) => edges.get(edge.id())).filter(Boolean);
    if (!through.length || (!one && !node.hasClass("group"))) return null;
    return { rank: one ? one.rank : Math.min(...through.map((each) => each.rank)), way: through.some((each) => each.way) };
  }

  /** Once for all that happens before the next picture. */
  function soon() {
    if (waiting) return;
    waiting = true;
    queueMicrotask(() => {
      waiting = false;
      update();
    });
  }

  function start() {
    graph.restyle();
    graph.library().on("add", soon); // a drawing that is made anew
    choice.listen(soon);
    soon();
  }

  return {
    start,
    shown: () => shown,
    listen: (listener) => listeners.push(listener),
    /** All that is lit, in view. */
    fit: () => {
      const cy = graph.library();
      const lit = cy.elements(".flow");
      if (lit.empty()) return;
      cy.fit(lit, 40);
      if (cy.zoom() > LARGEST) cy.zoom(LARGEST).center(lit);
    },
  };
})();
