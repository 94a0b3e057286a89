# SPDX-License-Identifier: Apache-2.0
"""What stands in one object, as far as flow is concerned."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, final

from rosward.flow.marks import NOTHING, Mark, Root

NO_SLOTS: Final[Mapping[object, Mark]] = MappingProxyType({})


@final
class Content:
    """Of one object: `base` of what was never written, `any` under keys that are not known, `size` of how much there is, and its slots.

    Never changed; what all of it comes to is put together once.
    """

    __slots__ = ("_whole", "any", "base", "size", "slots")

    def __init__(
        self,
        base: int = 0,
        any: Mark = NOTHING,  # noqa: A002
        size: int = 0,
        slots: Mapping[object, Mark] = NO_SLOTS,
    ) -> None:
        self.base = base
        self.any = any
        self.size = size
        self.slots = slots
        self._whole: Mark | None = None

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return (
            isinstance(other, Content)
            and self.base == other.base
            and self.size == other.size
            and self.any == other.any
            and self.slots == other.slots
        )

    __hash__ = None  # type: ignore[assignment]  # nobody looks for one

    def read(self, key: object) -> Mark:
        """What stands under a key."""
        found = self.slots.get(key)
        if found is None:
            return self.any.under(self.base)
        return found.joined(self.any)

    @property
    def whole(self) -> Mark:
        """All that stands in it."""
        found = self._whole
        if found is None:
            mask, roots = self.base | self.any.mask, self.any.roots
            several = {id(mark.roots): mark.roots for mark in self.slots.values() if mark.roots}
            for mark in self.slots.values():
                mask |= mark.mask
            if several:
                roots = roots.union(*several.values())
            found = self._whole = Mark(mask, roots)
        return found

    def with_slots(self, slots: Mapping[object, Mark]) -> Content:
        """The same with other slots."""
        return Content(self.base, self.any, self.size, slots)

    def with_any(self, mark: Mark, size: int) -> Content:
        """The same with something more under keys that are not known; itself where that is not new."""
        joined = self.any.joined(mark)
        if joined is self.any and self.size | size == self.size:
            return self
        return Content(self.base, joined, self.size | size, self.slots)


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
