# SPDX-License-Identifier: Apache-2.0
"""What all callbacks may have written, for who runs beside them; and which walks that met an earlier state of it are still what they were.

def on_timer(self):
    self.executor.spin_once()      others run here: what they write may stand behind it
    self.pub.publish(self.last)    reads `last`, so it is walked through again once a callback writes that, not another slot
"""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Final, final

from rosward.flow.marks import Root, behind
from rosward.flow.stored.memory import Memory
from rosward.flow.stored.tracker import differing

if TYPE_CHECKING:
    from rosward.flow.stored.remembered import Remembered
    from rosward.flow.stored.shape import Shape
    from rosward.flow.stored.tracker import Keys

_MOST_STATES: Final = 32
"""So many states are kept, the last ones."""


@final
class Beside:
    """`memory`: what callbacks have written so far; `state`: how often it became more."""

    def __init__(self, shape: Shape) -> None:
        self.memory = Memory(shape)
        self.state = 0
        self._shape = shape
        self._met: dict[int, Memory] = {}  # the states that somebody met
        self._moved: dict[int, dict[Root, Keys]] = {}  # what has changed since each of them, up to now
        self._merges = 0  # so many merges of objects are taken into account there

    def take(self, memory: Memory) -> bool:
        """What stands in a memory may stand here; whether that is more."""
        changed = self.memory.join(memory)
        if changed:
            self.state += 1
            self._moved.clear()
        self.memory.take_looks(memory)
        return changed

    def meet(self, memory: Memory) -> None:
        """What stands here may stand in a memory, too."""
        if self.state not in self._met:
            if len(self._met) >= _MOST_STATES:
                del self._met[next(iter(self._met))]
            self._met[self.state] = self.memory.copy()
        memory.meet(self.memory, self.state)

    def holds(self, each: Remembered) -> bool:
        """Whether a walk finds here what it found: nothing that it has read or written has changed since, nor stands for several objects."""
        numbers = self.memory.numbers
        if each.merges != len(numbers.merges) and any(numbers.one(root) != root for root, _, _ in each.writes):
            return False
        if not each.tracker.beside or each.beside == self.state:
            return True
        moved = self._since(each.beside)
        if moved is None:
            return False
        touched = chain(each.tracker.was_read(), each.writes)
        return not any(self._is_among(root, keys, moved) for root, keys, _ in touched)

    def _is_among(self, root: Root, keys: Keys, moved: dict[Root, Keys]) -> bool:
        one = self.memory.numbers.one
        here = one(root)
        if here in moved:
            others = moved[here]
            return keys is None or others is None or not keys.isdisjoint(others)
        return any(one(owner) in moved for owner in behind(root, self._shape.inner))

    def _since(self, state: int) -> dict[Root, Keys] | None:
        """What has changed since a state, with the slots (None: all); None where nobody knows."""
        merges = len(self.memory.numbers.merges)
        if merges != self._merges:
            self._merges = merges
            self._moved.clear()
        found = self._moved.get(state)
        if found is None:
            before = self._met.get(state)
            if before is None:
                return None
            found = self._moved[state] = {}
            roots = self.memory.numbers.roots
            for number, ours, theirs in self.memory.current().differing(before.current()):
                keys = None if ours is None or theirs is None else differing(theirs, ours)
                if keys is None or keys:
                    found[roots[number]] = keys
        return found
