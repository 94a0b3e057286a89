# SPDX-License-Identifier: Apache-2.0
"""Which sources a value depends on, and how strongly: as data, by control, or as the trigger of what runs.

    out.data = msg.data            data: the content is in it
    if msg.data > 3: out.data = 1  control: the content decides what is in it, or whether it is sent
    self.ready = True              trigger: only that the message arrived counts

Each source of a process has three bits, from strong to weak. A union is `|`; what decides a branch is demoted by a shift.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final, final

from rosward.effects.flows import Source
from rosward.records import NamedTuple

_SOURCES: Final = 2048
_DATA: Final = sum(1 << 3 * n for n in range(_SOURCES))
_CONTROL: Final = _DATA << 1
_TRIGGER: Final = _DATA << 2
_WEAKER: Final = _CONTROL | _TRIGGER

_ASSUMED: Final = frozenset(("parameter", "argv", "env"))
_EVENTS: Final = frozenset(("main", "timer", "thread", "parameters"))

Root = int | tuple[object, ...]
"""Where content stands: the address of an object, or a name for what has no address (the result of an unknown call, a tuple)."""


HANDLED: Final[Root] = ("handled",)
"""Where the exceptions stand that were handled, whoever asks for them (`sys.exc_info()`)."""
FUNCTIONS: Final[Root] = ("functions",)
"""Where the attributes of functions stand, which have no address: told apart by their names alone."""


CANCELLED: Final[Root] = ("cancelled",)
"""Where it stands what decides that servers of actions accept requests to cancel."""


def is_slot(root: Root) -> bool:
    """Whether it is a part of an object that has an address of its own (`engine.seen.places_of`)."""
    return not isinstance(root, int) and root[0] == "slot"


def slot_of(root: Root) -> tuple[Root, object, object]:
    """Of a slot: the object, the key, and how much of the object it is known to be."""
    assert not isinstance(root, int)
    base = root[1]
    assert isinstance(base, (int, tuple))
    return base, root[2], root[3]


_MOST_PARTS: Final = 8
_TWICE: Final = 2
"""So often a word may stand in the name of something of a library: `tqdm.tqdm`, `datetime.datetime`."""


def of_library(name: str) -> Root:
    """Something of a library, by its dotted name. Where the name is longer than any (`node.left.right.down`), its end is all the same."""
    name = unrolled(name)
    if name.count(".") < _MOST_PARTS:
        return ("external", name)
    return ("external", ".".join((*name.split(".", _MOST_PARTS)[:_MOST_PARTS], "*")))


def unrolled(name: str) -> str:
    """A dotted name without what repeats itself: what `node = node.next` finds in each turn is one (`node.next.next`)."""
    words = name.split(".")
    while words.count(words[-1]) > _TWICE:
        words = words[: len(words) - 1 - words[-2::-1].index(words[-1])]
    return ".".join(words)


def name_of(root: Root) -> str:
    """The dotted name of what stands behind something of a library; '' where it is of no library."""
    if isinstance(root, int):
        return ""
    if root[0] == "external":
        return str(root[1])
    if root[0] == "made":
        return str(root[3])
    if root[0] == "of":
        owner = name_of(root[1])  # type: ignore[arg-type]  # a root
        return f"{owner}.{root[2]}" if owner else ""
    return ""


class Mark(NamedTuple):
    """What a register or a slot holds: the sources that the value itself depends on, and the objects that it leads to."""

    mask: int = 0
    roots: frozenset[Root] = frozenset()

    def joined(self, other: Mark) -> Mark:
        """What covers both."""
        if self is other:
            return self
        mask, roots, others = self.mask | other.mask, self.roots, other.roots
        if others is not roots and not others <= roots:
            return Mark(mask, others if roots <= others else roots | others)
        return self if mask == self.mask else Mark(mask, roots)

    def under(self, mask: int) -> Mark:
        """The same, depending on more."""
        return self if self.mask | mask == self.mask else Mark(self.mask | mask, self.roots)


NOTHING: Final = Mark()


def demoted(mask: int) -> int:
    """What is made under a branch that depends on this: its data has become control."""
    return (mask & _DATA) << 1 | mask & _WEAKER


def decided(mask: int) -> int:
    """Of what stands somewhere: what decides that it was written. Of data only the arrival counts."""
    return (mask & _DATA) << 2 | mask & _WEAKER


def triggering(mask: int) -> int:
    """What is left where only the arrival of these counts."""
    return (mask & _DATA) << 2 | (mask & _CONTROL) << 1 | mask & _TRIGGER


def numbers(mask: int) -> Iterator[int]:
    """The numbers of the sources in a mask, of any strength."""
    number = 0
    while mask:
        if mask & 7:
            yield number
        mask >>= 3
        number += 1


@final
class Sources:
    """The sources that one process meets, in the order in which it does."""

    def __init__(self) -> None:
        self._numbers: dict[Source, int] = {}
        self._assumed = (0, 0)

    def data(self, source: Source) -> int:
        """The mask of its content."""
        number = self._numbers.setdefault(source, len(self._numbers))
        return 1 << 3 * min(number, _SOURCES - 1)

    def trigger(self, source: Source) -> int:
        """The mask of its arrival."""
        return self.data(source) << 2

    def number(self, source: Source) -> int:
        """Which of them it is."""
        return min(self._numbers[source], _SOURCES - 1)

    @property
    def assumed(self) -> int:
        """Those of which the interpretation takes one content for all, where it has to choose: what is chosen by one looks certain."""
        known, mask = self._assumed
        if known != len(self._numbers):
            for source, number in self._numbers.items():
                if source.kind in _ASSUMED:
                    mask |= 7 << 3 * min(number, _SOURCES - 1)
            self._assumed = (len(self._numbers), mask)
        return mask

    @property
    def all(self) -> int:
        """Every source as data, but for events that bring nothing."""
        found = 0
        for source, number in self._numbers.items():
            if source.kind not in _EVENTS:
                found |= 1 << 3 * min(number, _SOURCES - 1)
        return found

    def apart(self, mask: int) -> tuple[frozenset[Source], frozenset[Source], frozenset[Source]]:
        """The sources of a mask by strength: data, control, trigger; each in the strongest only."""
        found: tuple[set[Source], set[Source], set[Source]] = (set(), set(), set())
        for source, number in self._numbers.items():
            bits = mask >> 3 * min(number, _SOURCES - 1) & 7
            if bits:
                found[0 if bits & 1 else 1 if bits & 2 else 2].add(source)
        return frozenset(found[0]), frozenset(found[1]), frozenset(found[2])


def part_of(root: Root, inner: Mapping[int, tuple[int, str]]) -> tuple[Root, object] | None:
    """The object and the attribute that something is a part of, if it is one; `inner` says so of objects with an address."""
    if isinstance(root, int):
        return inner.get(root)
    return (root[1], root[2]) if root[0] == "of" else None  # type: ignore[return-value]  # a root and a name


def behind(root: Root, inner: Mapping[int, tuple[int, str]]) -> Iterator[Root]:
    """The objects that say what stands in one of which nothing was written itself."""
    while True:
        owner = slot_of(root) if is_slot(root) else part_of(root, inner)
        if owner is None:
            return
        root = owner[0]
        yield root
