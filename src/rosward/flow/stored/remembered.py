# SPDX-License-Identifier: Apache-2.0
"""What is remembered of a walk through a body: what it read, and what it left, so that the same call need not be walked through again.

for turn in any number:           the second turn finds in `handle` what the first one found, reads the same, writes the same
    self.handle(message)
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final, final

from rosward.flow.marks import NOTHING
from rosward.ir.program import CPP, PYTHON
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.running.seen import Activation
    from rosward.flow.marks import Mark, Root
    from rosward.flow.stored.content import Content, Layer
    from rosward.flow.stored.tracker import Keys, Tracker

MOST: Final = {PYTHON: 6, CPP: 2}
"""So many calls of one activation are remembered, the last ones, by the language. In C++ each reads very much."""


class Written(NamedTuple):
    """What a walk has left in one object: under these keys, or all of it."""

    root: Root
    keys: Keys
    content: Content


class Remembered(NamedTuple):
    """One walk: what it found, and what it left.

    `raising` is what may have failed in it; `beside` how often callbacks had written when it began, `told` how often all else had changed;
    `merges` how often objects were merged when it ended.
    """

    given: tuple[object, ...]
    tracker: Tracker
    writes: tuple[Written, ...]
    result: Mark
    raising: int
    beside: int
    told: int
    merges: int


@final
class News:
    """What has changed that stands in no memory, and when: walks that asked for it are not what they were."""

    def __init__(self) -> None:
        self._when: dict[object, int] = {}
        self.told = 0  # how often something has changed

    def tell(self, keys: Iterable[object]) -> None:
        """These are something else from now on."""
        self.told += 1
        self._when.update(dict.fromkeys(keys, self.told))

    def holds(self, each: Remembered) -> bool:
        """Whether all that a walk has asked for is what it was."""
        when, told = self._when, each.told
        return told == self.told or all(when.get(key, 0) <= told for key in each.tracker.asked)


@final
class Looked:
    """What a look through all that some roots lead to has found: the objects, and `further` those that say what stands in them.

    `changed`: those of them that were written since; `tracker`: who knows already that all of them were read.
    """

    __slots__ = ("changed", "further", "mask", "objects", "tracker")

    def __init__(
        self,
        mask: int,
        objects: Layer,
        further: Layer,
        tracker: Tracker | None,
        changed: frozenset[Root] = frozenset(),
    ) -> None:
        self.mask = mask
        self.objects = objects
        self.further = further
        self.tracker = tracker
        self.changed = changed

    def copy(self) -> Looked:
        """An independent one, to add to."""
        return Looked(self.mask, self.objects.copy(), self.further.copy(), self.tracker)

    def behind(self, root: Root) -> Looked:
        """The same, once an object was written."""
        if root in self.changed:
            return self
        return Looked(self.mask, self.objects, self.further, self.tracker, self.changed | {root})


def gather(known: dict[Activation, list[Mark]], activation: Activation, arguments: list[Mark]) -> bool:
    """What any call gives to a body; whether that is more now."""
    before = known.get(activation)
    if before is None:
        known[activation] = list(arguments)
        return False
    more = len(arguments) > len(before)
    before += [NOTHING] * (len(arguments) - len(before))
    for number, mark in enumerate(arguments):
        both = before[number].joined(mark)
        if both is not before[number]:
            before[number] = both
            more = True
    return more
