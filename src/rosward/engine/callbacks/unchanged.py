# SPDX-License-Identifier: Apache-2.0
"""Which callbacks need not run again, because nothing that they read has changed since they ran last?

def on_timer(self): self.pub.publish(self.last)    read: `pub` and `last` of the node, the publisher, what `last` leads to
def on_scan(self, scan): self.last = scan          writes `last`, so that on_timer runs once more

What a callback did from the same records is in the state already. What it made itself counts as it left it: others may have changed that.
"""

from __future__ import annotations

from collections.abc import Iterator, Set
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from rosward.engine.running import nodes_asked
from rosward.engine.running.attributes_asked import FIRST, says_the_same

if TYPE_CHECKING:
    from rosward.domain.memory import Heap
    from rosward.domain.state import State
    from rosward.engine.machine import Engine
    from rosward.engine.running.scheduled import Scheduled

_LEAST: Final = 2
"""A callback that creates something of ROS runs so often at least: from the second time on, what it makes is made many times."""


def is_unchanged(machine: Engine, entry: Scheduled) -> bool:
    """Whether a callback would do what it did the last time."""
    if entry.runs < (_LEAST if entry.made else 1) or entry.around != circumstances(machine):
        return False
    heap = machine.state.heap
    same = all(heap.get(address) is record for address, record in entry.read)
    same = same and all(heap.get(address) is record for address, record in entry.left)
    same = same and all(says_the_same(record, heap.get(address), name) for address, name, record in entry.parts)
    return same and nodes_asked.still_holds(machine.log, entry.nodes)


@contextmanager
def remembered(machine: Engine, entry: Scheduled, before: State) -> Iterator[None]:
    """A callback runs, from a state: what it reads there is noted with it."""
    around, outer, nodes = circumstances(machine), machine.asked_for, len(machine.log.nodes)
    unheld, made = frozenset(machine.unheld), machine.log.made
    machine.asked_for = set()
    machine.missed.clear()
    machine.summaries.memo.clear()  # what is remembered of a call tells nothing of what the call read
    try:
        yield
    finally:
        _read(machine, entry, before.heap, unheld)
        entry.made = entry.made or machine.log.made != made
        entry.nodes = nodes_asked.answered(machine.log, machine.asked_for, nodes)
        entry.runs += 1
        entry.around = around
        machine.asked_for |= outer


def _read(machine: Engine, entry: Scheduled, before: Heap, unheld: Set[int]) -> None:
    """Note what a callback found where it looked: the records, and those of which it asked for one attribute.

    What it made itself is apart: nothing was there before, or something that nothing held. Unless it asked whether something is there, as who
    makes what is made once does (a static variable, a module): the next time it finds that.
    """
    entry.read, entry.parts, entry.own = [], [], []
    first = machine.library.first_address
    for asked in machine.asked_for:
        address, name = (asked, "") if asked > FIRST else machine.attribute_names.asked(asked)
        record = before.get(address)
        if address in unheld or (record is None and address >= first and not _looked_for(machine, before, address)):
            entry.own.append(address)
        elif asked > FIRST:
            entry.read.append((address, record))
        else:
            entry.parts.append((address, name, record))


def _looked_for(machine: Engine, before: Heap, address: int) -> bool:
    """Whether a callback asked for something that is made once, where nothing was. A part of what it made itself is none."""
    if address not in machine.missed:
        return False
    owner = machine.inner.get(address)
    return owner is None or owner < machine.library.first_address or before.get(owner) is not None


def circumstances(machine: Engine) -> tuple[object, ...]:
    """What callbacks may ask for that is no record of the heap; all of it only grows."""
    book = machine.schedule_book
    return (
        len(machine.log.classes),
        len(machine.trace.handed),
        bool(book.entries),
        len(book.named),
        book.by_library,
        book.parallel,
        book.was_run,
        book.main_raised,
        book.threads_raised,
        machine.hooked,
        machine.unhooked is None,
    )
