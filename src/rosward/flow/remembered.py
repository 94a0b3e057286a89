# SPDX-License-Identifier: Apache-2.0
"""What is remembered of a walk through a body: what it read, and what it left, so that the same call need not be walked through again.

for turn in any number:           the second turn finds in `handle` what the first one found, reads the same, writes the same
    self.handle(message)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.effects.flows import Sink
    from rosward.flow.content import Content, Layer
    from rosward.flow.marks import Mark, Root

MOST: Final = 6
"""So many calls of one activation are remembered, the last ones."""


@final
class Tracker:
    """What a walk reads and writes. `open`: it depends on more than that, so that it can't be remembered; `beside`: on what callbacks write."""

    __slots__ = ("beside", "open", "placed", "reads", "sent", "writes")

    def __init__(self) -> None:
        self.reads: Layer = {}
        self.writes: set[Root] = set()
        self.placed: set[int] = set()
        self.sent: dict[Sink, int] = {}
        self.open = False
        self.beside = False

    def read(self, root: Root, content: Content) -> None:
        """Content was read, as it stands where the walk began unless the walk itself has written it."""
        if root not in self.writes:
            self.reads.setdefault(root, content)

    def send(self, sink: Sink, mask: int) -> None:
        """Something that depends on these sources was sent."""
        self.sent[sink] = self.sent.get(sink, 0) | mask

    def absorb(self, inner: Tracker) -> None:
        """What a body inside read and wrote."""
        for root, content in inner.reads.items():
            self.read(root, content)
        self.writes |= inner.writes
        self.placed |= inner.placed
        for sink, mask in inner.sent.items():
            self.send(sink, mask)
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
