# SPDX-License-Identifier: Apache-2.0
"""What stands in the objects of a program, as far as flow is concerned: for each slot, what it depends on and what it leads to.

    self.last = msg.data      the slot `last` of the node: data of the topic
    state['a'] = msg.data     the slot 'a' of the dict; an unknown key may be any

Reading is in `standing.py`, here is what writes.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import final

from rosward.flow.marks import FUNCTIONS, Mark, Root, is_slot, part_of, slot_of
from rosward.flow.stored.content import EMPTY, Content, Layer, both
from rosward.flow.stored.remembered import Written
from rosward.flow.stored.shape import Shape
from rosward.flow.stored.standing import Standing
from rosward.flow.stored.store import MASK, SHIFT, Covered, Differing
from rosward.flow.stored.tracker import KeySets, Tracker, differing


@final
class Memory(Standing):
    """The content of all objects, at one point of the program.

    A copy shares all that was written before; joining two looks at what differs.
    """

    __slots__ = ("_since", "log")

    def __init__(self, shape: Shape) -> None:
        super().__init__(shape)
        self.log: Layer | None = None  # where each write is noted too, for who may come in between
        self._since: set[int] = set()  # what was written since what stands beside was met

    def copy(self) -> Memory:
        """An independent copy."""
        self.current()
        copy = Memory(self.shape)
        self._share_with(copy)
        copy.log = self.log
        copy._met, copy._since = self._met, self._since.copy()
        copy._looked = self._looked.copy()
        return copy

    def _put(self, root: Root, content: Content, keys: Iterable[object] | None = None) -> None:
        """An object has this content from now on; it differs from what it had under these keys, where they are given."""
        number = self.numbers.number(root)
        if number in self.numbers.merged:
            root, keys = self.numbers.roots[number], None
            content = both(self.of(root), self.numbers.melted(content))
        if self._looked:
            self._mind_looks(root, content)
        self._set(number, content)
        if self._met >= 0:
            self._since.add(number)
        tracker = self.shape.tracker
        if tracker is not None:
            tracker.write(root, content, keys)
        if self.log is not None:
            before = self.log.get(root)
            self.log[root] = content if before is None else both(before, content)

    def _mind_looks(self, root: Root, content: Content) -> None:
        """What was found by looking through this object has to take in what stands there; where that is less, it is of no use."""
        within = [r for r, looked in self._looked.items() if root in looked.objects or root in looked.further]
        if within:
            before = self.known(root)
            less = before is not None and not before.within(content)
            for roots in within:
                if less:
                    del self._looked[roots]
                else:
                    self._looked[roots] = self._looked[roots].behind(root)

    def join(self, other: Memory) -> bool:
        """Cover another one, too; whether that changed anything."""
        self.current()
        return self._cover(other.current(), self.differing(other))

    def wrote_to_others(self, before: Memory) -> bool:
        """Whether anything was written since to an object that was there."""
        roots = (self.numbers.roots[number] for number, _, _ in self.current().differing(before.current()))
        return any(isinstance(root, int) and root not in self.shape.placed for root in roots)

    def meet(self, beside: Memory, state: int) -> None:
        """Cover what stands beside, which has a number for each of its states. What covered that state is looked at where it was written since."""
        self.current()
        if self._met != state:
            self.join(beside)
        elif self._since:
            beside.current()
            self._cover(beside, [(n, self.numbered(n), beside.numbered(n)) for n in self._since])
        self._met, self._since = state, set()

    def _cover(self, other: Memory, differing: Iterable[Differing]) -> bool:
        changed = False
        roots, covered, tracker = self.numbers.roots, self.numbers.covered, self.shape.tracker
        for number, mine, their in differing:
            if mine is their:
                continue
            root = roots[number]
            ours = self.now(root) if mine is None else mine
            theirs = other.now(root) if their is None else their
            known = covered.get((id(ours), id(theirs)))
            if known is None:
                changed |= self._takes_in(root, ours, theirs)
            elif tracker is not None:
                tracker.meets(root, ours, theirs, known.keys)
        return changed

    def _takes_in(self, root: Root, ours: Content, theirs: Content) -> bool:
        """What stands in an object covers another content, too; whether that is another one then."""
        covered, pair, tracker = self.numbers.covered, (id(ours), id(theirs)), self.shape.tracker
        known = covered.get(pair)
        if known is not None:
            if tracker is not None:
                tracker.meets(root, ours, theirs, known.keys)
            return False
        keys = None if self._is_first(root) else differing(ours, theirs)
        if tracker is not None:
            tracker.meets(root, ours, theirs, keys)
        merged = both(ours, theirs)
        if merged is ours:
            covered[pair] = Covered(ours, theirs, keys)
            return False
        self._put(root, merged, keys)
        return True

    def finds(self, tracker: Tracker) -> bool:
        """Whether what a walk read stands here as it did."""
        of, pages = self._of, self._pages
        for root, keys, then in tracker.was_read():
            number = of.get(root)  # `now`, without the call: of most, the same thing stands there
            if number is not None and (page := pages.get(number >> SHIFT)) is not None:
                here = page[number & MASK]
                if here is then:
                    continue
            here = self.now(root)
            if here is then:
                continue
            if keys is None:
                if here != then:
                    return False
            else:
                for key in keys:
                    if here.read(key) != then.read(key) or (key in here.slots) != (key in then.slots):
                        return False
        return True

    def left(self, tracker: Tracker, known: KeySets) -> tuple[Written, ...]:
        """What a walk has written, as it stands here. Its keys are among the known ones from then on."""
        return tuple(
            Written(root, None if keys is None else known.setdefault(f := frozenset(keys), f), content)
            for root, keys in tracker.wrote.items()
            if (content := self.known(root)) is not None
        )

    def replay(self, writes: Iterable[Written], placed: set[int]) -> None:
        """What a walk has left."""
        for again in placed & self.shape.placed:
            self.shape.several.add(again)
            self.shape.many.add(again)
        self.shape.placed |= placed
        for root, keys, content in writes:
            if keys is None:
                self._put(root, content.again())
            else:
                now, left = self.now(root), content.slots  # without what was written on ways that lead nowhere
                slots = {key: left[key] for key in keys if key in left}
                self._put(root, now.with_slots({**now.slots, **slots}), keys)

    def cover(self, written: Layer) -> None:
        """Each of these contents may stand here, too."""
        for root, content in written.items():
            self._takes_in(root, self.now(root), content)

    def _write_slot(self, slot: Root, mark: Mark, *, sure: bool = False) -> None:
        """Something is written into a slot: in the place of what stood there, where that is sure."""
        base, key, how = slot_of(slot)
        if how == "any":
            self.write_any([base], mark)
        elif sure and how == "one":
            self.write(frozenset((base,)), key, mark)
        else:
            self.write(frozenset((base,)), key, mark.joined(self.of(base).read(key)))

    def write(self, roots: frozenset[Root], key: object, mark: Mark) -> None:
        """Something is written under a key: in the place of what stood there, where it is surely one object."""
        self.write_each(roots, {key: mark})

    def set_attribute(self, roots: frozenset[Root], name: str, mark: Mark) -> None:
        """The same for an attribute, also of a function: these are told apart by their names alone. In a union, others change with it."""
        if not roots:
            mark = mark.joined(self.read((FUNCTIONS,), name))
        self.write(roots or frozenset((FUNCTIONS,)), name, mark)
        overlapping = [root for root in roots if self.shape.overlaps(root)]
        if overlapping:
            self.write_any(overlapping, mark)

    def write_each(
        self, roots: frozenset[Root], marks: Mapping[object, Mark], perhaps: Collection[object] = ()
    ) -> None:
        """The same under several keys, under some of them only `perhaps`."""
        sure = self.is_one(roots)
        self._keeps(marks.items())
        for root in self.apart(roots):
            if is_slot(root):
                for key, mark in marks.items():
                    self._write_slot(root, mark, sure=key is None and len(roots) == 1)
                continue
            if not isinstance(root, int):
                self._open(root)
            first = self._is_first(root)
            content = self.of(root) if first else self.part(root, *marks)
            slots: dict[object, Mark] = {}
            for key, mark in marks.items():
                old = content.slots.get(key)
                replaced = sure and key not in perhaps
                new = mark if replaced else mark.joined(content.read(key) if old is None else old)
                if new != old:
                    slots[key] = new
            if slots:
                self._put(root, content.with_slots({**content.slots, **slots}), None if first else slots)

    def write_any(self, roots: Iterable[Root], mark: Mark, size: int = 0) -> None:
        """Something is written under a key that is not known, or added."""
        self._keeps((("", mark),))
        for root in self.apart(roots):
            if is_slot(root):
                self._write_slot(root, mark)
                continue
            if not isinstance(root, int):
                self._open(root)
            content = self.of(root)
            new = content.with_any(mark, size)
            if new is not content:
                self._put(root, new)

    def _keeps(self, marks: Iterable[tuple[object, Mark]]) -> None:
        """These are written somewhere."""
        trail, held = self.shape.trail, self.numbers.held
        for key, mark in marks:
            held |= mark.roots
            if trail is not None and (mask := mark.mask | self.base(mark.roots)):
                trail.keep(mask, key)

    def renew(self, root: Root) -> None:
        """The result of a call stands here anew: what was written to the one before is gone, unless something still holds it."""
        if self.known(root) is not None and not self._is_held(root):
            self._put(root, Content())

    def _is_held(self, root: Root) -> bool:
        """Whether something leads to an object."""
        if root not in self.numbers.held:
            return False
        if self._of.get(root) in self.numbers.merged:
            return True
        ended = self.shape.ended
        for holder, content in self.items():
            whole = content.known or content.whole  # this is asked very often
            if root in whole.roots and holder != root and holder not in ended:
                return True
        return False

    def collapse(self, roots: Iterable[Root]) -> None:
        """Elements change their places."""
        for root in roots:
            content = self.of(root) if not is_slot(root) else EMPTY
            if content.slots:
                self._put(root, Content(content.base, content.whole, content.size))

    def take_out(self, roots: Collection[Root], mask: int) -> None:
        """An element is gone: what stands where, and how many there are, depends on this."""
        self.collapse(roots)
        self.write_any(roots, Mark(mask), mask)

    def place(self, root: Root, content: Content) -> None:
        """A new object stands here; beside an older one, where there may be several."""
        self.numbers.held |= content.whole.roots
        shape = self.shape
        old = self.known(root)
        if isinstance(root, int):
            if root in shape.placed or (old is not None and self._is_held(root)):
                shape.several.add(root)
                shape.many.add(root)
            elif root not in shape.several:
                shape.many.discard(root)
            shape.placed.add(root)
            if shape.tracker is not None:
                shape.tracker.placed.add(root)
            if root in shape.many and old is not None:
                self._put(root, both(self.of(root), content))
                return
        self._put(root, content)
        if isinstance(root, int):
            for inner in shape.parts(root):
                if self.known(inner) is not None:
                    self._put(inner, Content(base=content.read(shape.inner[inner][1]).mask))

    def forget(self, variables: Iterable[Root]) -> None:
        """Variables begin anew."""
        for root in variables:
            if self.known(root) is not None and self.is_one((root,)):
                self._put(root, Content())

    def place_again(self, root: Root, content: Content) -> None:
        """An object takes over another content, and so do its parts that were written."""
        self._put(root, content)
        if isinstance(root, int):
            for inner in self.shape.parts(root):
                if self.known(inner) is not None:
                    self._put(inner, Content(base=content.read(self.shape.inner[inner][1]).mask))

    def _is_first(self, root: Root) -> bool:
        """Whether a part is about to be written that was not: what stands in it does not follow what it is a part of any more."""
        return self.known(root) is None and part_of(root, self.shape.inner) is not None

    def _open(self, root: Root) -> None:
        """Something without an address is about to be written; what it is a part of leads to it."""
        owner = part_of(root, self.shape.inner)
        if owner is not None and root not in self.of(owner[0]).any.roots:
            self.write_any([owner[0]], Mark(0, frozenset((root,))))
