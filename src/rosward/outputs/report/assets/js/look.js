// SPDX-License-Identifier: Apache-2.0
"use strict";
// How does each kind of thing look in the graph? Shape and word tell kinds apart, colour only helps; the colours are those
// of the style sheet, so light, dark and print follow it.
rosward.look = (() => {
  const FAMILY = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", Arial, sans-serif';
  const FONT = `600 12px ${FAMILY}`; // of the widest labels, those of nodes
  const BADGE = 10; // as far as badges reach over the outline
  const PADDING = 16; // between a frame and what is in it; the layouts leave as much
  const STRIPES = 24;
  const SHAPES = {
    node: { shape: "ellipse" },
    topic: { shape: "rectangle" },
    service: { shape: "polygon", "shape-polygon-points": "-0.88 -1 0.88 -1 1 0 0.88 1 -0.88 1 -1 0" },
    action: { shape: "polygon", "shape-polygon-points": "-1 -1 0.86 -1 1 0 0.86 1 -1 1 -0.9 0" },
    group: { shape: "round-rectangle" },
  };
  const BADGES = {
    error: '<path d="M6 1h8l5 5v8l-5 5H6l-5-5V6z" fill="FILL" stroke="PAGE" stroke-width="1.5"/><path d="M7 7l6 6m0-6l-6 6" stroke="PAGE" stroke-width="2.2" stroke-linecap="round"/>',
    warning: '<path d="M10 1.500L19 18H1z" fill="FILL" stroke="PAGE" stroke-width="1.500" stroke-linejoin="round"/><path d="M10 7v5m0 2v1.800" stroke="PAGE" stroke-width="2.200"/>',
    note: '<circle cx="10" cy="10" r="7.500" fill="FILL" stroke="PAGE" stroke-width="1.500"/><path d="M10 9v5m0-8v1.800" stroke="PAGE" stroke-width="2.200"/>',
  };

  function colour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  }

  function badge(severity) {
    const drawing = BADGES[severity].replaceAll("FILL", colour(severity)).replaceAll("PAGE", colour("page"));
    return "data:image/svg+xml;utf8," + encodeURIComponent(`<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40" viewBox="0 0 20 20">${drawing}</svg>`);
  }

  /** A fill of stripes: a gradient whose colours change at once. */
  function hatched(...colours) {
    const stripes = Array.from({ length: STRIPES }, (_, at) => [colours[at % 2], (100 * at) / STRIPES, (100 * (at + 1)) / STRIPES]);
    return {
      "background-fill": "linear-gradient", "background-gradient-direction": "to-bottom-right",
      "background-gradient-stop-colors": stripes.flatMap(([one]) => [one, one]), "background-gradient-stop-positions": stripes.flatMap(([, from, to]) => [`${from}%`, `${to}%`]),
    };
  }

  /** The style sheet of the graph, in the colours of the moment. */
  function style() {
    const shapes = Object.entries(SHAPES).map(([kind, shape]) => ({
      selector: `node.${kind}`, style: { ...shape, "background-color": colour(kind), "border-color": colour(`${kind}-line`) },
    }));
    const edges = Object.keys(SHAPES).map((kind) => ({
      selector: `edge.${kind}`, style: { "line-color": colour(`${kind}-line`), "target-arrow-color": colour(`${kind}-line`), "source-arrow-color": colour(`${kind}-line`) },
    }));
    const badges = Object.keys(BADGES).map((severity) => ({
      selector: `node.${severity}`,
      style: {
        "background-image": badge(severity), "background-width": 17, "background-height": 17, "background-clip": "none",
        "background-image-containment": "over", "background-position-x": "100%", "background-position-y": 0,
        "background-offset-x": 6, "background-offset-y": -7,
      },
    }));
    return [
      { selector: "node.shape", style: {
        width: "data(width)", height: "data(height)", label: "data(label)", "font-family": FAMILY, "font-size": 12, color: colour("ink"),
        "text-valign": "center", "text-halign": "center", "text-wrap": "wrap", "text-max-width": 2000, "border-width": 1.5,
        "bounds-expansion": BADGE, "min-zoomed-font-size": 7.2, "overlay-opacity": 0, "line-height": 1.25 } },
      { selector: "node.node", style: { "font-weight": 600 } },
      ...shapes,
      { selector: "node.group", style: { "border-style": "double", "border-width": 4, "font-weight": 600 } },
      { selector: "node.system", style: { "background-opacity": 0.45 } },
      { selector: "node.hub", style: { "border-style": "double", "border-width": 4 } },
      { selector: "node.assumed", style: { "border-style": "dashed", "border-width": 2 } },
      { selector: "node.unknown", style: { ...hatched(colour("unknown"), colour("frame-line")), "border-color": colour("group-line") } },
      { selector: "node.doubtful", style: { "border-style": "dashed", "border-width": 2, "border-color": colour("doubt") } },
      ...badges,
      { selector: "node.frame", style: {
        shape: "round-rectangle", "background-color": colour("frame"), "background-opacity": 0.55, "border-width": 1, "border-color": colour("frame-line"),
        label: "data(label)", "font-family": FAMILY, "font-size": "data(size)", "font-weight": 600, color: colour("dim"), "text-valign": "top", "text-halign": "center",
        "text-margin-y": -4, padding: PADDING - BADGE, "bounds-expansion": `20 ${BADGE} ${BADGE} ${BADGE}`, "compound-sizing-wrt-labels": "exclude", "overlay-opacity": 0, "z-compound-depth": "bottom" } },
      { selector: "node.frame.far", style: {
        "text-valign": "center", "text-margin-y": 0, color: colour("ink"), "text-background-color": colour("page"), "text-background-opacity": 0.85, "text-background-padding": 3,
        "text-background-shape": "round-rectangle", "z-compound-depth": "top", "background-opacity": 0.12 } },
      { selector: "edge", style: {
        width: "data(width)", "curve-style": "bezier", "target-arrow-shape": "triangle", "arrow-scale": 0.8, "overlay-padding": 5, "overlay-opacity": 0 } },
      { selector: "edge.routed", style: { "curve-style": "round-segments", "segment-radii": 7, "edge-distances": "endpoints" } },
      ...edges,
      { selector: "edge.mixed", style: { "line-color": colour("group-line"), "target-arrow-color": colour("group-line"), "source-arrow-color": colour("group-line") } },
      { selector: "edge.both", style: { "source-arrow-shape": "triangle" } },
      { selector: "edge.behind", style: { opacity: "data(opacity)" } },
      { selector: "edge.maybe", style: { "line-color": colour("dim"), "target-arrow-shape": "none", "line-style": "dotted", width: 1.2 } },
      { selector: "edge.dashed", style: { "line-style": "dashed", "line-dash-pattern": [6, 4] } },
      { selector: "edge.maybe.dashed", style: { "line-style": "dotted" } },
      { selector: ".faded", style: { opacity: 0.16 } },
      { selector: "edge.lit", style: { width: 2.6, opacity: 1, "z-index": 10 } },
      { selector: "node.shape.lit", style: { "z-index": 10 } },
      { selector: "node.shape.hit", style: { "underlay-color": colour("focus"), "underlay-opacity": 0.28, "underlay-padding": 5 } },
      { selector: "node.shape.chosen", style: { "underlay-color": colour("focus"), "underlay-opacity": 0.5, "underlay-padding": 6, "underlay-shape": "round-rectangle" } },
      { selector: "edge.chosen", style: { width: 3.2, opacity: 1, "underlay-color": colour("focus"), "underlay-opacity": 0.4, "underlay-padding": 4 } },
    ];
  }

  return { style, colour, FONT, PADDING };
})();
