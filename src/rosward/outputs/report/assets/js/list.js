// SPDX-License-Identifier: Apache-2.0
"use strict";
// The list of all that is shown, and the search in it: the way to everything without a mouse.
rosward.list = (() => {
  const { model, route, dom, parts, graph, names } = rosward;
  const { el } = dom;
  const TITLES = [["node", "Nodes"], ["topic", "Topics"], ["service", "Services"], ["action", "Actions"]];
  const box = document.getElementById("list");
  const input = document.getElementById("search");
  const status = document.getElementById("found");
  const closed = new Set();
  let late = 0; // the timer of an update that is to come

  /** What the search looks at: names, types, packages, executables, in small letters. */
  const words = new Map();
  for (const one of [...model.report.nodes, ...model.report.endpoints]) {
    const more = one.fqn === undefined ? one.types : [one.package, one.executable, one.process];
    words.set(one.id, [model.nameOf(one), ...more].filter(Boolean).join("\n").toLowerCase());
  }

  function matches(id, query) {
    return query.every((word) => words.get(id).includes(word));
  }

  function update() {
    clearTimeout(late);
    late = 0;
    const query = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    const shown = graph.shown();
    const place = route.get();
    let number = 0;
    const hits = new Set();
    const sections = TITLES.map(([kind, title]) => {
      const things = (kind === "node" ? model.report.nodes : model.report.endpoints.filter((one) => one.kind === kind))
        .filter((one) => (kind === "node" ? shown.nodes : shown.endpoints).has(one.id));
      const found = things.filter((one) => matches(one.id, query));
      found.forEach((one) => hits.add(one.id));
      number += found.length;
      if (!found.length) return null;
      const section = el("details", { class: "things" }, el("summary", {}, title, el("span", { class: "number" }, query.length ? `${found.length} of ${things.length}` : found.length)),
        el("ul", {}, found.map((one) => item(one, place))));
      section.open = query.length > 0 || !closed.has(kind);
      section.addEventListener("toggle", () => { if (!query.length) closed[section.open ? "delete" : "add"](kind); });
      return section;
    });
    dom.fill(box, sections, number ? null : el("p", { class: "empty" }, query.length ? "Nothing here has that name, type or package. What filters hide is not searched." : "The filters leave nothing."));
    status.textContent = query.length ? names.plural(number, "hit") : "";
    graph.hits(query.length ? hits : null);
  }

  function item(one, place) {
    const link = parts.link(one);
    // what tells nodes of one name apart
    if (one.fqn !== undefined) link.title = [one.package, one.executable, parts.placeText(one.place)].filter(Boolean).map(names.visible).join(" · ");
    if (place.one === one) link.setAttribute("aria-current", "true");
    return el("li", {}, link, parts.badges(one.id));
  }

  function mark(place) {
    for (const link of box.querySelectorAll("a[aria-current]")) link.removeAttribute("aria-current");
    if (!place.one) return;
    const link = [...box.querySelectorAll("a.thing")].find((one) => one.getAttribute("href") === route.to(place.one));
    if (!link) return;
    link.setAttribute("aria-current", "true");
    if (!box.contains(document.activeElement)) link.scrollIntoView({ block: "nearest" });
  }

  /** Arrows go through the links, from and to the search. */
  function arrows(event) {
    if (!["ArrowDown", "ArrowUp", "Home", "End"].includes(event.key)) return;
    if (late) update(); // else the list would be made anew under the focus
    const stops = [input, ...[...box.querySelectorAll("summary, details[open] a.thing")]];
    const at = stops.indexOf(document.activeElement);
    if (at < 0 || (document.activeElement === input && !["ArrowDown"].includes(event.key))) return;
    const next = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 1, End: stops.length - 1 }[event.key];
    stops[Math.max(0, Math.min(stops.length - 1, next))].focus();
    event.preventDefault();
  }

  function start() {
    input.addEventListener("input", () => {
      clearTimeout(late);
      late = setTimeout(update, words.size > 400 ? 120 : 0);
    });
    input.addEventListener("keydown", (event) => {
      if (event.key === "Enter") {
        update();
        const first = box.querySelector("a.thing");
        if (first) route.go(first.getAttribute("href"));
      }
      if (event.key === "Escape" && input.value) {
        input.value = "";
        update();
        event.stopPropagation();
      }
    });
    document.getElementById("side").addEventListener("keydown", arrows);
    graph.listen(update);
    route.listen(mark);
    update();
  }

  return { start };
})();
