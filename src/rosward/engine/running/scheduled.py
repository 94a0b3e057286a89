# SPDX-License-Identifier: Apache-2.0
"""What was registered to run later: callbacks of every kind, and what a library may call by a name that it was handed."""

from __future__ import annotations

from typing import TYPE_CHECKING, final

from rosward.domain.values import Value
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.state import State
    from rosward.engine.running.nodes_asked import Answered
    from rosward.location import Place


class Wait(NamedTuple):
    """What callbacks found where the main body waited, and what they left."""

    around: tuple[object, ...]
    found: list[tuple[int, Obj | None]]
    left: list[tuple[int, Obj]]
    nodes: Answered


@final
class Scheduled:
    """One thing that may be called: with `args` (None: with anything), since `state`, registered at `place`."""

    __slots__ = (
        "answered",
        "args",
        "around",
        "callback",
        "coarse",
        "context",
        "costly",
        "doubted",
        "event",
        "exhausted",
        "late",
        "left",
        "made",
        "nodes",
        "others",
        "own",
        "parts",
        "place",
        "read",
        "runs",
        "state",
        "taken_in",
    )

    def __init__(
        self, callback: Value, args: tuple[Value, ...] | None, event: str, place: Place, state: State, context: int
    ) -> None:
        self.callback = callback
        self.args = args
        self.event = event
        self.place = place
        self.state = state
        self.context = context
        self.coarse = False  # it took many steps: from now on it is followed with less precision
        self.costly = False  # it would be so in any case: all callbacks together took too many
        self.doubted: frozenset[str] = (
            frozenset()
        )  # the callbacks that were followed in haste, of which one registered it
        self.answered: Value | None = None  # what is called with each result
        self.others: list[Scheduled] = []  # those for which it stands (`alike.py`)
        self.taken_in = False  # another one stands for it
        self.exhausted = False  # it hit a limit: it is not run again
        self.late = False  # it runs for the first time when all together took too many steps: it has a few
        self.runs = 0  # how often it ran
        self.read: list[tuple[int, Obj | None]] = []  # the records that it asked for when it ran last, as it found them
        # and those of which it asked for no more than one attribute
        self.parts: list[tuple[int, str, Obj | None]] = []
        self.own: list[int] = []  # where it read what it made itself,
        self.left: list[tuple[int, Obj | None]] = []  # and the records that it left there
        self.made = False  # it created something of ROS
        self.nodes: Answered = ()  # and which nodes it asked for
        self.around: tuple[object, ...] = ()  # what else it may have asked for (`unchanged.py`)
