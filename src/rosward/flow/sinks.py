# SPDX-License-Identifier: Apache-2.0
"""Where information leaves a process, and what it depends on there."""

from __future__ import annotations

from typing import final

from rosward.effects.flows import Sink, Source


@final
class Sinks:
    """Those of one process, each with what it depends on: as one mask, and the events in whose callbacks it sends."""

    def __init__(self) -> None:
        self.masks: dict[Sink, int] = {}
        self.events: dict[Sink, set[Source]] = {}

    def add(self, sink: Sink, mask: int, events: tuple[Source, ...]) -> bool:
        """Something is sent; whether that is new."""
        old = self.masks.get(sink)
        known = self.events.setdefault(sink, set())
        before = len(known)
        known.update(events)
        self.masks[sink] = mask if old is None else old | mask
        return self.masks[sink] != old or len(known) != before
