# SPDX-License-Identifier: Apache-2.0
"""What a random program is written into: files, definitions of the main module, names that are not used twice.

draft = Draft(chooser)
draft.define("TOPIC = 'scan'")        a statement of main.py, before what uses it
draft.fresh("topic")                  topic1, topic2, …
"""

from __future__ import annotations

import random
import textwrap
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeVar

T = TypeVar("T")


class Chooser(Protocol):
    """Where the randomness comes from: Hypothesis, which can shrink, or a seed."""

    def pick(self, options: Sequence[T]) -> T:
        """One of the options."""
        ...

    def number(self, low: int, high: int) -> int:
        """A number from `low` to `high`."""
        ...

    def chance(self, percent: int) -> bool:
        """True that often."""
        ...


class Seeded:
    """Choices that follow from a seed."""

    def __init__(self, seed: int) -> None:
        self._random = random.Random(seed)

    def pick(self, options: Sequence[T]) -> T:
        """One of the options."""
        return self._random.choice(options)

    def number(self, low: int, high: int) -> int:
        """A number from `low` to `high`."""
        return self._random.randint(low, high)

    def chance(self, percent: int) -> bool:
        """True that often."""
        return self._random.randrange(100) < percent


class Drawn:
    """Choices of Hypothesis."""

    def __init__(self, draw: Callable[[Any], Any], strategies: Any) -> None:
        self._draw, self._strategies = draw, strategies

    def pick(self, options: Sequence[T]) -> T:
        """One of the options."""
        return options[self.number(0, len(options) - 1)]

    def number(self, low: int, high: int) -> int:
        """A number from `low` to `high`."""
        return int(self._draw(self._strategies.integers(low, high)))

    def chance(self, percent: int) -> bool:
        """True that often."""
        return self.number(0, 99) >= 100 - percent


@dataclass
class Draft:
    """A program that grows. `known` says that nothing in it may be unknown before it runs, `further` that it may hold any construct."""

    chooser: Chooser
    known: bool = True
    imports: set[str] = field(default_factory=set)
    module: list[str] = field(default_factory=list)
    files: dict[str, list[str]] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)
    numbers: dict[str, int] = field(default_factory=dict)
    ways: tuple[Way, ...] = ()
    node_ways: tuple[Way, ...] = ()
    statements: tuple[Statement, ...] = ()
    further: bool = True

    def fresh(self, prefix: str) -> str:
        """A name that is not used yet."""
        self.numbers[prefix] = self.numbers.get(prefix, 0) + 1
        return f"{prefix}{self.numbers[prefix]}"

    def define(self, text: str) -> None:
        """Add statements to the main module."""
        self.module.append(textwrap.dedent(text).strip("\n"))

    def need(self, statement: str) -> None:
        """Add an import."""
        self.imports.add(statement)


@dataclass
class Scope:
    """Where an expression stands: the statements before it in the same block, and whether there is a node.

    `node` is the expression for it, `methods` those of the class in which this is, where it is one.
    """

    lines: list[str] = field(default_factory=list)
    node: str | None = None
    names: list[str] = field(default_factory=list)
    methods: list[str] | None = None

    def add(self, text: str) -> None:
        """Add statements before the expression."""
        self.lines += textwrap.dedent(text).strip("\n").split("\n")

    def inner(self, *names: str) -> Scope:
        """A block within this one, in which more local names hold strings."""
        return Scope([], self.node, [*self.names, *names], self.methods)

    @property
    def body(self) -> str:
        """The statements, one below the other."""
        return "\n".join(self.lines)


def block(lines: Sequence[str], depth: int = 1) -> str:
    """Statements indented; `pass` where there is none."""
    return textwrap.indent("\n".join(lines) if lines else "pass", "    " * depth)


Way = Callable[[Draft, Scope, int], str]
"""Writes an expression for a string, with what it needs before it."""

Statement = Callable[[Draft, Scope, int], None]
"""Writes statements that create entities on the node of the scope."""
