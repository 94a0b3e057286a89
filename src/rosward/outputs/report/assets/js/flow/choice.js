// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which flows does the user want to see? One record, as `rosward.state` is one; who shows something of it listens.
rosward.choice = (() => {
  const { route, flows } = rosward;
  const DIRECTIONS = ["both", "up", "down", "off"];
  let current = Object.freeze({
    direction: "both", // what influences the open item, what it influences, both, or nothing
    weakest: 1, // the weakest strength that counts, as a number of `flows.STRENGTHS`
    way: Object.freeze([]), // the edges of the way that is read at the moment
    finding: null, // the finding whose way is shown while no item is open
  });
  const listeners = [];
  let known = null; // the last answer, with what was asked

  function set(change) {
    current = Object.freeze({ ...current, ...change });
    for (const listener of listeners) listener(current);
  }

  const open = (place) => place.one !== null || place.entities.length > 0;

  /** {up, down}: the searches for what is open, each null where it is not asked for; null where nothing is open. */
  function found() {
    const place = route.get();
    const { direction, weakest } = current;
    if (known?.place === place && known.direction === direction && known.weakest === weakest) return known.answer;
    const search = (forward) => flows.search(flows.starts(place, forward), forward, weakest);
    const answer = !open(place) || direction === "off" ? null : { up: direction === "down" ? null : search(false), down: direction === "up" ? null : search(true) };
    known = { place, direction, weakest, answer };
    return answer;
  }

  return {
    found, set,
    get: () => current,
    turn: () => set({ direction: DIRECTIONS[(DIRECTIONS.indexOf(current.direction) + 1) % DIRECTIONS.length] }),
    weaken: () => set({ weakest: (current.weakest + 1) % flows.STRENGTHS.length }),
    listen: (listener) => listeners.push(listener),
    /** An item that is opened takes the place of a way; whatever the address names, who listens here hears of it. */
    start: () => route.listen((place) => set({ way: Object.freeze([]), finding: open(place) ? null : current.finding })),
  };
})();
