# SPDX-License-Identifier: Apache-2.0
"""Which value has a literal? `0x1Fu`, `1'000.5f`, `"a\\n" "b"`, `R"(x)"`, `'c'`, `10ms`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body, Want
from rosward.frontends.cpp.lower.survey import word
from rosward.ir.core import Binary, CharText
from rosward.ir.cpp import Argued, Invoke, Name, Part

if TYPE_CHECKING:
    from tree_sitter import Node

_ESCAPES: Final[Mapping[str, str]] = {
    "n": "\n", "t": "\t", "r": "\r", "0": "\0", "a": "\a", "b": "\b", "f": "\f", "v": "\v", "e": "\x1b",
}  # fmt: skip
_FLOATS: Final = frozenset({"float", "double", "long double"})
_NO_NUMBERS: Final = frozenset(
    {"bool", "char", "signed char", "unsigned char", "int8_t", "uint8_t", "char16_t", "char32_t", "wchar_t", "void"}
)
_DIGITS: Final = 400
"""A longer number is no number that anybody means."""


def number(text: str) -> int | float | None:
    """The value of a number as it is written."""
    text = text.replace("'", "").lower()
    if text[:1] in ("-", "+"):  # the grammar counts the sign in
        value = number(text[1:])
        return value if value is None or text[0] == "+" else -value
    if len(text) > _DIGITS:
        return None
    hexadecimal = text.startswith("0x")
    plain = text.rstrip("ulz") if hexadecimal or "." not in text else text
    try:
        if hexadecimal:
            return float.fromhex(text.rstrip("fl")) if "p" in text else int(plain, 16)
        if text.startswith("0b"):
            return int(plain, 2)
        if re.fullmatch(r"0[0-7]+", plain):
            return int(plain, 8)
        if plain.isdigit():
            return int(plain)
        return float(re.sub(r"(?:f|l|f\d+)$", "", plain))
    except (ValueError, OverflowError):
        return None


_FITS: Final = 128
_HOLDS: Final = {"int": range(-(2**31), 2**31), "long": range(-(2**63), 2**63), "double": range(-(2**63), 2**63)}
"""Which whole numbers some types hold; smaller ones than `_FITS` all hold."""


def is_of(type_: str, node: Node | None) -> bool:
    """Whether a literal is of this builtin type as it stands: `int n = 0`, `bool b = true`, not `int n = 0.5`."""
    if node is None:
        return False
    if node.type == "number_literal":
        value = number(word(node))
        kind = type(value)
        if isinstance(value, int) and not 0 <= value < _FITS and value not in _HOLDS.get(type_, range(0)):
            return False
        return kind is (float if type_ in _FLOATS else int) and type_ not in _NO_NUMBERS and bool(type_)
    return type_ == "bool" and node.type in ("true", "false")


def text_of(node: Node) -> str | None:
    """The text that a literal of a string or character means; None for what is none."""
    if node.type == "raw_string_literal":
        return next((word(child) for child in node.children if child.type == "raw_string_content"), "")
    if node.type not in {"string_literal", "char_literal"}:
        return None
    data = node.text or b""
    start = node.start_byte
    inner = node.children[1:-1]
    pieces: list[str] = []
    at = inner[0].start_byte if inner else node.end_byte
    for child in inner:
        pieces.append(data[at - start : child.start_byte - start].decode("utf-8", "replace"))
        pieces.append(_escaped(word(child)) if child.type == "escape_sequence" else word(child))
        at = child.end_byte
    return "".join(pieces)


def _escaped(sequence: str) -> str:
    body = sequence[1:]
    try:
        if body[:1] in "xuU" and len(body) > 1:
            return chr(int(body[1:].strip("{}"), 16))
        if body[:1].isdigit() and body != "0":
            return chr(int(body[:3], 8))
    except (ValueError, OverflowError):
        return sequence
    return _ESCAPES.get(body, body)


def _number(body: Body, node: Node, _want: Want) -> int:
    value = number(word(node))
    return body.unknown(node, "syntax") if value is None else body.constant(node, value)


def _string(body: Body, node: Node, _want: Want) -> int:
    text = text_of(node)
    return body.constant(node, text if text is None or node.type == "char_literal" else CharText(text))


def _concatenated(body: Body, node: Node, _want: Want) -> int:
    """Literals side by side; between them a name that may be a macro nobody knows."""
    parts = [child for child in node.named_children if child.type != "comment"]
    texts = [text_of(child) for child in parts]
    if None not in texts:
        return body.constant(node, CharText("".join(text or "" for text in texts)))
    found = body.value(parts[0])
    for part in parts[1:]:
        right = body.value(part)
        dst = body.register()
        body.emit(Binary(*body.place(part), dst, "+", found, right))
        found = dst
    return found


def _user_defined(body: Body, node: Node, _want: Want) -> int:
    """`10ms`, `"a"s`: what the operator of that suffix makes of the literal, and of its length where it is a text."""
    literal = node.named_children[0]
    text = None if literal.type == "char_literal" else text_of(literal)
    given = [Argued(body.value(literal))]
    if text is not None:
        given.append(Argued(body.constant(node, len(text.encode()))))
    func, dst = body.register(), body.register()
    place = body.place(node)
    body.emit(Name(*place, func, (Part(f'operator""{word(node.named_children[-1])}'),)))
    body.emit(Invoke(*place, dst, func, tuple(given)))
    return dst


EXPRESSIONS: Final = {
    "number_literal": _number,
    "string_literal": _string,
    "raw_string_literal": _string,
    "char_literal": _string,
    "concatenated_string": _concatenated,
    "user_defined_literal": _user_defined,
    "true": lambda body, node, _want: body.constant(node, True),
    "false": lambda body, node, _want: body.constant(node, False),
    "null": lambda body, node, _want: body.constant(node, None),
}
