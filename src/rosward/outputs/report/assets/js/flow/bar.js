// SPDX-License-Identifier: Apache-2.0
"use strict";
// Over the drawing: which direction, which strengths, and in one sentence what is lit. The strengths are the legend of the lines, too.
rosward.bar = (() => {
  const { model, route, dom, names, flows, choice, lit, ways } = rosward;
  const { el } = dom;
  const DIRECTIONS = [["both", "both ways"], ["up", "what influences it"], ["down", "what it influences"], ["off", "off"]];
  const KEYS = [["i", "information flow: both ways, up, down, off"], ["w", "weaker flows, too"]];
  const TITLES = ["The content itself is in it", "Also where the content decides what is sent, or whether", "Also where only its arrival counts"];

  function make() {
    const select = el("select", { id: "flow-direction", onchange: (event) => choice.set({ direction: event.target.value }) }, DIRECTIONS.map(([value, text]) => el("option", { value }, text)));
    const chips = flows.STRENGTHS.map((word, number) => el("button", { type: "button", class: `chip strength-chip ${word}`, title: TITLES[number], onclick: () => {
      const { weakest } = choice.get();
      choice.set({ weakest: number > weakest || number === 0 ? number : number - 1 });
    } }, ways.strength(number)));
    const status = el("span", { id: "flow-status", role: "status" });
    const clear = dom.button("Clear the way", "close", () => choice.set({ finding: null }));
    const fit = dom.button("Fit to the flow", "fit", () => lit.fit());
    const update = () => {
      const { direction, weakest, finding } = choice.get();
      select.value = direction;
      chips.forEach((chip, number) => {
        chip.setAttribute("aria-pressed", String(number <= weakest));
        chip.disabled = direction === "off";
      });
      clear.hidden = finding === null;
      fit.hidden = lit.shown() === null;
      const text = sentence();
      if (status.textContent !== text) status.textContent = text;
      status.title = text;
    };
    lit.listen(update);
    choice.listen(update);
    update();
    return el("div", { id: "flow", role: "group", "aria-label": "Information flow" }, el("label", { for: "flow-direction" }, "Flow"), select, el("span", { class: "chips" }, chips), status, fit, clear);
  }

  /** What is lit, in words. */
  function sentence() {
    const { direction, finding } = choice.get();
    const found = choice.found();
    if (!found && finding) return `the way of ${model.findings.get(finding).code}`;
    if (direction === "off") return "";
    if (!found) return "open something to see its flows";
    const count = (search, side) => new Set([...search.reached].filter(([number, { by }]) => by !== null && flows.contents[number].side === side).map(([number]) => number)).size;
    const counts = [found.up && names.plural(count(found.up, "in"), "source"), found.down && names.plural(count(found.down, "sent"), "output")];
    return counts.filter(Boolean).map((text) => text.replace(" ", "\u00a0")).join(" · ");
  }

  function pressed(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input[type=search], textarea, select") || document.querySelector("dialog[open]")) return;
    if (event.key === "i") choice.turn();
    else if (event.key === "w") choice.weaken();
    else if (event.key === "Escape" && choice.get().finding !== null) choice.set({ finding: null });
    else return;
    event.preventDefault();
  }

  /** The keys are shown with the others, as soon as these are there. */
  function told() {
    const list = document.querySelector("#keys dl");
    if (!list || list.querySelector(".flow-key")) return;
    for (const [key, word] of KEYS) list.append(el("dt", { class: "flow-key" }, el("kbd", {}, key)), el("dd", {}, word));
  }

  function start() {
    document.querySelector("#toolbar > .buttons").before(make());
    addEventListener("keydown", pressed);
    new MutationObserver(told).observe(document.getElementById("keys"), { childList: true });
    told();
  }

  return { start };
})();
