# SPDX-License-Identifier: Apache-2.0
"""The protocol between the engine and a model in code.

A native is a function of a `NativeCall` that returns an abstract value. It is found by its dotted name in one of the tables
(`NATIVES` of the modules beside this one): functions as `os.path.join`, methods of builtin types as `str.join` (the receiver comes first).

    def str_upper(call: NativeCall) -> Value:
        return lift_text(call.args[0], str.upper)
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence, Sized
from typing import TYPE_CHECKING, Literal, Protocol, SupportsIndex, final, overload

from rosward.domain.choice import reasons_of
from rosward.domain.unknown import Cause
from rosward.effects.log import Execution
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.domain.series import Series
    from rosward.domain.unknown import Reason
    from rosward.domain.values import Function, Ref, Value
    from rosward.effects.log import EffectLog, NodeEffect
    from rosward.models.file_paths import Files
    from rosward.source.definitions import Definition


class Items(NamedTuple):
    """What iterating over a value yields: `known` in order, then any number of `rest` (None: no more)."""

    known: tuple[Value, ...]
    rest: Value | None = None


class Callbacks(Protocol):
    """What was scheduled so far, as natives ask for it."""

    parallel: bool  # something may run while a callback waits
    threads: bool  # an executor or a pool has several threads

    @property
    def entries(self) -> Sized:
        """All that may be called."""

    @property
    def was_run(self) -> bool:
        """Whether the program was somewhere where its callbacks run."""

    @property
    def main_raised(self) -> Value:
        """The exceptions by which the main body may end."""

    @property
    def threads_raised(self) -> Value:
        """Those that threads do not catch."""


ResumptionKind = Literal["next", "send", "throw", "close"]
"""How a suspended generator goes on."""


class Machine(Execution, Protocol):
    """What the engine offers to a native. All of it acts on the current state of the interpretation."""

    choosing: int
    """Of how many alternatives what is being called is one; 0 where it is the only one."""
    raised: int
    """How many exceptions were raised so far: a call in which it grows is not remembered."""

    @property
    def is_alternative(self) -> bool:
        """Whether what runs is done for one of several alternatives, so that it may not be what is done."""

    @property
    def language_name(self) -> str:
        """The name of the language that runs, as `ir.program` has it."""

    @property
    def log(self) -> EffectLog:
        """What the process does to ROS, and what is worth telling."""

    def nodes_at(self, addresses: Collection[int] | None) -> list[NodeEffect]:
        """The nodes at some addresses (None: all), in the order in which they were recorded."""

    @property
    def environment(self) -> Mapping[str, Value | None]:
        """What is known of the environment of every process that is not given another."""

    @property
    def schedule_book(self) -> Callbacks:
        """What may run later."""

    @property
    def asked(self) -> set[tuple[str, str, str]]:
        """What may be called without being seen: file, class and name, '' for any."""

    @property
    def via(self) -> str | None:
        """The library function that the user's code called, where the current code is a library's."""

    @property
    def handled(self) -> Value:
        """The exception that is being handled; None where there is none."""

    @property
    def is_tried(self) -> bool:
        """Whether a `try` or `with` around the call would see an exception."""

    @property
    def is_sure(self) -> bool:
        """Whether no branch around the call leaves open whether it runs."""

    def call(self, function: Value, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        """Call a value; returns what it returns (`Unbound` where no execution returns)."""

    def call_native(self, name: str, args: Sequence[Value], keywords: Mapping[str, Value] | None = None) -> Value:
        """Call a builtin, or a model in code, on nobody's behalf: the program does not see it."""

    def load_attr(self, value: Value, name: str) -> Value:
        """value.name."""

    def store_attr(self, target: Value, name: str, value: Value) -> None:
        """target.name = value."""

    def keep_attr(self, owner: Ref, name: str, value: Value, *, weak: bool = False) -> None:
        """owner.__dict__[name] = value; UNBOUND: `del` of that."""

    def delete_attr(self, target: Value, name: str) -> None:
        """del target.name."""

    def load_item(self, value: Value, index: Value) -> Value:
        """value[index]."""

    def store_item(self, target: Value, index: Value, value: Value) -> None:
        """target[index] = value."""

    def guarded(self, action: Callable[[], Value], error: str, *, unseen: bool = True) -> tuple[Value, bool]:
        """What an action gives, and whether it may raise a builtin exception, which goes no further; `unseen`: or any operation may."""

    def binary(self, operator: str, left: Value, right: Value) -> Value:
        """left operator right."""

    def compare(self, operator: str, left: Value, right: Value) -> Value:
        """left operator right."""

    def iterate(self, value: Value) -> Items:
        """What `for x in value` sees (runs generators)."""

    def series(self, value: Value) -> Series:
        """The same, as far as the order is known."""

    def is_stepped(self, value: Value) -> bool:
        """Whether `for x in value` follows it step by step: a generator, or an object with `__next__`."""

    def next_of(self, iterator: Value, kind: ResumptionKind, value: Value, default: Value | None = None) -> Value:
        """Advance an iterator (`kind`: next, send or throw, with `value`): its next item; at its end the default, else StopIteration."""

    def close_generator(self, ref: Ref) -> None:
        """`generator.close()`."""

    def throw(self, exception: Value) -> None:
        """An exception is raised here for sure."""

    def unwind(self, exits: Sequence[Value], exception: Value) -> Value:
        """Call the exits of a stack of context managers."""

    def wait_for(self, value: Value) -> Value:
        """`await value`."""

    def load_module(self, name: str, level: int = 0, *, asked: bool = False) -> Value:
        """The module of a dotted name, run if it was not yet; where the program has `asked` for it, that may fail."""

    def load_file(self, file: str, name: str) -> Value | None:
        """The module of a file of the sources in the language of the program, run under a name, each time anew; None where it is none."""

    def truth(self, value: Value) -> bool | None:
        """The truth of a value; None where both are possible (also for constants that stem from a mere default)."""

    def is_instance(self, value: Value, classes: Value) -> bool | None:
        """isinstance(value, classes)."""

    def is_subclass(self, cls: Value, wanted: Value) -> bool | None:
        """issubclass(cls, wanted)."""

    def function_record(self, function: Function) -> Obj | None:
        """The heap record of a function that was given attributes."""

    def update(self, ref: Ref, obj: Obj) -> None:
        """Replace the heap record (a weak update where it stands for several objects)."""

    def allocate(self, obj: Obj, site: object = None, *, counted: bool = True) -> Ref:
        """A new object on the heap; `site` tells apart what one call makes in no fixed order (alone, where they are not `counted`)."""

    def new_list(self, items: Iterable[Value], rest: Value | None = None, tail: tuple[Value, ...] = ()) -> Ref:
        """A new list: of items, then any number of `rest`, then `tail`."""

    def new_set(self, items: Iterable[Value], rest: Value | None = None) -> Ref:
        """A new set."""

    def new_dict(self, entries: Mapping[Value, Value], rest: Value | None = None) -> Ref:
        """A new dict; `rest` joins the values under unknown keys."""

    def place_inner(self, owner: Ref, name: str, obj: Obj, *, again: bool) -> Ref:
        """The object that belongs to an attribute of another one: made where there is none yet; `again`: it stands for this one too."""

    def interface_definition(self, dotted: str) -> Definition | None:
        """The fields of a message by the dotted name of its class; None where they are not known."""

    def escape(self, values: Iterable[Value], library: str, callee: Value | None = None) -> None:
        """The values reach code that is not known: callables may be called, contents change, nodes may get entities (a finding)."""

    def schedule(self, callback: Value, args: Sequence[Value], event: str, *, answered: Value | None = None) -> None:
        """Something (a timer, a message, a thread) may call `callback` from now on, any number of times; `answered` is given its results."""

    def spin(self, *, serving: bool = False) -> None:
        """Everything that is scheduled may run here, in any order, any number of times; `serving`: because the client library spins."""

    def waits(self, *, suspended: bool = False, others: bool = False) -> None:
        """The program waits here: if one of its threads spins, everything that is scheduled may run. `suspended`: as a coroutine does.

        `others`: so it may if there is any thread, or a library that calls what it was given.
        """

    def variables(self, *, local: bool) -> Value:
        """What `locals()` or `globals()` gives where the call stands: a dict."""

    def spend(self, steps: int) -> None:
        """What is about to be computed takes as long as this many steps; raises where the budget has fewer left."""

    def die(
        self,
        error: str,
        message: str,
        args: Sequence[Value] | None = None,
        *,
        sure: bool = False,
        plain: bool = False,
    ) -> Value:
        """This path raises the builtin exception `error` here, with these arguments where they are known.

        `sure`: no operand is a mere default; `plain`: all are constants. Returns `Unbound`, or an unknown value where the path goes on.
        """

    @property
    def files(self) -> Files:
        """The files of the analysed packages."""


