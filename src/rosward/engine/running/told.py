# SPDX-License-Identifier: Apache-2.0
"""What does a call tell the `try` around it, or the end of the program where there is none?

def save(self, x): self.last = x; risky()      the handlers see `last` as it is then; an exception that is raised arrives with its state

It is noted while the call runs, and told again where the call need not run again (`recalled.py`): each object in the order in which it was
written, and each exception with what differs from the state before the call.
"""

from __future__ import annotations

import enum
from collections.abc import Iterable
from typing import TYPE_CHECKING

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.memory import Heap
    from rosward.domain.state import EventKey
    from rosward.domain.values import Value

__all__ = ["Kind", "Telling", "Told", "told_of"]

Pairs = tuple[tuple[int, "Obj"], ...]


class Kind(enum.Enum):
    """What is told."""

    NOTED = "an exception that is not known may be raised"
    WRITTEN = "an object was written where one may be raised"
    ARRIVED = "an exception is raised"


class Telling(NamedTuple):
    """One thing that is told, as it happens: with the whole heap of that moment, or the object that was written; None: nothing has changed."""

    kind: Kind
    level: int
    exception: Value | None
    heap: Heap | None
    done: frozenset[EventKey]
    written: Pairs = ()


class Told(NamedTuple):
    """The same for whoever tells it again: what differs from the beginning of the call, as far as it was not told before."""

    kind: Kind
    level: int
    exception: Value | None
    objects: Pairs
    done: frozenset[EventKey]


def told_of(tellings: Iterable[Telling], before: Heap, done: frozenset[EventKey]) -> tuple[Told, ...] | None:
    """What was told in a call that began with this heap, when this was done; None where something of that was not done any more."""
    found: list[Told] = []
    known: set[tuple[int, int]] = set()  # by id(): the objects are kept in what is found
    least: frozenset[EventKey] | None = None
    for kind, level, exception, heap, then, written in tellings:
        if not done <= then:
            return None
        objects = written if heap is None else tuple(heap.changed_since(before))
        added = then - done
        if kind is not Kind.ARRIVED:
            fresh = tuple([(address, obj) for address, obj in objects if (address, id(obj)) not in known])
            known.update([(address, id(obj)) for address, obj in fresh])
            if least is not None and not fresh and least <= added and level <= max(t.level for t in found):
                continue
            objects, least = fresh, added if least is None else least & added
        found.append(Told(kind, level, exception, objects, added))
    return tuple(found)
