// SPDX-License-Identifier: Apache-2.0
"use strict";
// One publisher, subscription, server or client: in a line, and in full with everything that its name was made of.
rosward.entity = (() => {
  const { model, route, dom, parts } = rosward;
  const { el, icon, named } = dom;

  const qosText = (qos) => (qos ? [qos.reliability, qos.durability, qos.history === "keep_last" ? `depth ${qos.depth}` : qos.history].filter((word) => word !== null && word !== undefined && word !== "").join(" · ") : "");

  /** `seen` says from where: in the panel of its node the endpoint is named, in that of its endpoint the node. */
  function row(entity, seen, open) {
    const other = seen === "node" ? model.endpoints.get(entity.endpoint) : model.nodes.get(entity.node);
    const title = seen === "both"
      ? [el("b", {}, entity.kind), " of ", parts.link(model.nodes.get(entity.node)), " at ", parts.link(model.endpoints.get(entity.endpoint))]
      : [parts.link(other)];
    const below = [
      seen === "node" || seen === "both" ? entity.type || "unknown type" : null,
      entity.callback ? `→ ${entity.callback}` : null, qosText(entity.qos), entity.via ? `by ${entity.via}` : null,
    ].filter(Boolean).join("  ·  ");
    const details = el("details", { class: "entity", id: `entity-${entity.id}` },
      el("summary", {}, el("span", { class: "title" }, title, flags(entity)), below ? el("span", { class: "below" }, named(below, "span")) : null));
    // the inside is made when it is looked at: a node may have hundreds of entities
    details.addEventListener("toggle", () => { if (details.open && details.childElementCount === 1) details.append(full(entity)); });
    if (open) {
      details.append(full(entity));
      details.open = true;
    }
    return details;
  }

  function flags(entity) {
    return el("span", { class: "flags" },
      entity.resolution === "exact" ? null : parts.resolution(entity),
      entity.conditional ? el("span", { class: "tag sometimes", title: "Created only in some executions" }, "conditional") : null,
      entity.system ? el("span", { class: "tag", title: "Created by the client library" }, "system") : null,
      parts.badges(entity.id));
  }

  function full(entity) {
    const rule = entity.rule === null ? null : model.rules.get(entity.rule);
    const [first, ...more] = entity.places;
    return el("div", { class: "inside" },
      entity.reasons.length ? el("div", { class: "callout doubt" }, icon("warning"), el("div", {},
        el("b", {}, `The name is ${parts.RESOLUTIONS[entity.resolution]}`), list(entity.reasons),
        entity.remedies.length ? [el("b", {}, "How to resolve"), list(entity.remedies)] : null)) : null,
      model.findingsOf(entity.id).map(parts.finding),
      parts.facts([
        ["name", [el("code", {}, named(entity.name)), " ", parts.resolution(entity)]],
        ["type", entity.type === null ? el("span", { class: "doubt" }, "unknown") : el("code", {}, named(entity.type))],
        ["callback", entity.callback && el("code", {}, entity.callback)],
        ["QoS", entity.qos && qosText(entity.qos)],
        ["created by", entity.via && el("code", {}, entity.via)],
        ["remapped", entity.remaps.map((one) => el("div", {}, el("code", {}, named(one))))],
        ["policy", rule ? el("a", { href: route.toRule(rule), class: "rule" }, icon("shield"), rule.text) : el("span", { class: "doubt" }, `no rule: ${entity.why_not || "not needed"}`)],
      ]),
      madeOf(entity.sources),
      first ? [el("h4", {}, "Created at"), parts.source(first)] : entity.system ? el("p", { class: "dim" }, "Created by the client library for every node.") : null,
      more.map((at) => parts.source(at)),
      entity.path.length > 1 ? el("details", { class: "path" }, el("summary", {}, `Reached through ${entity.path.length} places`), entity.path.map((at) => parts.source(at))) : null);
  }

  function madeOf(sources) {
    if (!sources.length) return null;
    const rows = sources.map((one) => el("tr", {},
      el("td", {}, one.what, " ", el("code", {}, named(one.name))),
      el("td", {}, el("code", {}, named(one.value === null ? "?" : one.value))),
      el("td", {}, one.origin, one.places.map((at) => [" ", parts.place(at)]))));
    return [el("h4", {}, "Parts of the name"), parts.table(["Part", "Value", "From"], rows)];
  }

  const list = (texts) => el("ul", {}, texts.map((text) => el("li", {}, named(text, "span"))));

  return { row, qosText };
})();
