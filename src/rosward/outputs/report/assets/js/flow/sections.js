// SPDX-License-Identifier: Apache-2.0
"use strict";
// What the panel says of flows: of a node what each of its outputs is made of, of everything what influences it and what it influences.
rosward.sections = (() => {
  const { model, route, dom, names, flows, choice, ways } = rosward;
  const { el, icon } = dom;
  const FIRST = 40; // of a long list; the rest on demand
  const panel = document.getElementById("panel");
  const OUTSIDE = new Set(["timer", "thread", "main", "parameters"]); // events, which are no content

  /** Fills in what the panel does not have yet, whenever it shows something else. */
  function complete() {
    const content = panel.querySelector(".content");
    const place = route.get();
    if (!content || content.querySelector(".flows") || !(place.one || place.entities.length)) return;
    const facts = place.one ? content.querySelector(":scope > dl") : null;
    const box = el("div", { class: "flows" });
    fill(box, place);
    if (facts) facts.after(box);
    else content.append(box);
  }

  function fill(box, place) {
    const node = place.one && model.kindOf(place.one) === "node" ? place.one : null;
    const found = choice.found();
    const outputs = node && box.querySelector(":scope > .made-of"); // what is open in it stays so
    dom.fill(box, outputs || (node && madeOf(node)), found?.up && reached(found.up, false, place), found?.down && reached(found.down, true, place));
  }

  function again() {
    const box = panel.querySelector(".flows");
    if (box) fill(box, route.get());
  }

  function madeOf(node) {
    const own = flows.ofNode.get(node.id);
    const outputs = own?.outputs || [];
    return el("section", { class: "made-of" }, el("h3", {}, "What each output is made of ", el("span", { class: "number" }, outputs.length)),
      own && !own.followed ? doubt("This node was not analysed: each output may hold each input.") : null,
      own?.followed && !own.complete ? doubt("A limit of the analysis was reached: outputs may hold every input.") : null,
      outputs.length ? some(outputs, (one) => output(one, node.id)) : el("p", { class: "dim" }, "It sends nothing of its own."));
  }

  const doubt = (text) => el("p", { class: "callout doubt" }, icon("warning"), el("span", {}, text));

  /** One output: its sources by strength; opened, with the lines by which each comes into it. */
  function output(one, node) {
    const groups = flows.STRENGTHS.map((_, strength) => one.sources.filter((source) => source[1] === strength)).filter((list) => list.length);
    const at = flows.place(one.place);
    return unfolding("output",
      [el("span", { class: "title" }, ways.content(one.content, node), at.file ? el("span", { class: "dim at" }, `${at.file.split("/").at(-1)}:${at.line}`) : null),
        groups.length ? groups.map((list) => el("span", { class: "sources" }, ways.strength(list[0][1]), " ", el("span", {}, list.map(([content], number) => [number ? ", " : "", ways.content(content, node)]))))
          : el("span", { class: "sources dim" }, "constant")],
      () => [
        one.sources.map(([content, strength, assumed, way]) => el("div", { class: "source-of" },
          el("p", { class: "from-to" }, ways.content(content, node), " ", ways.strength(strength, ways.VERBS[strength]), assumed ? ways.assumed() : null),
          ways.lines((way.length ? way : [one.place]).map(flows.place)))),
        one.sources.length ? null : ways.lines([at])]);
  }

  /** What was found on one side of what is open, the strongest first. */
  function reached({ reached: all }, forward, place) {
    const list = contents(all, forward, place);
    const title = forward ? "What it influences" : "What influences it";
    const section = el("section", { class: forward ? "down" : "up" }, el("h3", {}, title, " ", el("span", { class: "number" }, list.length)));
    if (!list.length) section.append(el("p", { class: "dim" }, nothing(forward)));
    flows.STRENGTHS.forEach((word, strength) => {
      const group = list.filter(([, one]) => one.strength === strength);
      if (group.length) section.append(el("h4", {}, ways.strength(strength, forward ? ["Its content is in", "It decides", "It triggers"][strength] : ["Made of", "Decided by", "Triggered by"][strength]), " ", el("span", { class: "number" }, group.length)),
        el("div", { class: "group" }, some(group, ([content, one]) => row(all, content, one, forward))));
    });
    return section;
  }

  function nothing(forward) {
    const { weakest } = choice.get();
    const more = weakest < 2 ? ", as far as these strengths go" : "";
    return forward ? `Nothing that is sent depends on it${more}.` : `It is constant, or comes from outside of the analysed sources${more}.`;
  }

  /** Each content once: upstream as it arrives, downstream as it is sent; not what is open itself. */
  function contents(all, forward, place) {
    const ids = new Set(place.one ? [place.one.id] : place.entities.map((one) => one.endpoint));
    const list = [...all].filter(([number, { by }]) => {
      const { side, endpoints, kind } = flows.contents[number];
      if (kind === "released" || by === null || endpoints.some((id) => ids.has(id))) return false;
      return forward ? side === "sent" : side === "in" && (!OUTSIDE.has(kind) || choice.get().weakest === 2);
    });
    // with a node open, the search begins at what it reads and sends: that is listed among its outputs
    return list.sort(([, a], [, b]) => a.strength - b.strength || a.assumed - b.assumed || a.steps - b.steps);
  }

  function row(all, number, one, forward) {
    const way = flows.way(all, number, forward);
    const through = new Set(way.map((edge) => edge.node).filter((id) => id !== null));
    return unfolding("reached",
      [el("span", { class: "title" }, ways.content(number, null), one.assumed ? ways.assumed() : null, el("span", { class: "dim at" }, names.plural(through.size, "node")))],
      () => ways.steps(way), way);
  }

  /** Details whose inside is made when it is looked at; an open way is marked in the drawing. */
  function unfolding(kind, summary, inside, way) {
    const details = el("details", { class: `entity flow-${kind}` }, el("summary", {}, summary));
    details.addEventListener("toggle", () => {
      if (details.open && details.childElementCount === 1) details.append(el("div", { class: "inside" }, inside()));
      if (!way) return;
      if (details.open) {
        for (const other of panel.querySelectorAll(".flow-reached[open]")) if (other !== details) other.open = false;
        rosward.choice.set({ way });
      } else if (choice.get().way === way) {
        rosward.choice.set({ way: [] });
      }
    });
    return details;
  }

  /** The first of a list, and a button for the rest. */
  function some(list, make) {
    if (list.length <= FIRST) return list.map(make);
    const more = el("button", { type: "button", class: "act more", onclick: () => more.replaceWith(...[list.slice(FIRST).map(make)].flat()) }, `${list.length - FIRST} more`);
    return [...list.slice(0, FIRST).map(make), more];
  }

  function start() {
    new MutationObserver(complete).observe(panel, { childList: true });
    let { direction, weakest } = choice.get();
    choice.listen((now) => {
      if (now.direction !== direction || now.weakest !== weakest) again();
      ({ direction, weakest } = now);
    });
    complete();
  }

  return { start };
})();
