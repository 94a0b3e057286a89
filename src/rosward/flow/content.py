# SPDX-License-Identifier: Apache-2.0
"""What stands in one object, as far as flow is concerned."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from rosward.flow.marks import NOTHING, Mark, Root
from rosward.records import NamedTuple

NO_SLOTS: Final[Mapping[object, Mark]] = MappingProxyType({})


class Content(NamedTuple):
    """Of one object: `base` of what was never written, `any` under keys that are not known, `size` of how much there is, and its slots."""

    base: int = 0
    any: Mark = NOTHING
    size: int = 0
    slots: Mapping[object, Mark] = NO_SLOTS

    def read(self, key: object) -> Mark:
        """What stands under a key."""
        found = self.slots.get(key)
        if found is None:
            return self.any.under(self.base)
        return found.joined(self.any)

    @property
    def whole(self) -> Mark:
        """All that stands in it."""
        found = self.any.under(self.base)
        for mark in self.slots.values():
            found = found.joined(mark)
        return found


EMPTY: Final = Content()


def both(ours: Content, theirs: Content) -> Content:
    """What covers two contents of one object."""
    if ours is theirs or ours == theirs:
        return ours
    slots = dict(ours.slots)
    for key, mark in theirs.slots.items():
        known = slots.get(key)
        slots[key] = mark.under(ours.base) if known is None else known.joined(mark)
    for key in ours.slots:
        if key not in theirs.slots:
            slots[key] = slots[key].under(theirs.base)
    return Content(ours.base | theirs.base, ours.any.joined(theirs.any), ours.size | theirs.size, slots)


Layer = dict[Root, Content]
"""What stands in each of several objects."""


class TooLongError(Exception):
    """The walk takes more steps, or a loop more turns, than it may."""


def fewer(layers: tuple[Layer, ...]) -> tuple[Layer, ...]:
    """The same in fewer layers. The oldest, which others share, stays as long as it is the larger part."""
    oldest, *newer = layers
    later: Layer = {}
    for layer in newer:
        later.update(layer)
    return (oldest, later) if 2 * len(later) < len(oldest) else ({**oldest, **later},)
