# SPDX-License-Identifier: Apache-2.0
"""The heap: from addresses to objects, cheap to copy, and quick to compare with what it was copied from.

before = heap.copy()        shares everything
heap[a] = changed           copies the page of `a`, not the heap
heap.cover(before, join)    looks only at the pages that differ
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Final, final

from rosward.domain.heap import Obj

Page = list[Obj | None]

SHIFT: Final = 6
MASK: Final = (1 << SHIFT) - 1
_BLANK: Final[tuple[None, ...]] = (None,) * (MASK + 1)
_MOST_COVERED: Final = 30_000


@final
class Covered:
    """Pairs of objects of which the first is known to cover the second, which the copies of one heap meet again and again.

    Joins and widenings have pairs of their own: a widening also leaves out what an unknown stands for.
    """

    __slots__ = ("_joined", "_widened")

    def __init__(self) -> None:
        # By id(): the objects are kept, so that no other takes the place of one.
        self._joined: dict[tuple[int, int], tuple[Obj, Obj]] = {}
        self._widened: dict[tuple[int, int], tuple[Obj, Obj]] = {}

    def pairs(self, *, widens: bool) -> dict[tuple[int, int], tuple[Obj, Obj]]:
        """Those that a join or a widening found, to ask and to add to; forgotten where they become too many."""
        pairs = self._widened if widens else self._joined
        if len(pairs) > _MOST_COVERED:
            pairs.clear()
        return pairs


@final
class Heap:
    """Pages of neighbouring addresses. A page is shared between copies until one of them writes to it.

    `pages` is open to reading, because every operation of a program reads some object; who writes goes through `heap[address] = …`.
    """

    __slots__ = ("_covered", "_own", "pages")

    def __init__(self, objects: Iterable[tuple[int, Obj]] = ()) -> None:
        self.pages: dict[int, Page] = {}
        self._covered = Covered()
        self._own: set[int] = set()  # the pages that no copy shares
        for address, obj in objects:
            self[address] = obj

    def copy(self) -> Heap:
        """An independent copy."""
        copy = Heap.__new__(Heap)
        copy.pages = self.pages.copy()
        copy._covered = self._covered
        copy._own = set()
        if self._own:
            self._own = set()
        return copy

    def get(self, address: int) -> Obj | None:
        """The object at an address."""
        page = self.pages.get(address >> SHIFT)
        return None if page is None else page[address & MASK]

    def __contains__(self, address: int) -> bool:
        return self.get(address) is not None

    def __setitem__(self, address: int, obj: Obj) -> None:
        number = address >> SHIFT
        page = self.pages.get(number)
        if number not in self._own:
            page = self.pages[number] = list(_BLANK) if page is None else page.copy()
            self._own.add(number)
        assert page is not None
        page[address & MASK] = obj

    def restore(self, before: Heap) -> None:
        """Take back what was written to the objects that an earlier copy has; what is new stays."""
        for number, theirs in before.pages.items():
            if self.pages[number] is not theirs:
                for offset, obj in enumerate(theirs):
                    if obj is not None and self.pages[number][offset] is not obj:
                        self[(number << SHIFT) + offset] = obj

    def items(self) -> Iterator[tuple[int, Obj]]:
        """All objects with their addresses."""
        for number, page in self.pages.items():
            for offset, obj in enumerate(page):
                if obj is not None:
                    yield (number << SHIFT) + offset, obj

    def cover(self, other: Heap, merge: Callable[[Obj, Obj], Obj], *, widens: bool = False) -> tuple[int, bool]:
        """Take over what only the other has, and merge what both have: how many objects differed, and whether anything changed here.

        `merge` gives its first argument where that covers the second.
        """
        changed, compared = False, 0
        covered = self._covered.pairs(widens=widens)
        for number, theirs in other.pages.items():
            ours = self.pages.get(number)
            if ours is theirs:
                continue
            if ours is None:
                self._share(number, other)
                changed = True
                continue
            merged, as_here, as_there = ours, True, True
            for offset, (a, b) in enumerate(zip(ours, theirs, strict=True)):
                if a is b:
                    continue
                compared += 1
                if b is None or (id(a), id(b)) in covered:
                    as_there = False
                    continue
                both = b if a is None else merge(a, b)
                as_there = as_there and both is b
                if a is not None and both is a:
                    covered[id(a), id(b)] = (a, b)
                else:
                    if as_here:
                        as_here, merged = False, ours.copy()
                    merged[offset] = both
            if as_here:
                continue
            changed = True
            if as_there:
                self._share(number, other)
            else:
                self.pages[number] = merged
                self._own.add(number)
        return compared, changed

    def fill(self, other: Heap) -> None:
        """Take over what only the other has."""
        for number, theirs in other.pages.items():
            ours = self.pages.get(number)
            if ours is None:
                self._share(number, other)
            elif ours is not theirs:
                missing = [offset for offset, obj in enumerate(ours) if obj is None and theirs[offset] is not None]
                for offset in missing:
                    obj = theirs[offset]
                    assert obj is not None
                    self[(number << SHIFT) + offset] = obj

    def _share(self, number: int, other: Heap) -> None:
        """One page for both from now on."""
        self.pages[number] = other.pages[number]
        self._own.discard(number)
        other._own.discard(number)
