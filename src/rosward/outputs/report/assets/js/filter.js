// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which nodes, endpoints and entities are left under the filters?
rosward.filter = (() => {
  const { model } = rosward;
  const HUB = 12; // what is used more often than this brings nobody near

  /** {nodes, endpoints, entities}: sets of ids, for a record of `rosward.state`. */
  function shown(view) {
    let nodes = new Set(model.report.nodes.filter((node) => nodeFits(node, view)).map((node) => node.id));
    let entities = model.report.entities.filter((entity) => entityFits(entity, nodes, view));
    if (!view.loose) entities = withoutLooseEnds(entities);
    if (view.found) {
      const found = (id) => model.severityOf(id) !== null;
      const near = new Set(entities.filter((entity) => found(entity.endpoint)).map((entity) => entity.node));
      nodes = new Set([...nodes].filter((id) => found(id) || near.has(id)));
      entities = entities.filter((entity) => found(entity.id) || found(entity.endpoint));
    }
    if (view.focus !== null) ({ nodes, entities } = near(view.focus, view.depth, nodes, entities));
    return { nodes, endpoints: new Set(entities.map((one) => one.endpoint)), entities: new Set(entities.map((one) => one.id)) };
  }

  function nodeFits(node, view) {
    const inSpace = view.namespace === "/" || node.namespace === view.namespace || node.namespace.startsWith(view.namespace + "/");
    return inSpace && (view.package === "" || node.package === view.package);
  }

  function entityFits(entity, nodes, view) {
    return nodes.has(entity.node) && (view.system || !entity.system) && view[model.endpoints.get(entity.endpoint).kind];
  }

  /** Without the endpoints that have one side only: nobody listens, or nobody speaks. */
  function withoutLooseEnds(entities) {
    const sides = new Map();
    for (const entity of entities) {
      const side = model.towardsNode(entity) ? 1 : 2;
      for (const id of [entity.endpoint, ...(model.endpoints.get(entity.endpoint).matches || [])]) sides.set(id, (sides.get(id) || 0) | side);
    }
    return entities.filter((entity) => sides.get(entity.endpoint) === 3);
  }

  /** What is at most `depth` nodes away from a thing; an endpoint's own nodes are at distance 1. */
  function near(start, depth, nodes, entities) {
    const ofNode = grouped(entities, "node");
    const ofEndpoint = grouped(entities, "endpoint");
    const seenNodes = new Set();
    const seenEndpoints = new Set();
    let border = nodes.has(start) ? [start] : [];
    if (model.endpoints.has(start)) {
      seenEndpoints.add(start);
      border = (ofEndpoint.get(start) || []).map((one) => one.node);
      depth -= 1;
    }
    border.forEach((id) => seenNodes.add(id));
    for (; depth > 0; depth--) {
      const next = [];
      for (const node of border) {
        for (const { endpoint } of ofNode.get(node) || []) {
          seenEndpoints.add(endpoint);
          if (ofEndpoint.get(endpoint).length > HUB) continue; // everyone is near everyone through `/tf`
          for (const other of ofEndpoint.get(endpoint)) {
            if (seenNodes.has(other.node)) continue;
            seenNodes.add(other.node);
            next.push(other.node);
          }
        }
      }
      border = next;
    }
    return { nodes: seenNodes, entities: entities.filter((one) => seenNodes.has(one.node) && seenEndpoints.has(one.endpoint)) };
  }

  function grouped(entities, key) {
    const groups = new Map();
    for (const entity of entities) {
      if (!groups.has(entity[key])) groups.set(entity[key], []);
      groups.get(entity[key]).push(entity);
    }
    return groups;
  }

  return { shown };
})();
