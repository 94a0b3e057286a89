// SPDX-License-Identifier: Apache-2.0
"use strict";
// Which labels are read at which zoom? The names of frames keep their size on the screen; seen from afar, where the shapes in them are too
// small for letters, they stand in their middle, those that there is room for.
rosward.labels = (() => {
  const { names } = rosward;
  const SIZE = 12;
  const FAR = 0.6;
  const LEAST = 6; // letters, to be worth reading
  let waiting = false;

  function follow(cy) {
    cy.on("zoom", () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => { waiting = false; update(cy); });
    });
  }

  function update(cy) {
    const zoom = cy.zoom();
    const far = zoom < FAR;
    cy.batch(() => {
      for (const frame of cy.nodes(".frame").toArray()) {
        const text = far ? fromAfar(frame, zoom) : near(frame, zoom);
        frame.data({ label: text, size: far ? SIZE / zoom : SIZE / Math.min(1, zoom) });
        frame.toggleClass("far", far);
      }
    });
  }

  /** The name over a frame, as far as the frame is wide where it was not made wide enough for it. */
  function near(frame, zoom) {
    const name = frame.data("name");
    return frame.data("wide") ? name : names.shortened(name, Math.max(LEAST, letters(frame, Math.min(1, zoom))));
  }

  /** The name as far as the frame has room for it; nothing where frames in it have. */
  function fromAfar(frame, zoom) {
    const fits = (one) => one.height() * zoom > 1.3 * SIZE && letters(one, zoom) >= Math.min(LEAST, one.data("name").length);
    if (!fits(frame) || frame.descendants(".frame").some(fits)) return "";
    return names.shortened(frame.data("name"), letters(frame, zoom));
  }

  /** How many letters there is room for over a frame. */
  function letters(frame, zoom) {
    return Math.floor((frame.outerWidth() * zoom + SIZE) / (frame.data("labelWidth") / frame.data("name").length));
  }

  return { follow, update };
})();
