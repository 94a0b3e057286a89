# SPDX-License-Identifier: Apache-2.0
"""What stands in the objects of a program, for who reads: in one slot, anywhere in an object, in all that a value leads to.

An object of which nothing was written holds its base: nothing, or the content of the message that arrived. What belongs to an attribute of
another object (`msg.header`) has the base of that attribute until it is written itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Final

from rosward.flow.content import EMPTY, Content, Layer, TooLongError
from rosward.flow.marks import NOTHING, Mark, Root, behind, is_slot, part_of, slot_of
from rosward.flow.remembered import Looked
from rosward.flow.shape import Shape
from rosward.flow.store import MASK, MELTED, SHIFT, Store

if TYPE_CHECKING:
    from typing_extensions import Self

_MOST: Final = 4_000
"""So many objects are looked through for what a value leads to; where there are more, the walk has come to its limit."""
_MOST_LOOKS: Final = 64
_DEPTH: Final = 8
"""Where a value leads to so many times more objects than it may be itself, these are one from then on."""
_APART: Final = frozenset(("made", "tuple", "of", "arrived", "external", MELTED))
"""What without an address may be one with others."""
_KINDS: Final = frozenset(("instance", "list", "dict", "set"))
"""And which objects with one."""


class Standing(Store):
    """The contents of all objects at one point of the program, to read."""

    __slots__ = ("_looked", "_met", "shape")

    def __init__(self, shape: Shape) -> None:
        super().__init__(shape.numbers)
        self.shape = shape
        self._looked: dict[frozenset[Root], Looked] = {}  # what still holds
        self._met = -1  # which state of what stands beside is covered here

    def apart(self, roots: Iterable[Root]) -> Iterable[Root]:
        """Of these objects, one for each content; where there are too many, they are one from now on."""
        if roots.__class__ is not frozenset:
            roots = frozenset(roots)
        assert isinstance(roots, frozenset)
        if len(roots) < 2:
            return roots
        self.shape.spent += len(roots) >> 3
        found = self.numbers.apart(roots)
        if len(found) > self.shape.few:
            self.merge(found)
            found = self.numbers.apart(roots)
        return found

    def current(self) -> Self:
        """The same, once it has taken in which objects are merged."""
        if self._fold():
            self._looked = {}
            self._met = -1
        return self

    def merge(self, roots: Iterable[Root]) -> None:
        """These are not told apart from now on, but for those that have to be."""
        numbers, shape = self.numbers, self.shape
        members = [r for r in roots if self._may_merge(r)]
        if len(set(map(numbers.number, members))) < 2:
            return
        numbers.merge(members, frozenset(held for r in members for held in shape.held(r)))
        addresses = [r for r in members if isinstance(r, int)]
        shape.many.update(addresses)
        shape.several.update(addresses)
        self.current()
        if shape.tracker is not None:
            shape.tracker.open = True

    def _may_merge(self, root: Root) -> bool:
        if isinstance(root, int):
            return root not in self.shape.nodes and self.shape.kind(root) in _KINDS
        return root[0] in _APART

    def now(self, root: Root) -> Content:
        """The content of an object, about which nobody is told that it was read; of a slot, what stands there."""
        number = self._of.get(root)  # `known`, without the call: nothing is asked as often
        if number is not None and (page := self._pages.get(number >> SHIFT)) is not None:
            found = page[number & MASK]
            if found is not None:
                return found
        return self._unwritten(root)

    def _unwritten(self, root: Root) -> Content:
        """The content of an object to which nothing was written: what it is a part of says it."""
        if root.__class__ is tuple and root[0] == "slot":  # no address
            return Content(any=self.at(root))
        owner = part_of(root, self.shape.inner)
        mask = 0 if owner is None else self.now(owner[0]).read(owner[1]).mask
        return Content(base=mask) if mask else EMPTY

    def of(self, root: Root) -> Content:
        """The content of an object, all of which is read."""
        found = self.now(root)
        tracker = self.shape.tracker
        if tracker is not None and (root.__class__ is int or not is_slot(root)):
            tracker.read(root, found)
        return found

    def part(self, root: Root, *keys: object) -> Content:
        """The content of an object, of which nothing but these slots is read."""
        found = self.now(root)
        tracker = self.shape.tracker
        if tracker is not None and (root.__class__ is int or not is_slot(root)):
            for key in keys:
                tracker.read_slot(root, key, found)
        return found

    def at(self, slot: Root) -> Mark:
        """What stands in a slot. Where that is a part of a message, which part it is the message does not say."""
        base, key, how = slot_of(slot)
        content = self.of(base)
        if how == "any":
            return content.whole
        part = self.shape.part(base, key)
        if part is None:
            return content.read(key)
        found = content.read(key) if key in content.slots else content.any
        return Mark(found.mask, found.roots | {part})

    def read(self, roots: Iterable[Root], key: object) -> Mark:
        """What stands under a key in any of several objects."""
        found = NOTHING
        for root in self.apart(roots):
            found = found.joined(self.part(root, key).read(key))
        return self.told(found)

    def read_all(self, roots: Iterable[Root]) -> Mark:
        """All that stands in any of several objects."""
        found = NOTHING
        for root in self.apart(roots):
            found = found.joined(self.of(root).whole)
        return self.told(found)

    def told(self, mark: Mark) -> Mark:
        """The same; where it leads to very many objects, with one for all that are merged."""
        if len(mark.roots) <= self.shape.few:
            return mark
        self.shape.spent += len(mark.roots) >> 3
        return Mark(mark.mask, self.numbers.canonical(mark.roots))

    def base(self, roots: frozenset[Root]) -> int:
        """What stands in objects that came from outside, as far as one look tells."""
        found = 0
        for root in self.numbers.apart(roots):
            content = self.known(root)
            if content is not None:
                found |= content.base
        return found

    def size(self, roots: Iterable[Root]) -> int:
        """What the number of elements depends on; of a set, on which of them are equal."""
        found = 0
        for root in self.apart(roots):
            content = self.of(root)
            found |= content.size | content.base
            if isinstance(root, int) and self.shape.kind(root) == "set":
                found |= self.deep(Mark(0, frozenset((root,))))
        return found

    def is_one(self, roots: Iterable[Root]) -> bool:
        """Whether it is surely one object."""
        known = list(roots)
        return len(known) == 1 and isinstance(known[0], int) and known[0] not in self.shape.many

    def near(self, mark: Mark) -> int:
        """What a value depends on, with what stands in it, as far as one look tells."""
        found = mark.mask
        for root in self.apart(mark.roots):
            content = self.of(root)
            found |= content.size | content.whole.mask
        return found

    def deep(self, mark: Mark) -> int:
        """All that a value depends on, with what it leads to; but not what nodes hold that it leads to."""
        roots = mark.roots
        if not roots:
            return mark.mask
        if len(roots) == 1:
            found = self._of_leaf(*roots)
            if found is not None:
                return mark.mask | found
        tracker = self.shape.tracker
        looked = self._looked.get(roots)
        if looked is None:
            looked = self._look(roots)
            if len(self._looked) >= _MOST_LOOKS:
                self._looked = {}
            self._looked[roots] = looked
        elif tracker is not None and looked.tracker is not tracker:
            for root, content in looked.reads.items():
                tracker.read(root, content)
            looked.tracker = tracker
            self.shape.spent += 1
        return mark.mask | looked.mask

    def _of_leaf(self, root: Root) -> int | None:
        """What stands in an object that leads nowhere; None where it is none."""
        content = self.known(root)
        if content is None or content.whole.roots or self._holds(root):
            return None
        tracker = self.shape.tracker
        if tracker is not None:
            tracker.read(root, content)
        self.shape.spent += 1
        return content.whole.mask | content.size

    def _holds(self, root: Root) -> Iterable[Root]:
        """What an object leads to whatever was written to it."""
        number = self._of.get(root)
        if number is not None and number in self.numbers.merged:
            return self.numbers.led[number]
        return self.shape.held(root)

    def _look(self, roots: frozenset[Root]) -> Looked:
        """All that these lead to."""
        mask = 0
        seen: Layer = {}
        further: Layer = {}
        canonical, of, merged = self.numbers.canonical, self._of, self.numbers.merged
        work = set(canonical(roots))
        known = {id(roots)}
        met: set[int] = set()  # what stands for several
        repeated = 0
        nodes = self.shape.nodes
        while work:
            if len(seen) > _MOST:
                raise TooLongError
            root = work.pop()
            number = of.get(root)
            if number in merged:
                if number in met:
                    repeated += 1
                    continue
                met.add(number)
                root = self.numbers.one(root)
            content = seen[root] = self.of(root)
            if self.known(root) is None:
                for each in map(self.numbers.one, behind(root, self.shape.inner)):
                    further[each] = self.of(each)
            whole = content.whole
            mask |= whole.mask | content.size
            if whole.roots and id(whole.roots) not in known:  # many objects share what they lead to
                known.add(id(whole.roots))
                work |= canonical(whole.roots) - seen.keys() - nodes
            work.update(r for r in self._holds(root) if r not in seen)
        self.shape.spent += len(seen) + (repeated >> 3)
        if len(seen) > self.shape.few * _DEPTH:
            self.merge(seen)
        return Looked(mask, {**further, **seen}, self.shape.tracker)

    def reached(self, mark: Mark) -> Iterator[Root]:
        """The objects that a value leads to, but for nodes that it does not lead to at once; of those that are merged, one."""
        canonical, of, merged = self.numbers.canonical, self._of, self.numbers.merged
        seen: set[object] = set()
        work = list(mark.roots)
        while work:
            root = work.pop()
            number = of.get(root)
            here = ("all", number) if number in merged else root
            if here in seen:
                continue
            if len(seen) > _MOST:
                raise TooLongError
            seen.add(here)
            yield root
            work += canonical(self.of(root).whole.roots) - self.shape.nodes
            work += self._holds(root)
