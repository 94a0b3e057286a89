// SPDX-License-Identifier: Apache-2.0
"use strict";
// The small parts that several views share: links to things, places, source lines, badges, findings.
rosward.parts = (() => {
  const { model, route, dom, names } = rosward;
  const { el, icon, named } = dom;
  const AROUND = 4;
  const SEVERITIES = ["error", "warning", "note"];

  /** A link to a node or endpoint, with the mark of its kind. */
  function link(one, text) {
    const kind = model.kindOf(one);
    return el("a", { href: route.to(one), class: `thing ${kind}` }, icon(kind), named(text === undefined ? model.nameOf(one) : text));
  }

  /** `file:line`, to be copied or read. */
  function placeText(place) {
    return place.line > 0 ? `${place.file}:${place.line}` : place.file;
  }

  function place(one) {
    return el("code", { class: "place" }, named(placeText(one), "span"));
  }

  /** A place with the lines around it; the line itself is marked. Without known lines, the place alone. */
  function source(one, note) {
    const lines = model.report.code[one.file] || {};
    const numbers = [];
    for (let at = one.line - AROUND; at <= one.line + AROUND; at++) if (lines[at] !== undefined) numbers.push(at);
    const head = el("figcaption", {}, place(one), note ? el("span", { class: "dim" }, note) : null, dom.copyButton(() => placeText(one), "Copy"));
    if (!one.line || !numbers.length) {
      const leftOut = one.line > 0 && model.report.summary.places_without_code > 0;
      return el("figure", { class: "source" }, head, leftOut ? el("p", { class: "left-out dim" }, "These lines are not in the report because its size is limited.") : null);
    }
    const indent = Math.min(...numbers.filter((at) => lines[at].trim()).map((at) => lines[at].search(/\S/)), 40);
    const rows = numbers.map((at) => el("div", { class: at === one.line ? "line marked" : "line" },
      el("span", { class: "number", "aria-hidden": "true" }, at), el("code", {}, lines[at].slice(indent) || " ")));
    return el("figure", { class: "source" }, head, el("div", { class: "lines", role: "group", "aria-label": `Lines around ${placeText(one)}`, tabindex: "0" }, rows));
  }

  function severityMark(severity, number) {
    const word = number === undefined ? severity : names.plural(number, severity);
    return el("span", { class: `severity ${severity}`, title: word }, icon(severity), el("span", { class: number === undefined ? "" : "digits" }, number === undefined ? severity : number));
  }

  /** Counts of findings by severity, as small marks. */
  function badges(id) {
    const found = model.findingsOf(id);
    return SEVERITIES.map((severity) => {
      const number = found.filter((one) => one.severity === severity).length;
      return number ? severityMark(severity, number) : null;
    });
  }

  /** A finding in few words, with the way to its full text. */
  function finding(one) {
    return el("a", { class: `callout ${one.severity}`, href: route.toFinding(one) },
      icon(one.severity), el("span", {}, el("b", {}, `${one.code} ${one.title}`), el("br"), named(one.message, "span")));
  }

  const RESOLUTIONS = {
    exact: "known exactly", default: "known if the defaults of its parameters are kept", bound: "known from a value that was set",
    pattern: "partially known", unknown: "unknown",
  };

  function resolution(one) {
    const open = model.doubtful(one);
    return el("span", { class: `tag ${open ? "doubt" : one.resolution}`, title: `The name is ${RESOLUTIONS[one.resolution]}` }, open ? icon("warning") : null, one.resolution);
  }

  /** The rows of a definition list; those without a value are left out. */
  function facts(rows) {
    return el("dl", {}, rows.filter(([, value]) => value !== null && value !== undefined && value !== "" && !(Array.isArray(value) && !value.length))
      .map(([word, value]) => [el("dt", {}, word), el("dd", {}, value)]));
  }

  /** A table that scrolls by itself where it is wider than its place. */
  function table(heads, rows) {
    return el("div", { class: "scroll" }, el("table", {}, el("thead", {}, el("tr", {}, heads.map((word) => el("th", { scope: "col" }, word)))), el("tbody", {}, rows)));
  }

  return { table, link, place, placeText, source, severityMark, badges, finding, resolution, facts, RESOLUTIONS, SEVERITIES };
})();
