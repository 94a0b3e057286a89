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
    """A generator that is being advanced, and what this gave so far: for calls that are nested too deep, and ask for it again.

    `within`: the same of those that stand for many, too, and are advanced inside of it, by address and how they are resumed.
    """

    __slots__ = ("asked", "asks", "before", "shared", "state", "stepped", "turn", "unsettled", "within")

    def __init__(self, before: State, *, shared: bool) -> None:
        self.before = before
        self.shared = shared  # it stands for all calls that are nested too deep
        self.turn = -1  # in which it ran last
        self.asked = False  # in this turn
        self.asks = 0  # how often something was made of what is not its last word, in all turns
        self.unsettled = False  # one within gave more in this turn than before
        self.stepped = Stepped(UNBOUND, None, UNBOUND)
        self.state: State | None = None  # behind the item
        self.within: dict[tuple[int, Resumption], Running] = {}

    @property
    def versions(self) -> tuple[object, ...]:
        """What must not change any more."""
        item, ended, value = self.stepped
        states = [s.version if s is not None else -1 for s in (self.before, self.state, ended)]
        return (item, value, *states)
