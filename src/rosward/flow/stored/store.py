# SPDX-License-Identifier: Apache-2.0
"""Where do the contents of objects stand, so that a copy costs little, and what differs between two copies is found at once?

before = memory.copy()       shares everything
memory.put(root, content)    copies the page of that object
memory.join(before)          looks only at the objects that differ

Each object of a walk has a number, and its content stands on a page with those of its neighbours. Objects that nobody needs to tell apart
have one number, and one content.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence, Set
from itertools import compress
from operator import is_not
from typing import Final, final

from rosward.flow.marks import Mark, Root, name_of
from rosward.flow.stored.content import EMPTY, Content, both
from rosward.records import NamedTuple

Page = list[Content | None]
Differing = tuple[int, Content | None, Content | None]
"""The number of an object, and what stands in it here and there."""

SHIFT: Final = 5
"""So many bits of the number of an object say where on a page it stands."""
MASK: Final = (1 << SHIFT) - 1
_OFFSETS: Final = range(MASK + 1)
_BLANK: Final[tuple[None, ...]] = (None,) * (MASK + 1)
_MOST_COVERED: Final = 5_000
_MOST_KNOWN: Final = 1_000
"""Of so many sets of objects it is kept which of them are one."""
MELTED: Final = "melted"
"""The first word of what stands for many objects."""


class Covered(NamedTuple):
    """A content that covers another one, from which it differs under these keys, or (None) anywhere."""

    ours: Content
    theirs: Content
    keys: Set[object] | None


@final
class Numbers:
    """The numbers of the objects of one walk."""

    __slots__ = (
        "_apart",
        "_canonical",
        "_covered",
        "_named",
        "_ranks",
        "_tells",
        "based",
        "from_outside",
        "held",
        "led",
        "merged",
        "merges",
        "of",
        "roots",
    )

    def __init__(self, tells: Callable[[str], bool]) -> None:
        self._tells = tells  # whether more is known of something of a library by its name
        self.of: dict[Root, int] = {}
        self.roots: list[Root] = []  # by number
        self.merged: dict[int, list[Root]] = {}  # the numbers that stand for several objects, with these
        self.led: dict[int, frozenset[Root]] = {}  # where such an object leads whatever was written to it
        self.merges: list[tuple[int, tuple[int, ...]]] = []  # each with the numbers that it took the place of
        self.held: set[Root] = set()  # what was ever written into an object
        self.based: set[Root] = set()  # what ever came from outside
        self.from_outside: set[int] = set()  # the numbers of which that is said
        self._covered: dict[tuple[int, int], Covered] = {}
        self._apart: dict[frozenset[Root], frozenset[Root]] = {}
        self._named: dict[tuple[int, str], Root] = {}  # the one that stands for others of the same name
        self._canonical: dict[frozenset[Root], frozenset[Root]] = {}
        self._ranks: dict[Root, str] = {}

    def _rank(self, root: Root) -> str:
        """An order of objects that is the same in each run, which that of sets is not: first those with an address."""
        found = self._ranks.get(root)
        if found is None:
            found = self._ranks[root] = f" {root:020}" if isinstance(root, int) else f"{root}"
        return found

    def number(self, root: Root) -> int:
        """The number of an object, which it has from now on."""
        found = self.of.get(root)
        if found is None:
            found = self.of[root] = len(self.roots)
            self.roots.append(root)
        return found

    def merge(self, members: Iterable[Root], led: frozenset[Root]) -> None:
        """Several objects are one from now on."""
        taken = dict.fromkeys(self.number(root) for root in sorted(members, key=self._rank))
        known = [number for number in taken if number in self.merged]
        if known:  # what stood for most of them stands for all
            new = max(known, key=lambda number: len(self.merged[number]))
        else:
            new = self.number((MELTED, len(self.merges)))
            self.merged[new] = [self.roots[new]]
        for number in taken:
            if number != new:
                several = self.merged.pop(number, [self.roots[number]])
                led |= self.led.pop(number, frozenset())
                self.merged[new] += several
                self.of.update(dict.fromkeys(several, new))
        if not self.based.isdisjoint(self.merged[new]):
            self.based.update(self.merged[new])
        self._apart.clear()
        self._canonical.clear()
        self.led[new] = self.canonical(led | self.led.get(new, frozenset()))
        self.merges.append((new, tuple(number for number in taken if number != new)))

    def one(self, root: Root) -> Root:
        """What stands for an object: itself, unless it is merged."""
        number = self.of.get(root)
        return root if number is None or number not in self.merged else self.roots[number]

    def alike(self, root: Root) -> Sequence[Root]:
        """The objects that an object is one with; itself, where it is not merged."""
        number = self.of.get(root)
        return (root,) if number is None else self.merged.get(number, (root,))

    def comes_in(self, number: int) -> None:
        """What stands in an object came from outside; where it stands for several, in each of them."""
        self.from_outside.add(number)
        self.based.update(self.merged.get(number) or (self.roots[number],))

    def canonical(self, roots: frozenset[Root]) -> frozenset[Root]:
        """The same objects, with one for all that are merged; of things of libraries, one for each name that tells something."""
        if not self.merged:
            return roots
        found = self._canonical.get(roots)
        if found is None:
            if len(self._canonical) >= _MOST_KNOWN:
                self._canonical.clear()
            of, merged, named = self.of, self.merged, self._named
            ones: dict[object, Root] = {}
            names: dict[tuple[int, str], Root] = {}  # such that were not met before
            for root in roots:
                number = of.get(root)
                if number is None or number not in merged:
                    ones[root] = root
                elif not isinstance(root, int) and root[0] != "of" and (name := name_of(root)):
                    key = (number, name if self._tells(name) else name.partition(".")[0])
                    if key in named:
                        ones[key] = named[key]
                    else:
                        names[key] = min(root, names.get(key, root), key=self._rank)
                else:
                    ones[number, ""] = self.roots[number]
            named.update(names)
            found = self._canonical[roots] = frozenset((*ones.values(), *names.values()))
        return found

    def apart(self, roots: frozenset[Root]) -> frozenset[Root]:
        """Of these, one for each content that they have."""
        if not self.merged:
            return roots
        found = self._apart.get(roots)
        if found is None:
            if len(self._apart) >= _MOST_KNOWN:
                self._apart.clear()
            of, merged = self.of, self.merged
            one: dict[object, Root] = {}
            for root in roots:
                number = of.get(root)
                here = number if number in merged else root
                one[here] = min(root, one.get(here, root), key=self._rank)
            found = self._apart[roots] = roots if len(one) == len(roots) else frozenset(one.values())
        return found

    def melted(self, content: Content) -> Content:
        """The content of one of many objects: nobody knows under which key what stands."""
        whole = content.whole
        return Content(content.base, Mark(whole.mask, self.canonical(whole.roots)), content.size)

    @property
    def covered(self) -> dict[tuple[int, int], Covered]:
        """Pairs of contents, by id(), of which the first is known to cover the second; forgotten where they become too many."""
        if len(self._covered) > _MOST_COVERED:
            self._covered.clear()
        return self._covered


class Store:
    """Pages of contents. A page is shared between copies until one of them writes to it."""

    __slots__ = ("_folded", "_of", "_own", "_pages", "numbers")

    def __init__(self, numbers: Numbers) -> None:
        self.numbers = numbers
        self._of = numbers.of
        self._pages: dict[int, Page] = {}
        self._own: set[int] = set()  # the pages that no copy shares
        self._folded = len(numbers.merges)  # so many merges are taken in

    def _share_with(self, copy: Store) -> None:
        """Another one, which holds nothing so far, holds the same from now on."""
        copy._pages = self._pages.copy()
        copy._folded = self._folded
        if self._own:
            self._own = set()

    def known(self, root: Root) -> Content | None:
        """What was written of an object; None where nothing was."""
        number = self._of.get(root)
        if number is None:
            return None
        page = self._pages.get(number >> SHIFT)
        return None if page is None else page[number & MASK]

    def numbered(self, number: int) -> Content | None:
        """The same, by the number of the object."""
        page = self._pages.get(number >> SHIFT)
        return None if page is None else page[number & MASK]

    def _set(self, number: int, content: Content | None) -> None:
        key = number >> SHIFT
        page = self._pages.get(key)
        if key not in self._own:
            page = self._pages[key] = list(_BLANK) if page is None else page.copy()
            self._own.add(key)
        assert page is not None
        page[number & MASK] = content
        if content is not None and content.base and number not in self.numbers.from_outside:
            self.numbers.comes_in(number)

    def items(self) -> Iterator[tuple[Root, Content]]:
        """All objects of which something was written."""
        roots = self.numbers.roots
        for key, page in self._pages.items():
            for offset, content in enumerate(page):
                if content is not None:
                    yield roots[(key << SHIFT) + offset], content

    def differing(self, other: Store) -> list[Differing]:
        """The objects whose contents are not the same thing here and there."""
        found: list[Differing] = []
        pages, others = self._pages, other._pages
        for key in compress(others, map(is_not, map(pages.get, others), others.values())):
            ours, theirs, first = pages.get(key, _BLANK), others[key], key << SHIFT
            found += [(first + n, ours[n], theirs[n]) for n in compress(_OFFSETS, map(is_not, ours, theirs))]
        for key in pages.keys() - others.keys():
            ours, first = pages[key], key << SHIFT
            found += [(first + n, ours[n], None) for n in compress(_OFFSETS, map(is_not, ours, _BLANK))]
        return found

    def _fold(self) -> bool:
        """Objects that were merged since this was current are one here, too; whether there were any."""
        merges = self.numbers.merges
        if self._folded == len(merges):
            return False
        for new, taken in merges[self._folded :]:
            content = self.numbered(new)
            for number in taken:
                old = self.numbered(number)
                if old is not None:
                    content = both(EMPTY if content is None else content, self.numbers.melted(old))
                    self._set(number, None)
            if content is not None:
                self._set(new, content)
        self._folded = len(merges)
        return True
