// SPDX-License-Identifier: Apache-2.0
"use strict";
// The small parts of flows: a strength, a content, the lines of a way, its steps.
rosward.ways = (() => {
  const { model, dom, parts, flows, names } = rosward;
  const { el, named } = dom;
  const WORDS = ["data", "decided by", "triggered by"];
  const VERBS = ["goes into", "decides", "triggers"];
  const TITLES = ["The content itself is in it", "The content decides what is sent, or whether", "Only its arrival counts"];
  const KINDS = {
    request: "request", response: "response", goal: "goal", cancel: "cancel request", feedback: "feedback", result: "result", parameter: "parameter", released: "released by",
    tf: "transforms (tf)", log: "log", clock: "clock", random: "random numbers", argv: "command line", env: "environment", file: "files", network: "network",
    process: "other programs", device: "devices", stdin: "standard input", stdout: "standard output", timer: "timer", thread: "thread", main: "start of the program", parameters: "parameter change",
  };
  const SVG = "http://www.w3.org/2000/svg";

  /** A strength as a piece of its line, and its word. */
  function strength(number, word) {
    return el("span", { class: `strength ${flows.STRENGTHS[number]}`, title: TITLES[number] }, sample(number), word === undefined ? WORDS[number] : word);
  }

  function sample(number) {
    const svg = document.createElementNS(SVG, "svg");
    const line = document.createElementNS(SVG, "path");
    svg.setAttribute("viewBox", "0 0 22 8");
    svg.setAttribute("class", "sample-line");
    svg.setAttribute("aria-hidden", "true");
    line.setAttribute("d", "M0 4h16");
    const head = document.createElementNS(SVG, "path");
    head.setAttribute("d", "M16 0.500L22 4l-6 3.500z");
    head.setAttribute("class", "head");
    svg.append(line, head);
    return svg;
  }

  /** A content in words, with the way to its topic, service or action; `node` is the one it need not name. */
  function content(number, node) {
    const { kind, name, node: own, endpoints } = flows.contents[number];
    const word = kind === "topic" ? "" : KINDS[kind] || kind;
    const of = own !== null && own !== node ? [" of ", parts.link(model.nodes.get(own))] : null;
    if (kind === "tf" || kind === "log") return el("span", { class: "content-of" }, word);
    const linked = endpoints.length ? parts.link(model.endpoints.get(endpoints[0])) : name ? el("code", {}, named(name)) : null;
    return el("span", { class: "content-of" }, word ? el("span", { class: "word" }, word) : null, word && linked ? " " : null, linked, of);
  }

  /** The same as text, for paper. */
  function text(number) {
    const { kind, name } = flows.contents[number];
    return [kind === "topic" ? "" : KINDS[kind] || kind, name].filter(Boolean).join(" ");
  }

  /** Lines of the sources in the order of a way, each file named once. */
  function lines(places) {
    const files = [];
    for (const place of places) {
      if (!place.file) continue; // nobody knows the line
      if (files.at(-1)?.[0] === place.file) files.at(-1)[1].push(place);
      else files.push([place.file, [place]]);
    }
    return files.map(([file, own]) => {
      const known = model.report.code[file] || {};
      const texts = own.map(({ line }) => (known[line] || "").trim());
      return el("figure", { class: "source way-lines" },
        el("figcaption", {}, el("code", { class: "place", title: names.visible(file) }, named(file.split("/").slice(-2).join("/"), "span")), dom.copyButton(() => own.map(parts.placeText).join("\n"), "Copy")),
        el("div", { class: "lines", role: "group", tabindex: "0", "aria-label": `${names.plural(own.length, "line")} of ${names.visible(file)}` },
          own.map(({ line }, at) => el("div", { class: "line" }, el("span", { class: "number" }, line || ""), el("code", {}, texts[at] || " ")))));
    });
  }

  /** The steps of a way: in which node, from what to what, how strongly, by which lines. */
  function steps(way) {
    return el("ol", { class: "steps" }, way.filter((edge) => edge.node !== null).map((edge) => el("li", {},
      el("p", { class: "step" }, parts.link(model.nodes.get(edge.node)), edge.assumed ? assumed() : null),
      el("p", { class: "from-to" }, content(edge.from, edge.node), " ", strength(edge.strength, VERBS[edge.strength]), " ", content(edge.to, edge.node)),
      lines(edge.way.map(flows.place)))));
  }

  const assumed = () => el("span", { class: "tag sometimes", title: "Something on the way is not analysed: each of its outputs may hold each input" }, "assumed");

  return { WORDS, VERBS, strength, content, text, lines, steps, assumed };
})();
