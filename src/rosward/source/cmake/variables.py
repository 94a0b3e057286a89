# SPDX-License-Identifier: Apache-2.0
"""What does an argument of a CMake command become, with the variables put in?

${S}  where S is "a.cpp;b.cpp"      ->  ["a.cpp", "b.cpp"]
"${S}"                              ->  ["a.cpp;b.cpp"]
lib_${SYSTEM}  that nobody knows    ->  a text that holds `HOLE`
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Final, final

from rosward.source.cmake.text import CMakeArgument

HOLE: Final = "\0"
"""Stands in a value for what is not known; no text of a description holds one (`text.py` reads none)."""

_VALUE_LIMIT: Final = 1_000_000  # characters
_PIECE: Final = re.compile(r"(\\.|\$\{|\$ENV\{|\$CACHE\{|\})", re.DOTALL)
_ESCAPES: Final = {"n": "\n", "t": "\t", ";": ";"}.get


def split(text: str) -> list[str]:
    """The elements of a list; a generator expression and brackets keep theirs together."""
    if ";" not in text:
        return [text] if text else []
    if "$<" not in text:
        return [part for part in text.split(";") if part]
    parts: list[str] = []
    depth, start = 0, 0
    for mark in re.finditer(r"\$<|>|;", text):
        if mark[0] == "$<":
            depth += 1
        elif mark[0] == ">":
            depth = max(0, depth - 1)
        elif not depth:
            parts.append(text[start : mark.start()])
            start = mark.end()
    parts.append(text[start:])
    return [part for part in parts if part]


@final
class Variables:
    """The variables of one scope; `known` gives those that CMake itself sets, `environment` those of the process."""

    __slots__ = ("_environment", "_known", "_spent", "values")

    def __init__(
        self,
        known: Callable[[str], str],
        environment: Callable[[str], str],
        spent: Callable[[int], None],
        values: dict[str, str],
    ) -> None:
        self._known = known
        self._environment = environment
        self._spent = spent
        self.values = values

    def get(self, name: str) -> str:
        """The value of a variable; '' where it has none."""
        value = self.values.get(name)
        return self._known(name) if value is None else value

    def elements(self, name: str) -> list[str]:
        """The elements of the list that a variable holds."""
        return split(self.get(name))

    def is_set(self, name: str) -> bool:
        """Whether it has a value, be it an empty one."""
        return name in self.values or bool(self._known(name))

    def set(self, name: str, values: Iterable[str]) -> None:
        """Give it a list; one that is too long is lost."""
        value = ";".join(values)
        self._spent(len(value) // 1000)
        self.values[name] = value if len(value) <= _VALUE_LIMIT else ""

    def set_version(self, project: str, version: str) -> None:
        """What `project(demo VERSION 1.2.3)` sets."""
        numbers = [*version.split("."), "", "", ""]
        for name in ("PROJECT", project):
            self.values[f"{name}_VERSION"] = version
            for part, number in zip(("MAJOR", "MINOR", "PATCH"), numbers, strict=False):
                self.values[f"{name}_VERSION_{part}"] = number

    def expand(self, arguments: Iterable[CMakeArgument]) -> list[str]:
        """The arguments with variables put in; what is not quoted falls apart at its semicolons."""
        result: list[str] = []
        for argument in arguments:
            text = argument.text if argument.literal else self.substitute(argument.text)
            if argument.quoted:
                result.append(text)
            else:
                result += split(text)
        return result

    def substitute(self, text: str) -> str:
        """The text with `${NAME}` replaced, the inner ones of `${A_${B}}` first, and escapes resolved."""
        if "$" not in text and "\\" not in text:
            return text
        open_ones: list[tuple[str, list[str]]] = []
        now: list[str] = []
        for piece in _PIECE.split(text):
            if piece.startswith("$") and piece.endswith("{"):
                open_ones.append((piece, now))
                now = []
            elif piece == "}" and open_ones:
                opening, before = open_ones.pop()
                name = "".join(now)
                before.append(self._environment(name) if opening == "$ENV{" else self.get(name))
                now = before
            elif piece.startswith("\\") and len(piece) == 2:
                now.append(_ESCAPES(piece[1], piece[1]))
            else:
                now.append(piece)
        size = sum(map(len, now))
        self._spent(size // 1000)
        return "".join(now) if size <= _VALUE_LIMIT else ""
