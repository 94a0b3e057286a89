# SPDX-License-Identifier: Apache-2.0
"""One memory for all points of a program: what is written somewhere may stand there everywhere.

It only grows. So whoever has read an object need look again only where that one has become more.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import TYPE_CHECKING, Final, final

from rosward.flow.content import Content, Layer, both
from rosward.flow.library import name_of
from rosward.flow.marks import Mark, Root, is_slot
from rosward.flow.memory import Memory
from rosward.flow.remembered import Looked
from rosward.flow.shape import MELTED

if TYPE_CHECKING:
    from rosward.flow.shape import Shape
    from rosward.flow.stay import Stay

_UNBOUNDED: Final = 1 << 62
_FEW: Final = 24
"""So many objects that unknown code can reach are told apart."""
_MOST_LOOKS: Final = 256


@final
class CoarseMemory(Memory):
    """The content of all objects, at any point. `reader` is the body that runs, `grew` whether anything became more."""

    __slots__ = ("_looking", "_melted", "_readers", "grew", "reader")
    most = _UNBOUNDED

    def __init__(self, shape: Shape) -> None:
        super().__init__(shape)
        self.reader: Stay | None = None
        self.grew = False
        self._readers: dict[Root, set[Stay]] = {}
        self._melted: set[Root] = set()
        self._looking: dict[Root, list[frozenset[Root]]] = {}  # what was looked through from where

    def copy(self) -> CoarseMemory:
        """Itself: there is no other."""
        return self

    def join(self, other: Memory) -> bool:
        """Nothing to do, since there is no other."""
        assert other is self
        return False

    def is_one(self, roots: Iterable[Root]) -> bool:  # noqa: ARG002 - as with any memory
        """Never: what stood there before may still be read."""
        return False

    def known(self, root: Root) -> Content | None:
        """What was written of an object; None where nothing was."""
        return self._own.get(MELTED if self._is_melted(root) else root)

    def _is_melted(self, root: Root) -> bool:
        """Whether it is one with others, or belongs to what is."""
        if root in self._melted:
            return True
        while not isinstance(root, int) and root[0] == "of":
            root = root[1]  # type: ignore[assignment]  # a root
            if root in self._melted or root == MELTED:
                return True
        return False

    def melt(self, roots: frozenset[Root]) -> frozenset[Root]:
        """These are one from now on, with all that were made one before; but for nodes."""
        fresh = {r for root in roots for r in self._around(root)} - self._melted
        for root in fresh:
            content = self.of(root)
            leads = content.whole.roots
            if isinstance(root, int):
                leads = leads.union(self.shape.held(root), self.shape.parts(root))
            self._melted.add(root)
            self._put(MELTED, Content(0, Mark(content.whole.mask, leads), content.size | content.base))
            self._own.pop(root, None)
            self._tell(root)
        whole = self._own.get(MELTED) if fresh else None
        if whole is not None:  # what it leads to may be itself by now
            self._own[MELTED] = Content(0, Mark(whole.any.mask, self._without(whole.any.roots) - {MELTED}), whole.size)
        return self._without(roots)

    def _around(self, root: Root) -> list[Root]:
        """An object, with those that say what stands in it as long as nothing else does; none where a node does so."""
        found = [] if is_slot(root) else [root]
        found += self._behind(root)
        return [] if root == MELTED or not self.shape.nodes.isdisjoint(found) else found

    def _without(self, roots: frozenset[Root]) -> frozenset[Root]:
        """The same objects, of which all that are one are named once."""
        if not any(map(self._is_melted, roots)):
            return roots
        found: set[Root] = {MELTED}
        for root in roots:
            if not self._is_melted(root):
                found.add(root)
            elif (name := name_of(root)) and (
                name := self.shape.class_behind(name)
            ):  # what is called on it goes by its name
                named: Root = ("made", "", 0, name)
                self._melted.add(named)
                found.add(named)
        return frozenset(found)

    def _mark(self, mark: Mark) -> Mark:
        roots = self._without(mark.roots)
        return mark if roots is mark.roots else Mark(mark.mask, roots)

    def _tell(self, root: Root) -> None:
        """Something became more here: who has read it is to look again."""
        self.grew = True
        for roots in self._looking.pop(root, ()):
            self._looked.pop(roots, None)
        for stay in self._readers.pop(root, ()):
            stay.again()

    def _put(self, root: Root, content: Content) -> None:
        if root == MELTED or self._is_melted(root):
            root = MELTED
            held = content.whole
            content = Content(0, Mark(held.mask, self._without(held.roots) - {MELTED}), content.size | content.base)
        elif self._melted:
            slots = {key: self._mark(mark) for key, mark in content.slots.items()}
            content = Content(content.base, self._mark(content.any), content.size, slots)
        old = self._own.get(root)
        merged = content if old is None else both(old, content)
        if merged.base:  # what was written later does not replace what was there
            bare = [key for key, mark in merged.slots.items() if mark.mask & merged.base != merged.base]
            if bare:
                slots = dict(merged.slots)
                for key in bare:
                    slots[key] = slots[key].under(merged.base)
                merged = merged.with_slots(slots)
        if merged is old or merged == old:
            return
        self._own[root] = merged
        self._tell(root)

    def of(self, root: Root) -> Content:
        """The content of an object; of a slot, what stands there."""
        if is_slot(root):
            return Content(any=self.at(root))
        if self._is_melted(root):
            root = MELTED
        if self.reader is not None:
            self._readers.setdefault(root, set()).add(self.reader)
        found = super().of(root)
        owner = self._owner(root)
        if owner is None or root not in self._own:
            return found
        mask = self.of(owner[0]).read(owner[1]).mask
        return both(found, Content(base=mask)) if mask else found

    def deep(self, mark: Mark) -> int:
        """All that a value depends on, with what it leads to."""
        if not mark.roots:
            return mark.mask
        looked = self._looked.get(mark.roots)
        if looked is None:
            looked = self._look(mark.roots)
            if len(self._looked) >= _MOST_LOOKS:
                self._looked.clear()
                self._looking.clear()
            self._looked[mark.roots] = looked
            for root in looked.reads:
                self._looking.setdefault(MELTED if self._is_melted(root) else root, []).append(mark.roots)
        elif self.reader is not None:
            for root in looked.reads:
                self._readers.setdefault(MELTED if self._is_melted(root) else root, set()).add(self.reader)
        return mark.mask | looked.mask

    def reached(self, mark: Mark) -> Iterator[Root]:
        """The objects that a value leads to; where they are many, they are one from now on."""
        found = frozenset(root for root, _ in self._all(mark.roots))
        yield from self.melt(found) if len(found) > _FEW else found

    def _all(self, roots: frozenset[Root]) -> Iterator[tuple[Root, Content]]:
        """All objects that these lead to, but for nodes that these do not lead to at once."""
        seen: set[Root] = set()
        work = list(roots)
        nodes = self.shape.nodes
        while work:
            root = work.pop()
            if root in seen:
                continue
            if self._is_melted(root):
                seen.add(root)
                root = MELTED
                if root in seen:
                    continue
            seen.add(root)
            content = self.of(root)
            yield root, content
            work += [r for r in content.whole.roots if r not in seen and r not in nodes]
            work += [r for r in self.shape.held(root) if r not in seen]

    def _look(self, roots: frozenset[Root]) -> Looked:
        """All that these lead to."""
        mask = 0
        found: Layer = {}
        for root, content in self._all(roots):
            mask |= content.whole.mask | content.size
            if root not in self._own:
                for each in self._behind(root):
                    found[each] = self.of(each)
            found[root] = content
        self.shape.spent += len(found)
        return Looked(mask, found, None)

    def cover(self, written: Layer) -> None:
        """Each of these contents may stand here, too."""
        for root, content in written.items():
            self._put(root, content)

    def place(self, root: Root, content: Content) -> None:
        """A new object stands here, beside all that stood there."""
        self._put(root, content)
        if isinstance(root, int):
            for inner in self.shape.parts(root):
                if self.known(inner) is not None:
                    self._put(inner, Content(base=content.read(self.shape.inner[inner][1]).mask))

    place_again = place

    def renew(self, root: Root) -> None:
        """What was written to the result of the call before may still be read."""

    def forget(self, variables: Iterable[Root]) -> None:
        """As with results."""

    def collapse(self, roots: Iterable[Root]) -> None:
        """Elements change their places: each may stand under any key."""
        for root in roots:
            content = self.of(root)
            if content.slots and not is_slot(root):
                self._put(root, Content(content.base, content.whole, content.size))

    def take_out(self, roots: Collection[Root], mask: int) -> None:
        """An element is gone, or is not."""
        self.collapse(roots)
        self.write_any(roots, Mark(mask), mask)
