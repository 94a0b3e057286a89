# SPDX-License-Identifier: Apache-2.0
"""Ways in which Python may hand on a value: `python_ways.txt` says of each what a node keeps, does when something arrives, and sends then.

What arrives is in what the node sends, but where it is not. Each was run in Python, but for those that use a library that does not exist.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final, NamedTuple

import pytest
from sampling import sample

from .reported import reported, said_of
from .robots import SEND, write

_PARTS: Final = ("top", "keeps", "does", "sends", "way")


class Way(NamedTuple):
    """One program: its parts, and whether the value is in the output ('data'), decides it ('control'), or is not in it ('clean')."""

    name: str
    parts: dict[str, str]

    @property
    def way(self) -> str:
        return self.parts.get("way", "data")


def read(text: str) -> Way:
    """One section of the file."""
    head, *lines = text.splitlines()
    parts: dict[str, list[str]] = {}
    key = ""
    for line in lines:
        begins, _, rest = line.partition(":")
        if begins in _PARTS:
            key = begins
            parts[key] = [rest.strip()] if rest.strip() else []
        elif line.strip():
            parts[key].append(line[4:])
    return Way(head.strip(), {name: "\n".join(part) for name, part in parts.items()})


WAYS: Final = [read(text) for text in (Path(__file__).parent / "python_ways.txt").read_text().split("\n## ")[1:]]


@pytest.mark.parametrize("way", sample(WAYS, 4), ids=lambda w: w.name)
def test_is_seen(way: Way, tmp_path: Path) -> None:
    program = tmp_path / "robot.py"
    parts = way.parts
    write(program, parts.get("keeps", ""), parts["does"], SEND.format(parts["sends"]), parts.get("top", ""))
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    sources = said.data | said.control if way.way == "control" else said.data
    assert ("topic:/in" in sources) == (way.way != "clean"), said
