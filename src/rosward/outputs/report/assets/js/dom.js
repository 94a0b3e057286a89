// SPDX-License-Identifier: Apache-2.0
"use strict";
// How does the page make elements? Text goes in as text nodes only, so no name of the sources can become markup.
rosward.dom = (() => {
  const { visible } = rosward.names;
  const SVG = "http://www.w3.org/2000/svg";
  const ICONS = {
    node: "M8 3c4 0 7 2.2 7 5s-3 5-7 5-7-2.2-7-5 3-5 7-5z",
    topic: "M1.5 4h13v8h-13z",
    service: "M4.5 3h7L15 8l-3.5 5h-7L1 8z",
    action: "M1.5 3.5h9L15 8l-4.500 4.500h-9z",
    group: "M1.500 2.500h13v11h-13zM4 5.500h8v5H4z",
    error: "M5 1.500h6L14.500 5v6L11 14.500H5L1.500 11V5zM5.500 5.500l5 5m0-5l-5 5",
    warning: "M8 1.800L15 14H1zM8 6v4m0 1.600v.8",
    note: "M8 1.500a6.500 6.500 0 1 0 0 13 6.500 6.500 0 0 0 0-13zM8 7v4.500m0-7.200v.8",
    ok: "M8 1.500a6.500 6.500 0 1 0 0 13 6.500 6.500 0 0 0 0-13zM5 8.200l2.200 2.200L11.200 6",
    plus: "M8 3v10M3 8h10", minus: "M3 8h10", fit: "M2 6V2h4m4 0h4v4m0 4v4h-4m-4 0H2v-4",
    close: "M3.500 3.500l9 9m0-9l-9 9", copy: "M5.500 5.500h8v8h-8zM3.500 10.500h-1v-8h8v1", download: "M8 2v8m-3.500-3L8 10.500 11.500 7M2.500 13.500h11",
    focus: "M8 1v4m0 6v4M1 8h4m6 0h4M8 5.500a2.500 2.500 0 1 1 0 5 2.500 2.500 0 0 1 0-5z",
    picture: "M1.500 3h13v10h-13zM3.500 11l3-4 2.500 3 1.500-1.500 2.500 2.500", theme: "M8 2a6 6 0 0 0 0 12zM8 2a6 6 0 0 1 0 12",
    keys: "M1.500 4h13v8h-13zM4 6.500h.6m2.200 0h.6m2.200 0h.6m2.200 0h.6M4.500 9.500h7", menu: "M2 4h12M2 8h12M2 12h12",
    shield: "M8 1.500l5.500 2v4.500c0 3.500-2.500 5.700-5.500 6.700C5 13.700 2.500 11.500 2.500 8V3.500z", back: "M10 3L5 8l5 5", graph: "M3.500 5.500a2 2 0 1 0 0-.1zM12.500 3.500h0M5.500 5l5 0M11 3h4v4h-4zM5 6.500l3 4M7 10h4v4H7z",
    collapse: "M4 2l4 4 4-4M4 14l4-4 4 4", expand: "M4 5l4-4 4 4M4 11l4 4 4-4",
  };

  /** An element: `properties` sets attributes, `on…` adds listeners; children are elements, texts, or nothing. */
  function el(tag, properties, ...children) {
    const element = document.createElement(tag);
    for (const [key, value] of Object.entries(properties || {})) {
      if (value === null || value === undefined || value === false) continue;
      if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
      else element.setAttribute(key, value === true ? "" : String(value));
    }
    append(element, children);
    return element;
  }

  function append(element, children) {
    for (const child of children.flat(Infinity)) {
      if (child === null || child === undefined || child === false || child === "") continue;
      element.append(child instanceof Node ? child : document.createTextNode(visible(child)));
    }
  }

  /** Puts these children in place of those that are there. */
  function fill(element, ...children) {
    element.replaceChildren();
    append(element, children);
    return element;
  }

  /** A small drawing, which says nothing to a screen reader: the word stands beside it. */
  function icon(name, kind) {
    const svg = document.createElementNS(SVG, "svg");
    const path = document.createElementNS(SVG, "path");
    svg.setAttribute("viewBox", "0 0 16 16");
    svg.setAttribute("class", `icon ${kind || name}`);
    svg.setAttribute("aria-hidden", "true");
    path.setAttribute("d", ICONS[name]);
    svg.append(path);
    return svg;
  }

  /** A name: breaks before slashes, where it stands alone behind underscores, too; and its direction stays its own. */
  function named(text, tag) {
    const element = el(tag || "bdi", { class: "name" });
    const breaks = /\s/.test(text) ? /(?=\/)/ : /(?=\/)|(?<=_)(?=[^_])/;
    visible(text).split(breaks).forEach((part, at) => {
      if (at) element.append(document.createElement("wbr"));
      element.append(document.createTextNode(part));
    });
    return element;
  }

  function button(label, iconName, onclick, more) {
    return el("button", { type: "button", title: label, "aria-label": label, onclick, class: "tool", ...more }, icon(iconName));
  }

  /** A button that copies a text and says so. */
  function copyButton(textOf, label) {
    const word = el("span", {}, label || "Copy");
    const made = el("button", { type: "button", class: "act" }, icon("copy"), word);
    made.addEventListener("click", async () => {
      const done = await copied(textOf());
      word.textContent = done ? "Copied" : "Copy failed";
      setTimeout(() => { word.textContent = label || "Copy"; }, 1600);
    });
    return made;
  }

  /** The clipboard's own way where the browser allows it (a page from file:// may not), else through a selection. */
  async function copied(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      const area = el("textarea", { class: "offscreen", "aria-hidden": "true" });
      area.value = text;
      document.body.append(area);
      area.select();
      const done = document.execCommand("copy");
      area.remove();
      return done;
    }
  }

  /** Hands a text or a blob to the user as a file. */
  function save(content, file, type) {
    const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
    el("a", { href: url, download: file }).click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
  }

  return { el, fill, icon, named, button, copyButton, save };
})();
