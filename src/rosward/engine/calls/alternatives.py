# SPDX-License-Identifier: Apache-2.0
"""Several alternatives of one value: each is followed from the same state, what comes out is joined.

make = self.left if unknown else self.right
make()                    both are called, neither sees what the other did
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final, TypeVar

from rosward.domain.choice import join
from rosward.domain.state import State, join_states
from rosward.domain.values import UNBOUND, Value

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

T = TypeVar("T")
_TOLD_APART: Final = 8
"""What so many alternatives make is told apart. Beyond, all make the same objects: where each turn's are the alternatives of the
next (`self.last = self.last[-9:]`), they would grow in number for ever."""


def each_apart(machine: Engine, alternatives: Sequence[T], action: Callable[[T], Value]) -> Value:
    """What an action gives for each alternative from the same state, results and states joined; UNBOUND where none comes back."""
    if len(alternatives) == 1:
        return action(alternatives[0])
    before = machine.state.copy()
    after: State | None = None
    value: Value = UNBOUND
    frame = machine.frames[-1] if machine.frames else None
    sequence: int | None = None
    doubts, failed = machine.log.open_doubts, 0
    for number, option in enumerate(alternatives):
        if number:
            machine.state = before.copy()
        if frame is not None and number >= _TOLD_APART:
            frame.sequence = sequence = frame.sequence if sequence is None else sequence
        so_far = machine.log.open_doubts
        machine.precision.apart += 1
        try:
            result = action(option)
        finally:
            machine.precision.apart -= 1
        if result is UNBOUND:
            failed += machine.log.open_doubts > so_far
            continue
        value = join(value, result)
        after = machine.state if after is None else join_states(after, machine.state, machine.fresh_version)
    if after is not None:
        machine.state = after
    all_failed = failed == len(alternatives)
    if not (all_failed and machine.precision.apart):  # else what is around it decides
        machine.log.settle_doubts(doubts, sure=all_failed)
    return value
