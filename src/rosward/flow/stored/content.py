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

    Never changed; what all of it comes to is put together once (`known`, None before that).
    """

    __slots__ = ("any", "base", "known", "size", "slots")

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
        self.known: Mark | None = None

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return (
            isinstance(other, Content)
            and self.base == other.base
            and self.size == other.size
            and self.any == other.any
            and (self.slots is other.slots or self.slots == other.slots)
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
        found = self.known
        if found is None:
            mask, roots = self.base | self.any.mask, self.any.roots
            several = {id(mark.roots): mark.roots for mark in self.slots.values() if mark.roots}
            for mark in self.slots.values():
                mask |= mark.mask
            if several:
                largest = max(roots, *several.values(), key=len)
                roots = roots.union(*several.values())
                if len(roots) == len(largest):  # many have it then
                    roots = largest
            found = self.known = Mark(mask, roots)
        return found

    def within(self, other: Content) -> bool:
        """Whether all that it leads to, and depends on, is in another one, too."""
        ours, theirs = self.whole, other.whole
        return not (ours.mask | self.size) & ~(theirs.mask | other.size) and ours.roots <= theirs.roots

    def with_slots(self, slots: Mapping[object, Mark]) -> Content:
        """The same with other slots."""
        return Content(self.base, self.any, self.size, slots)

    def again(self) -> Content:
        """The same, as a content that was put together anew."""
        return Content(self.base, self.any, self.size, self.slots)

    def with_any(self, mark: Mark, size: int) -> Content:
        """The same with something more under keys that are not known; itself where that is not new."""
        joined = self.any.joined(mark)
        if joined is self.any and self.size | size == self.size:
            return self
        return Content(self.base, joined, self.size | size, self.slots)


EMPTY: Final = Content()
Layer = dict[Root, Content]
"""What stands in each of several objects."""


def both(ours: Content, theirs: Content) -> Content:
    """What covers two contents of one object; the first itself where that covers the second."""
    if ours is theirs:
        return ours
    slots: dict[object, Mark] | None = None
    known = ours.slots
    if theirs.slots is not known:
        for key, mark in theirs.slots.items():
            mine = known.get(key)
            if mine is mark:
                continue
            merged = mark.under(ours.base) if mine is None else mine.joined(mark)
            if merged is not mine:
                if slots is None:
                    slots = dict(known)
                slots[key] = merged
        if theirs.base:
            for key, mine in known.items():
                if key not in theirs.slots and (merged := mine.under(theirs.base)) is not mine:
                    if slots is None:
                        slots = dict(known)
                    slots[key] = merged
    base, any_, size = ours.base | theirs.base, ours.any.joined(theirs.any), ours.size | theirs.size
    if slots is None and base == ours.base and any_ is ours.any and size == ours.size:
        return ours
    return Content(base, any_, size, known if slots is None else slots)


class TooLongError(Exception):
    """The walk takes more steps, or a loop more turns, than it may."""
