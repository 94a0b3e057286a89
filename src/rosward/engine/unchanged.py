# SPDX-License-Identifier: Apache-2.0
"""Which callbacks need not run again, because nothing that they read has changed since they ran last?

def on_timer(self): self.pub.publish(self.msg)     read: the node, the publisher, the message
def on_scan(self, scan): self.last = scan          writes to the node, so that on_timer runs once more

What a callback did from the same records is in the state already. Each runs twice at least: what it makes is made many times.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from rosward.engine import nodes_asked

if TYPE_CHECKING:
    from rosward.domain.memory import Heap
    from rosward.domain.state import State
    from rosward.engine.machine import Engine
    from rosward.engine.scheduled import Scheduled

_LEAST: Final = 2


def is_unchanged(machine: Engine, entry: Scheduled) -> bool:
    """Whether a callback would do what it did the last time."""
    if entry.runs < _LEAST or entry.around != circumstances(machine):
        return False
    heap = machine.state.heap
    same = all(heap.get(address) is record for address, record in entry.read)
    return same and nodes_asked.still_holds(machine.log, entry.nodes)


@contextmanager
def remembered(machine: Engine, entry: Scheduled, before: State) -> Iterator[None]:
    """A callback runs, from a state: what it reads there is noted with it."""
    around, outer, nodes = circumstances(machine), machine.asked_for, len(machine.log.nodes)
    machine.asked_for = set()
    machine.summaries.memo.clear()  # what is remembered of a call tells nothing of what the call read
    try:
        yield
    finally:
        heap: Heap = before.heap
        entry.read = [(address, heap.get(address)) for address in machine.asked_for if address >= 0]
        entry.nodes = nodes_asked.answered(machine.log, machine.asked_for, nodes)
        entry.runs += 1
        entry.around = around
        machine.asked_for |= outer


def circumstances(machine: Engine) -> tuple[object, ...]:
    """What callbacks may ask for that is no record of the heap; all of it only grows."""
    book = machine.schedule_book
    return (
        len(machine.log.classes),
        len(machine.trace.handed),
        bool(book.entries),
        len(book.named),
        book.by_library,
        book.was_run,
        book.main_raised,
        book.threads_raised,
        machine.hooked,
        machine.unhooked is None,
    )
