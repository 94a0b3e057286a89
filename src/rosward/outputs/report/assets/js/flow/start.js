// SPDX-License-Identifier: Apache-2.0
"use strict";
// Behind main.js: the parts for flows complete what the others show, so a report without flows has none of them.
[rosward.choice, rosward.lit, rosward.bar, rosward.sections, rosward.told].forEach((part) => part.start());
