# SPDX-License-Identifier: Apache-2.0
"""What may run later: callbacks of every kind, run to a fixpoint, in any order, any number of times.

self.create_timer(1.0, self.tick)     tick runs wherever the program spins, and after its main body
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import join, join_all, options, reasons_of, widen
from rosward.domain.state import State, join_objects, join_states
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import UNBOUND, BoundMethod, Class, Function, Partial, Ref, Unknown, Value
from rosward.engine.arguments import ANY
from rosward.engine.budget import LimitReachedError
from rosward.engine.catcher import throw
from rosward.engine.escape import BY_BASE, BY_LIBRARY, BY_PYTHON
from rosward.engine.frame import Frame
from rosward.engine.unheld import arrive, unheld_messages
from rosward.findings import Finding, Findings
from rosward.ir.ops import Op
from rosward.ir.program import Code, CodeKind, Parameters
from rosward.source.location import Place

if TYPE_CHECKING:
    from rosward.effects.log import EntityEffect
    from rosward.engine.machine import Engine
    from rosward.engine.named import Naming


def _fails(effect: EntityEffect) -> bool:
    """Whether an entity is made of something that is not there: a name or a node that an attribute would have to hold."""
    causes = {r.cause for r in reasons_of(effect.name)}
    return effect.address is None or Cause.ERROR in causes


_MOST_RAISED: Final = 12
_STEPS_OF_EACH: Final = 300
"""What each callback may take on top of what all may take together: a large program has many small ones."""
_NO_PARAMETERS: Final = Parameters((), 0, None, (), None)


@final
class Entry:
    """One thing that may be called: with `args` (None: with anything), since `state`, registered at `place`."""

    __slots__ = ("args", "callback", "coarse", "context", "event", "exhausted", "place", "state")

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
        self.exhausted = False  # it hit a limit: it is not run again


@final
class Schedule:
    """All that was registered so far, by callback, arguments and event."""

    __slots__ = (
        "_begun",
        "_event",
        "_raised",
        "_settled",
        "by_library",
        "entries",
        "main_raised",
        "named",
        "running",
        "spent",
        "threads_raised",
    )

    def __init__(self) -> None:
        self.entries: dict[object, Entry] = {}
        self.named: dict[str, Naming] = {}  # what a library may import and call by a name that it was handed
        self.running = False
        self.spent = 0  # steps of all callbacks, but for those that are running
        self._begun = 0  # how many steps there were when these began
        self.by_library = False  # something that the program handed out may be called by a library
        self.main_raised: Value = UNBOUND  # the exceptions by which the main body may end
        self.threads_raised: Value = UNBOUND  # those that threads do not catch
        self._event = ""  # of the entry that is running
        self._raised: dict[Value, State] = {}  # what callbacks raise and do not catch, and the states in which they do
        self._settled = (-1, -1)  # the number of entries and the version with which all came to rest last time

    def add(
        self,
        machine: Engine,
        callback: Value,
        args: tuple[Value, ...] | None,
        event: str,
        place: Place | None = None,
    ) -> None:
        """Register a callback; here, unless another place is given."""
        for option in options(callback):
            key = (option, args)
            self.by_library = self.by_library or event in (BY_LIBRARY, BY_BASE)
            if key not in self.entries and option.__class__ is not Unknown:
                entry = self.entries[key] = Entry(
                    option,
                    args,
                    event,
                    place or machine.place,
                    machine.state.copy(),
                    self._context(machine, option, event),
                )
                if event == "thread" and not self.running:
                    self._start(machine, entry)

    def _start(self, machine: Engine, entry: Entry) -> None:
        """A thread runs from here on: what follows may see what it writes, and it what is written so far.

        Where it finds an attribute missing that is set below, the program would fail: of that nothing is told.
        """
        before, findings, entities = machine.state, Findings(machine.log.findings), frozenset(machine.log.entities)
        machine.state = before.copy()
        with self._alone(machine):
            self._call(machine, entry)
        machine.state = join_states(before, machine.state, machine.fresh_version)
        machine.log.findings = findings
        for effect in [e for e in machine.log.entities if e not in entities and _fails(e)]:
            del machine.log.entities[effect]

    @property
    def was_run(self) -> bool:
        """Whether the program was somewhere where its callbacks run."""
        return self._settled[0] >= 0

    @contextmanager
    def _alone(self, machine: Engine) -> Iterator[None]:
        """What is scheduled runs under no frame and no `try` of the main body."""
        self.running = True
        catchers, machine.catchers = machine.catchers, []
        handling, machine.handling = machine.handling, []
        frames, machine.frames = machine.frames, []
        loops, machine.loops = machine.loops, 0
        fixpoints, machine.fixpoints = machine.fixpoints, 0
        coarse, self._begun = machine.coarse, machine.steps
        limits = machine.step_limit, machine.coarse_limit, machine.loop_limit
        try:
            yield
        finally:
            self.running = False
            machine.frames = frames
            machine.catchers, machine.handling = catchers, handling
            machine.loops, machine.fixpoints = loops, fixpoints
            spent = machine.steps - self._begun  # by callbacks: the main body has its own steps
            self.spent += spent
            machine.coarse = coarse
            machine.step_limit, machine.coarse_limit, machine.loop_limit = (limit + spent for limit in limits)

    def _context(self, machine: Engine, callback: Value, event: str) -> int:
        """The context in which a callback runs: its own, unless a callback registers it: then there must be finitely many."""
        if not self.running:
            return machine.context("callback", len(self.entries))
        while callback.__class__ in (BoundMethod, Partial):
            callback = callback.function
        code = callback.code.key if callback.__class__ is Function else ""
        return machine.context("later callback", code, event, machine.place)

    def spin(self, machine: Engine) -> None:
        """Run everything until neither the heap nor the schedule changes; the machine's state becomes the join of all that may be."""
        if self.running:
            return
        if self._settled != (len(self.entries), machine.state.version):
            frames = machine.frames
            with self._alone(machine):
                self._run(machine, frames)
            machine.unheld = set()
            self._settled = (len(self.entries), machine.state.version)
        self._throw(machine)

    def uncaught(self, machine: Engine, exception: Value) -> None:
        """Nothing catches an exception. That of a callback comes out where the program spins, that of a thread ends there."""
        if not self.running:
            self.main_raised = join(self.main_raised, exception)
            return
        if self._event == "thread":
            self.threads_raised = join(self.threads_raised, exception)
            return
        for option in options(exception):
            known = self._raised.get(option)
            state = machine.state.copy()
            self._raised[option] = state if known is None else join_states(known, state, machine.fresh_version)
        if len(self._raised) > _MOST_RAISED:
            self._raised = {join_all(self._raised): self._joined(machine)}

    def _joined(self, machine: Engine) -> State:
        joined = machine.state.copy()
        for state in self._raised.values():
            joined = join_states(joined, state.copy(), machine.fresh_version)
        return joined

    def _throw(self, machine: Engine) -> None:
        """The exceptions of callbacks may come out here."""
        after = machine.state
        for exception, state in self._raised.items():
            machine.state = join_states(after.copy(), state.copy(), machine.fresh_version)
            throw(machine, exception)
        machine.state = after

    def _run(self, machine: Engine, frames: Sequence[Frame]) -> None:
        reason = Reason(Cause.LOOP, "a callback that runs again", Place("", 0))

        def widening(old: Value, new: Value) -> Value:
            return widen(old, new, reason)

        for round_ in range(machine.budget.rounds * 3):
            start = (len(self.entries), machine.state.version)
            machine.unheld = unheld_messages(machine, self.entries.values(), frames)
            merge = join if round_ < machine.budget.widen_after else widening
            for entry in [e for e in self.entries.values() if not e.exhausted]:
                base = machine.state
                machine.state = base.copy()
                if not self._afford(machine, entry):
                    continue
                self._call(machine, entry)
                machine.state = join_states(base, machine.state, machine.fresh_version, merge)
            if start == (len(self.entries), machine.state.version):
                return
            machine.check_time()
        machine.report("RW201", "the callbacks did not come to rest; what they create later may be missing")

    def _afford(self, machine: Engine, entry: Entry) -> bool:
        """Whether there are steps left for a callback. Where many are gone, precision goes first."""
        budget = machine.budget
        most = budget.callback_steps + _STEPS_OF_EACH * len(self.entries)
        spent = self.spent + machine.steps - self._begun
        if spent > most:
            if not any(other.exhausted for other in self.entries.values()):
                said = f"more than {most} steps in all callbacks; what this one and others do later is missing"
                machine.log.findings.add(Finding("RW201", said, entry.place))
            entry.exhausted = True
            return False
        entry.coarse = entry.coarse or spent > most * budget.coarse
        return True

    def _call(self, machine: Engine, entry: Entry) -> None:
        self._event = entry.event
        machine.state.heap.fill(entry.state.heap, lambda ours, theirs: join_objects(ours, theirs, join))
        code = Code(CodeKind.FUNCTION, "", "", entry.place.file, entry.place.line, _NO_PARAMETERS, [], 0, (), (), ())
        frame = Frame(code, [], (), machine.library.nowhere, entry.context, False)
        frame.op = Op(entry.place.line, entry.place.column)
        frame.uncertain = 1
        machine.frames.append(frame)
        machine.loops = machine.fixpoints = 0
        machine.step_limit = machine.steps + machine.budget.entry_steps
        heavy = len(machine.heavy)
        machine.coarse = machine.always_coarse = entry.coarse
        machine.coarse_limit = machine.loop_limit = machine.steps + machine.budget.entry_coarse
        try:
            arrive(machine, entry)
            if entry.callback.__class__ is Ref and machine.obj(entry.callback).kind == "generator":
                machine.iterate(entry.callback)
            else:
                anything = machine.unknown(Cause.CALL, f"argument of a {entry.event}")
                result = machine.call(entry.callback, entry.args or (), {ANY: anything})
                if result is not UNBOUND and result.__class__ is Ref and machine.obj(result).kind == "generator":
                    machine.iterate(result)
                elif entry.callback.__class__ is Class:  # what a library makes is its own
                    machine.handed.update((o, entry.place) for o in options(result) if o is not UNBOUND)
                elif entry.event in (BY_LIBRARY, BY_BASE, BY_PYTHON) and result is not UNBOUND:
                    machine.escape((result,), "a library")
        except LimitReachedError as limit:
            entry.exhausted = True
            machine.report("RW201", f"{limit.what} in what a {entry.event} starts; the rest of it is missing")
            machine.check_time()
        finally:
            entry.coarse = machine.coarse or len(machine.heavy) > heavy
            machine.always_coarse = False
            machine.frames.clear()
