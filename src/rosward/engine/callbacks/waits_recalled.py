# SPDX-License-Identifier: Apache-2.0
"""What runs beside the main body where that waits, and need not run again: it ran from the same records before.

for each of three ports: port.wait()        from the same state, each time: what the others do meanwhile is the same

A wait is remembered with the records that callbacks asked for, and those that they left, if they did nothing else: registered nothing, created
nothing, raised nothing. What they told the log stands there already.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.domain.state import join_states
from rosward.engine.callbacks.unchanged import circumstances
from rosward.engine.running import nodes_asked
from rosward.engine.running.attributes_asked import records_of
from rosward.engine.running.scheduled import Wait

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_KEPT: Final = 32


def run_or_recall(machine: Engine, run: Callable[[], None]) -> None:
    """Run all callbacks where the main body waits, unless they have run from what is there now."""
    around = _around(machine)
    heap = machine.state.heap
    waits = machine.schedule_book.remembered
    for wait in reversed(waits):
        if wait.around != around or not nodes_asked.still_holds(machine.log, wait.nodes):
            continue
        if all(heap.get(address) is record for address, record in wait.found):
            after = machine.state.copy()
            for address, record in wait.left:
                after.heap[address] = record
            after.version = machine.fresh_version(len(wait.left))
            machine.state = join_states(machine.state, after, machine.fresh_version)
            return
    before, outer, nodes = machine.state.copy(), machine.asked_for, len(machine.log.nodes)
    machine.asked_for = set()
    run()
    asked, machine.asked_for = machine.asked_for, outer
    outer |= asked
    if _around(machine) != around:
        return
    left = list(machine.state.heap.changed_since(before.heap))
    addresses = {*records_of(asked), *(address for address, _ in left)}
    for entry in machine.schedule_book.entries.values():  # who did not run again would have found the same
        addresses.update(address for address, _ in entry.read)
        addresses.update(address for address, _ in entry.left)
        addresses.update(address for address, _, _ in entry.parts)
    found = [(address, before.heap.get(address)) for address in addresses]
    waits.append(Wait(around, found, left, nodes_asked.answered(machine.log, asked, nodes)))
    del waits[:-_KEPT]


def _around(machine: Engine) -> tuple[object, ...]:
    """What else callbacks may ask for, and all that they may do but write."""
    book, log = machine.schedule_book, machine.log
    return (
        *circumstances(machine),
        len(book.entries),
        sum(entry.exhausted for entry in book.entries.values()),
        len(book.raised),
        id(book.interrupted),
        log.made,
        len(log.nodes),
        len(log.entities),
    )
