// SPDX-License-Identifier: Apache-2.0
"use strict";
// Who talks with whom, when endpoints are not drawn? One edge between two shapes, for all that goes between them.
rosward.bundles = (() => {
  const { model } = rosward;
  const MOST = 3; // edges for each shape that takes part: what needs more joins everyone with everyone, as `/tf` does

  /** {edges, crowds}: the edges between what stands for the nodes of these entities, and how many endpoints join too many for edges. */
  function between(entities, standsFor) {
    const bundles = new Map();
    let crowds = 0;
    for (const [id, { from, to }] of sides(entities, standsFor)) {
      if (from.size * to.size > MOST * (from.size + to.size)) {
        crowds += 1;
        continue;
      }
      const { kind } = model.endpoints.get(id);
      for (const [source, some] of from) for (const [target, others] of to) if (source !== target) add(bundles, source, target, kind, some, others);
    }
    return { edges: [...bundles.values()], crowds };
  }

  /** For each endpoint the shapes on its two sides, each with its entities. */
  function sides(entities, standsFor) {
    const found = new Map();
    for (const entity of entities) {
      const endpoint = model.endpoints.get(entity.endpoint);
      if (endpoint.resolution === "unknown") continue;
      for (const id of [endpoint.id, ...(endpoint.matches || [])]) {
        if (!found.has(id)) found.set(id, { from: new Map(), to: new Map() });
        const side = found.get(id)[model.towardsNode(entity) ? "to" : "from"];
        const shape = standsFor.get(entity.node);
        if (!side.has(shape)) side.set(shape, []);
        side.get(shape).push(entity);
      }
    }
    return found;
  }

  function add(bundles, source, target, kind, some, others) {
    const turned = `${target} with ${source}`;
    const key = bundles.has(turned) ? turned : `${source} with ${target}`;
    const bundle = bundles.get(key) || { key, source, target, kind, both: false, entities: new Set(), dashed: true };
    if (bundle.kind !== kind) bundle.kind = "mixed";
    if (key === turned) bundle.both = true;
    const sure = (one) => !one.conditional && !model.doubtful(one);
    if (some.some(sure) && others.some(sure)) bundle.dashed = false;
    for (const one of some) bundle.entities.add(one.id);
    for (const one of others) bundle.entities.add(one.id);
    bundles.set(key, bundle);
  }

  return { between };
})();
