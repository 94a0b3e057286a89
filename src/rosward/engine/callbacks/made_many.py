# SPDX-License-Identifier: Apache-2.0
"""What callbacks make is made many times: what is still held when they may run again stands for several from then on.

def on_scan(self, scan):
    self.last = Scan(scan)       the next one that is made stands beside this one, until `last` leads to it
    text = [scan.header]         nothing holds the list any more: the next one takes its place
"""

from __future__ import annotations

from collections.abc import Iterable, Set
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.state import State
    from rosward.engine.machine import Engine
    from rosward.engine.running.scheduled import Scheduled

_ONE: Final = ("class", "module")


def note(machine: Engine, entry: Scheduled, before: State, made: set[int]) -> None:
    """A callback has run from a state: add to `made` where new objects stand, and note as it left them what of these it read."""
    heap, first = machine.state.heap, machine.library.first_address
    there, registered = before.heap, entry.state.heap  # what stood there when it was registered it has not made
    made.update(
        address
        for address, obj in heap.changed_since(there)
        if address >= first
        and not obj.many
        and obj.kind not in _ONE
        and there.get(address) is None
        and registered.get(address) is None
    )
    entry.left = [(address, heap.get(address)) for address in entry.own]


def mark(machine: Engine, entries: Iterable[Scheduled], made: Set[int]) -> None:
    """Before callbacks run again: the objects at these addresses, which something holds, stand for several."""
    heap = machine.state.heap
    marked: dict[int, tuple[Obj | None, Obj]] = {}
    for address in made:
        obj = heap.get(address)
        if obj is not None and not obj.many:
            marked[address] = obj, obj.replace(many=True)
            heap[address] = marked[address][1]
    if not marked:
        return
    machine.state.version = machine.fresh_version()
    for entry in entries:
        for number, (address, left) in enumerate(entry.left):
            if address in marked and marked[address][0] is left:
                entry.left[number] = address, marked[address][1]
