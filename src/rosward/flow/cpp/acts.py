# SPDX-License-Identifier: Apache-2.0
"""C++: all that an operation does besides giving a result: what it makes, calls, sends, writes and registers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.engine.running.seen import Seen
from rosward.flow.body import Body
from rosward.flow.cpp import calls, outside
from rosward.flow.cpp.values import (
    copies,
    sources,
)
from rosward.flow.marks import NOTHING, Mark, Root
from rosward.flow.reading import constant
from rosward.flow.site import waits
from rosward.ir import cpp, ops

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def acts(
    walker: Walker,
    op: ops.Op,
    body: Body,
    seen: Seen,
    marks: list[Mark],
    *,
    pc: int = 0,
    certain: bool = False,
    called: tuple[str, ...] = (),
    done: frozenset[Root] = frozenset(),
) -> Mark | None:
    """All that an operation does besides: what it makes, calls, writes; what that gives. None where it does nothing.

    `called`: what is called where it is a method of an object of which only the class is known by name.
    `done`: into these objects writes whoever asks.
    """
    everything = NOTHING
    for mark in marks:
        everything = everything.joined(mark)
    keys = tuple([constant(seen, a.register) for a in op.arguments]) if isinstance(op, cpp.Invoke) else ()
    if seen.made:
        copies(walker, seen, everything)
    result = calls.callees(walker, body, seen, everything, pc=pc, certain=certain)
    if result is not None and sources(seen):
        given = Mark(0, frozenset(p for b in seen.bound.values() for g in b.given for p in g.places))
        copies(walker, seen, everything, but=frozenset(walker.memory.reached(given)))
    calls.sends(walker, body, seen, marks)
    passed = (
        marks if result is None else [*marks, result]
    )  # a model writes what it is given, and what callables give it
    for brought in (
        outside.natives(walker, body, seen, passed, keys, done=done),
        outside.strange(walker, op.number, body, seen, marks, called),
    ):
        if brought is not None:
            result = brought if result is None else result.joined(brought)
    calls.register(walker, body, seen, everything)
    if any(n in _SPINS for n in seen.natives):
        walker.join_beside()
    elif walker.threaded and any(map(waits, (*seen.natives, *seen.strange))):
        walker.meet_callbacks()
    return result


def is_busy(seen: Seen) -> bool:
    """Whether an operation does more than to give a result."""
    return bool(seen.made or seen.bound or seen.callees or seen.natives or seen.strange or seen.summaries)


_SPINS: Final = frozenset({"rosward.spin", "rosward.spun"})
