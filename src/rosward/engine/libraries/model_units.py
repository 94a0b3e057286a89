# SPDX-License-Identifier: Apache-2.0
"""Which models are run together, and in which order?

    units(stubs, "launch_ros.actions")  ->  [("collections.abc",), ("launch", "launch.action", …), ("launch_ros", "launch_ros.actions", …)]

As in Python a package goes before its modules, and what is imported before what imports it. Modules that need each other are one unit, which
begins with the uppermost of them. So what a unit makes depends on the stubs alone, not on which of its modules a program names first.
"""

from __future__ import annotations

from collections.abc import Iterator

from rosward.engine.libraries.stub_files import StubFiles


def units(stubs: StubFiles, name: str) -> list[tuple[str, ...]]:
    """The units that a model needs, its own last: the strongly connected parts of what stubs import (Tarjan, without recursion)."""
    found: list[tuple[str, ...]] = []
    numbers: dict[str, int] = {}
    lowest: dict[str, int] = {}
    open_: dict[str, None] = {}
    work: list[tuple[str, Iterator[str]]] = []

    def enter(module: str) -> None:
        numbers[module] = lowest[module] = len(numbers)
        open_[module] = None
        work.append((module, iter(_needed(stubs, module))))

    enter(name)
    while work:
        module, needed = work[-1]
        for other in needed:
            if other not in numbers:
                enter(other)
                break
            if other in open_:
                lowest[module] = min(lowest[module], numbers[other])
        else:
            work.pop()
            if work:
                above = work[-1][0]
                lowest[above] = min(lowest[above], lowest[module])
            if lowest[module] == numbers[module]:
                found.append(_closed(open_, module))
    return found


def _closed(open_: dict[str, None], first: str) -> tuple[str, ...]:
    """Take a unit from what is open: all that was entered since its first module."""
    members = []
    while True:
        member, _ = open_.popitem()
        members.append(member)
        if member == first:
            return tuple(sorted(members, key=lambda m: (m.count("."), m)))


def _needed(stubs: StubFiles, name: str) -> list[str]:
    """The models that have to be there before this one: its packages, and all that it imports before a function of it is called.

    What a function imports is loaded when it is first called: most programs call few of them. That may be while the unit of the stub is loaded,
    and then it is at the same point for whoever asks, since no unit that needs this one can have been loaded before.
    """
    file = stubs.find(name)
    module = None if file is None else stubs.module(file)
    needed = set(_with_packages(name))
    if module is not None and file is not None:
        for written in module.first:
            level = len(written) - len(written.lstrip("."))
            needed.update(_with_packages(absolute(written[level:], level, name, file)))
    return sorted(n for n in needed if n != name and stubs.find(n) is not None)


def _with_packages(name: str) -> Iterator[str]:
    """A module and the packages around it."""
    while name:
        yield name
        name = name.rpartition(".")[0]


def absolute(name: str, level: int, importer: str, file: str) -> str:
    """The absolute form of an import in a model; `file` is that of the importer."""
    if not level:
        return name
    parts = importer.split(".")
    keep = len(parts) - level + (1 if file.endswith("__init__.pyi") else 0)
    return ".".join([*parts[: max(keep, 0)], *([name] if name else [])])
