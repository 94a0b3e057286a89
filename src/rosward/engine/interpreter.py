# SPDX-License-Identifier: Apache-2.0
"""The interpreter: one handler per operation, found by its class. It holds the state and delegates every question to a module.

A handler returns None where control goes on, and False where it does not (the path is dead, or has left by an exit).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Final, final

from rosward.domain.choice import join
from rosward.domain.compound import Native, TooManyPartsError
from rosward.domain.heap import KIND, Obj, ObjKind, fields_of
from rosward.domain.memory import MASK, SHIFT, Heap
from rosward.domain.series import Series
from rosward.domain.state import NOTHING_DONE, State, join_objects, join_states
from rosward.domain.suspended import Suspension
from rosward.domain.unknown import Cause
from rosward.domain.values import Class, ModuleValue, Ref, Value
from rosward.engine.answers import Answers
from rosward.engine.budget import Budget
from rosward.engine.languages import Watched
from rosward.engine.running.attributes_asked import BITS, FIRST, AttributeNames
from rosward.engine.running.catcher import Catcher
from rosward.engine.running.frame import Frame, Snapshot
from rosward.engine.running.precision import Precision
from rosward.engine.running.schedule_book import Schedule
from rosward.engine.running.summaries import Summaries
from rosward.engine.running.trace import Trace
from rosward.ir import ops
from rosward.location import Place
from rosward.models.native import Items
from rosward.models.python.containers.sets import distinct

if TYPE_CHECKING:
    from rosward.effects.log import EffectLog, EntityEffect
    from rosward.effects.sent import SentEffect
    from rosward.engine.machine import Language, SharedLanguages, Watcher
    from rosward.engine.running.stepped import Running
    from rosward.engine.running.ways import Way

_OBJECTS_A_STEP: Final = 3  # how many objects are joined in the time of one step, about


@final
class Interpreter(Answers):
    """Runs the code of one process abstractly. Implements `machine.Engine`."""

    def __init__(
        self,
        library: SharedLanguages,
        budget: Budget,
        log: EffectLog,
        watch: Watcher | None = None,
        careful: frozenset[str] | None = None,
    ) -> None:
        self.library = library
        self.budget = budget
        self.log = log
        self.state = State(Heap(ground=library.ground), 0, NOTHING_DONE)
        self.frames: list[Frame] = []
        self.catchers: list[Catcher] = []
        self.schedule_book = Schedule()
        self.precision = Precision(budget, careful)
        self.trace = Trace()
        self.summaries = Summaries()
        self.making: list[Class] = []  # the classes whose bodies are done and whose metaclass is making them
        self.unhooked: set[int] | None = set()  # the classes without `__init_subclass__` (`subclass_hooks.py`)
        self.hooked = False  # whether a class of the program has `__getattribute__`
        self.choosing = 0  # what is being called is one of so many alternatives
        self.refused: list[str] = []  # why alternatives did not take their arguments, of those too many to tell of each
        self.raised = 0
        self.noted = 0  # what Python may have raised by itself in the call that is running, as a level
        self.handling: list[tuple[Value, int]] = []  # the exceptions whose handlers are running, innermost last
        self.unheld: set[int] = set()  # what nothing holds any more of the last time that callbacks ran (`unheld.py`)
        self.declarations: dict[object, tuple[int, ...]] = {}  # what variables in C++ were last (`cpp/again.py`)
        self.ended: set[int] = set()  # those of a call that is over of which one is about to be made anew
        self.returned: set[int] = set()  # objects that functions in C++ have returned
        self.lasting: set[int] = set()  # variables to which nothing leads, and that last as long as the program
        self.ended_at: dict[Place, Value] = {}  # the classes of uncaught exceptions, by where they are raised
        self.advancing: dict[int, Running] = {}  # the generators that run now, by address
        self.ways: dict[str, dict[int, Way]] = {}  # how each body, by its key, leads to its yields
        self.ends: State | None = None  # where the program ends early, joined
        self.asked_for: set[int] = set()  # the addresses whose records were read since it was emptied last
        self.missed: set[int] = set()  # those of them that were asked for where nothing stood
        self.inner: dict[int, int] = {}  # where objects stand that belong to an attribute of another one: of which
        self.attribute_names = AttributeNames()
        self._attribute_numbers = self.attribute_names.numbers
        self.linked: object = None  # what a language with a linker keeps of its program
        self._versions = 0
        self._first_address = library.first_address
        self._addresses: dict[object, int] = {}
        self._contexts: dict[object, int] = {}
        self.watch = watch
        self.languages = library.languages if watch is None else Watched(library.languages, watch)
        self.language = self.languages[
            library.language_of(library.nowhere).name
        ]  # of the code that runs; at first that of the models

    # Running

    def run(self, block: ops.Block, frame: Frame) -> bool:
        """Interpret a block; False where control does not come out at its end."""
        if frame.code.language != self.language.name:
            return self._run_in(self.languages[frame.code.language], block, frame)
        precision = self.precision
        precision.steps += len(block)
        if precision.steps > precision.step_limit:
            precision.spend(0, self)
        if precision.steps > precision.loop_limit and not precision.coarse:
            precision.give_up()
        if self.catchers and self.language.run_noting is not None:
            return self.language.run_noting(self, block, frame)
        table = self.language.table
        for op in block:
            try:
                if table[op.__class__](self, op, frame) is False:
                    return False
            except TooManyPartsError:  # noqa: PERF203 - it costs nothing where nothing is raised
                self.give_up_value(op, frame)
        return True

    def _run_in(self, language: Language, block: ops.Block, frame: Frame) -> bool:
        """Interpret a block of code of another language than what called it."""
        outer, self.language = self.language, language
        try:
            return self.run(block, frame)
        finally:
            self.language = outer

    def run_module(self, module: ModuleValue, name: str, turn: int = 0) -> bool:
        """Run the top level of a module as its language does; False where it does not come to its end."""
        return self.library.language_of(module).run_module(self, module, name, turn)

    def give_up_value(self, op: ops.Op, frame: Frame) -> None:
        """What an operation makes is too large to keep: its result is not known."""
        if hasattr(op, "dst"):
            frame.registers[op.dst] = self.unknown(Cause.LIMIT, "parts of a tuple")
        if self.watch is not None:
            self.watch.gave_up(op, frame)

    def spend(self, steps: int) -> None:
        """Something that takes as long as this many steps: a native that computes, a join of much."""
        self.precision.spend(steps, self)

    def keep_end(self) -> None:
        """Here a path of the main body ends: its state counts for what runs afterwards."""
        if self.ends is None:
            self.ends = self.state.copy()
        else:
            self.ends = join_states(self.ends, self.state.copy(), self.fresh_version)

    def note_creation(self, *, new: bool, exact: bool, key: object = None) -> None:
        """Here something is created: what runs now is followed call by call, also where precision is given up."""
        self.trace.creating.update(frame.code.key for frame in self.frames)
        self.precision.note_creation(new=new, exact=exact and self.is_sure, key=key)

    def note_effect(self, effect: EntityEffect | SentEffect) -> None:
        """An entity is created, or a message sent, here."""
        if self.watch is not None:
            self.watch.effect(self, effect)

    def check_time(self) -> None:
        """Raise where the process has used up its time."""
        self.precision.check_time(self)

    def fresh_version(self, compared: int = 0) -> int:
        """A version number never used before, for a state that took as many comparisons of objects to make."""
        self.precision.steps += compared // _OBJECTS_A_STEP
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
        """The record behind a reference, of this process or of the library."""
        address = ref.address  # `at`, without the call
        self.asked_for.add(address)
        page = self.state.heap.pages.get(address >> SHIFT)
        found = None if page is None else page[address & MASK]
        return found if found is not None else self.library.at(address)

    def part(self, ref: Ref, name: str) -> Obj:
        """The record behind a reference, of which nothing is read but this attribute, and what tells how it is read."""
        address = ref.address
        page = self.state.heap.pages.get(address >> SHIFT)
        found = None if page is None else page[address & MASK]
        if found is None:
            found = self.library.at(address)
        if found.kind == "cell":  # of which a call forgets again what it asked for, where it made it (`bodies.py`)
            self.asked_for.add(address)
            return found
        number = self._attribute_numbers.get(name)
        if number is None or address < 0:
            self.asked_for.add(self.attribute_names.question(address, name))
        else:
            self.asked_for.add(FIRST - (address << BITS | number))  # `question`, without the call
        return found

    def at(self, address: int) -> Obj:
        """The record at an address."""
        self.asked_for.add(address)
        page = self.state.heap.pages.get(address >> SHIFT)  # `Heap.get`, without the call: nothing is asked as often
        found = None if page is None else page[address & MASK]
        return found if found is not None else self.library.at(address)

    def own(self, address: int) -> Obj | None:
        """The record that this process has at an address; None where it has none."""
        self.asked_for.add(address)
        found = self.state.heap.get(address)
        if found is None:
            self.missed.add(address)
        return found

    def put(self, address: int, obj: Obj) -> None:
        """Replace the record at an address."""
        state = self.state
        state.heap[address] = obj
        self.summaries.wrote.add(address)
        if self.watch is not None:
            self.watch.wrote(address)
        before = state.version
        self._versions += 1
        state.version = self._versions
        if self.catchers and self.language.run_noting is not None:
            self.catchers[-1].wrote(self, address, obj, before)

    def update(self, ref: Ref, obj: Obj) -> None:
        """Replace the record behind a reference; where it stands for several objects the old content stays possible."""
        old = self.part(ref, KIND)
        if old.many:
            joined = join_objects(old, obj, join)
            if joined is old:
                self.summaries.wrote.add(ref.address)
                if self.watch is not None:
                    self.watch.wrote(ref.address)
                return
            obj = joined
        self.put(ref.address, obj)

    def allocate(self, obj: Obj, site: object = None, *, counted: bool = True) -> Ref:
        """A new object, identified by the place and context in which it is made.

        `counted`: and by how many its operation made before. Without that, `site` alone tells those of one operation apart.
        """
        frame = self.frames[-1] if self.frames else None
        if frame is None:
            return Ref(self.place_at((obj.kind, site), obj))
        key = (
            frame.context,
            frame.code.key,
            frame.op.number,
            frame.next() if counted else None,
            site,
            obj.kind,
            obj.cls,
        )
        address = self.place_at(key, obj)
        if frame.placed is not None:
            frame.placed.append(address)
        if self.watch is not None:
            self.watch.made(address, site)
        return Ref(address)

    def place_key(self, key: object) -> int:
        """The address that belongs to a key."""
        address = self._addresses.get(key)
        if address is None:
            address = self._addresses[key] = self._first_address + len(self._addresses)
        return address

    def place_at(self, key: object, obj: Obj) -> int:
        """Put a new object at the address that belongs to a key; a second one there makes the record stand for both."""
        address = self.place_key(key)
        self.place_anew(address, obj)
        return address

    def place_anew(self, address: int, obj: Obj) -> None:
        """Put a new object at an address, beside those that stand there already.

        Unless that is a generator at its end: nothing can be had from it any more, so the new one takes its place.
        """
        old = self.state.heap.get(address)
        if address in self.unheld:
            self.unheld.discard(address)
            self.summaries.anew.append(address)
        elif address in self.ended:
            self.ended.discard(address)
            self.summaries.fresh.add(address)
        elif old is not None and not (isinstance(old.payload, Suspension) and old.payload.is_over):
            joined = join_objects(old, obj, join)
            if not joined.many:
                joined = joined.replace(many=True)
            if joined is old:
                self.asked_for.add(address)  # nothing is written, because of what stands there
                return
            obj = joined
        if obj is not old:
            self.put(address, obj)

    def place_inner(self, owner: Ref, name: str, obj: Obj, *, again: bool) -> Ref:
        """The object that belongs to an attribute of another one."""
        key = ("inner", owner.address, name)
        address = self.place_key(key)
        self.inner[address] = owner.address
        if again or self.own(address) is None:
            self.place_at(key, obj)
        return Ref(address)

    def inner_objects(self) -> dict[int, tuple[int, str]]:
        """The objects that belong to an attribute of another one: of which, and by what name."""
        return {a: (k[1], k[2]) for k, a in self._addresses.items() if k.__class__ is tuple and k[0] == "inner"}

    def new_list(self, items: Iterable[Value], rest: Value | None = None, tail: tuple[Value, ...] = ()) -> Ref:
        """A new list."""
        return self._collection("list", Series(tuple(items), rest, tail))

    def new_set(self, items: Iterable[Value], rest: Value | None = None) -> Ref:
        """A new set."""
        return self._collection("set", Series(*distinct(self, Items(tuple(items), rest))))

    def _collection(self, kind: ObjKind, series: Series) -> Ref:
        return self.allocate(Obj(kind, Native(f"builtins.{kind}"), **fields_of(series, kind, self.budget.items)))

    def new_dict(self, entries: Mapping[Value, Value], rest: Value | None = None) -> Ref:
        """A new dict."""
        return self.allocate(Obj("dict", Native("builtins.dict"), entries=dict(entries), rest=rest))
