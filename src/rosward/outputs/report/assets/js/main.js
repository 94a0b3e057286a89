// SPDX-License-Identifier: Apache-2.0
"use strict";
// Everything begins here, in this order.
rosward.layout.warm();
rosward.summary.start();
rosward.graph.start();
rosward.theme.start();
rosward.controls.start();
rosward.list.start();
rosward.legend.start();
rosward.panel.start();
rosward.policies.start();
rosward.problems.start();
rosward.keyboard.start();
rosward.print.start();
