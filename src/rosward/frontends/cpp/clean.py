# SPDX-License-Identifier: Apache-2.0
"""The text of a C++ file without comments and line splices, each line where it was.

    int a; // first          int a;
    #define B \\          ->  #define B 2
      2

Comments become blanks, a spliced line is one line with the empty ones after it. So whatever is read afterwards keeps its line.
"""

from __future__ import annotations

import re
from typing import Final

from rosward.frontends.cpp.tokens import SEPARATED

_SPECIAL: Final = re.compile(
    rf"""
      (?P<raw>\b(?:u8|u|U|L)?R"([^()\\\s"]{{0,16}})\()
    | (?P<line>//(?:[^\\\n]|\\[ \t]*\n|\\)*)
    | (?P<comment>/\*)
    | (?P<separated>{SEPARATED})
    | (?P<string>"(?:[^"\\\n]|\\[ \t]*\n|\\.)*(?:"|\\?(?=\n|\Z)))
    | (?P<character>'(?:[^'\\\n]|\\[ \t]*\n|\\.)*(?:'|\\?(?=\n|\Z)))
    | (?P<splice>\\[ \t]*\n)
    """,
    re.VERBOSE,
)
_QUOTES: Final = {"string": '"', "character": "'"}
_SPLICE: Final = re.compile(r"\\[ \t]*\n")
_NOT_NEWLINE: Final = re.compile(r"[^\n]+")


def cleaned(text: str) -> str:
    """The text with comments blanked and splices undone; it has as many lines as before."""
    pieces: list[str] = []
    position = 0
    spliced = 0
    unclosed: set[str] = set()

    def put(piece: str) -> None:
        nonlocal spliced
        at = piece.find("\n") if spliced else -1
        if at >= 0:  # the end of a logical line: here come the ends of the lines that it was made of
            piece = f"{piece[:at]}{chr(10) * spliced}{piece[at:]}"
            spliced = 0
        pieces.append(piece)

    search = _SPECIAL.search
    while True:
        found = search(text, position)
        if found is None:
            break
        start, end = found.span()
        put(text[position:start])
        position = end
        kind = found.lastgroup
        if kind == "raw" or found["raw"] is not None:
            closing = f'){found[2]}"'
            at = -1 if closing in unclosed else text.find(closing, end)
            if at < 0:
                unclosed.add(closing)
                put(found[0])
            else:
                position = at + len(closing)
                pieces.append(_one_line(text[start:position]))
                spliced += text.count("\n", start, position)
        elif kind == "comment":
            at = text.find("*/", end)
            position = len(text) if at < 0 else at + 2
            pieces.append(" ")
            put(_NOT_NEWLINE.sub("", text[start:position]) or " ")
        elif kind == "line":
            spliced += found[0].count("\n")
        elif kind == "splice":
            spliced += 1
        else:
            whole = _SPLICE.sub("", found[0]) if "\n" in found[0] else found[0]
            if kind in _QUOTES and not _is_closed(whole, _QUOTES[kind]):
                whole = whole.rstrip("\\") + _QUOTES[kind]  # closed here, so that nobody else has to look for its end
            put(whole)
            spliced += found[0].count("\n")
    put(text[position:])
    return "".join(pieces) + "\n" * spliced


def _is_closed(literal: str, quote: str) -> bool:
    """Whether a literal ends with its quote, and not with an escaped one."""
    content = literal[1:].removesuffix(quote)
    return len(content) < len(literal) - 1 and (len(content) - len(content.rstrip("\\"))) % 2 == 0


def _one_line(raw: str) -> str:
    """A raw string as an ordinary one in one line, so that nobody else has to know about raw strings."""
    content = raw[raw.index("(") + 1 : raw.rindex(")")]
    escaped = content.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'{raw[: raw.index("R")]}"{escaped}"'
