# SPDX-License-Identifier: Apache-2.0
"""The differences of two states: for a terminal, for a comment on a pull request, for a program.

rights gained: 1
  + /talker: publisher /status
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Final

from rosward._version import __version__
from rosward.differences.compare import Differences
from rosward.outputs.safe import encodable, printable

__all__ = ["diff_json", "diff_markdown", "diff_text"]

_SCHEMA_VERSION: Final = 1


def diff_text(differences: Differences) -> str:
    """Lines with `+` and `-`."""
    lines: list[str] = []
    for title, mark, items in _groups(differences):
        lines += [f"{title}: {len(items)}", *(f"  {mark} {printable(item)}" for item in items)]
    return "\n".join(lines or ["No difference."]) + "\n"


def diff_markdown(differences: Differences) -> str:
    """A section, with what was gained in rights first, since that is what has to be looked at."""
    lines = ["## Nodes, entities and rights", ""]
    groups = sorted(_groups(differences), key=lambda group: group[0] != "rights gained")
    for title, _, items in groups:
        lines += [f"**{title}: {len(items)}**", "", *(f"- `{_plain(item)}`" for item in items), ""]
    return "\n".join(lines if groups else [*lines, "No difference.", ""])


def diff_json(differences: Differences) -> str:
    """`{"nodes": {"gained": […], "lost": […]}, "entities": …, "rights": …}`."""
    nodes, entities, rights = differences
    document = {
        "schema_version": _SCHEMA_VERSION,
        "generator": {"name": "rosward", "version": __version__},
        "nodes": {"gained": nodes.gained, "lost": nodes.lost},
        "entities": {
            "gained": [e._asdict() for e in entities.gained],
            "lost": [e._asdict() for e in entities.lost],
        },
        "rights": {"gained": [r._asdict() for r in rights.gained], "lost": [r._asdict() for r in rights.lost]},
    }
    return encodable(json.dumps(document, indent=2, ensure_ascii=False)) + "\n"


def _groups(differences: Differences) -> Iterator[tuple[str, str, list[str]]]:
    nodes, entities, rights = differences
    groups: tuple[tuple[str, str, Sequence[object]], ...] = (
        ("nodes gained", "+", nodes.gained),
        ("nodes lost", "-", nodes.lost),
        ("entities gained", "+", entities.gained),
        ("entities lost", "-", entities.lost),
        ("rights gained", "+", rights.gained),
        ("rights lost", "-", rights.lost),
    )
    for title, mark, items in groups:
        if items:
            yield title, mark, [str(item) for item in items]


def _plain(text: str) -> str:
    """Text within a code span: nothing in it ends the span."""
    return printable(text).replace("`", "'")
