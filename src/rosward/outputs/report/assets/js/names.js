// SPDX-License-Identifier: Apache-2.0
"use strict";
// How are names of ROS shown? Control characters and direction marks become visible, long names lose their middle.
rosward.names = (() => {
  const HIDDEN = /[\u0000-\u001f\u007f-\u009f\u061c\u200b-\u200f\u2028\u2029\u202a-\u202e\u2066-\u2069\ufeff]/g;

  /** Text with what a browser would hide or obey written as \uXXXX. */
  function visible(text) {
    return String(text).replace(HIDDEN, (c) => "\\u" + c.charCodeAt(0).toString(16).padStart(4, "0"));
  }

  /** "/a/b/c" seen from "/a" is "b/c". */
  function relative(name, space) {
    return space && space !== "/" && name.startsWith(space + "/") ? name.slice(space.length + 1) : name;
  }

  /** At most `most` characters: the beginning and the end of a name tell more than its middle. */
  function shortened(name, most) {
    if (name.length <= most) return name;
    const end = Math.ceil((most - 1) * 0.6);
    return name.slice(0, most - 1 - end) + "…" + name.slice(-end);
  }

  /** The name and all namespaces above it: "/a/b" gives "/a/b", "/a", "/". */
  function above(name) {
    const spaces = [];
    for (let at = name; at.length > 1; at = at.slice(0, Math.max(0, at.lastIndexOf("/")))) spaces.push(at);
    spaces.push("/");
    return spaces;
  }

  /** plural(2, "process") is "2 processes", plural(1200, "line") is "1,200 lines". */
  function plural(number, word) {
    if (number === 1) return `1 ${word}`;
    return `${number.toLocaleString("en")} ${word.endsWith("y") ? word.slice(0, -1) + "ies" : word + (word.endsWith("s") ? "es" : "s")}`;
  }

  return { visible, relative, shortened, above, plural };
})();
