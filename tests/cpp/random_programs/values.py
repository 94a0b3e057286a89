# SPDX-License-Identifier: Apache-2.0
"""Which values can a program make? Texts, numbers, conditions and lists; each way gives the expression in both languages.

In C++ a text is a `std::string` and a number an `int`; numbers are not negative, texts have the letters of a name.
"""

from __future__ import annotations

from typing import Final

from .draft import Block, Draft, Pair

DEPTH: Final = 3
"""So deep are values made of values."""


def text(draft: Draft, block: Block, depth: int = 0) -> Pair:
    """A text."""
    return _one(draft, block, depth, "text")


def number(draft: Draft, block: Block, depth: int = 0) -> Pair:
    """A number, not negative."""
    return _one(draft, block, depth, "number")


def condition(draft: Draft, block: Block, depth: int = 0) -> Pair:
    """Something that is true or false."""
    return _one(draft, block, depth, "condition")


def words(draft: Draft, block: Block) -> Pair:
    """A list of texts, as an expression of type std::vector<std::string>; not empty."""
    if block.lists and draft.chance(30):
        return draft.pick(block.lists)
    items = [text(draft, block, DEPTH - 1) for _ in range(draft.number(1, 3))]
    return Pair(f"[{', '.join(i.py for i in items)}]", f"std::vector<std::string>{{{', '.join(i.cpp for i in items)}}}")


def name_of(draft: Draft, block: Block, *, prefixes: tuple[str, ...] = ("", "", "", "/", "~/", "sub/")) -> Pair:
    """The name of a topic: it is valid, whatever text stands in it."""
    start = draft.pick(prefixes) + draft.word()
    shape = draft.number(0, 3)
    if shape == 0:
        return Pair(repr(start), f'"{start}"')
    said = text(draft, block)
    if shape == 1:
        return Pair(f"'{start}/x_' + {said.py}", f'"{start}/x_" + {said.cpp}')
    return Pair(f"'{start}_' + {said.py}", f'"{start}_" + {said.cpp}')


def _one(draft: Draft, block: Block, depth: int, kind: str) -> Pair:
    ways = draft.ways[kind]
    among = ways.leaves if depth >= DEPTH else (*ways.leaves, *ways.pure, *(() if block.pure else ways.said))
    way = draft.pick(among)
    draft.use(way.__name__)
    return way(draft, block, depth + 1)
