// SPDX-License-Identifier: Apache-2.0
"use strict";
// What made this page, and under which licences is what it holds? The words stand in the page itself.
rosward.about = (() => {
  const { dom } = rosward;
  const dialog = document.getElementById("about");

  function start() {
    dialog.append(dom.el("form", { method: "dialog" }, dom.el("button", { class: "act" }, "Close")));
    document.getElementById("buttons").append(dom.button("About and licences", "note", () => dialog.showModal()));
  }

  return { start };
})();
