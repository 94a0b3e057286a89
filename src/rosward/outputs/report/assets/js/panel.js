// SPDX-License-Identifier: Apache-2.0
"use strict";
// The panel beside the view: everything about the node, endpoint, edge or rule that the address names.
rosward.panel = (() => {
  const { model, state, route, dom, parts, entity, names } = rosward;
  const { el, icon, named } = dom;
  const box = document.getElementById("panel");
  const INTERFACES = { declared: "declared", partial: "partially known", unknown: "unknown interface" };
  const KINDS = [["publisher", "Publishes"], ["subscription", "Subscribes to"], ["service server", "Serves"], ["service client", "Calls"], ["action server", "Executes actions"], ["action client", "Sends goals to"]];
  const SIDES = { topic: [["publisher", "Publishers"], ["subscription", "Subscriptions"]], service: [["service server", "Servers"], ["service client", "Clients"]], action: [["action server", "Servers"], ["action client", "Clients"]] };

  function show(place) {
    const content = contentFor(place);
    box.hidden = content === null;
    document.body.classList.toggle("with-panel", content !== null);
    dom.fill(box, content);
    box.scrollTop = 0;
  }

  function contentFor(place) {
    if (place.one) return model.kindOf(place.one) === "node" ? node(place.one) : endpoint(place.one);
    if (place.entities.length) return entities(place.entities);
    if (place.rule) return rule(place.rule);
    return null;
  }

  function head(kind, title, ...tags) {
    const close = dom.button("Close (Escape)", "close", () => route.go(`#${route.get().view}`), { class: "tool close" });
    return el("header", {}, el("p", { class: `kind ${kind}` }, icon(kind), kind, tags, close), el("h2", { tabindex: "-1" }, title));
  }

  function actions(one) {
    const name = model.nameOf(one);
    const enclave = one.enclave === undefined ? null : model.enclaves.get(one.enclave);
    const focused = state.get().focus === one.id;
    return el("p", { class: "actions" },
      el("button", { type: "button", class: "act", "aria-pressed": String(focused), onclick: (event) => {
        state.focus(focused ? null : one.id);
        if (route.get().view !== "graph") route.go(route.to(one));
        else show(route.get());
        event.preventDefault();
      } }, icon("focus"), focused ? "Show all" : "Focus"),
      enclave ? el("a", { class: "act", href: route.toEnclave(enclave) }, icon("shield"), "Policy") : null,
      dom.copyButton(() => name, "Copy name"));
  }

  function node(one) {
    const all = one.entities.map((id) => model.entities.get(id));
    const own = all.filter((each) => !each.system);
    const system = all.filter((each) => each.system);
    const enclave = model.enclaves.get(one.enclave);
    return el("div", { class: "content" },
      head("node", named(one.fqn), one.resolution === "exact" ? null : parts.resolution(one),
        one.interface === "analysed" ? null : el("span", { class: "tag sometimes", title: one.lacks.join("\n") }, INTERFACES[one.interface]),
        one.assumed ? el("span", { class: "tag sometimes", title: "Nothing in the sources starts it" }, "assumed") : null),
      actions(one),
      findings(one.id, own),
      one.reasons.length ? el("div", { class: "callout doubt" }, icon("warning"), el("ul", {}, one.reasons.map((text) => el("li", {}, named(text, "span"))))) : null,
      parts.facts([
        ["package", one.package], ["executable", one.executable], [one.assumed ? "created by" : "process", one.assumed ? `nothing in the sources: ${one.process}` : one.process],
        ["enclave", enclave && el("a", { href: route.toEnclave(enclave) }, named(enclave.path))],
      ]),
      KINDS.map(([kind, title]) => group(title, own.filter((each) => each.kind === kind), "node")),
      one.interface === "unknown" ? el("p", { class: "dim" }, `Its interface is unknown: ${one.lacks.join("; ")}.`)
        : own.length ? null : el("p", { class: "dim" }, "It creates no publishers, subscriptions, services or actions of its own."),
      parameters(one.parameters),
      system.length ? el("details", { class: "system" }, el("summary", {}, `${system.length} created by the client library`), system.map((each) => entity.row(each, "node"))) : null,
      el("h3", {}, "Source"),
      parts.source(one.place, "defined"),
      one.launched_by ? parts.source(one.launched_by, "launched") : null,
      one.includes.map((at) => parts.source(at, "included")));
  }

  /** Findings about the thing itself; those of its entities stand at the entities, too. */
  function findings(id) {
    const found = model.findingsOf(id);
    const [first, rest] = [found.slice(0, 4), found.slice(4)];
    return found.length ? el("div", { class: "callouts" }, first.map(parts.finding), rest.length ? el("details", {}, el("summary", {}, `${rest.length} more`), rest.map(parts.finding)) : null) : null;
  }

  function group(title, list, seen) {
    if (!list.length) return null;
    return el("section", {}, el("h3", {}, title, " ", el("span", { class: "number" }, list.length)), list.map((one) => entity.row(one, seen, list.length === 1 && seen === "endpoint")));
  }

  function parameters(list) {
    if (!list.length) return null;
    const value = (one) => (one === null || one === undefined ? "" : typeof one === "string" ? one : JSON.stringify(one));
    const rows = list.map((one) => el("tr", {},
      el("td", { title: one.place ? parts.placeText(one.place) : null }, el("code", {}, named(one.name))), el("td", {}, one.type || ""),
      el("td", {}, el("code", {}, named(value(one.default)))), el("td", {}, el("code", {}, named(value(one.value))))));
    return el("section", {}, el("h3", {}, "Parameters ", el("span", { class: "number" }, list.length)), parts.table(["Name", "Type", "Default", "Value"], rows));
  }

  function endpoint(one) {
    const all = model.users.get(one.id);
    const matches = (one.matches || []).map((id) => model.endpoints.get(id));
    const matched = model.report.endpoints.filter((other) => (other.matches || []).includes(one.id));
    const types = one.types.map((type) => el("div", {}, el("code", {}, named(type))));
    return el("div", { class: "content" },
      head(one.kind, named(one.name), one.resolution === "exact" ? null : parts.resolution(one), one.system ? el("span", { class: "tag" }, "system") : null),
      actions(one),
      findings(one.id),
      parts.facts([
        [one.types.length > 1 ? "types" : "type", types.length ? types : el("span", { class: "doubt" }, "unknown")],
        ["may match", matches.map((other) => el("div", {}, parts.link(other)))],
        ["may be matched by", matched.map((other) => el("div", {}, parts.link(other)))],
      ]),
      SIDES[one.kind].map(([kind, title]) => group(title, all.filter((each) => each.kind === kind), "endpoint")
        || el("section", {}, el("h3", {}, title, " ", el("span", { class: "number" }, 0)), el("p", { class: "dim" }, "None in the analysed sources."))));
  }

  function entities(list) {
    const title = list.length === 1 ? list[0].kind : names.plural(list.length, "connection");
    const kind = model.endpoints.get(list[0].endpoint).kind;
    return el("div", { class: "content" }, head(kind, title), list.map((one) => entity.row(one, "both", list.length <= 2)));
  }

  function rule(one) {
    const enclave = model.enclaves.get(one.enclave);
    const list = one.entities.map((id) => model.entities.get(id));
    return el("div", { class: "content" }, el("header", {}, el("p", { class: "kind" }, icon("shield"), "policy rule",
      dom.button("Close (Escape)", "close", () => route.go(route.toEnclave(enclave)), { class: "tool close" })), el("h2", { tabindex: "-1" }, named(one.text))),
    parts.facts([["enclave", el("a", { href: route.toEnclave(enclave) }, named(enclave.path))], ["needed by", names.plural(list.length, "entity")]]),
    list.map((each) => entity.row(each, "both", list.length <= 2)));
  }

  function start() {
    show(route.get());
    route.listen(show);
    state.listen(() => { if (route.get().one) show(route.get()); });
  }

  return { start };
})();
