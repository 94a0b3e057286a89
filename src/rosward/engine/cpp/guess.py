# SPDX-License-Identifier: Apache-2.0
"""A call of which nothing tells which of many functions it means, while it is followed (`guessing.py`)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, final

from rosward.domain.choice import widen
from rosward.domain.values import Function, Value

if TYPE_CHECKING:
    from rosward.domain.memory import Heap
    from rosward.domain.state import Merge, State
    from rosward.domain.unknown import Reason
    from rosward.engine.running.catcher import Catcher

__all__ = ["Arguments", "Call", "Guess"]

Arguments = tuple[Value, ...]
Call = Callable[[Function, Arguments], Value]


@final
class Guess:
    """What is known so far of all functions that calls within such a call may mean."""

    __slots__ = ("after", "before", "calls", "catcher", "joined", "merge", "values")

    def __init__(self, catcher: Catcher, reason: Reason) -> None:
        self.before: State | None = None  # any state in which one of them is called
        self.joined: Heap | None = None  # the heap that `before` was joined with last
        self.after: State | None = None  # and any that one leaves
        self.calls: dict[str, tuple[Function, Call, Arguments]] = {}  # by the code of functions
        self.values: dict[str, Value] = {}  # what they give
        self.catcher = catcher  # what leaves them by exceptions
        self.merge: Merge = lambda old, new: widen(old, new, reason)

    @property
    def version(self) -> tuple[object, ...]:
        """What must not change any more."""
        before, after = (-1 if state is None else state.version for state in (self.before, self.after))
        thrown = self.catcher.level, tuple(self.catcher.arrivals), self.catcher.snapshot.state.version
        return before, after, tuple(self.calls), tuple(self.values.items()), thrown
