# SPDX-License-Identifier: Apache-2.0
"""Which numbers and conditions can be made?"""

from __future__ import annotations

from typing import Final

from .draft import Block, Draft, Pair, Way
from .values import condition, number, text, words


def small(draft: Draft, block: Block, depth: int) -> Pair:
    value = str(draft.number(0, 5))
    return Pair(value, value)


def local_number(draft: Draft, block: Block, depth: int) -> Pair:
    return draft.pick(block.numbers) if block.numbers else small(draft, block, depth)


def constant_number(draft: Draft, block: Block, depth: int) -> Pair:
    name, value = draft.fresh("COUNT"), draft.number(0, 5)
    kind = draft.pick(["constexpr int", "const int", "static const int", "constexpr unsigned char"])
    draft.define(f"{name} = {value}", f"{kind} {name} = {value};")
    return Pair(name, f"static_cast<int>({name})" if kind.endswith("char") else name)


def arithmetic(draft: Draft, block: Block, depth: int) -> Pair:
    one, two = number(draft, block, depth), number(draft, block, depth)
    shape = draft.pick(["+", "*", "/", "%"])
    if shape in "+*":
        return Pair(f"({one.py} {shape} {two.py})", f"({one.cpp} {shape} {two.cpp})")
    divisor = draft.number(2, 3)
    return Pair(f"({one.py} {'//' if shape == '/' else '%'} {divisor})", f"({one.cpp} {shape} {divisor})")


def extreme(draft: Draft, block: Block, depth: int) -> Pair:
    one, two, which = number(draft, block, depth), number(draft, block, depth), draft.pick(["min", "max"])
    return Pair(f"{which}({one.py}, {two.py})", f"std::{which}<int>({one.cpp}, {two.cpp})")


def length(draft: Draft, block: Block, depth: int) -> Pair:
    given = draft.pick([text, lambda d, b, _: words(d, b)])(draft, block, depth)
    return Pair(f"len({given.py})", f"static_cast<int>(({given.cpp}).size())")


def compared(draft: Draft, block: Block, depth: int) -> Pair:
    one, two, how = (
        number(draft, block, depth),
        number(draft, block, depth),
        draft.pick(["<", ">", "==", "!=", "<=", ">="]),
    )
    return Pair(f"{one.py} {how} {two.py}", f"({one.cpp} {how} {two.cpp})")


def same_text(draft: Draft, block: Block, depth: int) -> Pair:
    one, word, how = text(draft, block, depth), draft.word(), draft.pick(["==", "!="])
    return Pair(f"{one.py} {how} {word!r}", f'({one.cpp} {how} "{word}")')


def contains(draft: Draft, block: Block, depth: int) -> Pair:
    one, part = text(draft, block, depth), draft.pick(["a", "r", "ar", "front", "_"])
    if draft.chance(50):
        return Pair(f"({one.py}).startswith({part!r})", f'(({one.cpp}).rfind("{part}", 0) == 0)')
    return Pair(f"{part!r} in {one.py}", f'(({one.cpp}).find("{part}") != std::string::npos)')


def both(draft: Draft, block: Block, depth: int) -> Pair:
    one, two = condition(draft, block, depth), condition(draft, block, depth)
    py, cpp = draft.pick([("and", "&&"), ("or", "||")])
    return Pair(f"({one.py} {py} {two.py})", f"({one.cpp} {cpp} {two.cpp})")


def opposite(draft: Draft, block: Block, depth: int) -> Pair:
    one = condition(draft, block, depth)
    return Pair(f"(not {one.py})", f"(!{one.cpp})")


LEAVES: Final[tuple[Way, ...]] = (small, local_number, constant_number)
NUMBERS: Final[tuple[Way, ...]] = (arithmetic, extreme, length)
COMPARISONS: Final[tuple[Way, ...]] = (compared, same_text, contains)
CONDITIONS: Final[tuple[Way, ...]] = (both, opposite)
