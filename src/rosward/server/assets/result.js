// SPDX-License-Identifier: Apache-2.0
// The page of one result: progress, tabs, another look with other options, and the next result when the workspace changes.
import { doing, element, facts, news, post, showProgress, trouble } from "./common.js";
import { settingsOf } from "./options.js";

const own = facts("facts");
const byId = (id) => document.getElementById(id);

if (location.search) history.replaceState(null, "", location.pathname + location.hash); // the token has done its work

// Tabs

const tabs = [...document.querySelectorAll("[data-tab]")];

function open(name) {
  const chosen = tabs.find((tab) => tab.dataset.tab === name) ?? tabs[0];
  for (const tab of tabs) {
    const here = tab === chosen;
    tab.setAttribute("aria-selected", here);
    tab.tabIndex = here ? 0 : -1;
    byId(tab.dataset.tab).hidden = !here;
  }
  const text = byId(chosen.dataset.tab).querySelector("[data-file]");
  if (text && !text.textContent) look(text.dataset.file).then((found) => { text.textContent = found; }).catch(trouble);
}

for (const [index, tab] of tabs.entries()) {
  const choose = (other) => { history.replaceState(null, "", `#${other.dataset.tab}`); open(other.dataset.tab); other.focus(); };
  tab.addEventListener("click", () => choose(tab));
  tab.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step) choose(tabs[(index + step + tabs.length) % tabs.length]);
  });
}
for (const link of document.querySelectorAll("[data-open]")) link.addEventListener("click", () => open(link.dataset.open));
if (tabs.length) open(location.hash.slice(1));

// Files

async function look(file) {
  const answer = await fetch(`/results/${own.id}/files/${file.split("/").map(encodeURIComponent).join("/")}?show`);
  if (!answer.ok) throw new Error("The file no longer exists.");
  return answer.text();
}

for (const button of document.querySelectorAll("[data-look]")) {
  button.addEventListener("click", async () => {
    const figure = byId("look");
    try {
      figure.querySelector("pre").textContent = await look(button.dataset.look);
      figure.querySelector("figcaption").textContent = button.dataset.look;
      figure.hidden = false;
      figure.scrollIntoView({ block: "nearest" });
    } catch (error) { trouble(error); }
  });
}

// Progress, and what comes next

byId("cancel")?.addEventListener("click", () => post(`/api/results/${own.id}/cancel`).catch(trouble));
byId("watch")?.addEventListener("change", (event) => {
  post(`/api/results/${own.id}/watch`, { on: event.target.checked }).catch((error) => { event.target.checked = !event.target.checked; trouble(error); });
});

const ended = (result) => !["waiting", "running"].includes(result.state);
const go = (id) => location.replace(`/results/${id}${location.hash}`);

function followed(results) {
  const here = results.find((result) => result.id === own.id);
  const next = results.find((result) => result.automatic && result.group === own.group && result.created > own.created);
  if (!ended(own)) {
    if (here && ended(here)) location.reload();
    else if (here) {
      byId("state").textContent = doing(here);
      showProgress(byId("progress"), here);
      byId("detail").textContent = here.step?.all > 1 ? `${here.step.done} of ${here.step.all}` : "\u00a0";
    } else location.reload();
  }
  if (here && byId("watch")) byId("watch").checked = here.watched;
  const again = byId("again");
  again.hidden = !next;
  if (!next) return;
  if (next.state === "done" && ended(own)) go(next.id);
  else if (ended(next)) again.textContent = `Files have changed, but the new analysis has no result: ${next.message}`;
  else again.textContent = `Files have changed. ${doing(next)}…`;
}
news(followed);

// Other options

const form = byId("change");
const launchFiles = facts("launch-files");
const given = own.settings_document.arguments;

function started() {
  const value = form.elements.namedItem("start").value;
  return value === "all" || value === "all-launch" ? value : launchFiles[Number(value)];
}

function showArguments() {
  const what = started();
  const found = typeof what === "object" ? what.arguments : [];
  byId("arguments").hidden = !found.length;
  byId("arguments").querySelector(".arguments").replaceChildren(...found.map((argument) => {
    const input = argument.choices.length
      ? element("select", {}, element("option", { value: "" }, argument.default === null ? "" : `default: ${argument.default}`), ...argument.choices.map((choice) => element("option", {}, choice)))
      : element("input", { type: "text", placeholder: argument.default ?? "needs a value", spellcheck: false, autocomplete: "off" });
    input.dataset.argument = argument.name;
    input.value = given[argument.name] ?? "";
    return element("label", {}, element("code", {}, argument.name), input, element("small", {}, argument.description));
  }));
}

function settings() {
  const what = started();
  const inputs = [...form.querySelectorAll("[data-argument]")].filter((input) => input.value !== "");
  return {
    ...settingsOf(form),
    launch: typeof what === "object" ? [what.file] : [],
    all_launch: what === "all-launch",
    arguments: Object.fromEntries(inputs.map((input) => [input.dataset.argument, input.value])),
  };
}

form?.addEventListener("change", (event) => { if (event.target.name === "start") showArguments(); });
form?.addEventListener("submit", async (event) => {
  event.preventDefault();
  try { location.assign(`/results/${(await post(`/api/results/${own.id}/again`, { settings: settings() })).id}`); } catch (error) { trouble(error); }
});
if (form) showArguments();
