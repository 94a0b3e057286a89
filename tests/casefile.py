# SPDX-License-Identifier: Apache-2.0
"""Reads the little programs of `tests/cases/*.md`: each is a section with files and what must come out of them.

    ## A name from an f-string
    Why it is here.
    ```python talker.py
    …
    ```
    ```expect
    node /talker
    pub /robot1/cmd std_msgs/msg/String
    ```

An expectation has one line for each node, entity and finding, sorted: `node`, `pub`, `sub`, `ss`, `sc`, `as`, `ac` with the full name and type, then
`default`, `bound`, `pattern` or `unknown` where the name is not exact, `conditional`, and `assumed`
for a node that nothing starts; `finding CODE file:line`. Entities of the client
library are left out unless a line `show system` stands among the expectations; `show findings` adds their messages.
A ```cpp block without a name is `main.cpp`, a program that no CMakeLists.txt builds. The files before the first section belong to every case of the
document.
`options:` before the files passes arguments on (`options: distro=humble`); `known:` says what rosward still
does otherwise than it is written; `fails:` names the exception by which the real program ends.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

import rosward
from rosward import EntityKind, Result

WORDS = {
    EntityKind.PUBLISHER: "pub",
    EntityKind.SUBSCRIPTION: "sub",
    EntityKind.SERVICE_SERVER: "ss",
    EntityKind.SERVICE_CLIENT: "sc",
    EntityKind.ACTION_SERVER: "as",
    EntityKind.ACTION_CLIENT: "ac",
}
SUFFIXES = {"python": "py"}
"""The ends of file names, where the word behind the backticks is another."""
_BLOCK = re.compile(r"^```(\w+)[ \t]*([^\n]*)\n(.*?)^```[ \t]*$", re.MULTILINE | re.DOTALL)


class Case(NamedTuple):
    """One little program: its files by name, the expected lines, options for `extract`."""

    file: Path
    title: str
    files: dict[str, str]
    expected: list[str]
    options: dict[str, str]
    known: str = ""
    fails: str = ""

    @property
    def name(self) -> str:
        """An identifier for reports."""
        return f"{self.file.stem}: {self.title}"


def read_cases(file: Path) -> list[Case]:
    """All cases of a document."""
    cases = []
    head, *sections = re.split(r"^## ", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
    common = {name.strip(): text for _, name, text in _BLOCK.findall(head)}
    for section in sections:
        title, _, body = section.partition("\n")
        files, expected = dict(common), []
        for kind, name, text in _BLOCK.findall(body):
            if kind == "expect":
                expected = text.splitlines()
            else:
                files[name.strip() or f"main.{SUFFIXES.get(kind, kind)}"] = text
        given = re.search(r"^options: (.*)$", body, re.MULTILINE)
        options = dict(o.split("=", 1) for o in given.group(1).split()) if given else {}
        known = re.search(r"^known: (.*)$", body, re.MULTILINE)
        fails = re.search(r"^fails: (.*)$", body, re.MULTILINE)
        cases.append(
            Case(
                file,
                title.strip(),
                files,
                expected,
                options,
                known.group(1) if known else "",
                fails.group(1) if fails else "",
            )
        )
    return cases


def write_files(case: Case, folder: Path) -> None:
    """Lay the files of a case into a folder."""
    for name, text in case.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def run_case(case: Case, folder: Path) -> list[str]:
    """Write the files, extract, and tell what came out in the words of an expectation."""
    write_files(case, folder)
    result = rosward.extract(folder, distro=case.options.get("distro", "jazzy"))
    return told(result, system="show system" in case.expected, messages="show findings" in case.expected)


def told(result: Result, *, system: bool = False, messages: bool = False) -> list[str]:
    """The lines that describe a result."""
    lines = set()
    for node in result.network.nodes:
        words = ["node", node.fqn, *([] if node.resolution.value == "exact" else [node.resolution.value])]
        lines.add(" ".join([*words, *(["assumed"] if node.assumed else [])]))
        for entity in node.entities:
            if entity.system and not system:
                continue
            words = [WORDS[entity.kind], entity.name, entity.type or "?"]
            if entity.resolution.value != "exact":
                words.append(entity.resolution.value)
            if entity.conditional:
                words.append("conditional")
            lines.add(" ".join(words))
    shown = []
    for finding in result.findings:
        text = f"finding {finding.code} {finding.place}"
        shown.append(f"{text} {finding.message}" if messages else text)
    head = (["show system"] if system else []) + (["show findings"] if messages else [])
    order = ["node", *WORDS.values()]
    return head + sorted(lines, key=lambda line: (order.index(line.split()[0]), line)) + sorted(set(shown))


def rewrite(file: Path, results: dict[str, list[str]]) -> None:
    """Replace the expectations of a document by what came out."""
    text = file.read_text(encoding="utf-8")
    head, *sections = re.split(r"^(?=## )", text, flags=re.MULTILINE)
    for number, section in enumerate(sections):
        title = section[3:].partition("\n")[0].strip()
        if title in results:
            block = "```expect\n" + "".join(f"{line}\n" for line in results[title]) + "```"
            if "```expect" in section:
                old = re.compile(r"^```expect\n.*?^```$", re.MULTILINE | re.DOTALL)
                sections[number] = old.sub(block.replace("\\", "\\\\"), section)
            else:
                sections[number] = section.rstrip("\n") + "\n" + block + "\n\n"
    file.write_text(head + "".join(sections), encoding="utf-8")
