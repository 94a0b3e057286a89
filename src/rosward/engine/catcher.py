# SPDX-License-Identifier: Apache-2.0
"""What a running `try` or `with` collects: the exceptions that arrive there, each with its state, and where Python itself may raise one.

self.t = 'a'; raise Refused('x')         arrives with t = 'a', and with its data
self.t = 'a'; risky(); self.t = 'b'      what Python may raise by itself: the handlers see t as it was, 'a' and 'b'
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import join, join_all, options
from rosward.domain.heap import Obj
from rosward.domain.state import State, join_objects, join_registers, join_states
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Unknown, Value
from rosward.engine.frame import Frame, Snapshot, join_into
from rosward.models.failures import tell_uncaught
from rosward.models.python.plain import EXCEPTION_HINT

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

OPERATION: Final = 1
"""Python itself may raise one of its own exceptions."""
LIBRARY: Final = 2
"""A library may raise anything but what the program defines."""
ANYTHING: Final = 3
"""Code that is not known runs with code of the program in its hands."""

_MOST: Final = 12
"""How many exceptions are kept apart in one `try`."""


@final
class Catcher:
    """A `try` or `with` that is running.

    `arrivals` holds the exceptions that are known, each with the join of the states in which it comes. `level` says what may raise one that
    is not known (0: nothing does), and `snapshot` covers every state in which it may come: the one in which it first may, joined with each
    object that is written and each change of the frame's registers since.
    """

    __slots__ = ("arrivals", "classes", "frame", "handles", "importing", "level", "noted", "snapshot", "version")

    def __init__(self, machine: Engine, frame: Frame, *, handles: bool = False, classes: tuple[str, ...] = ()) -> None:
        self.frame = frame
        self.handles = handles  # it has `except`, not `finally` or `with` alone
        self.classes = classes  # the names of builtin exceptions that its handlers surely catch
        self.snapshot = Snapshot(frame.registers, machine.state)  # of no meaning before something is noted
        self.noted: list[Value] = []
        self.version = -1  # of the state that the snapshot covers
        self.arrivals: dict[Value, Snapshot] = {}
        self.level = 0
        self.importing = False  # an import in the body may fail

    @property
    def reached(self) -> bool:
        """Whether anything may arrive."""
        return self.level > 0 or bool(self.arrivals)

    @property
    def raised(self) -> Value:
        """The exceptions that are known, joined; UNBOUND where there are none."""
        return join_all(self.arrivals) if self.arrivals else UNBOUND

    def note(self, machine: Engine, level: int = OPERATION) -> None:
        """An exception that is not known may be raised here."""
        variables = self.frame.registers[: len(self.frame.code.variables)]  # temporaries do not outlive a statement
        if not self.level:
            self.level, self.noted, self.snapshot = level, variables, machine.snapshot(self.frame)
            self.version = machine.state.version
            return
        self.level = max(self.level, level)
        if self.version != machine.state.version:
            self._take(machine)
        if self.noted != variables:
            self.noted = variables
            self.snapshot.registers = join_registers(self.snapshot.registers, variables)

    def arrive(self, machine: Engine, exception: Value, state: State) -> None:
        """An exception comes in a state (which is not used up)."""
        for each in options(exception):
            snapshot = Snapshot(self.frame.registers.copy(), state.copy())
            self.arrivals[each] = join_into(machine, self.arrivals.get(each), snapshot)
        self.arrivals = self.few(machine, _MOST)

    def few(self, machine: Engine, most: int) -> dict[Value, Snapshot]:
        """The exceptions that are known, each with its state; all joined where there are more than so many."""
        if len(self.arrivals) <= most:
            return self.arrivals
        joined = join_snapshots(machine, list(self.arrivals.values()))
        assert joined is not None
        return {self.raised: joined}

    def wrote(self, machine: Engine, address: int, obj: Obj, version: int) -> None:
        """An object was written, in a state that had this version before."""
        if not self.level:
            return
        if version != self.version:
            self._take(machine)
            return
        self.version = machine.state.version
        state = self.snapshot.state
        old = state.heap.stands(address)
        merged = obj if old is None else join_objects(old, obj, join)
        if merged is not old:
            state.heap[address] = merged
            state.version = machine.fresh_version()

    def _take(self, machine: Engine) -> None:
        """The state has become another one, not by writes alone: an exception that is not known may come in all of it."""
        self.version = machine.state.version
        self.snapshot.state = join_states(self.snapshot.state, machine.state.copy(), machine.fresh_version)

    def take_over(self, machine: Engine, inner: Catcher) -> None:
        """What may be raised in an inner statement, and is not surely caught there, may arrive here."""
        if not inner.level:
            return
        here, machine.state = machine.state, inner.snapshot.state.copy()
        self.note(machine, inner.level)
        machine.state = here
        self.importing = self.importing or inner.importing
        if inner.frame is self.frame:
            self.snapshot.registers = join_registers(self.snapshot.registers, inner.snapshot.registers)


def join_snapshots(machine: Engine, several: list[Snapshot]) -> Snapshot | None:
    """Copies of snapshots of one frame, joined."""
    joined: Snapshot | None = None
    for each in several:
        joined = join_into(machine, joined, Snapshot(each.registers.copy(), each.state.copy()))
    return joined


def note(machine: Engine, level: int = OPERATION) -> None:
    """An exception that is not known may be raised here: tell the innermost try."""
    if machine.catchers:
        machine.noted = max(machine.noted, level)
        machine.catchers[-1].note(machine, level)


def note_call(machine: Engine) -> None:
    """Unknown code runs here: it may raise what it likes, and an import in it may fail."""
    if machine.catchers:
        note(machine, ANYTHING if machine.handed or machine.schedule_book.by_library else LIBRARY)
        machine.catchers[-1].importing = True


def note_import(machine: Engine) -> None:
    """An ImportError may be raised here: of a module that is not among the sources."""
    if machine.catchers:
        note(machine, LIBRARY)
        machine.catchers[-1].importing = True


def unseen(machine: Engine) -> Unknown:
    """An exception that Python or a library may have raised, as the program sees it."""
    return machine.unknown(Cause.LIVE, "exception", EXCEPTION_HINT)


def is_unseen(exception: Value) -> bool:
    """Whether a value is such an exception. Where it is raised again, that does not count as an end of the program."""
    return exception.__class__ is Unknown and exception.hint == EXCEPTION_HINT


def throw(machine: Engine, exception: Value) -> None:
    """An exception is raised here. Where it surely is, the path ends behind; else it goes on."""
    machine.raised += 1
    known = [o for o in options(exception) if not is_unseen(o)]
    if len(known) < len(options(exception)):
        note(machine, LIBRARY)
    if not known:
        return
    exception = join_all(known)
    if machine.catchers:
        machine.catchers[-1].arrive(machine, exception, machine.state)
    else:
        tell_uncaught(machine, exception)
        machine.log.ends_early(machine)
        machine.uncaught(exception)


def rethrow(machine: Engine, inner: Catcher) -> None:
    """What leaves a call by exceptions reaches the `try` around it; the machine's state is left as it is."""
    if machine.catchers and inner.level:
        machine.catchers[-1].take_over(machine, inner)
        machine.noted = max(machine.noted, inner.level)
    here = machine.state
    for exception, snapshot in inner.arrivals.items():
        machine.state = snapshot.state.copy()
        throw(machine, exception)
    machine.state = here
