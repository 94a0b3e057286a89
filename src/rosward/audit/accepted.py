# SPDX-License-Identifier: Apache-2.0
"""Which running nodes and entities are known and accepted, though the source does not explain them?

    # what the maker of the arm starts by itself
    /vendor/*                   its nodes, with all that they have
    /talker /diagnostics        this name on that node

`*` is any text, also over `/`. What is accepted is counted, and is no difference.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, final

from rosward.findings import Finding
from rosward.policies.match import LONGEST_NAME, Pattern
from rosward.source import limits
from rosward.source.json_fields import UnreadableError
from rosward.source.text import decode, read_bytes

__all__ = ["Accepted", "read_accepted"]

_MOST: Final = 1_000


@final
class Accepted:
    """What is accepted. `names` are the lines, each a node, or a node and a name."""

    def __init__(self, names: Iterable[str] = ()) -> None:
        self._rows: list[tuple[Pattern, Pattern | None]] = []
        for line in names:
            words = line.split()
            if len(words) not in (1, 2) or not all(w.startswith(("/", "*")) and len(w) <= LONGEST_NAME for w in words):
                raise UnreadableError(
                    f"{line[:80]!r} is neither the full name of a node nor a node followed by the name of one of its entities"
                )
            self._rows.append((Pattern(words[0]), Pattern(words[1]) if len(words) == 2 else None))
            if len(self._rows) > _MOST:
                raise UnreadableError(f"more than {_MOST:,} names are accepted")

    def node(self, node: str) -> bool:
        """Whether a node is accepted with all that it has."""
        return any(name is None and of.matches(node) for of, name in self._rows)

    def entity(self, node: str, name: str) -> bool:
        """Whether an entity of that name is accepted on a node."""
        return any(of.matches(node) and (own is None or own.matches(name)) for of, own in self._rows)


def read_accepted(path: str) -> list[str]:
    """The lines of a file, without comments. Raises UnreadableError."""
    data = read_bytes(path, path, limits.ACCEPTED_FILE)
    text = data if isinstance(data, Finding) else decode(data, path)
    if isinstance(text, Finding):
        raise UnreadableError(f"{path}: {text.message}")
    lines = (line.partition("#")[0].strip() for line in text.text.splitlines())
    return [line for line in lines if line]
