# SPDX-License-Identifier: Apache-2.0
"""What is remembered of a walk through a body: what it read, and what it left, so that the same call need not be walked through again.

for turn in any number:           the second turn finds in `handle` what the first one found, reads the same, writes the same
    self.handle(message)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.flow.sinks import DEEP
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.effects.flows import Sink
    from rosward.flow.content import Content, Layer
    from rosward.flow.marks import Mark, Root
    from rosward.flow.sinks import Chain

MOST: Final = 6
"""So many calls of one activation are remembered, the last ones."""
_MOST_SENT: Final = 256
"""So many sinks and ways to them are told apart in a body."""


@final
class Tracker:
    """What a walk reads and writes. `open`: it depends on more than that, so that it can't be remembered; `beside`: on what callbacks write."""

    __slots__ = ("beside", "open", "placed", "reads", "sent", "writes")

    def __init__(self) -> None:
        self.reads: Layer = {}
        self.writes: set[Root] = set()
        self.placed: set[int] = set()
        self.sent: dict[tuple[Sink, Chain | None], int] = {}
        self.open = False
        self.beside = False

    def read(self, root: Root, content: Content) -> None:
        """Content was read, as it stands where the walk began unless the walk itself has written it."""
        if root not in self.writes:
            self.reads.setdefault(root, content)

    def send(self, sink: Sink, chain: Chain | None, mask: int) -> None:
        """Something that depends on these sources was sent, through these statements."""
        if len(self.sent) >= _MOST_SENT and (sink, chain) not in self.sent:
            chain = None
        self.sent[sink, chain] = self.sent.get((sink, chain), 0) | mask

    def absorb(self, inner: Tracker, at: Chain) -> None:
        """What a body inside read and wrote, which is called here."""
        for root, content in inner.reads.items():
            self.read(root, content)
        self.writes |= inner.writes
        self.placed |= inner.placed
        for (sink, chain), mask in inner.sent.items():
            self.send(sink, None if chain is None else (at + chain)[-DEEP:], mask)
        self.open = self.open or inner.open
        self.beside = self.beside or inner.beside


class Remembered(NamedTuple):
    """One walk: what it found, and what it left. `raising` is what may have failed in it, `beside` how often callbacks had written."""

    given: tuple[object, ...]
    tracker: Tracker
    writes: Layer
    result: Mark
    raising: int
    beside: int


@final
class Looked:
    """What a look through all that some roots lead to has found, and who knows already that it was read."""

    __slots__ = ("mask", "reads", "tracker")

    def __init__(self, mask: int, reads: Layer, tracker: Tracker | None) -> None:
        self.mask = mask
        self.reads = reads
        self.tracker = tracker
