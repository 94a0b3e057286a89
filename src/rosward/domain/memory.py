# SPDX-License-Identifier: Apache-2.0
"""The heap: from addresses to objects, cheap to copy, and quick to compare with what it was copied from.

before = heap.copy()        shares everything
heap[a] = changed           copies the page of `a`, not the heap
heap.cover(before, join)    looks only at the pages that differ

A heap stands on a ground, which all copies share and none writes to: what a copy holds of an object of the ground takes the place of that
object for this copy alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import compress
from operator import is_not
from typing import Final, final

from rosward.domain.heap import Obj, alike

Page = list[Obj | None]
Ground = Callable[[int], Obj | None]
CoveredPages = dict[tuple[int, int], tuple[Page, Page, int]]

SHIFT: Final = 6
MASK: Final = (1 << SHIFT) - 1
_OFFSETS: Final = range(MASK + 1)
_BLANK: Final[tuple[None, ...]] = (None,) * (MASK + 1)
_MOST_COVERED: Final = 30_000
_MOST_PAGES: Final = 4_000


@final
class Covered:
    """Pairs of objects of which the first is known to cover the second, which the copies of one heap meet again and again.

    Joins and widenings have pairs of their own: a widening also leaves out what an unknown stands for.
    """

    __slots__ = ("_joined", "_joined_pages", "_widened", "_widened_pages")

    def __init__(self) -> None:
        # By id(): the objects are kept, so that no other takes the place of one.
        self._joined: dict[tuple[int, int], tuple[Obj, Obj]] = {}
        self._widened: dict[tuple[int, int], tuple[Obj, Obj]] = {}
        self._joined_pages: CoveredPages = {}
        self._widened_pages: CoveredPages = {}

    def pairs(self, *, widens: bool) -> dict[tuple[int, int], tuple[Obj, Obj]]:
        """Those that a join or a widening found, to ask and to add to; forgotten where they become too many."""
        pairs = self._widened if widens else self._joined
        if len(pairs) > _MOST_COVERED:
            pairs.clear()
        return pairs

    def pages(self, *, widens: bool) -> CoveredPages:
        """The same for whole pages, which nobody writes to any more, with how many of their objects differ."""
        pages = self._widened_pages if widens else self._joined_pages
        if len(pages) > _MOST_PAGES:
            pages.clear()
        return pages


@final
class Heap:
    """Pages of neighbouring addresses. A page is shared between copies until one of them writes to it.

    `pages` is open to reading, because every operation of a program reads some object; who writes goes through `heap[address] = …`.
    """

    __slots__ = ("_changed", "_covered", "_ground", "_own", "pages")

    def __init__(
        self, objects: Iterable[tuple[int, Obj]] = (), ground: Ground | None = None, before: Heap | None = None
    ) -> None:
        self._own: set[int] = set()  # the pages that no copy shares
        self.pages: dict[int, Page] = {} if before is None else before.pages.copy()
        self._ground: Ground | None = ground if before is None else before._ground
        # The pages with objects that take the place of one of the ground.
        self._changed: frozenset[int] = frozenset() if before is None else before._changed
        self._covered: Covered = Covered() if before is None else before._covered
        for address, obj in objects:
            self[address] = obj

    def copy(self) -> Heap:
        """An independent copy."""
        if self._own:
            self._own = set()
        return Heap(before=self)

    def get(self, address: int) -> Obj | None:
        """The object at an address."""
        page = self.pages.get(address >> SHIFT)
        return None if page is None else page[address & MASK]

    def stands(self, address: int) -> Obj | None:
        """The object at an address, of this copy or of the ground."""
        found = self.get(address)
        return found if found is not None or self._ground is None else self._ground(address)

    def __contains__(self, address: int) -> bool:
        return self.get(address) is not None

    def __setitem__(self, address: int, obj: Obj) -> None:
        number = address >> SHIFT
        page = self.pages.get(number)
        if number not in self._own:
            page = self.pages[number] = list(_BLANK) if page is None else page.copy()
            self._own.add(number)
            if number not in self._changed and self._ground is not None and self._ground(address) is not None:
                self._changed |= {number}
        assert page is not None
        page[address & MASK] = obj

    def holds(self, addresses: Iterable[int], records: Iterable[Obj | None]) -> bool:
        """Whether these records, or such as say the same, stand at these addresses, of this copy alone (None: nothing does)."""
        pages = self.pages
        for address, record in zip(addresses, records, strict=True):
            page = pages.get(address >> SHIFT)
            found = None if page is None else page[address & MASK]
            if record is not found and (record is None or found is None or not alike(record, found)):
                return False
        return True

    def restore(self, before: Heap) -> None:
        """Take back what was written to the objects that an earlier copy has; what is new stays."""
        for number, theirs in before.pages.items():
            if self.pages[number] is not theirs:
                for offset, obj in enumerate(theirs):
                    if obj is not None and self.pages[number][offset] is not obj:
                        self[(number << SHIFT) + offset] = obj

    def changed_since(self, before: Heap) -> Iterator[tuple[int, Obj]]:
        """The objects that an earlier copy has not, or has otherwise."""
        for number, page in self.pages.items():
            theirs = before.pages.get(number, _BLANK)
            if page is not theirs:
                for offset in compress(_OFFSETS, map(is_not, page, theirs)):
                    obj = page[offset]
                    if obj is not None:
                        yield (number << SHIFT) + offset, obj

    def shared_pages(self) -> Iterable[tuple[int, Page]]:
        """The pages by their numbers, to keep: whoever writes to this heap from now on writes to copies of them."""
        if self._own:
            self._own = set()
        return self.pages.items()

    def pages_apart(self, other: Heap) -> Iterator[tuple[Page, Page | None]]:
        """The pages that another heap has, or has otherwise, each with that of the other; to keep, as above."""
        if self._own:
            self._own = set()
        pages, theirs = self.pages, other.pages
        for number in compress(pages, map(is_not, map(theirs.get, pages), pages.values())):
            yield pages[number], theirs.get(number)

    def items(self) -> Iterator[tuple[int, Obj]]:
        """All objects with their addresses."""
        for number, page in self.pages.items():
            for offset, obj in enumerate(page):
                if obj is not None:
                    yield (number << SHIFT) + offset, obj

    def cover(
        self,
        other: Heap,
        merge: Callable[[Obj, Obj], Obj],
        *,
        widens: bool = False,
        known: Heap | None = None,
    ) -> tuple[int, bool]:
        """Take over what only the other has, and merge what both have: how many objects differed, and whether anything changed here.

        `merge` gives its first argument where that covers the second. `known`: a heap that this one surely covers; what the other has as it was
        there is not looked at.
        """
        changed, compared = False, 0
        covered, whole = self._covered.pairs(widens=widens), self._covered.pages(widens=widens)
        on_ground = self._changed | other._changed if self._changed or other._changed else self._changed
        pages, others = self.pages, other.pages
        before = {} if known is None or on_ground else known.pages
        differing = list(compress(others, map(is_not, map(pages.get, others), others.values())))
        if self._changed:
            differing += self._changed.difference(others)
        for number in differing:
            ours, theirs = pages.get(number), others.get(number)
            if theirs is not None and before.get(number) is theirs:
                continue
            if number in on_ground:
                here, there = self._grounded(number, ours, theirs), self._grounded(number, theirs, ours)
                ours, theirs = here, there
            elif ours is None:
                self._share(number, other)
                changed = True
                continue
            assert ours is not None
            assert theirs is not None
            again = whole.get((id(ours), id(theirs)))
            if again is not None and number not in before:
                compared += again[2]
                continue
            first = compared
            merged, as_here, as_there = ours, True, number not in on_ground
            seen = before.get(number, _BLANK)
            for offset in compress(_OFFSETS, map(is_not, ours, theirs)):
                a, b = ours[offset], theirs[offset]
                if b is not None and seen[offset] is b:
                    as_there = False
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
                if number not in on_ground and number not in before:  # else they are not all that is looked at
                    self._own.discard(number)
                    other._own.discard(number)
                    whole[id(ours), id(theirs)] = ours, theirs, compared - first
                continue
            changed = True
            if as_there:
                self._share(number, other)
            else:
                self.pages[number] = merged
                self._own.add(number)
        self._changed = on_ground
        return compared, changed

    def _grounded(self, number: int, page: Page | None, beside: Page | None) -> Page:
        """A page with the objects of the ground in the places where the page beside it holds another one."""
        here, there = page or _BLANK, beside or _BLANK
        assert self._ground is not None
        return [
            self._ground((number << SHIFT) + offset) if a is None and b is not None else a
            for offset, (a, b) in enumerate(zip(here, there, strict=True))
        ]

    def fill(self, other: Heap, merge: Callable[[Obj, Obj], Obj]) -> None:
        """Take over what only the other has; of an object of the ground that only the other has changed, both."""
        for number, theirs in other.pages.items():
            ours = self.pages.get(number)
            if ours is None and number not in other._changed:
                self._share(number, other)
            elif ours is not theirs:
                for offset, obj in enumerate(theirs):
                    if obj is not None and (ours is None or ours[offset] is None):
                        address = (number << SHIFT) + offset
                        ground = self.stands(address)
                        self[address] = obj if ground is None else merge(ground, obj)

    def _share(self, number: int, other: Heap) -> None:
        """One page for both from now on."""
        self.pages[number] = other.pages[number]
        self._own.discard(number)
        other._own.discard(number)
