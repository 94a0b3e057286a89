// SPDX-License-Identifier: Apache-2.0
"use strict";
// Light or dark? As the system says, until the user says otherwise; the choice is kept where the browser allows it.
rosward.theme = (() => {
  const { dom, graph } = rosward;
  const KEY = "rosward-theme";
  const root = document.documentElement;
  const system = matchMedia("(prefers-color-scheme: dark)");

  function kept() {
    try {
      return localStorage.getItem(KEY);
    } catch {
      return null;
    }
  }

  function set(theme) {
    if (theme === "dark" || theme === "light") root.dataset.theme = theme;
    else delete root.dataset.theme;
    graph.restyle();
  }

  const dark = () => (root.dataset.theme || (system.matches ? "dark" : "light")) === "dark";

  function turn() {
    const theme = dark() ? "light" : "dark";
    try {
      localStorage.setItem(KEY, theme);
    } catch { /* nothing is kept then */ }
    set(theme);
  }

  function start() {
    set(kept());
    system.addEventListener("change", graph.restyle);
    document.getElementById("buttons").append(dom.button("Light or dark theme", "theme", turn));
  }

  return { start, turn };
})();
