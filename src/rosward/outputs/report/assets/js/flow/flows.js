// SPDX-License-Identifier: Apache-2.0
"use strict";
// What flows where? Contents are numbers; each edge is one source of one output of a node, or leads from what is sent to as what it arrives.
rosward.flows = (() => {
  const { model } = rosward;
  const { contents, places, nodes, meets } = model.report.flows;
  const STRENGTHS = ["data", "control", "trigger"];
  /** Which contents an entity sends, and which arrive at it. */
  const SENT = { publisher: ["topic", "tf", "log"], "service client": ["request"], "service server": ["response"], "action client": ["goal"], "action server": ["feedback", "result"] };
  const ARRIVING = { subscription: ["topic", "tf"], "service client": ["response"], "service server": ["request"], "action client": ["feedback", "result"], "action server": ["goal", "cancel"] };

  const edges = [];
  const out = contents.map(() => []);
  const into = contents.map(() => []);
  const ofNode = new Map(nodes.map((one) => [one.node, one]));
  const ofEndpoint = new Map();
  contents.forEach(({ endpoints }, number) => endpoints.forEach((id) => ofEndpoint.set(id, [...(ofEndpoint.get(id) || []), number])));
  for (const { node, outputs } of nodes) {
    for (const output of outputs) for (const [from, strength, assumed, way] of output.sources) add({ from, to: output.content, strength, assumed, node, way: way.length ? way : [output.place] });
  }
  for (const [from, to] of meets) add({ from, to, strength: 0, assumed: 0, node: null, way: [] });

  function add(edge) {
    edges.push(edge);
    out[edge.from].push(edge);
    into[edge.to].push(edge);
  }

  /**
   * What these reach, or, not `forward`, what reaches them: content to {strength, assumed, steps, by}, the strongest way of each, then the surest,
   * then the shortest; a way is as strong as its weakest step. A start is [content, node, strength]: with a node, the first step is one of that
   * node; the strength is how the content is part of what the search is about.
   */
  function search(starts, forward, weakest) {
    const reached = new Map();
    const only = new Map();
    const waiting = Array.from({ length: 2 * STRENGTHS.length }, () => []);
    const put = (strength, assumed, steps, item) => {
      const line = waiting[2 * strength + assumed];
      (line[steps] ||= []).push(item);
    };
    for (const [content, node, strength] of starts) {
      if (strength > weakest) continue;
      if (!only.has(content)) only.set(content, new Set());
      only.get(content).add(node);
      put(strength, 0, 0, [content, null]);
    }
    waiting.forEach((line, rank) => {
      for (let steps = 0; steps < line.length; steps++) {
        for (const [content, by] of line[steps] || []) {
          if (reached.has(content)) continue;
          const here = { strength: rank >> 1, assumed: rank & 1, steps, by };
          reached.set(content, here);
          for (const edge of next(content, here, only, forward, weakest)) {
            const target = forward ? edge.to : edge.from;
            if (!reached.has(target)) put(Math.max(here.strength, edge.strength), here.assumed | edge.assumed, steps + 1, [target, edge]);
          }
        }
      }
    });
    return { reached, edges: (content) => next(content, reached.get(content), only, forward, weakest) };
  }

  /** The edges by which a search goes on. */
  function next(content, here, only, forward, weakest) {
    const first = here.by === null ? only.get(content) : null;
    const free = !first || first.has(null);
    return (forward ? out : into)[content].filter((edge) => edge.strength <= weakest && (free || edge.node === null || first.has(edge.node)));
  }

  /** The edges between a start and what was reached, in the direction of the flow. */
  function way(reached, content, forward) {
    const found = [];
    for (let edge = reached.get(content).by; edge; edge = reached.get(forward ? edge.from : edge.to).by) found.push(edge);
    return forward ? found.reverse() : found;
  }

  /** Where a search begins for what the address names: a node, an endpoint, entities. */
  function starts({ one, entities }, forward) {
    if (one && model.kindOf(one) === "node") {
      const outputs = ofNode.get(one.id)?.outputs || [];
      return forward ? outputs.map((output) => [output.content, null, 0]) : outputs.flatMap((output) => output.sources.map(([content, strength]) => [content, null, strength]));
    }
    if (one) return (ofEndpoint.get(one.id) || []).map((content) => [content, null, 0]);
    return entities.flatMap((entity) => [
      ...ends(entity, "sent").map((content) => [content, forward ? null : entity.node, 0]),
      ...ends(entity, "in").map((content) => [content, forward ? entity.node : null, 0]),
    ]);
  }

  /** The contents that an entity sends, or that arrive at it. */
  function ends(entity, side) {
    const kinds = (side === "sent" ? SENT : ARRIVING)[entity.kind] || [];
    return (ofEndpoint.get(entity.endpoint) || []).filter((content) => contents[content].side === side && kinds.includes(contents[content].kind));
  }

  /** The steps in nodes that a finding tells of: those whose lines are all among its own; no weaker ones than it takes to have all of these. */
  function told(finding) {
    const key = ({ file, line }) => `${line} ${file}`;
    const lines = new Set((finding.way || []).map(key));
    const about = new Set(finding.subjects);
    const fitting = edges.filter((edge) => about.has(edge.node) && edge.way.every((number) => lines.has(key(place(number)))));
    const upTo = (weakest) => fitting.filter((edge) => edge.strength <= weakest);
    const whole = (some) => new Set(some.flatMap((edge) => edge.way)).size >= lines.size;
    return [0, 1].map(upTo).find(whole) || fitting;
  }

  function place(number) {
    const [file, line] = places[number];
    return { file, line };
  }

  return { STRENGTHS, SENT, ARRIVING, contents, ofNode, search, way, starts, told, place };
})();
