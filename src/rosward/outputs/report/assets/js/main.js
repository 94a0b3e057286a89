// SPDX-License-Identifier: Apache-2.0
"use strict";
// Everything begins here, in this order; of a large system the picture is seen before the lists are made.
(() => {
  const LARGE = 150; // nodes
  const first = [rosward.summary, rosward.graph, rosward.theme, rosward.controls, rosward.legend];
  const rest = [rosward.list, rosward.panel, rosward.policies, rosward.problems, rosward.keyboard, rosward.about, rosward.print];
  const start = (parts) => parts.forEach((part) => part.start());
  rosward.layout.warm();
  start(first);
  if (rosward.model.nodes.size <= LARGE) start(rest);
  else requestAnimationFrame(() => setTimeout(() => start(rest)));
})();
