// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which place of the report does the address name? `#n/robot/talker` is a node, `#t/chatter` a topic: links that people keep.
//
//     #graph  #policies  #findings      a view
//     #n/NAME  #t/NAME  #s/NAME  #a/NAME  a node, topic, service, action
//     #e/ID,ID                          entities: what an edge stands for
//     #p/PATH  #r/ID                    the policy of an enclave, one rule of a policy
//     #f/ID                             a finding
rosward.route = (() => {
  const { model } = rosward;
  const LETTERS = { node: "n", topic: "t", service: "s", action: "a" };
  const KINDS = { n: "node", t: "topic", s: "service", a: "action" };
  const VIEWS = ["graph", "policies", "findings"];
  const listeners = [];

  /** Names that two things have, or that do not begin with a slash, are given by their id. */
  const byName = new Map();
  for (const one of [...model.report.nodes, ...model.report.endpoints]) {
    const key = `${LETTERS[model.kindOf(one)]}${model.nameOf(one)}`;
    byName.set(key, byName.has(key) ? null : one);
  }
  const byPath = new Map(model.report.enclaves.map((one) => [one.path, one]));

  const written = (name) => name.split("/").map(encodeURIComponent).join("/");

  function to(one) {
    const letter = LETTERS[model.kindOf(one)];
    if (letter === undefined) return `#e/${one.id}`;
    const name = model.nameOf(one);
    return name.startsWith("/") && byName.get(letter + name) === one ? `#${letter}${written(name)}` : `#${letter}:${one.id}`;
  }

  const toEntities = (ids) => `#e/${[...ids].join(",")}`;
  const toEnclave = (enclave) => (enclave.path.startsWith("/") ? `#p${written(enclave.path)}` : `#p:${enclave.id}`);
  const toRule = (rule) => `#r/${rule.id}`;
  const toFinding = (finding) => `#f/${finding.id}`;

  /** {view, one, entities, enclave, rule, finding}: what an address names; the graph where it names nothing. */
  function read(fragment) {
    const nothing = { view: "graph", one: null, entities: [], enclave: null, rule: null, finding: null };
    let text = "";
    try {
      text = decodeURIComponent(fragment.slice(1));
    } catch {
      return nothing;
    }
    if (VIEWS.includes(text)) return { ...nothing, view: text };
    const [letter, id, name] = [text.slice(0, 1), text.slice(2), text.slice(1)];
    if (KINDS[letter]) {
      const one = text[1] === ":" ? model.thing(id) : byName.get(letter + name);
      return { ...nothing, one: one && model.kindOf(one) === KINDS[letter] ? one : null };
    }
    if (letter === "e") return { ...nothing, entities: id.split(",").map((part) => model.entities.get(part)).filter(Boolean) };
    if (letter === "p") return { ...nothing, view: "policies", enclave: (text[1] === ":" ? model.enclaves.get(id) : byPath.get(name)) || null };
    if (letter === "r") {
      const rule = model.rules.get(id) || null;
      return { ...nothing, view: "policies", rule, enclave: rule && model.enclaves.get(rule.enclave) };
    }
    if (letter === "f") return { ...nothing, view: "findings", finding: model.findings.get(id) || null };
    return nothing;
  }

  let current = read(location.hash);
  addEventListener("hashchange", () => {
    current = read(location.hash);
    listeners.forEach((listener) => listener(current));
  });

  return {
    to, toEntities, toEnclave, toRule, toFinding,
    get: () => current,
    go: (fragment) => { if (location.hash !== fragment) location.hash = fragment; },
    listen: (listener) => listeners.push(listener),
  };
})();
