// SPDX-License-Identifier: Apache-2.0
"use strict";
// The policy of each enclave, as it is written to policy.xml: every rule leads to the source that needs it.
rosward.policies = (() => {
  const { model, route, dom, parts, names } = rosward;
  const { el, icon, named } = dom;
  const XML = /(<!--.*?-->)|(<\/?[\w:.-]+)|([\w:.-]+)(=)("[^"]*")|([?/]?>)/g;
  const box = document.getElementById("policies");
  let enclave = null;

  function update(place) {
    if (place.view !== "policies") return;
    const wanted = place.enclave || enclave || model.report.enclaves[0] || null;
    if (wanted !== enclave || !box.firstChild) draw(wanted);
    enclave = wanted;
    for (const line of box.querySelectorAll(".line.marked")) line.classList.remove("marked");
    if (!place.rule) return;
    const line = box.querySelectorAll(".xml .line")[model.lineOf(place.rule)];
    line?.classList.add("marked");
    line?.scrollIntoView({ block: "center" });
  }

  function draw(one) {
    if (one === null) {
      dom.fill(box, el("div", { class: "nothing" }, icon("shield"), el("h2", {}, "No policy"), el("p", {}, "These sources contain no nodes, so there is nothing to allow.")));
      return;
    }
    dom.fill(box,
      el("nav", { "aria-label": "Enclaves" }, el("h2", {}, "Enclaves ", el("span", { class: "number" }, model.enclaves.size)),
        el("ul", {}, model.report.enclaves.map((each) => el("li", {}, el("a", { href: route.toEnclave(each), "aria-current": each === one ? "true" : null }, named(each.path), sum(each)))))),
      el("article", {}, title(one), document_(one), refused(one)));
    box.querySelector("nav a[aria-current]").scrollIntoView({ block: "nearest" });
  }

  function sum(one) {
    const rules = one.policy.filter((line) => line.rule !== null).length;
    return el("span", { class: "number", title: names.plural(rules, "rule") }, rules);
  }

  function text(one) {
    return one.policy.map((line) => line.text).join("\n");
  }

  function title(one) {
    const nodes = one.nodes.map((id) => model.nodes.get(id));
    const number = one.policy.filter((line) => line.rule !== null).length;
    return el("header", {},
      el("h2", {}, named(one.path)),
      el("p", { class: "dim" }, `${names.plural(number, "rule")}. The enclave of `, nodes.map((node, at) => [at ? ", " : "", parts.link(node)]), "."),
      el("p", { class: "actions" }, dom.copyButton(() => text(one), "Copy policy"),
        el("button", { type: "button", class: "act", onclick: () => dom.save(text(one), "policy.xml", "application/xml") }, icon("download"), "Download policy.xml")));
  }

  /** The file line by line. A line with a rule is a link to what needs it. */
  function document_(one) {
    const last = one.policy.length && one.policy[one.policy.length - 1].text === "" ? -1 : undefined;
    return el("div", { class: "xml", role: "group", "aria-label": `policy.xml of ${names.visible(one.path)}` }, one.policy.slice(0, last).map((line, at) => {
      const code = el("code", {}, coloured(line.text));
      const rule = line.rule === null ? null : model.rules.get(line.rule);
      const content = rule ? el("a", { href: route.toRule(rule), title: `Why? ${names.visible(rule.text)}` }, code, el("span", { class: "why" }, `${names.plural(rule.entities.length, "entity")} ›`)) : code;
      return el("div", { class: "line" }, el("span", { class: "number", "aria-hidden": "true" }, at + 1), content);
    }));
  }

  function coloured(line) {
    const found = [];
    let from = 0;
    for (const match of line.matchAll(XML)) {
      found.push(line.slice(from, match.index));
      const [whole, comment, tag, attribute, equals, value] = match;
      if (comment) found.push(el("span", { class: "x-comment" }, comment));
      else if (tag) found.push(el("span", { class: "x-tag" }, tag));
      else if (attribute) found.push(el("span", { class: "x-attribute" }, attribute), equals, el("span", { class: "x-value" }, value));
      else found.push(el("span", { class: "x-tag" }, whole));
      from = match.index + whole.length;
    }
    found.push(line.slice(from));
    return found;
  }

  /** What the nodes of this enclave would use and may not, since its name is not known. */
  function refused(one) {
    const list = one.nodes.flatMap((id) => model.nodes.get(id).entities.map((each) => model.entities.get(each))).filter((each) => each.rule === null && each.why_not);
    if (!list.length) return null;
    return el("section", { class: "refused" }, el("h3", {}, icon("warning"), `${names.plural(list.length, "use")} not allowed by this policy`),
      el("p", { class: "dim" }, "These names cannot be determined from the sources, so the policy does not allow them."),
      list.map((each) => rosward.entity.row(each, "both")));
  }

  function start() {
    update(route.get());
    route.listen(update);
  }

  return { start };
})();
