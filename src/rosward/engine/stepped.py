# SPDX-License-Identifier: Apache-2.0
"""How is a generator resumed, what does one step of it give, and what of those that run now?"""

from __future__ import annotations

from typing import Final, final

from rosward.domain.state import State
from rosward.domain.values import NONE, UNBOUND, Value
from rosward.models.native import ResumptionKind
from rosward.records import NamedTuple


class Resumption(NamedTuple):
    """How a suspended generator is resumed: `next`, `send` a value, `throw` an exception, or `close`."""

    kind: ResumptionKind
    value: Value


NEXT: Final = Resumption("next", NONE)


class Stepped(NamedTuple):
    """One step: the item (UNBOUND: surely none), where it ends instead (None: surely not), and the value of StopIteration there."""

    item: Value
    ended: State | None = None
    value: Value = NONE


@final
class Running:
    """A generator that is being advanced, and what this gave so far: for calls that are nested too deep, and ask for it again."""

    __slots__ = ("asked", "before", "state", "stepped")

    def __init__(self, before: State) -> None:
        self.before = before
        self.asked = False
        self.stepped = Stepped(UNBOUND, None, UNBOUND)
        self.state: State | None = None  # behind the item

    @property
    def versions(self) -> tuple[object, ...]:
        """What must not change any more."""
        item, ended, value = self.stepped
        states = [s.version if s is not None else -1 for s in (self.before, self.state, ended)]
        return (item, value, *states)
