# SPDX-License-Identifier: Apache-2.0
"""What does an argument with generator expressions mean, when the package is built?

$<BUILD_INTERFACE:/ws/demo/include>     ->  /ws/demo/include
$<INSTALL_INTERFACE:include>            ->  nothing
$<$<CONFIG:Debug>:TRACE>                ->  TRACE, and nobody knows whether
"""

from __future__ import annotations

import re
from typing import Final

from rosward.records import NamedTuple

_SPECIAL: Final = re.compile(r"\$<|>|:")
_KEPT: Final = frozenset(
    {"BUILD_INTERFACE", "BUILD_LOCAL_INTERFACE", "LINK_ONLY", "COMPILE_ONLY", "1", "LOWER_CASE", "UPPER_CASE"}
)
_LIMIT: Final = 10_000
_OBJECTS: Final = "$<TARGET_OBJECTS:"


class Meant(NamedTuple):
    """A text without generator expressions; without `sure`, nobody knows whether it counts. '' is nothing at all."""

    text: str
    sure: bool = True


def meant(text: str) -> Meant:
    """The argument as the build sees it. `$<TARGET_OBJECTS:x>` stays as it is."""
    if "$<" not in text or text.startswith(_OBJECTS):
        return Meant(text)
    if len(text) > _LIMIT:
        return Meant("", sure=False)
    sure = True
    open_ones: list[tuple[list[str], list[str]]] = []  # what stood before it, and its name once the colon has been seen
    now: list[str] = []
    position = 0
    for mark in _SPECIAL.finditer(text):
        now.append(text[position : mark.start()])
        position = mark.end()
        if mark[0] == "$<":
            open_ones.append((now, []))
            now = []
        elif not open_ones:
            now.append(mark[0])
        elif mark[0] == ":":
            if open_ones[-1][1]:
                now.append(":")
            else:
                open_ones[-1][1].append("".join(now))
                now = []
        else:
            before, name = open_ones.pop()
            value, known = _one(name[0] if name else None, "".join(now))
            sure = sure and known
            now = [*before, value]
    now.append(text[position:])
    return Meant("".join(now), sure) if not open_ones else Meant("", sure=False)


def _one(name: str | None, content: str) -> tuple[str, bool]:
    """The value of one expression, and whether that is sure."""
    if name is None or name in {"INSTALL_INTERFACE", "INSTALL_PREFIX", "0"}:
        return "", name is not None
    if name in _KEPT:
        return content, True
    if name in {"", "TARGET_NAME", "TARGET_NAME_IF_EXISTS"}:
        return content, name != ""
    if name.isupper() or not name:  # a condition, or something that the build computes
        return "", False
    return content, False


def objects_of(text: str) -> str | None:
    """The target in `$<TARGET_OBJECTS:target>`."""
    return text[len(_OBJECTS) : -1] if text.startswith(_OBJECTS) and text.endswith(">") else None
