# SPDX-License-Identifier: Apache-2.0
"""By which lines does information come from its source to a sink?

    def on_image(self, msg):      it arrives
        self.last = msg           it is kept
    def on_timer(self):
        image = self.last         another callback gets it
        self.pub.publish(image)   and sends it

For each callback it is noted where each source is met first, and where it is kept; the way is put together where somebody asks.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain
from typing import TYPE_CHECKING, Final, final

from rosward.flow.marks import numbers
from rosward.location import Place
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.effects.flows import Sink, Source

_MOST: Final = 8
"""So many callbacks a way goes through."""


class _Met(NamedTuple):
    """Where something is met, and the name under which it was kept ('' where it has none)."""

    place: Place
    key: object


_Kept = tuple[list[tuple[object, _Met]], dict[object, list[tuple[object, _Met]]]]
"""In which callbacks something is kept: all of them, and by the name under which."""


@final
class Trail:
    """What is noted in one process. `event` tells the callback that runs from others."""

    def __init__(self, where: Callable[[], Place]) -> None:
        self.event: object = None
        self.had = 0  # what was met in it
        self._where = where
        self.begins: dict[object, Place] = {}
        self._had: dict[object, int] = {}  # the same of those that ran before
        self._first: dict[tuple[object, int], _Met] = {}
        self._kept: dict[int, list[tuple[object, _Met]]] = {}
        self._sent: dict[Sink, dict[object, int]] = {}
        self._keeping: dict[tuple[object, object], int] = {}
        self._grouped: dict[tuple[int, Source], tuple[_Kept, _Kept]] = {}
        self._behind: dict[tuple[object, int], tuple[Place | None, ...]] = {}  # once the walk has come to its end

    def begin(self, event: object, place: Place | None) -> None:
        """A callback begins, at the first line of its code."""
        self._had[self.event] = self.had
        self.event, self.had = event, self._had.get(event, 0)
        if place is not None:
            self.begins.setdefault(event, place)

    def meet(self, mask: int, key: object) -> None:
        """These sources are met here."""
        new = mask & ~self.had
        if new:
            self.had |= mask
            place = self._where()
            for number in numbers(new):
                self._first.setdefault((self.event, number), _Met(place, key))

    def keep(self, mask: int, key: object) -> None:
        """These sources are kept under a key."""
        known = self._keeping.get((self.event, key), 0)
        if mask & ~known:
            self._keeping[(self.event, key)] = known | mask
            place = self._where()
            for number in numbers(mask & ~known):
                self._kept.setdefault(number, []).append((self.event, _Met(place, key)))

    def send(self, sink: Sink, mask: int) -> None:
        """Something that depends on these sources is sent in this callback."""
        events = self._sent.setdefault(sink, {})
        events[self.event] = events.get(self.event, 0) | mask

    def sent_in(self, event: object) -> Iterator[tuple[Sink, int]]:
        """What is sent in a callback, and what it depends on there."""
        yield from ((sink, events[event]) for sink, events in self._sent.items() if event in events)

    def way(
        self, sink: Sink, number: int, source: Source, arriving: dict[object, tuple[Source, ...]]
    ) -> tuple[Place, ...]:
        """The lines from a source to a sink. `arriving`: what arrives in each callback."""
        event = next((e for e in self._sent.get(sink, ()) if source in arriving.get(e, ())), None)
        if event is not None:
            return _once(self.begins.get(event), sink.place)
        event = next(iter(self._sent.get(sink, ())), None)
        behind = self._behind.get((event, number))
        if behind is None:
            behind = self._behind[event, number] = self._back(event, number, source, arriving)
        return _once(*behind, sink.place)

    def _back(
        self, event: object, number: int, source: Source, arriving: dict[object, tuple[Source, ...]]
    ) -> tuple[Place | None, ...]:
        """The lines from a source to where it is met in a callback."""
        places: list[Place | None] = []
        seen = {event}
        for _ in range(_MOST):
            met = self._first.get((event, number))
            places.append(met.place if met is not None else None)
            before = self._keeper(number, seen, None if met is None else met.key, source, arriving)
            if before is None:
                break
            event, kept = before
            seen.add(event)
            places.append(kept.place)
            if source in arriving.get(event, ()):
                places.append(self.begins.get(event))
                break
        return tuple(places[::-1])

    def _keeper(
        self, number: int, seen: set[object], key: object, source: Source, arriving: dict[object, tuple[Source, ...]]
    ) -> tuple[object, _Met] | None:
        """The callback that kept it: one in which it arrives, under the same name, sooner than another."""
        for kept, by_key in self._keepers(number, source, arriving):
            for found in chain(by_key.get(key, ()), kept):
                if found[0] not in seen:
                    return found
        return None

    def _keepers(self, number: int, source: Source, arriving: dict[object, tuple[Source, ...]]) -> tuple[_Kept, _Kept]:
        """The callbacks that kept something: those in which it arrives, and others."""
        found = self._grouped.get((number, source))
        if found is None:
            found = self._grouped[number, source] = ([], {}), ([], {})
            for event, met in self._kept.get(number, ()):
                kept, by_key = found[source not in arriving.get(event, ())]
                kept.append((event, met))
                by_key.setdefault(met.key, []).append((event, met))
        return found


def _once(*places: Place | None) -> tuple[Place, ...]:
    return tuple({(p.file, p.line): p for p in places if p is not None and p.file}.values())
