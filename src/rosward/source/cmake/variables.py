# SPDX-License-Identifier: Apache-2.0
"""What do the variables of a build description hold, and what does a text with `${NAME}` in it say?"""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, final

from rosward.source.cmake.text import CMakeArgument

_VALUE_LIMIT: Final = 1_000_000  # characters
_PIECE: Final = re.compile(r"(\\.|\$\{|\$ENV\{|\$CACHE\{|\})", re.DOTALL)
_INSTALL_FOLDERS: Final = MappingProxyType(
    {
        "CMAKE_INSTALL_LIBDIR": "lib",
        "CMAKE_INSTALL_BINDIR": "bin",
        "CMAKE_INSTALL_DATADIR": "share",
        "CMAKE_INSTALL_DATAROOTDIR": "share",
    }
)


@final
class Variables:
    """The variables of a project. `steps` counts what they cost, one for each thousand characters."""

    def __init__(self, values: dict[str, str], folders: Mapping[str, str]) -> None:
        self.values = values
        self.steps = 0
        self._folders = folders

    def set(self, name: str, values: list[str]) -> None:
        """`set(NAME value…)`."""
        value = ";".join(values)
        self.steps += len(value) // 1000
        self.values[name] = value if len(value) <= _VALUE_LIMIT else ""

    def change_list(self, operation: str, name: str, values: list[str]) -> None:
        """`list(APPEND NAME value…)` and the other operations that change a list."""
        now = elements(self.values.get(name, ""))
        match operation:
            case "APPEND":
                self.set(name, now + values)
            case "PREPEND":
                self.set(name, values + now)
            case "REMOVE_ITEM":
                unwanted = set(values)
                self.set(name, [item for item in now if item not in unwanted])
            case "REMOVE_DUPLICATES":
                self.set(name, list(dict.fromkeys(now)))
            case "SORT":
                self.set(name, sorted(now))
            case _:
                pass

    def expand(self, arguments: tuple[CMakeArgument, ...], folder: str) -> list[str]:
        """Return the arguments with variables put in, in the current folder; what is not quoted is split at semicolons."""
        result: list[str] = []
        for argument in arguments:
            text = argument.text if argument.literal else self._substitute(argument.text, folder)
            if argument.quoted:
                result.append(text)
            else:
                result += elements(text)
        return result

    def _substitute(self, text: str, folder: str) -> str:
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
                before.append(self._value("".join(now), folder) if opening == "${" else "")
                now = before
            elif piece.startswith("\\") and len(piece) == 2:
                now.append({"n": "\n", "t": "\t", ";": ";"}.get(piece[1], piece[1]))
            else:
                now.append(piece)
        size = sum(map(len, now))
        self.steps += size // 1000
        return "".join(now) if size <= _VALUE_LIMIT else ""

    def _value(self, name: str, folder: str) -> str:
        if name in self.values:
            return self.values[name]
        if name in {"CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR"}:
            return folder
        return self._folders.get(name) or _INSTALL_FOLDERS.get(name, "")


def elements(text: str) -> list[str]:
    """Return the elements of a list, which are not empty."""
    return [part for part in text.split(";") if part]
