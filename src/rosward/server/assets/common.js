// SPDX-License-Identifier: Apache-2.0
// What all pages need: asking the server, news from it, elements.

/** Ask the server to do something; what it answers. Throws an Error with the reason for people. */
export async function post(address, body) {
  const form = body instanceof FormData;
  const answer = await fetch(address, {
    method: "POST",
    body: form ? body : JSON.stringify(body ?? {}),
    headers: form ? {} : { "Content-Type": "application/json" },
  }).catch(() => { throw new Error("The server does not answer. Is it still running?"); });
  return answered(answer.status, await answer.text());
}

/** What an answer says. */
export function answered(status, text) {
  let said = {};
  try { said = JSON.parse(text); } catch { /* not from our server */ }
  if (status >= 400 || status === 0) {
    const why = said.error ?? (status === 403 ? "Open the address printed by rosward serve again." : `The server answered ${status}.`);
    throw new Error(why.charAt(0).toUpperCase() + why.slice(1));
  }
  return said;
}

/** Show what went wrong. */
export function trouble(error) {
  const place = document.getElementById("trouble");
  place.textContent = error instanceof Error ? error.message : String(error);
  place.hidden = false;
  setTimeout(() => { place.hidden = true; }, 9000);
}

/** Call with the list of all results, now and with each change, while the page is in sight: browsers have few connections to spare. */
export function news(tell) {
  let source = null;
  function listen() {
    if (document.hidden || source) return;
    source = new EventSource("/api/news");
    source.onmessage = (event) => tell(JSON.parse(event.data));
    source.onerror = () => trouble("The server does not answer. Is it still running?");
  }
  function rest() {
    source?.close();
    source = null;
  }
  addEventListener("pagehide", rest);
  addEventListener("pageshow", listen);
  document.addEventListener("visibilitychange", () => (document.hidden ? rest() : listen()));
  listen();
}

/** An element: its name, its properties, and what is in it (text stays text). */
export function element(name, properties = {}, ...inner) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (key in made) made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...inner.filter((each) => each !== null && each !== undefined));
  return made;
}

const STEPS = { starting: "Starting", unpacking: "Unpacking", reading: "Reading the sources", analysing: "Analysing the programs", writing: "Writing the results" };

/** What a result is doing, in words. */
export function doing(result) {
  if (result.state === "waiting") return "Waiting for others";
  return STEPS[result.step?.what] ?? "Working";
}

/** Let a progress bar show how far a result is. */
export function showProgress(bar, result) {
  const { done = 0, all = 0 } = result.step ?? {};
  if (all > 1) { bar.max = all; bar.value = done; } else bar.removeAttribute("value");
}

/** The JSON that stands in the page under an id. */
export const facts = (id) => JSON.parse(document.getElementById(id).textContent);
