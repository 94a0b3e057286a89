# SPDX-License-Identifier: Apache-2.0
"""Which calls need not be run again, because they find everything as it was?

for (auto & cell : cells) { total += cost(cell.x, cell.y); }     cost reads the resolution: it gives what it gave
lamp.limit(3)                                                    it wrote level_ = 3, and does so again

A call is remembered with the records that it read, as it found them, and with those that it wrote. Where the same stands there, it does the
same; what it made for itself is gone with it. One that creates something, waits, or lets out what it made is run each time.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, final

from rosward.domain.heap import Obj
from rosward.domain.values import UNBOUND, Function, Value
from rosward.engine import declared
from rosward.engine.summaries import Repeated
from rosward.engine.throwing import note
from rosward.engine.unchanged import around
from rosward.engine.unheld import held_by, refs_in

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["Run", "again", "key_of"]

_APART: Final = 6
"""So many ways in which one call may find what it reads are remembered."""
_MOST: Final = 400_000
"""So many records are remembered, over all calls."""
_VERSION: Final = 7
"""Where a key has the version of the state that it holds for alone."""


def key_of(machine: Engine, function: Function, registers: list[Value]) -> tuple[object, ...]:
    """What a call depends on beside the records that it reads.

    What a model finds unknown is so at the place of its caller. Who watches wants to see each call that may do something, and what a launch
    has set is no record: there a call is repeated only where no record at all has changed. So it is while a summary is solved, which comes to
    rest by the states that its body goes through.
    """
    whole = machine.watch is not None or machine.log.holds_more or bool(machine.summaries.running)
    return (
        function,
        tuple(registers),
        bool(machine.catchers),
        machine.schedule_book.running,
        machine.precision.coarse,
        machine.language.situation(machine),
        machine.place if declared.is_model(function) else None,
        machine.state.version if whole else None,
        around(machine),
    )


def again(machine: Engine, key: tuple[object, ...]) -> Value | None:
    """What a call gives that finds everything as it was, and has written by now what it wrote then; None: it has to be run."""
    heap = machine.state.heap
    for known in machine.summaries.repeated.get(key, ()):
        if all(heap.get(address) is record for several in known[:2] for address, record in several):
            machine.asked_for.update(address for address, _ in known.reads)
            for address, record in known.writes:
                machine.put(address, record)
            if known.level:
                note(machine, known.level)
            return known.value
    return None


@final
class Run:
    """A call that is run: what is to be known of the time before it."""

    __slots__ = ("asked_for", "deeds", "done", "ends", "given", "heap", "made", "provisional", "raised")

    def __init__(self, machine: Engine) -> None:
        self.heap = machine.state.heap.copy()
        self.done = machine.state.done
        self.ends = machine.ends
        self.raised = machine.raised
        self.provisional = machine.summaries.provisional
        self.deeds = machine.trace.deeds
        self.given = len(machine.trace.given)
        self.made = len(machine.trace.made)
        self.asked_for, machine.asked_for = machine.asked_for, set()

    def end(self, machine: Engine) -> set[int]:
        """The call is over: what it asked for."""
        asked_for, machine.asked_for = machine.asked_for, self.asked_for
        return asked_for

    def keep(self, machine: Engine, key: tuple[object, ...], asked_for: set[int], value: Value, level: int) -> bool:
        """Remember the call, if it did nothing that another run of it would do otherwise."""
        if value is UNBOUND or not self._is_plain(machine):
            self.asked_for |= asked_for
            return False
        before, own = self.heap, set(machine.trace.made[self.made :])
        writes = [each for each in machine.state.heap.changed_since(before) if each[0] not in own]
        if own and not own.isdisjoint(self._outgoing(machine, value, writes)):
            self.asked_for |= asked_for
            return False
        asked_for -= own
        self.asked_for |= asked_for
        if writes and (level or key[_VERSION] is not None):
            return False
        written = tuple((address, before.get(address)) for address, _ in writes if address not in asked_for)
        reads = tuple((address, before.get(address)) for address in asked_for)
        machine.summaries.keep(key, Repeated(reads, written, tuple(writes), value, level), _APART, _MOST)
        return True

    def _is_plain(self, machine: Engine) -> bool:
        """Whether the call only read and wrote."""
        return (
            machine.raised == self.raised
            and machine.trace.deeds == self.deeds
            and machine.summaries.provisional == self.provisional
            and machine.ends is self.ends
            and machine.state.done == self.done
        )

    def _outgoing(self, machine: Engine, value: Value, writes: list[tuple[int, Obj]]) -> Iterator[int]:
        """What others have of the call: its result, what it wrote, what it gave away."""
        yield from (ref.address for ref in refs_in((value, *machine.trace.given[self.given :])))
        for address, record in writes:
            old = self.heap.get(address)
            if old is not None and record.kind == "instance" and old.attrs is not record.attrs:
                changed = (v for n, v in record.attrs.items() if old.attrs.get(n) is not v)
                yield from (ref.address for ref in refs_in(changed))
            elif old is None or record.kind != "instance":
                yield from (ref.address for ref in held_by(record))
