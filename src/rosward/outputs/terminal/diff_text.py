# SPDX-License-Identifier: Apache-2.0
"""The differences of two states: for a terminal, for a comment on a pull request, for a program.

rights gained: 1
  + /talker: publisher /status  (src/talker.py:9)

The form of the JSON is schemas/diff.schema.json.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from rosward.diff.compare import Differences, RightLine
from rosward.safe import printable

__all__ = ["diff_markdown", "diff_text"]

_MOST_ROWS: Final = 200
"""Rows of one list in Markdown: a comment on GitHub has 65,536 characters at most."""


def diff_text(differences: Differences) -> str:
    """Lines with `+` and `-`."""
    lines: list[str] = []
    for title, mark, items in _groups(differences):
        lines += [f"{title}: {len(items)}", *(f"  {mark} {printable(_line(item))}" for item in items)]
    lines = lines or ["No difference."]
    return "\n".join([*lines, *(f"note: {printable(note)}" for note in differences.notes)]) + "\n"


def diff_markdown(differences: Differences) -> str:
    """What somebody has to look at first: the new rights; the rest can be unfolded. One line where nothing changed."""
    notes = [f"> `{_plain(note)}`" for note in differences.notes[:_MOST_ROWS]]
    if differences.empty:
        return "\n\n".join(["**rosward:** no change in nodes, entities or permissions.", *notes]) + "\n"
    parts = [f"**rosward:** {_in_short(differences)}", *_new_rights(differences.rights.gained)]
    for title, _, items in _groups(differences):
        if title != "permissions gained":
            rows = [f"- `{_plain(str(item))}`" for item in items[:_MOST_ROWS]]
            rows += [f"- … and {len(items) - _MOST_ROWS} more"] if len(items) > _MOST_ROWS else []
            listed = "\n".join(rows)
            parts.append(f"<details><summary>{title}: {len(items)}</summary>\n\n{listed}\n\n</details>")
    return "\n\n".join([*parts, *notes]) + "\n"


def _in_short(differences: Differences) -> str:
    nodes, entities, rights = differences[:3]
    changes = ((rights, "permission"), (nodes, "node"), (entities, "entity"))
    counts = [
        f"{len(items)} {'new ' if new else ''}{_several(word, len(items))}{'' if new else ' removed'}"
        for change, word in changes
        for items, new in ((change.gained, True), (change.lost, False))
        if items
    ]
    first = [] if rights.gained else ["no new permissions"]
    return ", ".join([*first, *counts]) + "."


def _several(word: str, number: int) -> str:
    return word if number == 1 else "entities" if word == "entity" else f"{word}s"


def _new_rights(rights: Sequence[RightLine]) -> Iterator[str]:
    if rights:
        rows = ["| enclave | new permission | where |", "|---|---|---|"]
        rows += [
            f"| {_cell(r.enclave)} | {_plain(r.words)} {_cell(r.name)} | {_cell(str(r.place))} |"
            for r in rights[:_MOST_ROWS]
        ]
        rows += [f"| | … and {len(rights) - _MOST_ROWS} more | |"] if len(rights) > _MOST_ROWS else []
        yield "\n".join(rows)


def _groups(differences: Differences) -> Iterator[tuple[str, str, Sequence[object]]]:
    nodes, entities, rights = differences[:3]
    groups: tuple[tuple[str, str, Sequence[object]], ...] = (
        ("nodes gained", "+", nodes.gained),
        ("nodes lost", "-", nodes.lost),
        ("entities gained", "+", entities.gained),
        ("entities lost", "-", entities.lost),
        ("permissions gained", "+", rights.gained),
        ("permissions lost", "-", rights.lost),
    )
    for title, mark, items in groups:
        if items:
            yield title, mark, items


def _line(item: object) -> str:
    return f"{item}  ({item.place})" if isinstance(item, RightLine) else str(item)


def _cell(text: str) -> str:
    """A code span in a table: nothing in it ends the span or the cell."""
    escaped = _plain(text).replace("|", "\\|")
    return f"`{escaped}`"


def _plain(text: str) -> str:
    """Text of one line for a code span: nothing in it ends the span."""
    return printable(text).replace("`", "'")
