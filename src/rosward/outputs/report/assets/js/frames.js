// SPDX-License-Identifier: Apache-2.0
"use strict";
// In which frames does each thing stand? Namespaces within namespaces; in a namespace the containers, that is, processes of several
// nodes; where many nodes are left, their packages; and one frame around many of a kind: /robot1 … /robot83 are in /robot*.
rosward.frames = (() => {
  const { model, names } = rosward;
  const CROWD = 16; // so many nodes side by side are told apart by their packages
  const FAMILY = 6; // so many frames whose names differ by a number are one

  /**
   * {all, homes, endpoint}: the frames by their key, the key of the innermost frame of each node, and a function for that of an endpoint
   * with these users. A frame is {key, name, space, parent}; names in it are written without `space`.
   */
  function around(ids, view) {
    const made = { all: new Map(), homes: new Map(), endpoint: () => null };
    if (view.group === "none") return made;
    const nodes = [...ids].map((id) => model.nodes.get(id));
    if (view.group === "namespace") namespaces(nodes, made);
    else flat(nodes, made, view.group === "process" ? (node) => node.process || "unknown process" : (node) => model.enclaves.get(node.enclave)?.path || null);
    return made;
  }

  function add(made, key, name, space, parent) {
    if (!made.all.has(key)) made.all.set(key, { key, name, space, parent });
    return key;
  }

  function flat(nodes, made, nameOf) {
    for (const node of nodes) {
      const name = nameOf(node);
      made.homes.set(node.id, name === null ? null : add(made, `frame ${name}`, name, null, null));
    }
    made.endpoint = (_, users) => common(made, users);
  }

  /** The frame that all nodes of these entities are in. */
  function common(made, users) {
    const [first, ...more] = new Set(users.map((one) => made.homes.get(one.node)));
    return more.length ? null : first;
  }

  function namespaces(nodes, made) {
    const spaces = new Set(nodes.flatMap((node) => names.above(node.namespace)));
    const frameOf = (space) => {
      if (space === "/") return null;
      const key = `frame ${space}`;
      return made.all.has(key) ? key : add(made, key, space, space, frameOf(names.above(space)[1]));
    };
    const inside = new Map();
    for (const node of nodes) {
      frameOf(node.namespace);
      if (!inside.has(node.namespace)) inside.set(node.namespace, []);
      inside.get(node.namespace).push(node);
    }
    for (const [space, members] of inside) parts(space, frameOf(space), members, made);
    families(made);
    made.endpoint = (endpoint, users) => {
      const home = frameOf(names.above(endpoint.name).slice(1).find((space) => spaces.has(space)) || "/");
      const shared = common(made, users);
      return shared && made.all.get(shared).within === home ? shared : home;
    };
  }

  /** What is right in a namespace: nodes of one process or, among many, of one package together. */
  function parts(space, parent, members, made) {
    const together = (list, keyOf, name) => {
      const alone = [];
      for (const [key, some] of grouped(list, keyOf)) {
        if (key === null || some.length < 2 || some.length === members.length) alone.push(...some);
        else {
          const frame = add(made, `frame ${space} ${key}`, name(key, some), space === "/" ? null : space, parent);
          made.all.get(frame).within = parent;
          some.forEach((node) => made.homes.set(node.id, frame));
        }
      }
      return alone;
    };
    let alone = together(members, (node) => node.process, container);
    if (alone.length > CROWD) alone = together(alone, (node) => node.package, (key) => key);
    alone.forEach((node) => made.homes.set(node.id, parent));
  }

  /** What its user calls a process: by the node that loads the others, or by its executable. */
  function container(process, members) {
    const loads = (node) => node.entities.some((id) => model.entities.get(id).name.endsWith("/_container/load_node"));
    const executable = process.slice(process.lastIndexOf("/") + 1);
    return members.find(loads)?.name || (executable.startsWith("*") ? "unknown process" : executable);
  }

  function families(made) {
    const alike = ({ name, parent }) => (/\d/.test(name) ? `${parent} ${name.replace(/\d+/g, "*")}` : null);
    for (const [key, some] of grouped([...made.all.values()].filter((one) => one.name === one.space), alike)) {
      if (key === null || some.length < FAMILY) continue;
      const { name, parent } = some[0];
      const frame = add(made, `frame ${key}`, name.replace(/\d+/g, "*"), made.all.get(parent)?.space || null, parent);
      for (const one of some) one.parent = frame;
    }
  }

  function grouped(list, keyOf) {
    const groups = new Map();
    for (const one of list) {
      const key = keyOf(one);
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(one);
    }
    return groups;
  }

  /** Takes away frames around nothing or a single thing, which say nothing that its name does not say. `things` have a `parent`. */
  function dissolve(all, things) {
    const inner = new Map([...all.keys()].map((key) => [key, 0]));
    const count = ({ parent }) => { if (parent) inner.set(parent, inner.get(parent) + 1); };
    things.forEach(count);
    const depth = (key) => (key ? 1 + depth(all.get(key).parent) : 0);
    const deepest = [...all.keys()].map((key) => [depth(key), key]).sort(([a], [b]) => b - a);
    for (const [, key] of deepest) if (inner.get(key)) count(all.get(key)); // a frame around nothing does not count
    const gone = new Map([...all].filter(([key]) => inner.get(key) < 2).map(([key, one]) => [key, one.parent]));
    const left = (key) => { let at = key; while (gone.has(at)) at = gone.get(at); return at; };
    for (const key of gone.keys()) all.delete(key);
    for (const one of [...all.values(), ...things]) one.parent = left(one.parent);
  }

  return { around, dissolve };
})();
