# SPDX-License-Identifier: Apache-2.0
"""What stands in the objects of a program, for who reads: in one slot, anywhere in an object, in all that a value leads to.

An object of which nothing was written holds its base: nothing, or the content of the message that arrived. What belongs to an attribute of
another object (`msg.header`) has the base of that attribute until it is written itself.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING, Final

from rosward.flow.marks import NOTHING, Mark, Root, behind, is_slot, part_of, slot_of
from rosward.flow.stored.content import EMPTY, Content, Layer, TooLongError
from rosward.flow.stored.remembered import Looked
from rosward.flow.stored.shape import Shape
from rosward.flow.stored.store import MASK, MELTED, SHIFT, Store

if TYPE_CHECKING:
    from typing_extensions import Self

_MOST: Final = 4_000
"""So many objects are looked through for what a value leads to; where there are more, the walk has come to its limit."""
_SHORT: Final = 3
_WORTH: Final = 8
"""What was found by looking through fewer objects is not kept for others."""
_MOST_LOOKS: Final = 12
_DEPTH: Final = 8
"""Where a value leads to so many times more objects than it may be itself, these are one from then on."""
_APART: Final = frozenset(("made", "tuple", "of", "arrived", "external", MELTED))
"""What without an address may be one with others."""
_OF_LIBRARIES: Final = frozenset(("made", "of", "arrived", "external", MELTED))
"""In C++ none but these."""
_PARTS: Final = frozenset(("slot", "of"))
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
            return self.shape.merges_objects and root not in self.shape.nodes and self.shape.kind(root) in _KINDS
        return root[0] in (_APART if self.shape.merges_objects else _OF_LIBRARIES)

    def now(self, root: Root) -> Content:
        """The content of an object, about which nobody is told that it was read; of a slot, what stands there."""
        number = self._of.get(root)  # `known`, without the call: nothing is asked as often
        if number is not None and (page := self._pages.get(number >> SHIFT)) is not None:
            found = page[number & MASK]
            if found is not None:
                return found
        if root.__class__ is int and root not in self.shape.inner:
            return EMPTY
        return self._unwritten(root)

    def _unwritten(self, root: Root) -> Content:
        """The content of an object to which nothing was written: what it is a part of says it."""
        if is_slot(root):
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
        roots = mark.roots
        if len(roots) > self.shape.few:
            self.shape.spent += len(roots) >> 3
        elif self.shape.merges_objects or len(roots) < _SHORT or not self.numbers.merged:
            return mark
        one = self.numbers.canonical(roots)
        return mark if one is roots else Mark(mark.mask, one)

    def base(self, roots: frozenset[Root]) -> int:
        """What stands in objects that came from outside, as far as one look tells."""
        found, based = 0, self.numbers.based
        if based.isdisjoint(roots):
            return found
        for root in roots & based:
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
            if self.shape.is_set(root):
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
        return mark.mask | self._through(roots).mask

    def _through(self, roots: frozenset[Root]) -> Looked:
        """What a look through all that these lead to has found, perhaps before."""
        tracker = self.shape.tracker
        looked = self._fresh(roots)
        if looked is None:
            looked = self._look(roots)
            if len(self._looked) >= _MOST_LOOKS:
                self._looked = dict(islice(self._looked.items(), _MOST_LOOKS >> 1, None))
            self._looked[roots] = looked
        elif tracker is not None and looked.tracker is not tracker:
            tracker.read_each(looked.further)
            tracker.read_each(looked.objects)
            looked.tracker = tracker
            self.shape.spent += 1
        return looked

    def _fresh(self, roots: frozenset[Root]) -> Looked | None:
        """What a look has found, with what was written since; None where nobody looked, or there is less now."""
        looked = self._looked.get(roots)
        if looked is None or not looked.changed:
            return looked
        del self._looked[roots]
        grown = self._grown(looked, looked.changed)
        if grown is not None:
            self._looked[roots] = grown
        return grown

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
        found = Looked(0, {}, {}, self.shape.tracker)
        self._look_on(found, set(self.numbers.canonical(roots)))
        if len(found.objects) > self.shape.few * _DEPTH:
            self.merge(found.objects)
        return found

    def _look_on(self, looked: Looked, work: set[Root]) -> None:
        """What these lead to is looked through, too. What is known of some of them is taken over."""
        mask, seen, further = 0, looked.objects, looked.further
        numbers, pages, shape = self.numbers, self._pages, self.shape
        canonical, of, merged, nodes, inner = numbers.canonical, self._of, numbers.merged, shape.nodes, shape.inner
        known: set[int] = set()
        found: Layer = {}
        earlier: list[frozenset[Root]] | None = None  # what others have found that is of use here
        while work:
            if earlier is None and len(work) >= _SHORT:
                earlier = [roots for roots, each in self._looked.items() if len(each.objects) >= _WORTH]
            if earlier and len(work) >= _SHORT:
                reach = work | seen.keys()
                for roots in earlier:
                    if roots <= reach and not roots <= seen.keys():
                        each = self._fresh(roots)
                        if each is not None:
                            seen.update(each.objects)
                            found.update(each.objects)
                            further.update(each.further)
                            mask |= each.mask
                work -= seen.keys()
            more: set[Root] = set()
            before = len(found)
            for root in work:
                number = of.get(root)
                content: Content | None = None
                if number is not None:
                    if number in merged:
                        root = numbers.roots[number]  # noqa: PLW2901
                        if root in seen:
                            continue
                    page = pages.get(number >> SHIFT)
                    content = None if page is None else page[number & MASK]
                if content is None:
                    for other in map(numbers.one, behind(root, inner)):
                        further[other] = self.now(other)
                    content = self.now(root)
                seen[root] = found[root] = content
                whole = content.known or content.whole
                mask |= whole.mask | content.size
                roots = whole.roots
                if roots and id(roots) not in known:  # many objects share what they lead to
                    known.add(id(roots))
                    more |= (canonical(roots) if merged else roots) - nodes
                if number in merged:
                    more.update(numbers.led[number])
                elif root.__class__ is int and (held := shape.held(root)):
                    more.update(held)
            several = len(found) - before  # of those that are one, each costs less
            self.shape.spent += several + ((len(work) - several) >> 1)
            if len(seen) > _MOST:
                raise TooLongError
            work = more - seen.keys()
        looked.mask |= mask
        tracker = looked.tracker
        if tracker is not None and tracker is self.shape.tracker:
            tracker.read_each(further)
            tracker.read_each(found)

    def _grown(self, looked: Looked, written: frozenset[Root]) -> Looked | None:
        """What a look finds now that these were written; None where less stands in one of them."""
        found = looked.copy()
        self.shape.spent += 1
        more: set[Root] = set()
        for root in self._told_by(looked, written):
            before, here = looked.objects[root], self.now(root)
            if before is here:
                continue
            if not before.within(here):
                return None
            whole = here.whole
            found.objects[root] = here
            found.mask |= whole.mask | here.size
            more |= whole.roots
        for root in written & looked.further.keys():
            found.further[root] = self.now(root)
        if more:
            self._look_on(found, set(self.numbers.canonical(frozenset(more)) - found.objects.keys() - self.shape.nodes))
        return found

    def _told_by(self, looked: Looked, written: frozenset[Root]) -> Iterator[Root]:
        """The objects of a look that may have another content where these were written."""
        yield from written & looked.objects.keys()
        if not looked.further.keys().isdisjoint(written):
            inner, one = self.shape.inner, self.numbers.one
            for root in looked.objects:
                if root in inner if isinstance(root, int) else root[0] in _PARTS:
                    if self.known(root) is None and not written.isdisjoint(map(one, behind(root, inner))):
                        yield root

    def take_looks(self, other: Standing) -> None:
        """What was found by looking through another one, which is covered here, is of use here, too."""
        for roots, looked in other.current()._looked.items():
            if roots in self._looked or len(looked.objects) < _WORTH or len(self._looked) >= _MOST_LOOKS:
                continue
            known = {**looked.further, **looked.objects}
            changed = [root for root, content in known.items() if self.known(root) not in (None, content)]
            self._looked[roots] = Looked(looked.mask, looked.objects, looked.further, None, frozenset(changed))

    def reached(self, mark: Mark) -> Collection[Root]:
        """The objects that a value leads to, but for nodes that it does not lead to at once; of those that are merged, one."""
        roots = mark.roots
        if not roots:
            return ()
        return self._through(roots).objects
