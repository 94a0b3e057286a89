# SPDX-License-Identifier: Apache-2.0
"""What a process has registered to run later, and the names by which a library may call what it was not handed."""

from __future__ import annotations

from typing import TYPE_CHECKING, final

from rosward.domain.choice import join
from rosward.domain.values import UNBOUND, Value
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.memory import Page
    from rosward.domain.state import State
    from rosward.engine.running.frame import Frame
    from rosward.engine.running.scheduled import Scheduled, Wait
    from rosward.location import Place


class Naming(NamedTuple):
    """A name that was handed to a library: of which module, what in it, and where that was."""

    module: str
    name: str
    place: Place
    frame: Frame | None


class PageLeads(NamedTuple):
    """Where the objects of a page of the heap lead: such as nothing has to hold, and each of the others (`unheld.py`)."""

    page: Page
    inner: int  # how many objects belonged to an attribute of another one when it was looked through
    held: frozenset[int]
    inside: dict[int, tuple[int, ...]]


@final
class Schedule:
    """All that was registered so far, by callback, arguments and event."""

    __slots__ = (
        "_main_raised",
        "_threads_raised",
        "asked",
        "beside",
        "between",
        "by_library",
        "entries",
        "event",
        "hurried",
        "interrupted",
        "leads",
        "leads_there",
        "named",
        "parallel",
        "raised",
        "remembered",
        "running",
        "seen",
        "settled",
        "spent",
        "spins",
        "standing",
        "taken",
        "threads",
        "waited",
    )

    def __init__(self) -> None:
        self.entries: dict[object, Scheduled] = {}
        self.named: dict[str, Naming] = {}  # what a library may import and call by a name that it was handed
        self.taken: dict[str, int] = {}  # by the key of a function, the steps of the callbacks that run it
        # by that and the event, the one that stands for many (`alike.py`)
        self.standing: dict[tuple[str, str], Scheduled] = {}
        self.running = False
        self.spent = False  # callbacks do not run again, as all together took too many steps
        self.leads: dict[int, PageLeads] = {}  # by the number of the page
        self.leads_there: dict[tuple[int, int], tuple[tuple[Page, Page | None], frozenset[int]]] = {}  # by id()
        self.beside = False  # a thread was started that spins: callbacks run wherever the main body waits
        self.waited = 0  # how often the main body waited then
        self.remembered: list[Wait] = []  # what ran where the main body waited (`waits_recalled.py`)
        self.hurried = False  # it did so often that callbacks are followed with less precision there
        self.parallel = False  # something may run while a callback waits: another thread, a signal, an executor with several threads
        self.threads = False  # an executor or a pool has several threads
        self.between: State | None = None  # what was there while the callback that runs waited
        self.interrupted: State | None = (
            None  # what was there where a callback waited that nothing but the user interrupts
        )
        self.seen = -1  # the version of the state in which it waited last
        self.by_library = False  # something that the program handed out may be called by a library
        self._main_raised: Value = UNBOUND
        self._threads_raised: Value = UNBOUND
        self.asked = 0  # how often somebody asked what only the schedule knows
        self.spins = 0  # how often the main body came to where callbacks run
        self.event = ""  # of the entry that is running
        self.raised: dict[Value, State] = {}  # what callbacks raise and do not catch, and the states in which they do
        # the number of entries, the version and `parallel` with which all came to rest last time
        self.settled = (-1, -1, False)

    def uncaught(self, exception: Value, *, thread: bool) -> None:
        """Nothing in the main body, or in a thread, catches an exception."""
        if thread:
            self._threads_raised = join(self._threads_raised, exception)
        else:
            self._main_raised = join(self._main_raised, exception)

    @property
    def main_raised(self) -> Value:
        """The exceptions by which the main body may end."""
        self.asked += 1
        return self._main_raised

    @property
    def threads_raised(self) -> Value:
        """Those that threads do not catch."""
        self.asked += 1
        return self._threads_raised

    @property
    def was_run(self) -> bool:
        """Whether the program was somewhere where its callbacks run."""
        self.asked += 1
        return self.settled[0] >= 0
