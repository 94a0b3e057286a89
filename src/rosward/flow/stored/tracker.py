# SPDX-License-Identifier: Apache-2.0
"""What does a walk through a body read of what stood there when it began, and what does it write?

def on_timer(self):
    self.count += 1            reads and writes the slot `count` of the node, and no other
    self.pub.publish(self.m)   reads `pub` and `m`, and all that `m` leads to

What it reads is noted as it stood at the beginning: contents that the walk itself has put together are told apart by being the same thing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Set
from typing import TYPE_CHECKING, Final, final

from rosward.flow.stored.sinks import DEEP

if TYPE_CHECKING:
    from rosward.effects.flows import Sink
    from rosward.flow.marks import Root
    from rosward.flow.stored.content import Content, Layer
    from rosward.flow.stored.sinks import Chain
    from rosward.flow.stored.store import Store

_MOST_SENT: Final = 256
"""So many sinks and ways to them are told apart in a body."""

Keys = Set[object] | None
"""Slots of an object; None where it is all of it."""
KeySets = dict[frozenset[object], frozenset[object]]
"""Slots of objects, each set of them once."""
_NO_KEYS: Final[frozenset[object]] = frozenset()


@final
class Tracker:
    """Of one walk. `open`: it depends on more than that, so that it can't be remembered; `beside`: on what callbacks write.

    `asked`: what else it depends on, for which the walker has names.
    """

    __slots__ = ("_first", "_own", "_read", "asked", "beside", "open", "placed", "reads", "sent", "wrote")

    def __init__(self) -> None:
        self.reads: dict[Root, Keys] = {}
        self.wrote: dict[Root, Keys] = {}
        self.placed: set[int] = set()
        self.asked: set[object] = set()
        self.sent: dict[tuple[Sink, Chain | None], int] = {}
        self.open = False
        self.beside = False
        self._first: dict[Root, Content] = {}  # what is read, as it stood when the walk began
        self._read: tuple[tuple[Root, ...], tuple[Keys, ...], tuple[Content, ...]] = (), (), ()  # once it has ended
        self._own: dict[int, Content] = {}  # by id(): what the walk has put together itself

    def read(self, root: Root, content: Content) -> None:
        """All of an object is read."""
        if self.reads.get(root, _NO_KEYS) is None:
            return
        if id(content) not in self._own:
            self._first.setdefault(root, content)
            self.reads[root] = None
        elif root in self._first and self.wrote.get(root, _NO_KEYS) is not None:
            self.reads[root] = None

    def read_each(self, contents: Layer) -> None:
        """All of several objects is read; of slots, what they are slots of is told besides."""
        own, first, reads, wrote = self._own, self._first, self.reads, self.wrote
        for root, content in contents.items():
            if root.__class__ is not int and root[0] == "slot":  # type: ignore[index]  # `is_slot`, without the call
                continue
            if id(content) not in own:
                if root not in first:
                    first[root] = content
                reads[root] = None
            elif root in first and wrote.get(root, _NO_KEYS) is not None:
                reads[root] = None

    def read_slot(self, root: Root, key: object, content: Content) -> None:
        """One slot of an object is read."""
        known = self.reads.get(root, _NO_KEYS)
        if known is None or key in known:
            return
        if id(content) not in self._own:
            self._first.setdefault(root, content)
        else:
            wrote = self.wrote.get(root, _NO_KEYS)
            if root not in self._first or wrote is None or key in wrote:
                return
        _add(self.reads, root, (key,))

    def _read_slots(self, root: Root, keys: Set[object], content: Content) -> None:
        """Slots of an object are read that were not read before."""
        if id(content) not in self._own:
            self._first.setdefault(root, content)
        else:
            wrote = self.wrote.get(root, _NO_KEYS)
            if root not in self._first or wrote is None:
                return
            keys = keys - wrote
        _add(self.reads, root, keys)

    def meets(self, root: Root, ours: Content, theirs: Content, keys: Keys) -> None:
        """Two contents of an object, which differ under these keys, or anywhere, are joined: what is read for that, and written."""
        if keys is None:
            self.read(root, ours)
            self.read(root, theirs)
            return
        for content in (ours, theirs):
            known = self.reads.get(root, _NO_KEYS)
            if known is None or not (new := keys - known):
                return
            self._read_slots(root, new, content)

    def write(self, root: Root, content: Content, keys: Iterable[object] | None) -> None:
        """An object has another content from now on, which differs under these keys, or anywhere."""
        self._own[id(content)] = content
        _add(self.wrote, root, keys)

    def send(self, sink: Sink, chain: Chain | None, mask: int) -> None:
        """Something that depends on these sources was sent, through these statements."""
        if len(self.sent) >= _MOST_SENT and (sink, chain) not in self.sent:
            chain = None
        self.sent[sink, chain] = self.sent.get((sink, chain), 0) | mask

    def forget_ways(self) -> None:
        """The body may have called itself: through which statements something was sent is not told."""
        masks: dict[tuple[Sink, Chain | None], int] = {}
        for (sink, _), mask in self.sent.items():
            masks[sink, None] = masks.get((sink, None), 0) | mask
        self.sent = masks

    def absorb(self, inner: Tracker, at: Chain, store: Store) -> None:
        """A body inside was walked through, which is called here; `store` is what stands behind it."""
        self._reads_as(inner.reads.items(), inner._first.__getitem__)
        for root, keys in inner.wrote.items():
            _add(self.wrote, root, keys)
            content = store.known(root)
            if content is not None and id(content) in inner._own:
                self._own[id(content)] = content
        self._has_sent(inner, at)

    def repeat(self, inner: Tracker, at: Chain, standing: Callable[[Root], Content]) -> None:
        """A body inside need not be walked through once more: it reads what is standing here, and what it writes is written elsewhere."""
        roots, several, _ = inner._read
        self._reads_as(zip(roots, several, strict=True), standing)
        self._has_sent(inner, at)

    def ended(self, known: KeySets | None = None) -> None:
        """The walk has come to its end: what it has read, and sent, is kept, where it takes little space; `known` are the keys of others."""
        sets = {} if known is None else known
        keys = [None if k is None else sets.setdefault(f := frozenset(k), f) for k in self.reads.values()]
        self._read = tuple(self.reads), tuple(keys), tuple(map(self._first.__getitem__, self.reads))
        self.reads, self.wrote = {}, {}
        self._first, self._own = {}, {}

    def was_read(self) -> Iterator[tuple[Root, Keys, Content]]:
        """What a walk that has come to its end has read: of which object, under which keys, and what stood there when it began."""
        return zip(*self._read, strict=True)

    def _reads_as(self, read: Iterable[tuple[Root, Keys]], standing: Callable[[Root], Content]) -> None:
        """What a body inside reads is read here, as it stands."""
        reads = self.reads
        for root, keys in read:
            known = reads.get(root, _NO_KEYS)
            if known is None:
                continue
            if keys is None:
                self.read(root, standing(root))
                continue
            new = keys - known if known else keys
            if not new:
                continue
            self._read_slots(root, new, standing(root))

    def _has_sent(self, inner: Tracker, at: Chain) -> None:
        self.placed |= inner.placed
        self.asked |= inner.asked
        for (sink, chain), mask in inner.sent.items():
            self.send(sink, None if chain is None else (at + chain)[-DEEP:], mask)
        self.open = self.open or inner.open
        self.beside = self.beside or inner.beside


def differing(ours: Content, theirs: Content) -> Keys:
    """Under which keys two contents of an object differ; None where that is anywhere."""
    if ours.base != theirs.base or ours.size != theirs.size or ours.any != theirs.any:
        return None
    keys = {key for key, mark in theirs.slots.items() if ours.slots.get(key) != mark}
    keys.update(key for key in ours.slots if key not in theirs.slots)
    return keys


def _add(known: dict[Root, Keys], root: Root, keys: Iterable[object] | None) -> None:
    """These slots of an object are among the known ones from now on, or all of it."""
    if keys is None:
        known[root] = None
        return
    before = known.get(root, _NO_KEYS)
    if isinstance(before, set):
        before.update(keys)
    elif before is not None:
        known[root] = set(keys)
