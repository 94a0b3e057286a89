// SPDX-License-Identifier: Apache-2.0
"use strict";
// How are names of ROS shown? Control characters and direction marks become visible, long names lose their middle.
rosward.names = (() => {
  // as safe.py has it: what ends a line, turns it round, or cannot be seen
  const HIDDEN =
    /[\u0000-\u001f\u007f-\u009f\u00ad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b-\u200f\u2028-\u202e\u2060-\u206f\u3164\ud800-\udfff\ufe00-\ufe0f\ufeff\uffa0\ufff0-\ufffb\u{1bca0}-\u{1bca3}\u{1d173}-\u{1d17a}\u{e0000}-\u{e0fff}]/gu;

  /** Text with what a browser would hide or obey written as \uXXXX. */
  function visible(text) {
    return String(text).replace(HIDDEN, (c) => {
      const digits = c.codePointAt(0).toString(16);
      return digits.length > 4 ? "\\U" + digits.padStart(8, "0") : "\\u" + digits.padStart(4, "0");
    });
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
