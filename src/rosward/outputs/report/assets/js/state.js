// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which part of the system does the user want to see, and how? One record; who shows something of it listens.
rosward.state = (() => {
  const DEFAULTS = Object.freeze({
    group: "namespace", // namespace, process, enclave, none
    detail: "all", // all: endpoints are drawn; nodes: nodes only, with edges through what they share
    topic: true, service: true, action: true, // which kinds are drawn
    system: false, // what the client library makes
    found: false, // only what has findings, and its neighbours
    loose: true, // endpoints with one side only
    namespace: "/", package: "", // "" is every package
    focus: null, depth: 1, // the id of a thing, and how many nodes away
    collapsed: Object.freeze([]), // ids of closed frames
  });
  let current = DEFAULTS;
  const listeners = [];

  function set(change) {
    current = Object.freeze({ ...current, ...change });
    for (const listener of listeners) listener(current);
  }

  return {
    DEFAULTS,
    get: () => current,
    set,
    /** What is near a thing, with all that goes between; null ends it. */
    focus: (id) => set(id === null ? { focus: null } : { focus: id, detail: "all" }),
    reset: () => set({ ...DEFAULTS, group: current.group, detail: current.detail, collapsed: current.collapsed }),
    listen: (listener) => listeners.push(listener),
    /** Whether less than everything is asked for. */
    narrowed: () => ["topic", "service", "action", "system", "found", "loose", "namespace", "package", "focus"].some(
      (key) => current[key] !== DEFAULTS[key]),
  };
})();
