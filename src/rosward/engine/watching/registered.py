# SPDX-License-Identifier: Apache-2.0
"""Where was a callback registered that runs later, and, if a timer wakes it, how often?"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, NamedTuple

from rosward.domain.values import Const

if TYPE_CHECKING:
    from rosward.effects.log import EntityEffect
    from rosward.effects.sent import SentEffect
    from rosward.engine.machine import Engine
    from rosward.engine.running.seen import Activation, Seen

_SECONDS: Final = "timer_period_sec"
_PERIODS: Final = (_SECONDS, "period")
"""What models of client libraries call the period of a timer."""
_LONGEST: Final = 1e9


class Registered(NamedTuple):
    """Where a callback was registered: by methods of which objects, innermost first, by which operation, in which turn of its loops.

    `period`: of a timer of the client library, in nanoseconds; 0 where it is not known.
    """

    receivers: tuple[int, ...]
    by: Seen
    turn: int
    among: Activation | None = None
    period: int | None = None

    def effects(self) -> Iterator[tuple[int, EntityEffect | SentEffect]]:
        """What is created where the callback is registered: by the same operation, else in the same body."""
        yield from self.by.effects
        if self.among is not None:
            for seen in self.among.seen.values():
                yield from seen.effects


def period_of(machine: Engine) -> int | None:
    """What the model of a client library that makes a timer is given as its period: 0 where it is not known; None where it makes none."""
    for frame in reversed(machine.frames):
        if not frame.stub:
            return None
        given = frame.code.parameters.names
        name = next((name for name in _PERIODS if name in given), None)
        if name is not None:
            value = frame.registers[given.index(name)]
            number = value.value if isinstance(value, Const) else None
            if name == _SECONDS and isinstance(number, (int, float)) and 0 < number < _LONGEST:
                return round(number * 1_000_000_000)
            return 0
    return None
