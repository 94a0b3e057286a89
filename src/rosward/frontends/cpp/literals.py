# SPDX-License-Identifier: Apache-2.0
"""What stands in the literals of a text, while the text around them is changed?

    f("a; emit b", "c")    ->   f("①·······", "②"),  and what ① and ② stand for

Whatever is rewritten by its look is not rewritten within a literal: a name that is written there stays what it is.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

_LITERAL: Final = re.compile(
    r"""(?P<separator>(?<=[\dA-F])(?<![uU]8)'(?=[\da-fA-F]))|"(?P<content>(?:[^"\\\n]|\\.)+)"|'(?:[^'\\\n]|\\.)*'"""
)
_FIRST: Final = 0xF0000
_LAST: Final = 0x10FFFD
"""Characters that nobody uses in C++ outside of literals."""
_FILLED: Final = "\ue000"
_HIDDEN: Final = re.compile(rf'(?<=")[{chr(_FIRST)}-{chr(_LAST)}]{_FILLED}*(?=")')


def hidden(text: str) -> tuple[str, Sequence[str]]:
    """The text with one character for what is in each literal, as wide as before, and what it stands for."""
    if '"' not in text:
        return text, ()
    contents: dict[str, int] = {}

    def hide(found: re.Match[str]) -> str:
        content = found["content"]
        number = _LAST if content is None else _FIRST + contents.setdefault(content, len(contents))
        return found[0] if number >= _LAST else f'"{chr(number)}{_FILLED * (len(content) - 1)}"'

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
