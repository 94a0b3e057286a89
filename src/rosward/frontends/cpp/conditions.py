# SPDX-License-Identifier: Apache-2.0
"""Does the condition of an `#if` hold?

#if defined(WITH_IMU) && RATE > 10      where both are defined      ->  True
#if OPENCV_VERSION_MAJOR >= 4           where nobody knows          ->  None
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Final, Protocol, final

from rosward.frontends.cpp.macros import Expansion, Macros, TooMuchError
from rosward.frontends.cpp.tokens import is_name, tokens

_LIMIT: Final = 2_000  # tokens
_DEPTH: Final = 40
_INTEGER: Final = re.compile(r"(0[xX][\da-fA-F]{1,16}|0[bB][01]{1,64}|\d{1,20})[uUlLzZ]*")
_UNKNOWN: Final = "\0unknown"
_PRECEDENCE: Final[Mapping[str, int]] = {
    "||": 1, "&&": 2, "|": 3, "^": 4, "&": 5, "==": 6, "!=": 6, "<": 7, ">": 7, "<=": 7, ">=": 7, "<<": 8, ">>": 8, "+": 9, "-": 9,
    "*": 10, "/": 10, "%": 10,
}  # fmt: skip
_OPERATIONS: Final[Mapping[str, Callable[[int, int], int | None]]] = {
    "|": lambda a, b: a | b,
    "^": lambda a, b: a ^ b,
    "&": lambda a, b: a & b,
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    ">": lambda a, b: a > b,
    "<=": lambda a, b: a <= b,
    ">=": lambda a, b: a >= b,
    "<<": lambda a, b: a << b if 0 <= b < 64 else None,
    ">>": lambda a, b: a >> b if 0 <= b < 64 else None,
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: int(a / b) if b and abs(a) < 2**52 else None,
    "%": lambda a, b: a % b if b else None,
}
_SIGNS: Final[Mapping[str, Callable[[int], int]]] = {
    "!": lambda a: int(not a),
    "-": lambda a: -a,
    "+": lambda a: a,
    "~": lambda a: ~a,
}


class Asked(Protocol):
    """What conditions ask beside macros."""

    def defined(self, name: str) -> bool | None:
        """Whether a name that no definition was seen of is defined."""

    def has_include(self, name: str, *, quoted: bool) -> bool | None:
        """Whether a header is there."""

    def call(self, name: str, arguments: Sequence[str]) -> bool | None:
        """Whether a version macro of a library holds."""


def is_defined(name: str, macros: Macros, asked: Asked) -> bool | None:
    """Whether a name is defined."""
    macro = macros.get(name)
    if macro is None:
        return asked.defined(name)
    if macro.alternatives:
        known = {m is not None for m in macro.alternatives}
        return known.pop() if len(known) == 1 else None
    return True


def holds(text: str, macros: Macros, asked: Asked, budget: int) -> bool | None:
    """Whether the condition holds; None where nobody can say."""
    found = [t for t in tokens(text) if not t.isspace()]
    if len(found) > _LIMIT:
        return None
    found = _answered(found, macros, asked)
    try:
        expanded = Expansion(macros, budget, lambda _, __: None).expand(found)
    except TooMuchError:
        return None
    parser = _Expression(_answered([t for t in expanded if not t.isspace()], macros, asked), asked)
    value = parser.ternary(0)
    return None if value is None or not parser.at_end() else bool(value)


def _answered(found: list[str], macros: Macros, asked: Asked) -> list[str]:
    """The tokens with `defined X` and `__has_include(X)` replaced by what they say."""
    result: list[str] = []
    position = 0
    while position < len(found):
        token = found[position]
        position += 1
        if token == "defined":
            bracket = found[position : position + 1] == ["("]
            name = "".join(found[position + bracket : position + bracket + 1])
            position += 3 if bracket else 1
            result.append(_constant(is_defined(name, macros, asked)))
        elif token == "__has_include" and found[position : position + 1] == ["("]:
            end = found.index(")", position) if ")" in found[position:] else len(found)
            name = "".join(found[position + 1 : end])
            position = end + 1
            result.append(_constant(asked.has_include(name[1:-1], quoted=name.startswith('"'))))
        elif token in macros and macros[token].alternatives:
            result.append(_UNKNOWN)
        else:
            result.append(token)
    return result


def _constant(answer: bool | None) -> str:
    return _UNKNOWN if answer is None else str(int(answer))


@final
class _Expression:
    """A constant expression in the course of being read; its depth is bounded."""

    def __init__(self, found: list[str], asked: Asked) -> None:
        self._found = found
        self._asked = asked
        self._position = 0

    def at_end(self) -> bool:
        return self._position >= len(self._found)

    def _next(self) -> str:
        return self._found[self._position] if not self.at_end() else ""

    def ternary(self, depth: int) -> int | None:
        condition = self._binary(1, depth)
        if self._next() != "?":
            return condition
        if depth > _DEPTH:
            return None
        self._position += 1
        first = self.ternary(depth + 1)
        if self._next() != ":":
            return None
        self._position += 1
        second = self.ternary(depth + 1)
        return None if condition is None else first if condition else second

    def _binary(self, least: int, depth: int) -> int | None:
        left = self._unary(depth)
        while True:
            operator = self._next()
            strength = _PRECEDENCE.get(operator, 0)
            if strength < least or depth > _DEPTH:
                return left
            self._position += 1
            right = self._binary(strength + 1, depth + 1)
            if operator == "&&":
                left = 0 if left == 0 or right == 0 else None if left is None or right is None else 1
            elif operator == "||":
                left = 1 if left or right else None if left is None or right is None else 0
            else:
                left = None if left is None or right is None else _OPERATIONS[operator](left, right)

    def _unary(self, depth: int) -> int | None:
        operators: list[str] = []
        while self._next() in _SIGNS:
            operators.append(self._next())
            self._position += 1
        value = self._primary(depth)
        for operator in reversed(operators):
            value = None if value is None else _SIGNS[operator](value)
        return value

    def _primary(self, depth: int) -> int | None:
        token = self._next()
        self._position += 1
        if token == "(":
            value = self.ternary(depth + 1) if depth <= _DEPTH else None
            if self._next() == ")":
                self._position += 1
                return value
            self._position = len(self._found) + 1
            return None
        number = _INTEGER.fullmatch(token.replace("'", ""))
        if number is not None:
            digits = number[1].lower()
            if digits.startswith(("0x", "0b")):
                return int(digits, 0)
            return int(digits, 8 if digits.startswith("0") and set(digits) <= set("01234567") else 10)
        if token in {"true", "false"}:
            return int(token == "true")
        if is_name(token) and self._next() == "(":
            arguments: list[str] = []
            self._position += 1
            while not self.at_end() and self._next() != ")":
                arguments.append(self._next())
                self._position += 1
            self._position += 1
            answer = self._asked.call(token, [a for a in arguments if a != ","])
            return None if answer is None else int(answer)
        if is_name(token):
            defined = self._asked.defined(token)
            return 0 if defined is False else None
        return None
