# SPDX-License-Identifier: Apache-2.0
"""What the modules of the engine ask each other (`Engine`, which the interpreter implements), and what they ask a language (`Language`).

A module that says how calls or attributes work takes an `Engine`, and names no module that implements it. What a language means by an
attribute, a call or a truth stands in its record; `engine/languages.py` lists them. One engine, one heap, one schedule and one log serve all:

    the code that runs asks its own language (`machine.language`): p->name, x == y, if (count)
    who is called decides what a call does with its arguments (`machine.languages[function.code.language]`)
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Any, Protocol, final

from rosward.engine.sources.shared import Shared
from rosward.models.native import Machine
from rosward.records import dataclass

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.series import Series
    from rosward.domain.state import State
    from rosward.domain.values import Class, Function, ModuleValue, Ref, Value
    from rosward.effects.log import EntityEffect
    from rosward.effects.sent import SentEffect
    from rosward.engine.budget import Budget
    from rosward.engine.running.attributes_asked import AttributeNames
    from rosward.engine.running.catcher import Catcher
    from rosward.engine.running.frame import Frame, Snapshot
    from rosward.engine.running.precision import Precision
    from rosward.engine.running.schedule_book import Schedule
    from rosward.engine.running.scheduled import Scheduled
    from rosward.engine.running.stepped import Resumption, Running, Stepped
    from rosward.engine.running.summaries import Summaries
    from rosward.engine.running.trace import Trace
    from rosward.engine.running.ways import Way
    from rosward.ir import ops
    from rosward.ir.program import Code
    from rosward.location import Place
    from rosward.models.native import Items, ResumptionKind


class Watcher(Protocol):
    """Notes what is seen of a program while it runs (`watch.py`)."""

    def watching(self, language: Language) -> Language:
        """The language, noting what its operations do."""

    def schedule(self, machine: Engine, entry: Scheduled) -> None:
        """A callback is registered here."""

    def gave_up(self, op: ops.Op, frame: Frame) -> None:
        """What an operation makes is too large to keep; control goes on behind it."""

    def effect(self, machine: Engine, effect: EntityEffect | SentEffect) -> None:
        """An entity is created, or a message sent, here."""

    def summary(self, machine: Engine, code: Code, context: int) -> None:
        """The result of a call is taken from the summary of the function, which runs in a context of its own."""

    def remember(self, key: object, code: Code, context: int) -> None:
        """The result of a call is remembered."""

    def recalled(self, machine: Engine, code: Code, context: int) -> None:
        """A call does what it did before in that context."""

    def again(self, machine: Engine, key: object) -> None:
        """What is remembered of a call is its result once more."""

    def wrote(self, address: int) -> None:
        """The object at an address is written to."""

    def made(self, address: int, site: object) -> None:
        """An object is made, of what the site says."""

    def bound(self, machine: Engine, function: Function, args: tuple[Value, ...], registers: list[Value]) -> None:
        """A function in C++ is called with these arguments, which stand in its registers so."""

    def native(self, name: str) -> None:
        """A model in code runs."""

    def strange(self, name: str) -> None:
        """Code that nobody knows gets hold of something."""

    def swallows(self, machine: Engine) -> None:
        """The `with` that is running may swallow an exception."""


class Engine(Machine, Protocol):
    """What runs the code of one process: its state, and each question that one module of the engine asks another."""

    state: State
    frames: list[Frame]
    catchers: list[Catcher]
    schedule_book: Schedule
    precision: Precision
    trace: Trace
    summaries: Summaries
    making: list[Class]
    unhooked: set[int] | None
    hooked: bool
    choosing: int
    refused: list[str]
    noted: int
    handling: list[tuple[Value, int]]
    unheld: set[int]
    declarations: dict[object, tuple[int, ...]]
    ended: set[int]
    returned: set[int]
    lasting: set[int]
    inner: dict[int, int]
    missed: set[int]
    ended_at: dict[Place, Value]
    advancing: dict[int, Running]
    ways: dict[str, dict[int, Way]]
    ends: State | None
    watch: Watcher | None
    """Who notes what is seen of the program; None where nobody asks."""
    attribute_names: AttributeNames
    asked_for: set[int]
    """The addresses whose records were read, and questions (`attributes_asked.py`, `nodes_asked.py`). Who wants to know which are from now on
    empties it."""
    language: Language
    """That of the code that runs."""
    linked: object
    """What a language with a linker keeps of the program that runs."""

    @property
    def library(self) -> Shared:
        """What all processes share."""

    @property
    def budget(self) -> Budget:
        """How much the process may take."""

    @property
    def languages(self) -> Mapping[str, Language]:
        """Every language that code may be written in, by its name."""

    def run_module(self, module: ModuleValue, name: str, turn: int = 0) -> bool:
        """Run the top level of a module as its language does; False where it does not come to its end."""

    def run(self, block: ops.Block, frame: Frame) -> bool:
        """Interpret a block; False where control does not come out at its end."""

    def give_up_value(self, op: ops.Op, frame: Frame) -> None:
        """What an operation makes is too large to keep: its result is not known."""

    def check_time(self) -> None:
        """Raise where the process has used up its time."""

    def context(self, *key: object) -> int:
        """The number of a context."""

    def snapshot(self, frame: Frame) -> Snapshot:
        """An independent copy of where we are."""

    def resume(self, frame: Frame, snapshot: Snapshot) -> None:
        """Go on from a snapshot (which is used up)."""

    def part(self, ref: Ref, name: str) -> Obj:
        """The record behind a reference, of which nothing is read but this attribute, and what tells how it is read."""

    def at(self, address: int) -> Obj:
        """The record at an address."""

    def own(self, address: int) -> Obj | None:
        """The record that this process has at an address; None where it has none."""

    def put(self, address: int, obj: Obj) -> None:
        """Replace the record at an address."""

    def place_key(self, key: object) -> int:
        """The address that belongs to a key."""

    def place_at(self, key: object, obj: Obj) -> int:
        """Put a new object at the address that belongs to a key; a second one there makes the record stand for both."""

    def place_anew(self, address: int, obj: Obj) -> None:
        """Put a new object at an address, beside those that stand there already."""

    def place_instead(self, key: object, obj: Obj) -> int:
        """Put a new object at the address that belongs to a key, instead of what stood there, which nobody has any more."""

    def new_cells(self, code: Code, context: int) -> list[int]:
        """Fresh cells for the captured variables of a code body."""

    def call_method(self, value: Value, name: str, args: tuple[Value, ...]) -> Value:
        """value.name(*args)."""

    def make_generator(self, function: Function, registers: list[Value]) -> Ref:
        """What a call of a generator function or coroutine gives."""

    def advance(self, ref: Ref, action: Resumption) -> Stepped:
        """Resume a suspended generator."""

    def run_out(self, ref: Ref) -> tuple[Items, Value]:
        """Run a generator or coroutine to its end: what it yields, what it returns."""

    def handles(self, exception: Value, level: int) -> AbstractContextManager[None]:
        """A handler runs for these exceptions (UNBOUND: none that is known), and where there is a level for others that are not known."""

    def uncaught(self, exception: Value) -> None:
        """Nothing around catches this exception, which is raised here."""

    def schedule(
        self,
        callback: Value,
        args: Sequence[Value] | None,
        event: str,
        place: Place | None = None,
        *,
        answered: Value | None = None,
    ) -> None:
        """A callback may run from now on, with these arguments, or (None) with anything; registered here, unless another place is given."""

    def may_call(self, values: Sequence[Value]) -> None:
        """A described library may call those that are functions."""


Handler = Callable[[Any, Any, Any], "bool | None"]
"""What an operation does: None where control goes on, False where it does not. Takes the machine, the operation and the frame."""


@final
@dataclass(frozen=True, slots=True)
class Language:
    """What a language means by the operations of the core, and by what natives ask. UNBOUND for a value: no execution goes on there.

    `table` has the handler of each operation by its class: those of the core (`transfer.CORE`), and the language's own. Where a language means by
    an operation of the core something that this record cannot say, its table has another handler for it.
    C++ adds to its table what it alone has: references to places, copies by value, conversions to the type of a variable, the end of a scope.
    Overloads and template arguments are a matter of `call_with`, which is given the arguments as they are written.
    """

    name: str
    table: Mapping[type[ops.Op], Handler]
    run_noting: Callable[[Engine, ops.Block, Frame], bool] | None
    """Run a block inside of a `try`: what its operations may raise is noted, and what is written behind one that may is seen by handlers.

    None where calls alone raise, and say so themselves.
    """
    situation: Callable[[Engine], object]
    """What a call depends on beside its arguments and the state: in C++, which objects are being constructed, and as what."""
    instance: Callable[[Engine, Function, Sequence[Value]], object]
    """Which of the bodies that are made of one code a call runs: those of a template are told apart by its arguments."""
    cells_outlive: bool
    """Whether a variable may be used when the call that has it has ended."""
    recalls: bool
    """Whether a call leaves nothing but its result, records and what it told: then one from the same records need not run again."""

    # Values
    truth: Callable[[Engine, Value], bool | None]
    unary: Callable[[Engine, str, Value], Value]
    binary: Callable[..., Value]
    """Of machine, operator, left, right; `inplace` for an augmented assignment."""
    compare: Callable[[Engine, str, Value, Value], Value]
    may: Callable[[Engine, Value, str, Value | None, bool], bool]
    """Whether a test of a value (see `ops.Assume`) may come out so."""
    is_instance: Callable[[Engine, Value, Value], bool | None]
    is_subclass: Callable[[Engine, Value, Value], bool | None]

    # Attributes and elements
    load_attr: Callable[[Engine, Value, str], Value]
    store_attr: Callable[[Engine, Value, str, Value], bool]
    keep_attr: Callable[..., None]
    """Of machine, object, name, value; past all that a program may have put between. `weak`: the old one stays possible."""
    delete_attr: Callable[[Engine, Value, str], None]
    lookup: Callable[[Engine, Value, str], Value | None]
    """What a class and its bases have under a name, as it stands there."""
    bind: Callable[[Engine, Value, Value, Value], Value]
    """What an object of a class has of what was looked up there: a method with its receiver."""
    load_item: Callable[[Engine, Value, Value], Value]
    store_item: Callable[[Engine, Value, Value, Value], None]

    # Calls
    call: Callable[[Engine, Value, tuple[Value, ...], dict[str, Value]], Value]
    call_with: Callable[[Engine, Value, tuple[ops.Argument, ...], list[Value]], Value]
    """A call as it is written."""
    call_native: Callable[[Engine, str, tuple[Value, ...], dict[str, Value]], Value]
    """A builtin, or a model in code, by its name."""
    call_function: Callable[[Engine, Function, tuple[Value, ...], dict[str, Value]], Value]
    """What a function of this language does with arguments, whoever calls it."""
    call_method: Callable[[Engine, Value, str, tuple[Value, ...]], Value]
    is_open: Callable[[Engine, Obj], bool]
    """Whether code that knows nothing of the program may change the attributes of an object that it gets."""
    own_methods: Callable[[Engine, Class, Ref], Iterable[tuple[str, Value]]]
    """The methods that sources, not models, define for an object and that others may call on it: name and bound method."""
    implicit_calls: Callable[[Engine], Iterable[Value]]
    """What the language itself calls, at times that nobody sees: conversions, hooks."""

    # Iteration, and calls that are suspended
    iterate: Callable[[Engine, Value], Items]
    series: Callable[[Engine, Value], Series]
    is_stepped: Callable[[Engine, Value], bool]
    next_of: Callable[[Engine, Value, ResumptionKind, Value, Value | None], Value]
    wait_for: Callable[[Engine, Value], Value]
    make_generator: Callable[[Engine, Function, list[Value]], Ref]
    advance: Callable[[Engine, Ref, Resumption], Stepped]
    run_out: Callable[[Engine, Ref], tuple[Items, Value]]
    close_generator: Callable[[Engine, Ref], None]

    # Modules and their variables
    run_module: Callable[[Engine, ModuleValue, str, int], bool]
    run_packages: Callable[[Engine, ModuleValue], bool]
    """Run what has to be run before a module that an entry point names."""
    load_module: Callable[[Engine, str, Frame | None, int], Value]
    load_asked: Callable[[Engine, str, Frame | None, int], Value]
    """The same, where the program asks for it: it may fail."""
    load_global: Callable[[Engine, ModuleValue, str], Value]
    """A name that is no variable of a module."""
    variables: Callable[..., Value | None]
    """Of machine; `local`: of the call that runs, else of its module."""

    # Exceptions
    raised: Callable[[Engine, Value], Value]
    """The exception that `raise value` raises, with what it follows from."""
    class_of: Callable[[Engine, Value], Value]
    fail: Callable[..., Value]
    builtin_error: Callable[[Engine, str, Sequence[Value] | None], Value]
    guarded: Callable[..., tuple[Value, bool]]
    unwind: Callable[[Engine, Sequence[Value], Value], Value]


class SharedLanguages(Shared, Protocol):
    """What all processes share, and which languages there are."""

    @property
    def languages(self) -> Mapping[str, Language]:
        """What each language means by its operations, by its name."""

    def language_of(self, module: ModuleValue) -> Language:
        """That of the file of a module; of one without a file, that of the models."""
