# SPDX-License-Identifier: Apache-2.0
"""What stands in the objects of a program, as far as flow is concerned: for each slot, what it depends on and what it leads to.

    self.last = msg.data      the slot `last` of the node: data of the topic
    state['a'] = msg.data     the slot 'a' of the dict; an unknown key may be any

An object of which nothing was written holds its base: nothing, or the content of the message that arrived. What belongs to an attribute of
another object (`msg.header`) has the base of that attribute until it is written itself.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Final, final

from rosward.flow.content import EMPTY, Content, Layer, TooLongError, both, fewer
from rosward.flow.marks import NOTHING, Mark, Root, behind, is_slot, part_of, slot_of
from rosward.flow.remembered import Looked
from rosward.flow.shape import MELTED, Shape

_MOST: Final = 4_000
"""So many objects are looked through for what a value leads to; where there are more, the walk has come to its limit."""
_MOST_LAYERS: Final = 6
_MOST_LOOKS: Final = 64


@final
class Memory:
    """The content of all objects, at one point of the program.

    A copy shares all layers that were written before; joining two looks at those that were written since.
    """

    __slots__ = ("_looked", "_met", "_own", "_shared", "_since", "log", "shape")

    def __init__(self, shape: Shape) -> None:
        self.shape = shape
        self.log: Layer | None = None  # where each write is noted too, for who may come in between
        self._own: Layer = {}
        self._shared: tuple[Layer, ...] = ()
        self._looked: dict[frozenset[Root], Looked] = {}  # what still holds
        self._met = -1  # which state of what stands beside is covered here, but for what was written `_since`
        self._since: set[Root] = set()

    def copy(self) -> Memory:
        """An independent copy."""
        if self._own:
            self._shared = (*self._shared, self._own)
            self._own = {}
            if len(self._shared) > _MOST_LAYERS:
                self._shared = fewer(self._shared)
        copy = Memory(self.shape)
        copy._shared, copy.log = self._shared, self.log
        copy._met, copy._since = self._met, self._since.copy()
        copy._looked = self._looked.copy()
        return copy

    def known(self, root: Root) -> Content | None:
        """What was written of an object; None where nothing was."""
        found = self._own.get(root)
        if found is None:
            for layer in reversed(self._shared):
                found = layer.get(root)
                if found is not None:
                    return found
        return found

    def _put(self, root: Root, content: Content) -> None:
        if self._looked:
            self._forget_looks(root, content)
        self._own[root] = content
        if self._met >= 0:
            self._since.add(root)
        tracker = self.shape.tracker
        if tracker is not None:
            tracker.writes.add(root)
        if self.log is not None:
            old = self.log.get(root)
            self.log[root] = content if old is None else both(old, content)

    def _forget_looks(self, root: Root, content: Content) -> None:
        """What was found by looking through this object is out of date, unless the same stands in it."""
        stale = [roots for roots, look in self._looked.items() if look.reads.get(root, content) != content]
        if stale:
            self._looked = {roots: look for roots, look in self._looked.items() if roots not in stale}

    def items(self) -> Iterator[tuple[Root, Content]]:
        """All objects of which something was written."""
        whole: Layer = {}
        for layer in (*self._shared, self._own):
            whole.update(layer)
        return iter(whole.items())

    def join(self, other: Memory) -> bool:
        """Cover another one, too; whether that changed anything."""
        alike = 0
        for ours, theirs in zip(self._shared, other._shared, strict=False):
            if ours is not theirs:
                break
            alike += 1
        roots = {r for layer in (*other._shared[alike:], other._own) for r in layer}
        roots.update(r for layer in (*self._shared[alike:], self._own) for r in layer)
        return self._cover(other, roots)

    def meet(self, beside: Memory, state: int) -> None:
        """Cover what stands beside, which has a number for each of its states. What covered that state is looked at where it was written since."""
        if self._met != state:
            self.join(beside)
        elif self._since:
            self._cover(beside, self._since.copy())
        self._met, self._since = state, set()

    def _cover(self, other: Memory, roots: Iterable[Root]) -> bool:
        changed = False
        for root in roots:
            mine, their = self.known(root), other.known(root)
            if mine is their:
                continue
            merged = both(self.of(root), other.of(root))
            if merged != mine:
                self._put(root, merged)
                changed = True
        return changed

    def finds(self, reads: Layer) -> bool:
        """Whether the same stands here."""
        return all(self.of(root) == content for root, content in reads.items())

    def replay(self, writes: Layer, placed: set[int]) -> None:
        """What a walk has left."""
        for again in placed & self.shape.placed:
            self.shape.several.add(again)
            self.shape.many.add(again)
        self.shape.placed |= placed
        for root, content in writes.items():
            self._put(root, content)

    def cover(self, written: Layer) -> None:
        """Each of these contents may stand here, too."""
        for root, content in written.items():
            merged = both(self.of(root), content)
            if merged != self.known(root):
                self._put(root, merged)

    def of(self, root: Root) -> Content:
        """The content of an object; of a slot, what stands there."""
        if is_slot(root):
            return Content(any=self.at(root))
        found = self.known(root)
        if found is None:
            owner = part_of(root, self.shape.inner)
            mask = 0 if owner is None else self.of(owner[0]).read(owner[1]).mask
            found = Content(base=mask) if mask else EMPTY
        tracker = self.shape.tracker
        if tracker is not None:
            tracker.read(root, found)
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

    def _write_slot(self, slot: Root, mark: Mark, *, sure: bool = False) -> None:
        """Something is written into a slot: in the place of what stood there, where that is sure."""
        base, key, how = slot_of(slot)
        if how == "any":
            self.write_any([base], mark)
        elif sure and how == "one":
            self.write(frozenset((base,)), key, mark)
        else:
            self.write(frozenset((base,)), key, mark.joined(self.of(base).read(key)))

    def read(self, roots: Iterable[Root], key: object) -> Mark:
        """What stands under a key in any of several objects."""
        found = NOTHING
        for root in roots:
            found = found.joined(self.of(root).read(key))
        return found

    def read_all(self, roots: Iterable[Root]) -> Mark:
        """All that stands in any of several objects."""
        found = NOTHING
        for root in roots:
            found = found.joined(self.of(root).whole)
        return found

    def base(self, roots: Iterable[Root]) -> int:
        """What stands in objects that came from outside, as far as one look tells."""
        found = 0
        for root in roots:
            content = self.known(root)
            if content is not None:
                found |= content.base
        return found

    def size(self, roots: Iterable[Root]) -> int:
        """What the number of elements depends on; of a set, on which of them are equal."""
        found = 0
        for root in roots:
            content = self.of(root)
            found |= content.size | content.base
            if isinstance(root, int) and self.shape.kind(root) == "set":
                found |= self.deep(Mark(0, frozenset((root,))))
        return found

    def is_one(self, roots: Iterable[Root]) -> bool:
        """Whether it is surely one object."""
        known = list(roots)
        return len(known) == 1 and isinstance(known[0], int) and known[0] not in self.shape.many

    def write(self, roots: frozenset[Root], key: object, mark: Mark) -> None:
        """Something is written under a key: in the place of what stood there, where it is surely one object."""
        self.write_each(roots, {key: mark})

    def write_each(
        self, roots: frozenset[Root], marks: Mapping[object, Mark], perhaps: Collection[object] = ()
    ) -> None:
        """The same under several keys, under some of them only `perhaps`."""
        sure = self.is_one(roots)
        trail = self.shape.trail
        if trail is not None:
            for key, mark in marks.items():
                if mask := mark.mask | self.base(mark.roots):
                    trail.keep(mask, key)
        for root in roots:
            if is_slot(root):
                for key, mark in marks.items():
                    self._write_slot(root, mark, sure=key is None and len(roots) == 1)
                continue
            content = self._opened(root)
            slots: dict[object, Mark] = {}
            for key, mark in marks.items():
                old = content.slots.get(key)
                replaced = sure and key not in perhaps
                new = mark if replaced else mark.joined(content.read(key) if old is None else old)
                if new != old:
                    slots[key] = new
            if slots:
                self._put(root, content.with_slots({**content.slots, **slots}))

    def write_any(self, roots: Iterable[Root], mark: Mark, size: int = 0) -> None:
        """Something is written under a key that is not known, or added."""
        trail = self.shape.trail
        if trail is not None and (mask := mark.mask | self.base(mark.roots)):
            trail.keep(mask, "")
        for root in roots:
            if is_slot(root):
                self._write_slot(root, mark)
                continue
            content = self._opened(root)
            new = content.with_any(mark, size)
            if new is not content:
                self._put(root, new)

    def renew(self, root: Root) -> None:
        """The result of a call stands here anew: what was written to the one before is gone, unless something still holds it."""
        if root != MELTED and self.known(root) is not None and not self._is_held(root):
            self._put(root, EMPTY)

    def _is_held(self, root: Root) -> bool:
        """Whether something leads to an object."""
        for holder, content in self.items():
            if holder in self.shape.ended:
                continue
            if holder != root and root in content.whole.roots:
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
        if root == MELTED:
            self.write_any([root], content.whole, content.size)
            return
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
                self._put(root, both(old, content))
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
                self._put(root, EMPTY)

    def place_again(self, root: Root, content: Content) -> None:
        """An object takes over another content, and so do its parts that were written."""
        self._put(root, content)
        if isinstance(root, int):
            for inner in self.shape.parts(root):
                if self.known(inner) is not None:
                    self._put(inner, Content(base=content.read(self.shape.inner[inner][1]).mask))

    def _opened(self, root: Root) -> Content:
        """The content of an object that is about to be written; what it is a part of leads to it."""
        content = self.of(root)
        owner = part_of(root, self.shape.inner)
        if owner is not None and not isinstance(root, int) and root not in self.of(owner[0]).any.roots:
            self.write_any([owner[0]], Mark(0, frozenset((root,))))
        return content

    def near(self, mark: Mark) -> int:
        """What a value depends on, with what stands in it, as far as one look tells."""
        found = mark.mask
        for root in mark.roots:
            content = self.of(root)
            found |= content.size | content.whole.mask
        return found

    def deep(self, mark: Mark) -> int:
        """All that a value depends on, with what it leads to; but not what nodes hold that it leads to."""
        if not mark.roots:
            return mark.mask
        tracker = self.shape.tracker
        looked = self._looked.get(mark.roots)
        if looked is None:
            looked = self._look(mark.roots)
            if len(self._looked) >= _MOST_LOOKS:
                self._looked = {}
            self._looked[mark.roots] = looked
        elif tracker is not None and looked.tracker is not tracker:
            for root, content in looked.reads.items():
                tracker.read(root, content)
            looked.tracker = tracker
            self.shape.spent += 1
        return mark.mask | looked.mask

    def _look(self, roots: frozenset[Root]) -> Looked:
        """All that these lead to."""
        mask = 0
        seen: Layer = {}
        further: Layer = {}
        work = set(roots)
        known = {id(roots)}
        nodes = self.shape.nodes
        while work:
            if len(seen) > _MOST:
                raise TooLongError
            root = work.pop()
            content = seen[root] = self.of(root)
            if root not in self._own and self.known(root) is None:
                for each in behind(root, self.shape.inner):
                    further[each] = self.of(each)
            whole = content.whole
            mask |= whole.mask | content.size
            if whole.roots and id(whole.roots) not in known:  # many objects share what they lead to
                known.add(id(whole.roots))
                work |= whole.roots - seen.keys() - nodes
            work.update(r for r in self.shape.held(root) if r not in seen)
        self.shape.spent += len(seen)
        return Looked(mask, {**further, **seen}, self.shape.tracker)

    def reached(self, mark: Mark) -> Iterator[Root]:
        """The objects that a value leads to, but for nodes that it does not lead to at once."""
        seen: set[Root] = set()
        work = list(mark.roots)
        while work:
            root = work.pop()
            if root in seen:
                continue
            if len(seen) > _MOST:
                raise TooLongError
            seen.add(root)
            yield root
            work += self.of(root).whole.roots - self.shape.nodes
            work += self.shape.held(root)
