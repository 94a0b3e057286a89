# SPDX-License-Identifier: Apache-2.0
"""Which components do sources in C++ register that are of no package?

pump.cpp: RCLCPP_COMPONENTS_REGISTER_NODE(demo::Pump)         a CMakeLists.txt without a package.xml, or a folder of sources alone
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Final

from rosward.effects.entry import Entry

if TYPE_CHECKING:
    from pathlib import Path

    from rosward.source.cmake.programs import Unit
    from rosward.source.workspace import SourceFile

MAIN: Final = re.compile(r"\bmain\s*\(")
REGISTERED: Final = re.compile(
    r"^[ \t]*RCLCPP_COMPONENTS_REGISTER_NODE(?:_WITH_FACTORY)?\s*\(\s*([\w:]+)", re.MULTILINE
)


def components_of(
    texts: Mapping[SourceFile, str], unit: Callable[[SourceFile], Unit]
) -> Iterator[tuple[Entry, tuple[Unit, ...]]]:
    """How each of them starts, and what it is linked of: all sources beside it. It is assumed to be loaded by somebody.

    Where a source beside it has `main`, that is the program.
    """
    folders: dict[Path, list[SourceFile]] = {}
    for file in texts:
        if file.package is None:
            folders.setdefault(file.path.parent, []).append(file)
    for beside in folders.values():
        found = [(file, match[1].removeprefix("::")) for file in beside for match in REGISTERED.finditer(texts[file])]
        if not found or any(MAIN.search(texts[file]) for file in beside):
            continue
        units = {file: unit(file) for file in beside}
        for file, plugin in found:
            label = f"{file.relative}/{plugin}"
            entry = Entry(file.relative, "", "", (plugin,), None, None, label, assumed=True, program=label)
            yield entry, (units[file], *(each for other, each in units.items() if other is not file))
