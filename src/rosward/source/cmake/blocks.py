# SPDX-License-Identifier: Apache-2.0
"""Which commands of a CMakeLists.txt belong to which block?

    if(A)            Block(if(A), [x()], branches=[(else(), [y()])])
      x()
    else()
      y()
    endif()

A block that is not closed holds everything up to the end; an end without its beginning is a command like any other.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, TypeAlias

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source.cmake.text import Command

_OPENING: Final = frozenset({"if", "foreach", "while", "function", "macro", "block"})
_BRANCH: Final = frozenset({"elseif", "else"})


class Block(NamedTuple):
    """What stands between `foreach(…)`, `if(…)` and the like and its end; `branches` are the `elseif` and `else` of an `if`."""

    opening: Command
    body: list[Step]
    branches: list[tuple[Command, list[Step]]]


class Way(NamedTuple):
    """One way of an `if` that nobody can decide, each time that it is read."""

    place: Place
    number: int


Step: TypeAlias = Command | Block


def blocks(commands: Sequence[Command], depth_limit: int) -> tuple[list[Step], Command | None]:
    """The commands as a tree, and the first one that is nested too deeply: it and what is in it are left out."""
    top: list[Step] = []
    into = top
    around: list[tuple[str, Block, list[Step]]] = []
    too_deep: Command | None = None
    left_out = 0
    for command in commands:
        name = command.name
        if name in _OPENING:
            if left_out or len(around) >= depth_limit:
                too_deep = too_deep or command
                left_out += 1
                continue
            block = Block(command, [], [])
            into.append(block)
            around.append((name, block, into))
            into = block.body
        elif left_out:
            left_out -= name.startswith("end") and name[3:] in _OPENING
        elif name in _BRANCH and around and around[-1][0] == "if":
            into = []
            around[-1][1].branches.append((command, into))
        elif name.startswith("end") and any(kind == name[3:] for kind, _, _ in around):
            while True:
                kind, _, into = around.pop()
                if kind == name[3:]:
                    break
        else:
            into.append(command)
    return top, too_deep
