// SPDX-License-Identifier: Apache-2.0
"use strict";
// The first script, and the only one that is not compressed: how is what the page holds taken out and started?
const unpacked = (() => {
  /** The text of a packed element of the page: base64 of a zlib stream. */
  async function text(id) {
    const packed = document.getElementById(id).textContent;
    const bytes = Uint8Array.fromBase64 ? Uint8Array.fromBase64(packed) : Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).text();
  }

  /** Scripts run in their order, each as an element of its own: the policy of the page allows these texts and no others. */
  async function start() {
    const [report, scripts] = await Promise.all([text("report"), text("scripts")]);
    unpacked.report = JSON.parse(report);
    for (const code of JSON.parse(scripts)) {
      const script = document.createElement("script");
      script.textContent = code;
      document.body.append(script);
    }
  }

  return { text, start, report: null };
})();
unpacked.start().catch((error) => {
  const blank = document.getElementById("blank");
  blank.textContent = `This browser cannot show the report: ${error.message}`;
  blank.hidden = false;
});
