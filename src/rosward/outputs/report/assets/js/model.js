// SPDX-License-Identifier: Apache-2.0
"use strict";
// What is in the document, found by id, and who belongs to whom?
rosward.model = (() => {
  const { report } = unpacked;
  /** robot2 before robot10. The names are made comparable once: a collator is asked half a million times of a large system. */
  function sorted(list, nameOf) {
    const keys = new Map(list.map((one) => [one, nameOf(one).toLowerCase().replace(/\d+/g, (digits) => digits.padStart(9, "0"))]));
    list.sort((a, b) => (keys.get(a) < keys.get(b) ? -1 : keys.get(a) > keys.get(b) ? 1 : 0));
    return list;
  }
  sorted(report.nodes, (one) => one.fqn);
  sorted(report.endpoints, (one) => one.name);
  sorted(report.enclaves, (one) => one.path);
  const byId = (list) => new Map(list.map((one) => [one.id, one]));
  const nodes = byId(report.nodes);
  const endpoints = byId(report.endpoints);
  const entities = byId(report.entities);
  const enclaves = byId(report.enclaves);
  const rules = byId(report.rules);
  const findings = byId(report.findings);
  const WEIGHT = { error: 3, warning: 2, note: 1 };
  const TOWARDS_NODE = new Set(["subscription", "service server", "action server"]);

  /** The entities of each endpoint, in the order of the document. */
  const users = new Map(report.endpoints.map((one) => [one.id, []]));
  for (const entity of report.entities) users.get(entity.endpoint)?.push(entity);

  /** A thing of any kind by its id: ids are unique within a document. */
  function thing(id) {
    return nodes.get(id) || endpoints.get(id) || entities.get(id) || null;
  }

  function kindOf(one) {
    if (nodes.has(one.id)) return "node";
    return endpoints.has(one.id) ? one.kind : "entity";
  }

  function nameOf(one) {
    return one.fqn === undefined ? one.name : one.fqn;
  }

  /** What there is to read: one finding for each cause, and the others of it by its id. */
  const causes = report.findings.filter((one) => !one.first);
  const sameCause = new Map(causes.map((one) => [one.id, []]));
  for (const finding of report.findings) if (finding.first) sameCause.get(finding.first).push(finding);

  /** The findings of a node or endpoint, with those of its entities; the heaviest first. */
  const about = new Map();
  for (const finding of report.findings) {
    for (const id of finding.subjects) {
      const entity = entities.get(id);
      for (const subject of entity ? [id, entity.node, entity.endpoint] : [id]) {
        if (!about.has(subject)) about.set(subject, new Set());
        about.get(subject).add(finding);
      }
    }
  }

  function findingsOf(id) {
    return [...(about.get(id) || [])].sort((a, b) => WEIGHT[b.severity] - WEIGHT[a.severity]);
  }

  function severityOf(id) {
    const heaviest = findingsOf(id)[0];
    return heaviest ? heaviest.severity : null;
  }

  /** Whether this entity's data flow leads from the endpoint to its node. */
  function towardsNode(entity) {
    return TOWARDS_NODE.has(entity.kind);
  }

  function doubtful(one) {
    return one.resolution === "pattern" || one.resolution === "unknown";
  }

  /** The line of a rule in the policy of its enclave, from 0; -1 where it has none. */
  function lineOf(rule) {
    return enclaves.get(rule.enclave).policy.findIndex((line) => line.rule === rule.id);
  }

  const count = (words) => {
    const numbers = new Map();
    for (const word of words) numbers.set(word, (numbers.get(word) || 0) + 1);
    return sorted([...numbers], ([word]) => word);
  };
  /** Each namespace with the number of nodes in it or below it, and each package with the number of its nodes. */
  const namespaces = count(report.nodes.flatMap((node) => rosward.names.above(node.namespace)));
  const packages = count(report.nodes.map((node) => node.package).filter((name) => name !== null));

  return {
    report, nodes, endpoints, entities, enclaves, rules, findings, causes, sameCause, users, namespaces, packages,
    thing, kindOf, nameOf, findingsOf, severityOf, towardsNode, doubtful, lineOf,
  };
})();
