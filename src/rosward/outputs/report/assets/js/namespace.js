// SPDX-License-Identifier: Apache-2.0
"use strict";
// The one global of the page. Each file below hangs one part on it, and uses only parts of files before it.
const rosward = Object.create(null);
