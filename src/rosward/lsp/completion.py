# SPDX-License-Identifier: Apache-2.0
"""Which names can be meant where a remapping is being written? Those of the node first, then all that there are.

<remap from="|" …/>     remappings=[("|", "")]     - from: "|"
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final, NamedTuple

from rosward.lsp.extents import LONGEST_LINE, Extent
from rosward.lsp.marks import meeting
from rosward.lsp.records import End, Started
from rosward.lsp.state import State

__all__ = ["Offer", "completions"]

_MOST: Final = 500
_BACK: Final = 30
_NAME: Final = r"[\w/~{}.*-]*"
_XML: Final = re.compile(rf"\b(?:from|to)\s*=\s*[\"']({_NAME})$")
_YAML: Final = re.compile(rf"\b(?:from|to)[\"']?\s*:\s*[\"']?({_NAME})$")
_PYTHON: Final = re.compile(rf"[\"']({_NAME})$")
_REMAPS: Final = re.compile(r"\bremap(?:ping)?s?\b|\bSetRemap\b")
_CLOSED: Final = re.compile(r"\]")


class Offer(NamedTuple):
    """A name, what it is, where it is to stand, and how near it is (0: of this node)."""

    name: str
    detail: str
    extent: Extent
    rank: int


def completions(state: State, path: str, line: int, column: int) -> list[Offer]:
    """The names at a position; none where no remapping is written."""
    folder, lines = state.folder_of(path), state.lines(path)
    if (
        folder is None
        or not 0 <= line < len(lines)
        or any(len(t) > LONGEST_LINE for t in lines[max(0, line - _BACK) : line + 1])
    ):
        return []
    begun = _begun(lines, path, line, column)
    if begun is None:
        return []
    rest = re.match(_NAME, lines[line][column:])
    where = Extent(line, column - len(begun), line, column + (rest.end() if rest else 0))
    near = {
        end.name
        for found in state.at(path, line, column)
        if isinstance(found.mark.what, Started)
        for node in found.marks.nodes_at(found.mark.what.place)
        for end in node.ends
    }
    offers: dict[str, Offer] = {}
    for marks in folder.views():
        for name, inside in marks.named.items():
            if name not in offers and "*" not in name:
                what = inside[0].what
                detail = f"{meeting(what)} {what.type or ''}".rstrip() if isinstance(what, End) else ""
                offers[name] = Offer(name, detail, where, int(name not in near))
    return sorted(offers.values(), key=lambda offer: (offer.rank, offer.name))[:_MOST]


def _begun(lines: Sequence[str], path: str, line: int, column: int) -> str | None:
    """What is written of the name; None where no remapping is written."""
    before = lines[line][:column]
    if path.endswith((".xml", ".launch")):
        match = _XML.search(before) if "remap" in _tag(lines, line, column) else None
    elif path.endswith((".yaml", ".yml")):
        match = _YAML.search(before) if _is_remapping(lines, line) else None
    elif path.endswith(".py"):
        match = _PYTHON.search(before) if _is_in_list(lines, line, column) else None
    else:
        match = None
    return None if match is None else match[1]


def _tag(lines: Sequence[str], line: int, column: int) -> str:
    """The tag that is open at a position."""
    text = "\n".join([*lines[max(0, line - 5) : line], lines[line][:column]])
    opened = text.rpartition("<")[2]
    return "" if ">" in opened else opened[:20]


def _is_remapping(lines: Sequence[str], line: int) -> bool:
    indent = len(lines[line]) - len(lines[line].lstrip())
    for number in range(line, max(-1, line - _BACK), -1):
        text = lines[number]
        if text.strip() and (number == line or len(text) - len(text.lstrip()) <= indent) and _REMAPS.search(text):
            return True
    return False


def _is_in_list(lines: Sequence[str], line: int, column: int) -> bool:
    """Whether the nearest list that is open was begun for remappings."""
    text = "\n".join([*lines[max(0, line - _BACK) : line], lines[line][:column]])
    last = None
    for match in _REMAPS.finditer(text):
        last = match
    return last is not None and not _CLOSED.search(text, last.end())
