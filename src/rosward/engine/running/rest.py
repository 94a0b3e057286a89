# SPDX-License-Identifier: Apache-2.0
"""Where a loop came to rest: what its turns have made of what was there when it began.

for v in values: total += v         total: any number; of all else it says nothing

Where precision is given up, the next run of the loop starts from there, and comes to rest sooner.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.heap import Obj, alike
from rosward.domain.state import Merge, join_objects, join_registers
from rosward.domain.values import UNBOUND, Value
from rosward.engine.running.frame import Snapshot
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.effects.log import Execution


class Rest(NamedTuple):
    """The registers that changed, UNBOUND in the place of the others, and the objects."""

    registers: tuple[Value, ...]
    objects: tuple[tuple[int, Obj], ...]

    @classmethod
    def of(cls, begun: Snapshot, rest: Snapshot) -> Rest:
        """What differs between the beginning of a loop and where it came to rest."""
        pairs = zip(begun.registers, rest.registers, strict=True)
        registers = tuple(UNBOUND if before is after else after for before, after in pairs)
        before = begun.state.heap
        changed = rest.state.heap.changed_since(before)
        return cls(registers, tuple((address, obj) for address, obj in changed if address in before))

    def says_the_same(self, other: Rest) -> bool:
        """Whether a run that starts from the one ends as one that starts from the other does."""
        return (
            self.registers == other.registers
            and len(self.objects) == len(other.objects)
            and all(
                a == b and (one is two or alike(one, two))
                for (a, one), (b, two) in zip(self.objects, other.objects, strict=True)
            )
        )

    def joined(self, machine: Execution, begun: Snapshot, merge: Merge) -> Snapshot:
        """A beginning of the same loop, with what its turns may make of it."""
        state = begun.state.copy()
        for address, obj in self.objects:
            ours: Obj | None = state.heap.get(address)
            both = ours if ours is None else join_objects(ours, obj, merge)
            if both is not None and both is not ours:
                state.heap[address] = both
                state.version = machine.fresh_version()
        return Snapshot(join_registers(begun.registers, list(self.registers), merge), state)
