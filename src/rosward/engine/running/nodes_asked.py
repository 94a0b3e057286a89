# SPDX-License-Identifier: Apache-2.0
"""Which nodes did a call ask for? Which objects are nodes is written in the log, not on the heap, and there it only grows.

A question is noted among the addresses whose records were read, as a number below zero: -1 stands for all nodes, -2 - a for those at address a.
So whoever carries such addresses on, as the engine does for all that it remembers, carries questions on as well.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.engine.running.attributes_asked import FIRST

if TYPE_CHECKING:
    from rosward.effects.log import EffectLog

Answered = tuple[tuple[int, int], ...]
"""Questions, and how many nodes there were for each."""

ALL: Final = -1


def question(address: int) -> int:
    """What is noted where somebody asks for the nodes at an address."""
    return -2 - address


def answered(log: EffectLog, asked_for: Iterable[int], begun: int) -> Answered:
    """The questions among what a call asked for, with the answers that it had; there were `begun` nodes when it began."""
    if len(log.nodes) != begun:
        return ((ALL, begun),)  # it made some itself, and may have asked before or after
    return tuple([(asked, _count(log, asked)) for asked in asked_for if FIRST < asked < 0])


def still_holds(log: EffectLog, answers: Answered) -> bool:
    """Whether the answers are what they were."""
    return all(_count(log, asked) == count for asked, count in answers)


def _count(log: EffectLog, asked: int) -> int:
    return len(log.nodes) if asked == ALL else log.count_at(-2 - asked)
