# SPDX-License-Identifier: Apache-2.0
"""The interpreter: one handler per operation, found by its class. It holds the state and delegates every question to a module.

A handler returns None where control goes on, and False where it does not (the path is dead, or has left by an exit).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import join, join_all
from rosward.domain.heap import Obj, fields_of
from rosward.domain.memory import MASK, SHIFT, Heap
from rosward.domain.series import Series
from rosward.domain.state import NOTHING_DONE, State, join_objects, join_states
from rosward.domain.suspended import Suspension
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import (
    NONE,
    UNBOUND,
    Class,
    Function,
    Native,
    Ref,
    TooManyPartsError,
    Unknown,
    Value,
)
from rosward.engine import activation, catcher, escape, failing
from rosward.engine.budget import Budget, LimitReachedError
from rosward.engine.frame import Frame, Snapshot
from rosward.engine.python import (
    abandoned,
    assignment,
    attributes,
    calls,
    contexts,
    equality,
    generators,
    instances,
    items,
    iteration,
    modules,
    namespaces,
    raised,
    removal,
    stepping,
    suspending,
)
from rosward.engine.schedule import Schedule
from rosward.engine.transfer import HANDLERS
from rosward.findings import Finding
from rosward.ir import ops
from rosward.models.python.containers.sets import each_once
from rosward.models.python.operators.compare import compares
from rosward.source.location import Place

if TYPE_CHECKING:
    from rosward.effects.log import EffectLog
    from rosward.engine.library import Library
    from rosward.ir.program import Code, OpKey
    from rosward.models.file_paths import Files
    from rosward.models.native import Items

_OBJECTS_A_STEP: Final = 3  # how many objects are joined in the time of one step, about
_LONGEST_PATH: Final = 12


@final
class Interpreter:
    """Runs the code of one process abstractly. Implements `machine.Engine`."""

    def __init__(self, library: Library, budget: Budget, log: EffectLog) -> None:
        self.library = library
        self.budget = budget
        self.log = log
        self.state = State(Heap(ground=library.ground), 0, NOTHING_DONE)
        self.frames: list[Frame] = []
        self.catchers: list[catcher.Catcher] = []
        self.schedule_book = Schedule()
        self.steps = 0
        self.step_limit = budget.steps
        self.coarse = False  # precision is given up: too many steps were spent
        self.always_coarse = False  # the callback that is running took too many steps when it ran before
        self.coarse_limit = int(budget.steps * budget.coarse)
        self.loop_limit = self.coarse_limit  # the same for the outermost loop that is running
        self.heavy: set[OpKey] = set()  # the outermost loops that took too many steps
        self.heads: dict[OpKey, Snapshot] = {}  # where loops came to rest; in coarse mode only
        self.deadline = time.thread_time() + budget.seconds
        self.making: list[Class] = []  # the classes whose bodies are done and whose metaclass is making them
        self.unhooked: set[int] | None = set()  # the classes without `__init_subclass__` (`subclass_hooks.py`)
        self.hooked = False  # whether a class of the program has `__getattribute__`
        self.choosing = False  # what is being called is one of several alternatives
        self.raised = 0
        self.noted = 0  # what Python may have raised by itself in the call that is running, as a level
        self.handling: list[tuple[Value, int]] = []  # the exceptions whose handlers are running, innermost last
        self.provisional = 0  # how often an unfinished summary of a recursion was read
        self.fixpoints = 0  # how many loops are being followed to a fixpoint
        self.loops = 0  # how many loops are running
        self.turns = 0  # turns followed one by one since the outermost of them began
        self.ended_at: dict[Place, Value] = {}  # the classes of uncaught exceptions, by where they are raised
        self.advancing: dict[int, generators.Running] = {}  # the generators that run now, by address
        self.ways: dict[str, dict[int, suspending.Way]] = {}  # how each body, by its key, leads to its yields
        self.ends: State | None = None  # where the program ends early, joined
        self.summaries: dict[object, activation.Summary] = {}
        self.finished: dict[object, activation.Summary] = {}  # of recursions and large functions; in coarse mode only
        self.large: dict[str, bool] = {}  # whether a code body, by its key, has loops
        self.memo: dict[object, tuple[Value, int]] = {}  # results, and what Python may raise
        self.instantiated: set[Place] = set()
        self.handed: dict[Value, Place] = {}  # classes and objects that reached unknown code, and where
        self.entered: set[str] = set()  # the key of each code body that was run
        self.reached: set[OpKey] = set()  # each operation that was run and reads a method that creates an entity
        self.asked: set[tuple[str, str, str]] = set()  # what may be called without being seen: see `unreached.py`
        self._versions = 0
        self._first_address = library.first_address
        self._addresses: dict[object, int] = {}
        self._contexts: dict[object, int] = {}
        self.table = HANDLERS

    # Running

    def run(self, block: ops.Block, frame: Frame) -> bool:
        """Interpret a block; False where control does not come out at its end."""
        self.steps += len(block)
        if self.steps > self.step_limit:
            raise LimitReachedError(f"more than {self.step_limit} steps", self.place)
        if self.steps > self.loop_limit:
            self.coarse = True
        if self.catchers:
            return failing.run_noting(self, block, frame)
        table = self.table
        for op in block:
            try:
                if table[op.__class__](self, op, frame) is False:
                    return False
            except TooManyPartsError:  # noqa: PERF203 - it costs nothing where nothing is raised
                self.give_up_value(op, frame)
        return True

    def give_up_value(self, op: ops.Op, frame: Frame) -> None:
        """What an operation makes is too large to keep: its result is not known."""
        if hasattr(op, "dst"):
            frame.registers[op.dst] = self.unknown(Cause.LIMIT, "parts of a tuple")

    def spend(self, steps: int) -> None:
        """Something that takes as long as this many steps: a native that computes, a join of much."""
        self.steps += steps
        if self.steps > self.step_limit:
            raise LimitReachedError(f"more than {self.step_limit} steps", self.place)

    def begin_loop(self, op: ops.Op, frame: Frame) -> None:
        """A loop begins: an outermost one has turns and steps of its own, before precision is given up."""
        if not self.loops:
            self.turns = 0
            self.loop_limit = min(self.coarse_limit, self.steps + self.budget.loop_steps)
            self.coarse = self.coarse or (frame.code.key, op.number) in self.heavy
        self.loops += 1

    def end_loop(self, op: ops.Op, frame: Frame) -> None:
        """A loop has ended."""
        self.loops -= 1
        if not self.loops:
            if self.coarse and not self.always_coarse:
                self.heavy.add((frame.code.key, op.number))
                self.always_coarse = self.schedule_book.running  # in a callback, until it ends
            if not self.schedule_book.running:  # what follows in the main body has its part of what is left
                left = int((self.step_limit - self.steps) * self.budget.coarse)
                self.coarse_limit = max(self.coarse_limit, self.steps + left)
            self.loop_limit = self.coarse_limit
            self.coarse = self.always_coarse or self.steps > self.coarse_limit

    def keep_end(self) -> None:
        """Here a path of the main body ends: its state counts for what runs afterwards."""
        if self.ends is None:
            self.ends = self.state.copy()
        else:
            self.ends = join_states(self.ends, self.state.copy(), self.fresh_version)

    def check_time(self) -> None:
        """Raise where the process has used up its time."""
        if time.thread_time() > self.deadline:
            raise LimitReachedError(f"more than {self.budget.seconds:g} s of analysis", self.place)

    def fresh_version(self, compared: int = 0) -> int:
        """A version number never used before, for a state that took as many comparisons of objects to make."""
        self.steps += compared // _OBJECTS_A_STEP
        self._versions += 1
        return self._versions

    def context(self, *key: object) -> int:
        """The number of a context."""
        number = self._contexts.get(key)
        if number is None:
            number = self._contexts[key] = len(self._contexts) + 1
        return number

    def snapshot(self, frame: Frame) -> Snapshot:
        """An independent copy of where we are."""
        return Snapshot(frame.registers.copy(), self.state.copy())

    def resume(self, frame: Frame, snapshot: Snapshot) -> None:
        """Go on from a snapshot (which is used up)."""
        frame.registers = snapshot.registers
        self.state = snapshot.state

    # The heap

    def obj(self, ref: Ref) -> Obj:
        """The record at an address, of this process or of the library."""
        return self.at(ref.address)

    def at(self, address: int) -> Obj:
        """The record at an address."""
        page = self.state.heap.pages.get(address >> SHIFT)  # `Heap.get`, without the call: nothing is asked as often
        found = None if page is None else page[address & MASK]
        return found if found is not None else self.library.at(address)

    def put(self, address: int, obj: Obj) -> None:
        """Replace the record at an address."""
        state = self.state
        state.heap[address] = obj
        before = state.version
        self._versions += 1
        state.version = self._versions
        if self.catchers:
            self.catchers[-1].wrote(self, address, obj, before)

    def update(self, ref: Ref, obj: Obj) -> None:
        """Replace the record behind a reference; where it stands for several objects the old content stays possible."""
        old = self.at(ref.address)
        if old.many:
            joined = join_objects(old, obj, join)
            if joined is old:
                return
            obj = joined
        self.put(ref.address, obj)

    def allocate(self, obj: Obj, site: object = None) -> Ref:
        """A new object, identified by the place and context in which it is made."""
        frame = self.frames[-1] if self.frames else None
        if frame is None:
            return Ref(self.place_at((obj.kind, site), obj))
        key = (frame.context, frame.code.key, frame.op.number, frame.next(), site, obj.kind, obj.cls)
        return Ref(self.place_at(key, obj))

    def place_key(self, key: object) -> int:
        """The address that belongs to a key."""
        address = self._addresses.get(key)
        if address is None:
            address = self._addresses[key] = self._first_address + len(self._addresses)
        return address

    def place_at(self, key: object, obj: Obj) -> int:
        """Put a new object at the address that belongs to a key; a second one there makes the record stand for both.

        Unless that is a generator at its end: nothing can be had from it any more, so the new one takes its place.
        """
        address = self.place_key(key)
        old = self.state.heap.get(address)
        if old is not None and not (isinstance(old.payload, Suspension) and old.payload.is_over):
            joined = join_objects(old, obj, join)
            if not joined.many:
                joined = joined.replace(many=True)
            if joined is old:
                return address
            obj = joined
        self.put(address, obj)
        return address

    def new_list(self, items: Iterable[Value], rest: Value | None = None, tail: tuple[Value, ...] = ()) -> Ref:
        """A new list."""
        return self._collection("list", Series(tuple(items), rest, tail))

    def new_set(self, items: Iterable[Value], rest: Value | None = None) -> Ref:
        """A new set."""
        known = each_once(items)
        if len(known) > 1 and any(compares(self, v) for v in known):  # how many of them are equal is not known
            known, rest = (), join_all([*known, *(() if rest is None else (rest,))])
        return self._collection("set", Series(known, rest))

    def _collection(self, kind: str, series: Series) -> Ref:
        return self.allocate(Obj(kind, Native(f"builtins.{kind}"), **fields_of(series, kind, self.budget.items)))

    def new_dict(self, entries: Mapping[Value, Value], rest: Value | None = None) -> Ref:
        """A new dict."""
        return self.allocate(Obj("dict", Native("builtins.dict"), entries=dict(entries), rest=rest))

    # What natives ask for

    def call(self, function: Value, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        """Call a value."""
        return calls.call(self, function, tuple(args), dict(keywords) if keywords else {})

    def call_method(self, value: Value, name: str, args: tuple[Value, ...]) -> Value:
        """value.name(*args)."""
        return calls.call_method(self, value, name, args)

    def wait_for(self, value: Value) -> Value:
        """`await value`."""
        return calls.wait_for(self, value)

    def make_generator(self, function: Function, registers: list[Value]) -> Ref:
        """What a call of a generator function or coroutine gives."""
        return generators.make(self, function, registers)

    def advance(self, ref: Ref, action: stepping.Action) -> stepping.Stepped:
        """Resume a suspended generator."""
        return generators.advance(self, ref, action)

    def run_out(self, ref: Ref) -> tuple[Items, Value]:
        """Run a generator or coroutine to its end: what it yields, what it returns."""
        return generators.run_out(self, ref)

    def close_generator(self, ref: Ref) -> None:
        """`generator.close()`."""
        generators.close(self, ref)

    def next_of(self, iterator: Value, kind: str, value: Value, default: Value | None = None) -> Value:
        """The next item of an iterator, or the default, else StopIteration."""
        item = stepping.next_of(self, iterator, stepping.Action(kind, value), default)
        abandoned.watch(self, iterator)
        return item

    def is_stepped(self, value: Value) -> bool:
        """Whether a value is followed step by step where it is iterated over."""
        return stepping.is_followed(self, value)

    def throw(self, exception: Value) -> None:
        """An exception is raised here for sure."""
        made = raised.made(self, exception)
        raised.chain(self, made, None)
        catcher.throw(self, made)

    @contextmanager
    def handles(self, exception: Value, level: int) -> Iterator[None]:
        """A handler runs for these exceptions (UNBOUND: none that is known), and where there is a level for others that are not known."""
        self.handling.append((exception, level))
        try:
            yield
        finally:
            self.handling.pop()

    @property
    def handled(self) -> Value:
        """The exception that is being handled; None where there is none."""
        if not self.handling:
            return NONE
        known, level = self.handling[-1]
        return known if not level else join(known, catcher.unseen(self))

    def uncaught(self, exception: Value) -> None:
        """Nothing around catches this exception, which is raised here."""
        self.schedule_book.uncaught(self, exception)
        if not self.schedule_book.running:
            cls = raised.class_of(self, exception)
            self.ended_at[self.place] = join(self.ended_at.get(self.place, UNBOUND), cls)

    def guarded(self, action: Callable[[], Value], error: str, *, unseen: bool = True) -> tuple[Value, bool]:
        """What an action gives, and whether it may raise a builtin exception, which goes no further."""
        return raised.guarded(self, action, error, unseen=unseen)

    def unwind(self, exits: Sequence[Value], exception: Value) -> Value:
        """Call the exits of a stack of context managers."""
        return contexts.unwind(self, exits, exception)

    def new_cells(self, code: Code, context: int) -> list[int]:
        """Fresh cells for the captured variables of a code body."""
        return [self.place_at(("cell", context, code.key, n), Obj("cell", NONE)) for n in range(len(code.cells))]

    def load_attr(self, value: Value, name: str) -> Value:
        """value.name."""
        return attributes.load(self, value, name)

    def store_attr(self, target: Value, name: str, value: Value) -> None:
        """target.name = value."""
        assignment.store(self, target, name, value)

    def keep_attr(self, owner: Ref, name: str, value: Value, *, weak: bool = False) -> None:
        """owner.__dict__[name] = value; UNBOUND: `del` of that."""
        assignment.keep(self, owner, name, value, weak=weak)

    def delete_attr(self, target: Value, name: str) -> None:
        """del target.name."""
        removal.delete(self, target, name)

    def load_item(self, value: Value, index: Value) -> Value:
        """value[index]."""
        return items.load(self, value, index)

    def store_item(self, target: Value, index: Value, value: Value) -> None:
        """target[index] = value."""
        items.store(self, target, index, value)

    def binary(self, operator: str, left: Value, right: Value) -> Value:
        """left operator right."""
        return equality.binary(self, operator, left, right, inplace=False)

    def compare(self, operator: str, left: Value, right: Value) -> Value:
        """left operator right."""
        return equality.compare(self, operator, left, right)

    def iterate(self, value: Value) -> Items:
        """What iterating yields."""
        return iteration.iterate(self, value)

    def series(self, value: Value) -> Series:
        """What iterating yields, as far as the order is known."""
        return iteration.series(self, value)

    def truth(self, value: Value) -> bool | None:
        """The truth of a value, None for both."""
        return equality.truth(self, value)

    def is_instance(self, value: Value, wanted: Value) -> bool | None:
        """isinstance(value, wanted)."""
        return instances.is_instance(self, value, wanted)

    def is_subclass(self, cls: Value, wanted: Value) -> bool | None:
        """issubclass(cls, wanted)."""
        return instances.is_subclass(self, cls, wanted)

    def unknown(self, cause: Cause, subject: str, hint: str = "") -> Unknown:
        """An unknown that arises here."""
        return Unknown((Reason(cause, subject, self.place),), hint)

    def may_call(self, values: Iterable[Value]) -> None:
        """A described library may call those that are functions."""
        escape.may_call(self, values)

    def escape(self, values: Iterable[Value], library: str, callee: Value | None = None) -> None:
        """Values reach unknown code."""
        escape.escape(self, values, library, callee)

    def schedule(self, callback: Value, args: Sequence[Value], event: str) -> None:
        """A callback may run from now on."""
        self.schedule_book.add(self, callback, tuple(args), event)

    def spin(self) -> None:
        """Everything scheduled may run here."""
        self.schedule_book.spin(self)

    def variables(self, *, local: bool) -> Value:
        """What `locals()` or `globals()` gives here."""
        found = namespaces.variables(self, local=local)
        return self.unknown(Cause.LIVE, "variables", "dict") if found is None else found

    def report(self, code: str, message: str, causes: tuple[str, ...] = ()) -> None:
        """A finding at the current place."""
        self.log.findings[Finding(code, message, self.place, causes)] = None

    def die(
        self, error: str, message: str, args: Sequence[Value] | None = None, *, sure: bool = False, plain: bool = False
    ) -> Value:
        """This path raises here: it ends where that is what the program wants (SystemExit), or waits for. Any other failure of a builtin
        is taken as a value that is not known: what fails for the values that we see (a default list too short) may go well for others."""
        if error not in ("SystemExit", "StopIteration"):
            return raised.fail(self, error, f"{error}: {message}", args, sure=sure, plain=plain)
        catcher.throw(self, raised.builtin_error(self, error, args))
        return UNBOUND

    @property
    def place(self) -> Place:
        """The innermost place in the user's code."""
        for frame in reversed(self.frames):
            if not frame.stub:
                return frame.place
        return Place("", 0)

    @property
    def path(self) -> tuple[Place, ...]:
        """The calls in the user's code that lead here, outermost first; of a longer chain the innermost."""
        own = [frame for frame in self.frames if not frame.stub][-_LONGEST_PATH:]
        return tuple(frame.place for frame in own)

    @property
    def in_callback(self) -> bool:
        """Whether something that was scheduled is running, not the main body."""
        return self.schedule_book.running

    @property
    def is_tried(self) -> bool:
        """Whether a `try` or `with` is running around."""
        return bool(self.catchers)

    @property
    def is_sure(self) -> bool:
        """Whether no branch around leaves open whether this runs."""
        return not any(f.uncertain for f in self.frames)

    @property
    def environment(self) -> Mapping[str, Value | None]:
        """What is known of the environment of every process that is not given another."""
        return self.library.environment

    def function_record(self, function: Function) -> Obj | None:
        """The heap record of a function that was given attributes."""
        return self.state.heap.get(self.library.function_address(function))

    @property
    def files(self) -> Files:
        """The files of the analysed packages."""
        return self.library.sources.files

    @property
    def via(self) -> str | None:
        """The library function that the user's code called, where the current code is a library's."""
        name: str | None = None
        for frame in reversed(self.frames):
            if not frame.stub:
                break
            name = f"{frame.module.name}.{frame.code.qualname}"
        return name.removesuffix(".__init__") if name else None

    def load_module(self, name: str, level: int = 0, *, asked: bool = False) -> Value:
        """The module (or external thing) of a dotted name, run if it was not yet; where the program has `asked` for it, that may fail."""
        frame = next((f for f in reversed(self.frames) if not f.stub), None)
        return (modules.load_asked if asked else modules.load)(self, name, frame, level)
