# SPDX-License-Identifier: Apache-2.0
"""What of a text that the parser does not understand is C++ all the same?

"%" VENDOR_FORMAT " bytes"               "%" ""VENDOR_FORMAT " bytes"      a macro of a header that nobody has
"%" VENDOR_FORMAT(4) " bytes"            "%" ""VENDOR_FORMAT     " bytes"
if (late) volatile int stop = 1;         if (late) {volatile int stop = 1;}
else std::string name("a");              else {std::string name("a");}
x = (i = 4, 5);                          x = ((i = 4), 5);

It is asked only where something was not understood, so that all other files pay nothing. Lines stay; what follows in a line moves.
"""

from __future__ import annotations

import re
from typing import Final

from rosward.frontends.cpp.literals import hidden, shown
from rosward.frontends.cpp.tokens import LITERAL, behind_bracket

_MOST: Final = 1_000
"""So long is what a macro or a condition has between its brackets, at most."""

_BESIDE: Final = re.compile(rf"(?:{LITERAL})(?:(?P<space>\s*)(?P<name>[A-Za-z_]\w*)(?P<open>\s*\()?)?")
_BEFORE: Final = re.compile(r"(?:\bextern|\boperator)\s*\Z")
_NO_MACROS: Final = frozenset({"and", "or", "not_eq", "xor", "bitand", "bitor", "and_eq", "or_eq", "xor_eq"})
_PREFIXES: Final = frozenset({"L", "u", "U", "u8", "R", "LR", "uR", "UR", "u8R"})

_BODY: Final = re.compile(rf"{LITERAL}|\b(?:(?:if|while|for)\s*(?:constexpr\s*)?(?P<open>\()|(?:else|do)(?=\s))")
_DECLARED: Final = re.compile(
    r"\s*(?!(?:return|throw|goto|delete|new|else|do|if|while|for|switch|case|using|typedef|co_return|co_yield|co_await|try|sizeof)\b)"
    r"(?P<declaration>(?:[A-Za-z_]\w*(?:::\w+)*(?:<[^;{}()]{0,200}>)?(?:\s*[*&]+\s*|\s+)){1,5}[A-Za-z_]\w*\s*(?=[=({;])[^;{}]{0,1000}(?:\{[^;{}]{0,1000}\}[^;{}]{0,100})?;)"
)

_ASSIGNED: Final = re.compile(
    r"\((\s*[A-Za-z_][\w.]*\s*[-+*/%&|^]?=(?!=)(?:[^,;(){}\"']|\"[^\"\\\n]{0,200}\"|\([^;(){}\"']{0,200}\)){1,200})(?=,)"
)
"""An assignment that is the first of several in brackets."""


def repaired(text: str) -> str:
    """The text with these made plain; the same one where there are none."""
    text, contents = hidden(_with_bodies(_with_literals(text)))
    return shown(_ASSIGNED.sub(r"((\1)", text), contents)


def _with_literals(text: str) -> str:
    """A name that stands behind a literal is a macro that stands for another: an empty one before it, and the grammar knows it."""
    pieces: list[str] = []
    position = 0
    for found in _BESIDE.finditer(text):
        name = found["name"]
        if name is None or not found[0].startswith('"') or name in _NO_MACROS or found.start() < position:
            continue
        after = text[found.end("name") : found.end("name") + 1]
        if (after == '"' and name in _PREFIXES) or not (found["space"] or (name.isupper() and len(name) > 1)):
            continue
        if _BEFORE.search(text, max(0, found.start() - 20), found.start()):
            continue
        pieces += (text[position : found.start("name")], ' "" ', name)
        position = found.end("name")
        if found["open"]:
            end = behind_bracket(text, found.end(), _MOST)
            if end > 0:
                pieces.append("\n" * text.count("\n", position, end))
                position = end
    return "".join([*pieces, text[position:]])


def _with_bodies(text: str) -> str:
    """A declaration that is all that a condition or a loop does stands between braces."""
    pieces: list[str] = []
    position = 0
    for found in _BODY.finditer(text):
        if not found[0][0].isalpha():
            continue
        start = behind_bracket(text, found.end(), _MOST) if found["open"] else found.end()
        declared = _DECLARED.match(text, start) if start >= position else None
        if declared is not None:
            first, last = declared.span("declaration")
            pieces += (text[position:first], "{", text[first:last], "}")
            position = last
    return "".join([*pieces, text[position:]])
