# SPDX-License-Identifier: Apache-2.0
"""Which example programs can be clicked?

    gallery/talker.md:   # Talker and listener         title
                         Two nodes meet on a topic.    what it shows; the first paragraph stands on the card
                         launch: demo:=x               settings, where it needs some (see `_SETTINGS`)
                         ```python talker.py           its files
                         …
                         ```

The programs lie in Markdown, not as modules, so nothing can import them.
"""

from __future__ import annotations

import re
from importlib import resources
from pathlib import Path
from typing import Final

from rosward.records import NamedTuple
from rosward.server.places import write_left_out
from rosward.server.settings import Settings

__all__ = ["Example", "examples", "write_example"]

_BLOCK: Final = re.compile(r"^```(\w+)[ \t]+([^\n]+)\n(.*?)^```[ \t]*$", re.MULTILINE | re.DOTALL)
_ORDER: Final = ("talker", "parameters", "unknown", "services", "lifecycle", "robots")


class Example(NamedTuple):
    """An example: its files by name, and with which settings it is analysed."""

    name: str
    title: str
    short: str
    text: str
    files: dict[str, str]
    settings: Settings


def examples() -> tuple[Example, ...]:
    """All, in the order in which they are shown."""
    folder = resources.files("rosward.server") / "gallery"
    return tuple(_read(name, (folder / f"{name}.md").read_text(encoding="utf-8")) for name in _ORDER)


def _read(name: str, document: str) -> Example:
    files = {match[2].strip(): match[3] for match in _BLOCK.finditer(document)}
    head, *rest = [part.strip() for part in _BLOCK.sub("", document).split("\n\n") if part.strip()]
    launch = tuple(p.removeprefix("launch:").strip() for p in rest if p.startswith("launch:"))
    paragraphs = [" ".join(p.split()) for p in rest if not p.startswith(("launch:", "<!--"))]
    title = next(line for line in head.splitlines() if line.startswith("# ")).removeprefix("# ")
    return Example(name, title, paragraphs[0], " ".join(paragraphs[1:]), files, Settings(launch=launch))


def write_example(example: Example, folder: Path) -> None:
    """Write the files of an example as an upload is kept: `tree`, and what was left out of it."""
    for name, text in example.files.items():
        path = folder / "tree" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    write_left_out(folder / "left_out.json", [])
