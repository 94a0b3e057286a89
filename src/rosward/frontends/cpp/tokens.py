# SPDX-License-Identifier: Apache-2.0
"""Which tokens does a piece of cleaned C++ text consist of?

    "f(a, 1'000)"   ->   f ( a , ␣ 1'000 )

White space is a token, too, so that the tokens in a row are the text again. Nothing is refused: what is no token is one character.
"""

from __future__ import annotations

import re
from typing import Final

_TOKEN: Final = re.compile(
    r"""[A-Za-z_$]\w*(?:"(?:[^"\\\n]|\\.)*")?   # a name, or the prefix of a literal with it
    |\s+
    |\.?\d(?:[eEpP][+-]|'?[\w.])*
    |"(?:[^"\\\n]|\\.)*"
    |'(?:[^'\\\n]|\\.)*'
    |\#\#|::|->|<<|>>|<=|>=|==|!=|&&|\|\||.
    """,
    re.VERBOSE | re.DOTALL,
)
SEPARATED: Final = r"[0-9](?<!\w[0-9])\w*(?:'\w+)+"
"""The pattern of a number with separators (`0xff'ff`), which begin no literal."""
LITERAL: Final = rf""""(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|{SEPARATED}"""
"""The pattern of a literal in cleaned text, be it of what has no quotes but for separators."""

_BRACKET: Final = re.compile(rf"{LITERAL}|[()]")
"""A round bracket; literals match, too, so that none is found within them."""

NAME: Final = re.compile(r"[A-Za-z_]\w*")
_NOT_NEWLINE: Final = re.compile(r"[^\n]")


def tokens(text: str) -> list[str]:
    """The tokens of a text; joined, they are the text."""
    return _TOKEN.findall(text)


def is_name(token: str) -> bool:
    """Whether a token is an identifier (or keyword)."""
    return token.isidentifier()


def trimmed(found: list[str]) -> list[str]:
    """The tokens without white space at both ends, and with single blanks within."""
    result = [" " if token.isspace() else token for token in found]
    while result and result[-1] == " ":
        result.pop()
    start = 0
    while start < len(result) and result[start] == " ":
        start += 1
    return result[start:]


def open_brackets(text: str) -> int:
    """How many round brackets a text opens more than it closes, literals left out."""
    if "(" not in text and ")" not in text:
        return 0
    found = _BRACKET.findall(text)
    return found.count("(") - found.count(")")


def behind_bracket(text: str, position: int, most: int) -> int:
    """The position behind the bracket that closes the one before `position`; -1 where none does within `most` characters."""
    depth = 1
    for mark in _BRACKET.finditer(text, position, position + most):
        depth += (mark[0] == "(") - (mark[0] == ")")
        if not depth:
            return mark.end()
    return -1


def blank(text: str) -> str:
    """As many blanks as the text has characters, in as many lines."""
    return _NOT_NEWLINE.sub(" ", text)