class MissingArgumentError(Exception):
    """A native reads an argument that the call does not give: a TypeError of the program."""


@final
class Arguments(tuple["Value", ...]):
    """Positional arguments. No native reads one that is not there: that ends it, and is told apart from its own faults."""

    __slots__ = ()

    @overload
    def __getitem__(self, index: SupportsIndex, /) -> Value: ...
    @overload
    def __getitem__(self, index: slice, /) -> tuple[Value, ...]: ...
    def __getitem__(self, index: SupportsIndex | slice, /) -> Value | tuple[Value, ...]:
        try:
            return tuple.__getitem__(self, index)
        except IndexError:
            raise MissingArgumentError from None


class NativeCall(NamedTuple):
    """One call of a native: its arguments bound to nothing yet (a receiver is args[0]).

    `loose` joins further arguments, of unknown number and name (`f(*unknown)`); the keywords in `unsure` may not be there.
    """

    machine: Machine
    name: str
    args: tuple[Value, ...]
    keywords: dict[str, Value]
    loose: Value | None = None
    unsure: frozenset[str] = frozenset()

    def arg(self, index: int, name: str, default: Value | None = None) -> Value | None:
        """The argument that is positional at `index` or named `name`, else default."""
        if index < len(self.args):
            return self.args[index]
        return self.keywords.get(name, default)

    def exactly(self, count: int) -> tuple[Value, ...]:
        """The positional arguments of a native that takes so many; fewer are a TypeError of the program."""
        if len(self.args) < count:
            raise MissingArgumentError
        return self.args[:count]

    def reasons(self, *values: Value) -> tuple[Reason, ...]:
        """The reasons for which any of the values is unknown, for a result computed from them."""
        return tuple(dict.fromkeys(r for v in values for r in reasons_of(v)))


NativeFunction = Callable[[NativeCall], "Value"]


def perform(native: NativeFunction, call: NativeCall) -> Value:
    """What a native gives; a call without an argument that it reads is a TypeError, or not known where there may be more arguments."""
    try:
        return native(call if call.args.__class__ is Arguments else call._replace(args=Arguments(call.args)))
    except MissingArgumentError:
        machine, name = call.machine, call.name.removeprefix("builtins.")
        if call.loose is None and not call.unsure:
            return machine.die("TypeError", f"{name}() is called with too few arguments")
        machine.escape((*call.args, *call.keywords.values()), name)
        return machine.unknown(Cause.CALL, name)
