# SPDX-License-Identifier: Apache-2.0
"""What a running `try` or `with` collects: the exceptions that arrive there, each with its state, and where Python itself may raise one.

self.t = 'a'; raise Refused('x')         arrives with t = 'a', and with its data
self.t = 'a'; risky(); self.t = 'b'      what Python may raise by itself: the handlers see t as it was, 'a' and 'b'
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import join, join_all, options
from rosward.domain.heap import Obj
from rosward.domain.memory import Heap
from rosward.domain.state import Merge, State, join_objects, join_registers, join_states
from rosward.domain.values import UNBOUND, Choice, Value
from rosward.engine.running.frame import Frame, Snapshot, join_into
from rosward.engine.running.told import Kind, Telling, Told

if TYPE_CHECKING:
    from rosward.effects.log import Execution

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

    __slots__ = (
        "arrivals",
        "arrived",
        "classes",
        "covered",
        "frame",
        "handles",
        "importing",
        "level",
        "merge",
        "noted",
        "snapshot",
        "told",
        "untold",
        "version",
    )

    def __init__(
        self, machine: Execution, frame: Frame, *, handles: bool = False, classes: tuple[str, ...] = ()
    ) -> None:
        self.frame = frame
        self.merge: Merge = join  # the states of one exception
        self.handles = handles  # it has `except`, not `finally` or `with` alone
        self.classes = classes  # the names of builtin exceptions that its handlers surely catch
        self.snapshot = Snapshot(frame.registers, machine.state)  # of no meaning before something is noted
        self.noted: list[Value] = []
        self.version = -1  # of the state that the snapshot covers
        self.covered: Heap | None = None  # the heap that it was made of last
        self.arrivals: dict[Value, Snapshot] = {}
        self.arrived: dict[Value, Heap] = {}  # by exception, the heap in which it came last
        self.level = 0
        self.importing = False  # an import in the body may fail
        self.told: list[Telling | None] | None = None  # what is told here, while a call is remembered
        self.untold = False  # nothing was told since the innermost of these calls began

    @property
    def reached(self) -> bool:
        """Whether anything may arrive."""
        return self.level > 0 or bool(self.arrivals)

    @property
    def versions(self) -> tuple[object, ...]:
        """What tells whether more arrives than before."""
        return (self.level, *((each, snapshot.state.version) for each, snapshot in self.arrivals.items()))

    @property
    def raised(self) -> Value:
        """The exceptions that are known, joined; UNBOUND where there are none."""
        return join_all(self.arrivals) if self.arrivals else UNBOUND

    def note(self, machine: Execution, level: int = OPERATION, state: State | None = None) -> None:
        """An exception that is not known may be raised here, in the current state or another one (which is not used up)."""
        state = state or machine.state
        variables = self.frame.registers[: len(self.frame.code.variables)]  # temporaries do not outlive a statement
        if not self.level:
            self.level, self.noted = level, variables
            self.snapshot = Snapshot(self.frame.registers.copy(), state.copy())
            self.version = state.version
            if self.told is not None:
                self._tell(Telling(Kind.NOTED, level, None, state.heap.copy(), state.done))
            return
        if self.told is not None and (self.untold or level > self.level) and self.version == state.version:
            self._tell(Telling(Kind.NOTED, level, None, None, state.done))
        self.level = max(self.level, level)
        if self.version != state.version:
            self._take(machine, state)
        if self.noted != variables:
            self.noted = variables
            self.snapshot.registers = join_registers(self.snapshot.registers, variables)

    def arrive(self, machine: Execution, exception: Value, state: State) -> None:
        """An exception comes in a state (which is not used up)."""
        for each in options(exception):
            snapshot = Snapshot(self.frame.registers.copy(), state.copy())
            heap = snapshot.state.heap
            if self.told is not None:
                self.told.append(Telling(Kind.ARRIVED, 0, each, heap.copy(), state.done))
            key = next((k for k in self.arrivals if k.__class__ is Choice and each in options(k)), each)
            self.arrivals[key] = join_into(machine, self.arrivals.get(key), snapshot, self.merge, self.arrived.get(key))
            self.arrived[key] = heap
        self.arrivals = self.few(machine, _MOST)
        if len(self.arrivals) < len(self.arrived):
            self.arrived = {each: heap for each, heap in self.arrived.items() if each in self.arrivals}

    def few(self, machine: Execution, most: int) -> dict[Value, Snapshot]:
        """The exceptions that are known, each with its state; all joined where there are more than so many."""
        if len(self.arrivals) <= most:
            return self.arrivals
        joined = join_snapshots(machine, list(self.arrivals.values()))
        assert joined is not None
        return {self.raised: joined}

    def wrote(self, machine: Execution, address: int, obj: Obj, version: int) -> None:
        """An object was written, in a state that had this version before."""
        if not self.level:
            return
        if version != self.version:
            self._take(machine, machine.state)
            return
        self.version = machine.state.version
        if self.told is not None:
            self._tell(Telling(Kind.WRITTEN, self.level, None, None, machine.state.done, ((address, obj),)))
        self._cover(machine, address, obj)

    def _tell(self, telling: Telling) -> None:
        assert self.told is not None
        self.untold = False
        self.told.append(telling)

    def _cover(self, machine: Execution, address: int, obj: Obj) -> None:
        state = self.snapshot.state
        old = state.heap.stands(address)
        merged = obj if old is None else join_objects(old, obj, join)
        if merged is not old:
            state.heap[address] = merged
            state.version = machine.fresh_version()

    def told_again(self, machine: Execution, told: Told, state: State, *, first: bool) -> None:
        """What a call told that need not run again, in the state that it is called from with the objects that differ in it (used up)."""
        if told.kind is Kind.ARRIVED:
            assert told.exception is not None
            self.arrive(machine, told.exception, state)
        elif told.kind is Kind.WRITTEN and not self.level:
            return
        elif first:
            if told.kind is Kind.NOTED:
                self.note(machine, told.level, state)
            else:
                self._take(machine, state)
        else:
            if self.told is not None:
                self._tell(Telling(told.kind, told.level, None, None, state.done, told.objects))
            self.level = max(self.level, told.level)
            self.snapshot.state.done &= state.done
            for address, obj in told.objects:
                self._cover(machine, address, obj)

    def _take(self, machine: Execution, found: State) -> None:
        """The state has become another one, not by writes alone: an exception that is not known may come in all of it."""
        self.version = found.version
        taken = found.copy()
        if self.told is not None:
            self._tell(Telling(Kind.NOTED, self.level, None, taken.heap, found.done))
        self.snapshot.state = join_states(self.snapshot.state, taken, machine.fresh_version, known=self.covered)
        self.covered = taken.heap

    def take_over(self, machine: Execution, inner: Catcher, state: State | None = None) -> None:
        """What may be raised in an inner statement, and is not surely caught there, may arrive here; in another state, where one is given."""
        if not inner.level:
            return
        self.note(machine, inner.level, state or inner.snapshot.state)
        self.importing = self.importing or inner.importing
        if inner.frame is self.frame:
            self.snapshot.registers = join_registers(self.snapshot.registers, inner.snapshot.registers)


def join_snapshots(machine: Execution, several: list[Snapshot]) -> Snapshot | None:
    """Copies of snapshots of one frame, joined."""
    joined: Snapshot | None = None
    for each in several:
        joined = join_into(machine, joined, Snapshot(each.registers.copy(), each.state.copy()))
    return joined
