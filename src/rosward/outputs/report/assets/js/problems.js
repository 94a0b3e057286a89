// SPDX-License-Identifier: Apache-2.0
"use strict";
// The findings, by their code: errors and warnings open, notes closed where there are many. Each leads to the thing that it is about.
rosward.problems = (() => {
  const { model, route, dom, parts, names } = rosward;
  const { el, icon, named } = dom;
  const box = document.getElementById("findings");
  const MANY = 40; // with more findings than this, notes begin closed
  const off = new Set();

  function groups() {
    const byCode = new Map();
    for (const finding of model.causes) {
      if (!byCode.has(finding.code)) byCode.set(finding.code, []);
      byCode.get(finding.code).push(finding);
    }
    const order = parts.SEVERITIES;
    return [...byCode.values()].sort((a, b) => order.indexOf(a[0].severity) - order.indexOf(b[0].severity) || (a[0].code < b[0].code ? -1 : 1));
  }

  function draw() {
    const all = groups();
    if (!all.length) {
      dom.fill(box, el("div", { class: "nothing" }, icon("ok"), el("h2", {}, "No findings"), el("p", {}, "Every file was read, every name is known, and everything that is sent is received.")));
      return;
    }
    dom.fill(box, el("header", {}, el("h2", {}, "Findings"), el("div", { class: "chips", role: "group", "aria-label": "Severities" }, parts.SEVERITIES.map(filter))),
      all.map(group));
  }

  function filter(severity) {
    const number = model.causes.filter((one) => one.severity === severity).length;
    if (!number) return null;
    const button = el("button", { type: "button", class: `chip ${severity}`, "aria-pressed": "true", onclick: () => {
      off[off.has(severity) ? "delete" : "add"](severity);
      button.setAttribute("aria-pressed", String(!off.has(severity)));
      for (const one of box.querySelectorAll("details.code")) one.hidden = off.has(one.dataset.severity);
    } }, icon(severity), names.plural(number, severity));
    return button;
  }

  function group(list) {
    const [{ code, title, help, severity }] = list;
    const section = el("details", { class: `code ${severity}`, "data-severity": severity, id: `code-${code}` },
      el("summary", {}, icon(severity), el("b", {}, code), el("span", {}, title), el("span", { class: "number" }, list.length)),
      el("p", { class: "help" }, help));
    const open = () => { if (section.open && section.childElementCount === 2) section.append(el("ul", {}, list.map(cause))); };
    section.addEventListener("toggle", open);
    section.open = severity !== "note" || list.length <= 3 || model.causes.length <= MANY;
    open();
    return section;
  }

  function cause(finding) {
    const others = model.sameCause.get(finding.id);
    const line = item(finding);
    if (!others.length) return line;
    const rest = el("details", {}, el("summary", {}, `${others.length} more with this cause`));
    rest.addEventListener("toggle", () => { if (rest.open) unfold(rest, finding); });
    line.append(rest);
    return line;
  }

  /** Show what else there is of a cause; made when it is first asked for. */
  function unfold(rest, finding) {
    rest.open = true;
    if (rest.childElementCount === 1) rest.append(el("ul", {}, model.sameCause.get(finding.id).map((one) => item(one, one.code !== finding.code))));
  }

  function item(finding, coded = false) {
    const things = finding.subjects.map((id) => model.thing(id)).filter(Boolean);
    const named_ = things.filter((one) => model.kindOf(one) !== "entity");
    const entities = things.filter((one) => model.kindOf(one) === "entity");
    return el("li", { id: `finding-${finding.id}`, tabindex: "-1" },
      el("p", { class: "message" }, coded ? el("b", {}, `${finding.code} `) : null, named(finding.message, "span")),
      el("p", { class: "subjects" }, named_.slice(0, 8).map((one) => parts.link(one)), entities.length ? el("a", { href: route.toEntities(entities.slice(0, 50).map((one) => one.id)), class: "thing" }, icon("graph"), names.plural(entities.length, "connection")) : null),
      finding.place && finding.place.file ? parts.source(finding.place) : null);
  }

  function update({ view, finding }) {
    if (view !== "findings") return;
    if (!box.firstChild) draw();
    for (const one of box.querySelectorAll("li.marked")) one.classList.remove("marked");
    if (!finding) return;
    const first = finding.first ? model.findings.get(finding.first) : finding;
    const section = document.getElementById(`code-${first.code}`);
    section.hidden = false;
    section.open = true;
    if (section.childElementCount === 2) section.append(el("ul", {}, groups().find(([one]) => one.code === first.code).map(cause)));
    if (finding !== first) unfold(document.querySelector(`#finding-${first.id} > details`), first);
    const line = document.getElementById(`finding-${finding.id}`);
    line.classList.add("marked");
    line.scrollIntoView({ block: "center" });
    line.focus({ preventScroll: true });
  }

  function start() {
    update(route.get());
    route.listen(update);
  }

  return { start };
})();
