# SPDX-License-Identifier: Apache-2.0
"""Where information leaves a process, and what it depends on there: in all, and by the calls that lead there.

def say(self, text):             the one statement that sends, with all that any caller gives it
    self.pub.publish(text)
def on_plan(self, plan):
    self.say(plan.name)          called from here, it sends the name of a plan
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.effects.flows import Call, Sink, Source
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.flow.marks import Sources

Chain = tuple[Place, ...]
"""Statements of the user's code, each of which calls the next one; the last one sends."""

DEEP: Final = 4
"""So many statements of a chain are told, the last ones."""
_MOST: Final = 64
"""So many chains that lead to one sink are told apart."""


@final
class Sinks:
    """Those of one process, each with what it depends on: as one mask, and the events in whose callbacks it sends."""

    def __init__(self) -> None:
        self.masks: dict[Sink, int] = {}
        self.events: dict[Sink, set[Source]] = {}
        self._calls: dict[Sink, dict[Chain, int] | None] = {}  # None where there are too many

    def add(self, sink: Sink, mask: int, events: tuple[Source, ...]) -> bool:
        """Something is sent; whether that is new."""
        old = self.masks.get(sink)
        known = self.events.setdefault(sink, set())
        before = len(known)
        known.update(events)
        self.masks[sink] = mask if old is None else old | mask
        return self.masks[sink] != old or len(known) != before

    def called(self, sink: Sink, chain: Chain | None, mask: int) -> None:
        """It is sent through these statements; None where nobody tells them apart."""
        known = self._calls.setdefault(sink, {})
        if known is None:
            return
        callers = () if chain is None else chain[:-1]
        if chain is None or (len(known) == _MOST and callers not in known):
            self._calls[sink] = None
        else:
            known[callers] = known.get(callers, 0) | mask

    def calls(self, sink: Sink, sources: Sources) -> tuple[Call, ...]:
        """What a sink depends on by the statements that call; nothing where that is not known."""
        known = self._calls.get(sink) or {}
        return tuple(Call(callers, *sources.apart(mask)) for callers, mask in known.items())
