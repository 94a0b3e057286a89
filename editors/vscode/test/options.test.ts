// SPDX-License-Identifier: Apache-2.0
import * as assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { missing, places, program, SELECTOR, status } from "../src/options";

const manifest = JSON.parse(readFileSync(join(__dirname, "../../package.json"), "utf8"));
const start = { line: 0, character: 4 };
const place = { uri: "file:///a.py", range: { start, end: { line: 0, character: 9 } } };

test("the program is that of the settings, then lsp and its options", () => {
    assert.deepEqual(program(["python3", "-m", "rosward"], ["--distro", "humble"]), {
        command: "python3",
        args: ["-m", "rosward", "lsp", "--distro", "humble"],
    });
});

test("settings of a wrong kind leave the usual program", () => {
    for (const wrong of [undefined, null, "rosward; rm", 3, [], [""], [7, null], {}]) {
        assert.deepEqual(program(wrong, wrong === "rosward; rm" ? undefined : []), { command: "rosward", args: ["lsp"] });
    }
});

test("no word of the settings is split or joined: nothing goes through a shell", () => {
    assert.deepEqual(program(["my rosward"], ["--env", "A=b c"]).args, ["lsp", "--env", "A=b c"]);
    assert.equal(program(["my rosward"], []).command, "my rosward");
});

test("the bar shows whether any folder is being analysed", () => {
    assert.match(status(new Map([["a", false], ["b", true]])), /spin/);
    assert.doesNotMatch(status(new Map([["a", false]])), /spin/);
});

test("the arguments of a code lens are taken as the server sends them", () => {
    assert.deepEqual(places(["file:///a.py", start, [place]]), { uri: "file:///a.py", position: start, places: [place] });
    assert.deepEqual(places(["file:///a.py", start, []])?.places, []);
});

test("anything else is no place to go to", () => {
    const wrong = [
        [],
        [1, start, [place]],
        ["file:///a.py", { line: -1, character: 0 }, [place]],
        ["file:///a.py", null, [place]],
        ["file:///a.py", start, [{ uri: "file:///a.py" }]],
        ["file:///a.py", start, [null]],
        ["file:///a.py", start, "x"],
    ];
    for (const each of wrong) {
        assert.equal(places(each), undefined);
    }
});

test("a program that does not start is named with what can be done", () => {
    const told = missing(program(undefined, undefined), "ENOENT");
    assert.match(told, /rosward lsp/);
    assert.match(told, /pip install 'rosward\[lsp\]'/);
});

test("the manifest declares what the extension registers and reads", () => {
    const source = readFileSync(join(__dirname, "../../src/extension.ts"), "utf8");
    for (const { command } of manifest.contributes.commands) {
        assert.ok(source.includes(`registerCommand("${command}"`), command);
    }
    for (const key of Object.keys(manifest.contributes.configuration.properties)) {
        assert.ok(source.includes(`"${key.replace("rosward.", "")}"`), key);
    }
});

test("the settings that name a program do not come from a workspace that nobody trusts", () => {
    assert.deepEqual(manifest.capabilities.untrustedWorkspaces.restrictedConfigurations, [
        "rosward.command",
        "rosward.arguments",
    ]);
});

test("every language of the server is among the selected ones", () => {
    const languages = SELECTOR.map((each) => each.language).filter((each) => each !== undefined);
    assert.deepEqual(languages, ["python", "cpp", "c", "xml", "yaml"]);
    assert.ok(SELECTOR.every((each) => each.scheme === "file"));
});
