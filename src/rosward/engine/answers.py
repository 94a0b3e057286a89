# SPDX-License-Identifier: Apache-2.0
"""What natives and the modules of the engine ask the interpreter: each question goes to the language of the code that runs, or to one module."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, UNBOUND, Function, ModuleValue, Ref, Unknown, Value
from rosward.engine import throwing
from rosward.engine.callbacks import schedule
from rosward.engine.running import nodes_asked
from rosward.engine.running.frame import is_running, own_frame
from rosward.engine.unknown import escape
from rosward.findings import Finding
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.effects.log import NodeEffect
    from rosward.engine.machine import Engine
    from rosward.engine.running.stepped import Resumption, Stepped
    from rosward.ir.program import Code
    from rosward.models.file_paths import Files
    from rosward.models.native import Items, ResumptionKind
    from rosward.source.definitions import Definition

_LONGEST_PATH: Final = 12
MAX_LOADS: Final = 16
"""How many modules are made of one file that is loaded by its path."""

_HIDING: Final = frozenset({"RW203", "RW208"})
"""Findings that something is done of which it is not known what: set an attribute, make a class or an entity of a node."""


class Answers:
    """The answers of an engine that delegates; the interpreter is one."""

    def call(
        self: Engine, function: Value, args: Sequence[Value], keywords: Mapping[str, Value] | None = None
    ) -> Value:
        """Call a value."""
        return self.language.call(self, function, tuple(args), dict(keywords) if keywords else {})

    def call_native(
        self: Engine, name: str, args: Sequence[Value], keywords: Mapping[str, Value] | None = None
    ) -> Value:
        """Call a builtin, or a model in code, on nobody's behalf: the program does not see it."""
        return self.language.call_native(self, name, tuple(args), dict(keywords) if keywords else {})

    def call_method(self: Engine, value: Value, name: str, args: tuple[Value, ...]) -> Value:
        """value.name(*args)."""
        return self.language.call_method(self, value, name, args)

    def wait_for(self: Engine, value: Value) -> Value:
        """`await value`."""
        return self.language.wait_for(self, value)

    def make_generator(self: Engine, function: Function, registers: list[Value]) -> Ref:
        """What a call of a generator function or coroutine gives."""
        return self.language.make_generator(self, function, registers)

    def advance(self: Engine, ref: Ref, action: Resumption) -> Stepped:
        """Resume a suspended generator."""
        return self.language.advance(self, ref, action)

    def run_out(self: Engine, ref: Ref) -> tuple[Items, Value]:
        """Run a generator or coroutine to its end: what it yields, what it returns."""
        return self.language.run_out(self, ref)

    def close_generator(self: Engine, ref: Ref) -> None:
        """`generator.close()`."""
        self.language.close_generator(self, ref)

    def next_of(
        self: Engine, iterator: Value, kind: ResumptionKind, value: Value, default: Value | None = None
    ) -> Value:
        """The next item of an iterator, or the default, else StopIteration."""
        return self.language.next_of(self, iterator, kind, value, default)

    def is_stepped(self: Engine, value: Value) -> bool:
        """Whether a value is followed step by step where it is iterated over."""
        return self.language.is_stepped(self, value)

    def throw(self: Engine, exception: Value) -> None:
        """An exception is raised here for sure."""
        throwing.throw(self, self.language.raised(self, exception))

    @contextmanager
    def handles(self: Engine, exception: Value, level: int) -> Iterator[None]:
        """A handler runs for these exceptions (UNBOUND: none that is known), and where there is a level for others that are not known."""
        self.handling.append((exception, level))
        try:
            yield
        finally:
            self.handling.pop()

    @property
    def handled(self: Engine) -> Value:
        """The exception that is being handled; None where there is none."""
        if not self.handling:
            return NONE
        known, level = self.handling[-1]
        return known if not level else join(known, throwing.unseen(self))

    def uncaught(self: Engine, exception: Value) -> None:
        """Nothing around catches this exception, which is raised here."""
        schedule.uncaught(self, exception)
        if not self.schedule_book.running:
            cls = self.language.class_of(self, exception)
            self.ended_at[self.place] = join(self.ended_at.get(self.place, UNBOUND), cls)

    def guarded(self: Engine, action: Callable[[], Value], error: str, *, unseen: bool = True) -> tuple[Value, bool]:
        """What an action gives, and whether it may raise a builtin exception, which goes no further."""
        return self.language.guarded(self, action, error, unseen=unseen)

    def unwind(self: Engine, exits: Sequence[Value], exception: Value) -> Value:
        """Call the exits of a stack of context managers."""
        return self.language.unwind(self, exits, exception)

    def new_cells(self: Engine, code: Code, context: int) -> list[int]:
        """Fresh cells for the captured variables of a code body."""
        if not code.cells:
            return []
        keys = [("cell", context, code.key, n) for n in range(len(code.cells))]
        outlive = self.languages[code.language].cells_outlive
        if outlive or is_running(self.frames, code, context):
            return [self.place_at(key, Obj("cell", NONE)) for key in keys]
        return [self.place_instead(key, Obj("cell", NONE)) for key in keys]

    def place_instead(self: Engine, key: object, obj: Obj) -> int:
        """Put a new object at the address that belongs to a key, instead of what stood there, which nobody has any more."""
        address = self.place_key(key)
        self.put(address, obj)
        self.unheld.discard(address)
        self.summaries.fresh.add(address)
        return address

    def is_node(self: Engine, address: int) -> bool:
        """Whether the object at an address is a node."""
        self.asked_for.add(nodes_asked.question(address))
        return self.log.count_at(address) > 0

    def nodes_at(self: Engine, addresses: Collection[int] | None) -> list[NodeEffect]:
        """The nodes at some addresses (None: all), in the order in which they were recorded."""
        if addresses is None:
            self.asked_for.add(nodes_asked.ALL)
            return list(self.log.nodes)
        self.asked_for.update(map(nodes_asked.question, addresses))
        return self.log.nodes_at(addresses)

    def load_attr(self: Engine, value: Value, name: str) -> Value:
        """value.name."""
        return self.language.load_attr(self, value, name)

    def store_attr(self: Engine, target: Value, name: str, value: Value) -> None:
        """target.name = value."""
        self.language.store_attr(self, target, name, value)

    def keep_attr(self: Engine, owner: Ref, name: str, value: Value, *, weak: bool = False) -> None:
        """owner.__dict__[name] = value; UNBOUND: `del` of that."""
        self.language.keep_attr(self, owner, name, value, weak=weak)

    def delete_attr(self: Engine, target: Value, name: str) -> None:
        """del target.name."""
        self.language.delete_attr(self, target, name)

    def load_item(self: Engine, value: Value, index: Value) -> Value:
        """value[index]."""
        return self.language.load_item(self, value, index)

    def store_item(self: Engine, target: Value, index: Value, value: Value) -> None:
        """target[index] = value."""
        self.language.store_item(self, target, index, value)

    def binary(self: Engine, operator: str, left: Value, right: Value) -> Value:
        """left operator right."""
        return self.language.binary(self, operator, left, right, inplace=False)

    def compare(self: Engine, operator: str, left: Value, right: Value) -> Value:
        """left operator right."""
        return self.language.compare(self, operator, left, right)

    def iterate(self: Engine, value: Value) -> Items:
        """What iterating yields."""
        return self.language.iterate(self, value)

    def series(self: Engine, value: Value) -> Series:
        """What iterating yields, as far as the order is known."""
        return self.language.series(self, value)

    def truth(self: Engine, value: Value) -> bool | None:
        """The truth of a value, None for both."""
        return self.language.truth(self, value)

    def is_instance(self: Engine, value: Value, wanted: Value) -> bool | None:
        """isinstance(value, wanted)."""
        return self.language.is_instance(self, value, wanted)

    def is_subclass(self: Engine, cls: Value, wanted: Value) -> bool | None:
        """issubclass(cls, wanted)."""
        return self.language.is_subclass(self, cls, wanted)

    def unknown(self: Engine, cause: Cause, subject: str, hint: str = "") -> Unknown:
        """An unknown that arises here."""
        return Unknown((Reason(cause, subject, self.place),), hint)

    def may_call(self: Engine, values: Iterable[Value]) -> None:
        """A described library may call those that are functions."""
        escape.may_call(self, values)

    def escape(self: Engine, values: Iterable[Value], library: str, callee: Value | None = None) -> None:
        """Values reach unknown code."""
        escape.escape(self, values, library, callee)

    def schedule(
        self: Engine,
        callback: Value,
        args: Sequence[Value] | None,
        event: str,
        place: Place | None = None,
        *,
        answered: Value | None = None,
    ) -> None:
        """A callback may run from now on, with these arguments, or (None) with anything; registered here, unless another place is given."""
        schedule.add(self, callback, None if args is None else tuple(args), event, place, answered)

    def spin(self: Engine, *, serving: bool = False) -> None:
        """Everything scheduled may run here."""
        schedule.spin(self, serving=serving)

    def waits(self: Engine, *, suspended: bool = False, others: bool = False) -> None:
        """The program waits here for something that takes time; `others`: or for one of those that run beside it."""
        schedule.waits(self, suspended=suspended, others=others)

    def variables(self: Engine, *, local: bool) -> Value:
        """What `locals()` or `globals()` gives here."""
        self.summaries.asked += local  # it looks at all registers, of which nobody else knows
        found = self.language.variables(self, local=local)
        return self.unknown(Cause.LIVE, "variables", "dict") if found is None else found

    def report(self: Engine, code: str, message: str, causes: tuple[str, ...] = ()) -> None:
        """A finding at the current place."""
        self.log.findings.add(Finding(code, message, self.place, causes))
        if code in _HIDING:
            self.precision.note_unknown()

    def die(
        self: Engine,
        error: str,
        message: str,
        args: Sequence[Value] | None = None,
        *,
        sure: bool = False,
        plain: bool = False,
    ) -> Value:
        """This path raises here: it ends where that is what the program wants (SystemExit), or waits for. Any other failure of a builtin
        is taken as a value that is not known: what fails for the values that we see (a default list too short) may go well for others."""
        if error not in ("SystemExit", "StopIteration"):
            return self.language.fail(self, error, f"{error}: {message}", args, sure=sure, plain=plain)
        throwing.throw(self, self.language.builtin_error(self, error, args))
        return UNBOUND

    @property
    def place(self: Engine) -> Place:
        """The innermost place in the user's code."""
        frame = own_frame(self.frames)
        return Place("", 0) if frame is None else frame.place

    @property
    def path(self: Engine) -> tuple[Place, ...]:
        """The calls in the user's code that lead here, outermost first; of a longer chain the innermost."""
        own = [frame for frame in self.frames if not frame.stub][-_LONGEST_PATH:]
        return tuple(frame.place for frame in own)

    @property
    def in_callback(self: Engine) -> bool:
        """Whether something that was scheduled is running, not the main body."""
        return self.schedule_book.running

    @property
    def is_tried(self: Engine) -> bool:
        """Whether a `try` or `with` is running around."""
        return bool(self.catchers)

    @property
    def is_sure(self: Engine) -> bool:
        """Whether no branch around leaves open whether this runs."""
        return not any(f.uncertain for f in self.frames)

    @property
    def is_alternative(self: Engine) -> bool:
        """Whether what runs is done for one of several alternatives, so that it may not be what is done."""
        return bool(self.precision.apart)

    @property
    def language_name(self: Engine) -> str:
        """The name of the language that runs."""
        return self.language.name

    @property
    def environment(self: Engine) -> Mapping[str, Value | None]:
        """What is known of the environment of every process that is not given another."""
        return self.library.environment

    def function_record(self: Engine, function: Function) -> Obj | None:
        """The heap record of a function that was given attributes."""
        return self.own(self.library.function_address(function))

    def interface_definition(self: Engine, dotted: str) -> Definition | None:
        """The fields of a message by the dotted name of its class."""
        return self.library.interface_definition(dotted)

    @property
    def asked(self: Engine) -> set[tuple[str, str, str]]:
        """What may be called without being seen."""
        return self.trace.asked

    @property
    def files(self: Engine) -> Files:
        """The files of the analysed packages."""
        return self.library.sources.files

    @property
    def via(self: Engine) -> str | None:
        """The library function that the user's code called, where the current code is a library's."""
        name: str | None = None
        for frame in reversed(self.frames):
            if not frame.stub:
                break
            name = f"{frame.module.name}.{frame.code.qualname}"
        return name.removesuffix(".__init__") if name else None

    def load_module(self: Engine, name: str, level: int = 0, *, asked: bool = False) -> Value:
        """The module (or external thing) of a dotted name, run if it was not yet; where the program has `asked` for it, that may fail."""
        load = self.language.load_asked if asked else self.language.load_module
        return load(self, name, own_frame(self.frames), level)

    def load_file(self: Engine, file: str, name: str) -> Value | None:
        """The module of a file of the sources in the language of the program, run under a name, each time anew; None where it is none."""
        if not file.endswith(".py") or self.library.module(file) is None:
            return None
        for turn in range(MAX_LOADS):
            module = ModuleValue(self.place_key(("module", file, "by its path", turn)), name, file)
            if self.own(module.address) is None:
                return module if self.run_module(module, name, turn) else UNBOUND
        self.report(
            "RW203", f"{file} is loaded by its path more than {MAX_LOADS} times: what runs again is not analysed"
        )
        return module
