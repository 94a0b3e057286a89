# SPDX-License-Identifier: Apache-2.0
"""What was registered to run later: callbacks of every kind, and what a library may call by a name that it was handed."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, final

from rosward.domain.values import UNBOUND, Value

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.state import State
    from rosward.engine.frame import Frame
    from rosward.source.location import Place


class Naming(NamedTuple):
    """A name that was handed to a library: of which module, what in it, and where that was."""

    module: str
    name: str
    place: Place
    frame: Frame | None


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
        "event",
        "exhausted",
        "place",
        "read",
        "runs",
        "state",
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
        self.answered: Value | None = None  # what is called with each result
        self.exhausted = False  # it hit a limit: it is not run again
        self.runs = 0  # how often it ran
        self.read: list[tuple[int, Obj | None]] = []  # the records that it asked for when it ran last, as it found them
        self.around: tuple[object, ...] = ()  # what else it may have asked for (`unchanged.py`)


@final
class Schedule:
    """All that was registered so far, by callback, arguments and event."""

    __slots__ = (
        "by_library",
        "entries",
        "event",
        "main_raised",
        "named",
        "raised",
        "running",
        "settled",
        "threads_raised",
    )

    def __init__(self) -> None:
        self.entries: dict[object, Scheduled] = {}
        self.named: dict[str, Naming] = {}  # what a library may import and call by a name that it was handed
        self.running = False
        self.by_library = False  # something that the program handed out may be called by a library
        self.main_raised: Value = UNBOUND  # the exceptions by which the main body may end
        self.threads_raised: Value = UNBOUND  # those that threads do not catch
        self.event = ""  # of the entry that is running
        self.raised: dict[Value, State] = {}  # what callbacks raise and do not catch, and the states in which they do
        self.settled = (-1, -1)  # the number of entries and the version with which all came to rest last time

    @property
    def was_run(self) -> bool:
        """Whether the program was somewhere where its callbacks run."""
        return self.settled[0] >= 0
