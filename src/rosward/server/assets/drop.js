// SPDX-License-Identifier: Apache-2.0
// What was dropped or chosen, as files with paths; and their way to the server.
import { answered } from "./common.js";

const BUILT = new Set(["build", "install", "log"]);

/** The files of a drop, folders walked: [{path, file}]. What cannot be of use is left out by its name. */
export async function dropped(transfer, rules, leftOut) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (!entries.length) return chosen(transfer.files, rules, leftOut);
  const files = [];
  for (const entry of entries) await walk(entry, "", files, rules, leftOut);
  return files;
}

/** The files of an input, with the paths that the browser gives them. */
export function chosen(list, rules, leftOut) {
  const files = [...list].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
  const workspaces = new Set(files.map(({ path }) => path.split("/")).filter((parts) => parts[1] === "src").map((parts) => parts[0]));
  return files.filter(({ path, file }) => {
    const [top, second, ...rest] = path.split("/");
    if (workspaces.has(top) && rest.length && BUILT.has(second)) return false;
    return files.length === 1 || isOfUse(path, file, rules, leftOut);
  });
}

async function walk(entry, folder, files, rules, leftOut) {
  const path = folder + entry.name;
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    if ((!folder && isZip(path)) || isOfUse(path, file, rules, leftOut)) files.push({ path, file });
    return;
  }
  if (isHidden(entry.name, rules)) return;
  if (files.length > rules.files) throw new Error(`More than ${rules.files.toLocaleString()} files. Open the folder below instead.`);
  const inner = await listing(entry.createReader());
  const workspace = inner.some((each) => each.isDirectory && each.name === "src");
  for (const each of inner) {
    if (!(workspace && each.isDirectory && BUILT.has(each.name))) await walk(each, `${path}/`, files, rules, leftOut);
  }
}

/** All entries of a folder: a browser gives a hundred at a time. */
async function listing(reader) {
  const all = [];
  for (;;) {
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (!some.length) return all;
    all.push(...some);
  }
}

const isZip = (path) => path.toLowerCase().endsWith(".zip");
const isHidden = (name, rules) => name.startsWith(".") || rules.folders.includes(name);

function isOfUse(path, file, rules, leftOut) {
  const parts = path.split("/");
  if (parts.some((part) => isHidden(part, rules))) return false;
  const name = parts.at(-1);
  const ending = name.includes(".") ? name.split(".").at(-1).toLowerCase() : "";
  if (rules.endings.includes(ending) || file.size > rules.file) {
    leftOut.push(path);
    return false;
  }
  return true;
}

/** Send files; the id of the result. `tell` hears which part of them is sent. */
export function send(files, settings, leftOut, rules, tell) {
  const size = files.reduce((sum, { file }) => sum + file.size, 0);
  if (!files.length) throw new Error("It contains nothing that rosward can read.");
  if (size > rules.upload) throw new Error(`More than ${Math.round(rules.upload / 2 ** 20)} MB. Open the folder below instead.`);
  const form = new FormData();
  form.append("settings", JSON.stringify(settings));
  form.append("left_out", JSON.stringify(leftOut.slice(0, 1000)));
  for (const { path, file } of files) form.append("file", file, path);
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open("POST", "/api/uploads");
    request.upload.onprogress = (event) => tell(event.loaded / (event.total || 1));
    request.onerror = () => reject(new Error("The upload was interrupted: it may be too large, or a file may have changed."));
    request.onload = () => {
      try { resolve(answered(request.status, request.responseText).id); } catch (error) { reject(error); }
    };
    request.send(form);
  });
}
