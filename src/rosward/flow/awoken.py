# SPDX-License-Identifier: Apache-2.0
"""Which callbacks does a process have, what wakes each, and where does it send?"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from rosward.effects.flows import Callback
from rosward.models.ros.callbacks import callback_name

if TYPE_CHECKING:
    from rosward.engine.running.scheduled import Scheduled
    from rosward.flow.walker import Walker


def callbacks_of(
    walker: Walker, entries: Iterable[Scheduled], node_of: Callable[[Walker, Scheduled], int | None]
) -> tuple[Callback, ...]:
    """Those of a process that was walked through, in the order in which they were registered."""
    found: dict[Callback, None] = {}
    for entry in entries:
        sources = walker.arriving.get(entry)
        if sources:
            place = walker.trail.begins.get(entry, entry.place)
            registered = walker.watch.entries.get(entry)
            period = None if registered is None else registered.period
            sinks = tuple(
                (sink, frozenset().union(*walker.sources.apart(mask))) for sink, mask in walker.trail.sent_in(entry)
            )
            found[
                Callback(node_of(walker, entry), sources, callback_name(entry.callback) or "", place, sinks, period)
            ] = None
    return tuple(found)
