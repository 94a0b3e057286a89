// SPDX-License-Identifier: Apache-2.0
// The start page: drop, name or click something; the list of results.
import { doing, element, facts, news, post, showProgress, trouble } from "./common.js";
import { chosen, dropped, send } from "./drop.js";
import { settingsOf } from "./options.js";

const form = document.getElementById("choose");
const drop = document.getElementById("drop");
const rules = facts("rules");
let busy = false;

if (location.search) history.replaceState(null, "", location.pathname); // the token has done its work

const show = (id) => location.assign(`/results/${id}`);

async function take(find) {
  if (busy) return;
  busy = true;
  const sending = document.getElementById("sending");
  const [bar, status] = sending.children;
  try {
    sending.hidden = false;
    status.textContent = "Checking the files";
    bar.removeAttribute("value");
    const leftOut = [];
    const files = await find(leftOut);
    status.textContent = `Sending ${files.length.toLocaleString()} file${files.length === 1 ? "" : "s"}`;
    show(await send(files, settingsOf(form), leftOut, rules, (part) => { bar.value = part; }));
  } catch (error) {
    trouble(error);
  } finally {
    sending.hidden = true;
    busy = false;
  }
}

for (const kind of ["dragover", "drop"]) addEventListener(kind, (event) => event.preventDefault());
addEventListener("dragenter", () => drop.classList.add("over"));
addEventListener("dragleave", (event) => { if (!event.relatedTarget) drop.classList.remove("over"); });
addEventListener("drop", (event) => {
  drop.classList.remove("over");
  take((leftOut) => dropped(event.dataTransfer, rules, leftOut));
});
for (const id of ["pick-folder", "pick-files"]) {
  const input = document.getElementById(id);
  input.addEventListener("change", () => {
    const files = [...input.files];
    input.value = "";
    if (files.length) take(async (leftOut) => chosen(files, rules, leftOut));
  });
}

form.addEventListener("submit", async (event) => {
  event.preventDefault();
  const path = document.getElementById("path").value;
  try {
    const body = { path, settings: settingsOf(form), watch: document.getElementById("watch").checked };
    show((await post("/api/workspaces", body)).id);
  } catch (error) { trouble(error); }
});

for (const card of document.querySelectorAll("[data-example]")) {
  card.addEventListener("click", async () => {
    try { show((await post(`/api/examples/${card.dataset.example}`)).id); } catch (error) { trouble(error); }
  });
}

function row(result) {
  const when = new Date(result.created * 1000).toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });
  const ended = !["waiting", "running"].includes(result.state);
  const bar = element("progress", { ariaLabel: doing(result) });
  showProgress(bar, result);
  const words = result.state === "done" ? result.numbers.join(" · ") || "nothing found" : result.state;
  return element("li", {},
    element("div", { className: "title" },
      element("a", { href: `/results/${result.id}` }, result.title),
      element("small", {}, [when, result.settings, result.watched ? "watched" : "", ended ? "" : doing(result)].filter(Boolean).join(" · "))),
    ended ? element("span", { className: `facts${result.state === "done" && result.complete ? "" : " bad"}` }, words) : bar,
    element("button", { type: "button", className: "quiet", ariaLabel: `Remove ${result.title}`, onclick: () => post(`/api/results/${result.id}/delete`).catch(trouble) }, "✕"));
}

news((results) => {
  document.getElementById("earlier").hidden = !results.length;
  const list = document.getElementById("results");
  const focused = [...list.querySelectorAll("a, button")].indexOf(document.activeElement);
  list.replaceChildren(...results.map(row));
  if (focused >= 0) list.querySelectorAll("a, button")[focused]?.focus();
});
