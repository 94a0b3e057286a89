# SPDX-License-Identifier: Apache-2.0
"""What stands in the literals of a text, while the text around them is changed?

    f("a; emit b", "c")    ->   f("①·······", "②"),  and what ① and ② stand for

Whatever is rewritten by its look is not rewritten within a literal: a name that is written there stays what it is.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from rosward.frontends.cpp.tokens import LITERAL

_LITERAL: Final = re.compile(LITERAL)
_FIRST: Final = 0xF0000
_LAST: Final = 0x10FFFD
"""Characters that nobody uses in C++ outside of literals."""
_FILLED: Final = "\ue000"
_HIDDEN: Final = re.compile(rf"(?<=[\"'])[{chr(_FIRST)}-{chr(_LAST)}]{_FILLED}*(?=[\"'])")


def hidden(text: str) -> tuple[str, Sequence[str]]:
    """The text with one character for what is in each literal, as wide as before, and what it stands for."""
    contents: dict[str, int] = {}

    def hide(found: re.Match[str]) -> str:
        literal = found[0]
        content, quote = literal[1:-1], literal[0]
        if not content or quote not in "\"'":
            return literal
        number = _FIRST + contents.setdefault(content, len(contents))
        return literal if number > _LAST else f"{quote}{chr(number)}{_FILLED * (len(content) - 1)}{quote}"

    changed = _LITERAL.sub(hide, text)
    return changed, tuple(contents)


def shown(text: str, contents: Sequence[str]) -> str:
    """The text with what was hidden; what is not among it stays."""
    if not contents:
        return text

    def show(found: re.Match[str]) -> str:
        number = ord(found[0][0]) - _FIRST
        known = number < len(contents) and len(contents[number]) == len(found[0])
        return contents[number] if known else found[0]

    return _HIDDEN.sub(show, text)
