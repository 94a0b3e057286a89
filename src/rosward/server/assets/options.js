// SPDX-License-Identifier: Apache-2.0
// The options of an analysis: what a form says, as the server reads it.

/** Lines `NAME=VALUE`; the server says what is wrong with one. */
function variablesOf(text) {
  const lines = text.split("\n").map((line) => line.trim()).filter(Boolean);
  return Object.fromEntries(lines.map((line) => {
    const [name, ...value] = line.split("=");
    return value.length ? [name, value.join("=")] : [`${name}=`, ""];
  }));
}

/** The settings that the fields of a form show, without what is started. */
export function settingsOf(form) {
  const field = (name) => form.elements.namedItem(name);
  return {
    distro: field("distro").value,
    unknown: field("unknown").value,
    enclaves: field("enclaves").value || null,
    tests: field("tests").checked,
    flows: field("flows").checked,
    env: variablesOf(field("env").value),
  };
}
