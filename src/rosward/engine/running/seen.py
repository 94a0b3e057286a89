# SPDX-License-Identifier: Apache-2.0
"""What was seen of a program while it was interpreted: which operations ran, what each gave, and whom it called.

self.pub.publish(self.text(msg))     the attribute `pub` was the object at 70; `text` ran, in the activation of `App.text` in this context

An analysis that asks something else of the same program (`flow`) starts from here: it need not find out again what stands where. Where
nobody asks, nothing is noted.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Final, final

from rosward.domain.choice import options, reasons_of
from rosward.domain.compound import BoundMethod, External, Native, Partial, Range, Slice, Tuple
from rosward.domain.slots import Pointer, Slot
from rosward.domain.values import Choice, Class, Const, Function, ModuleValue, Ref, Text, Unknown, Value
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.unknown import Origin, Reason
    from rosward.effects.log import EntityEffect
    from rosward.effects.sent import SentEffect
    from rosward.engine.running.scheduled import Scheduled
    from rosward.ir.program import Code

_DEPTH: Final = 6


Place = int | tuple[object, ...]
"""Where a value leads: the address of an object, or ('slot', address, key, how) for a part of one, as `_placed` says."""
Places = Callable[[Value], Iterator[Place]]


def refs_of(value: Value) -> Iterator[int]:
    """The addresses of the objects that a value is or holds; not those that a function or method is bound to.

    A class stands where its attributes and those of its bases do, a module where its variables do.
    """
    for option in _leaves(value):
        if option.__class__ is Ref or option.__class__ is ModuleValue:
            yield option.address
        elif option.__class__ is Class:
            yield from (c.address for c in option.mro if c.__class__ is Class and not c.stub)
        elif isinstance(option, Slot):
            yield from refs_of(option.base)


def places_of(value: Value) -> Iterator[Place]:
    """The same for a language in which a part of an object has an address: a slot, or a pointer to it, leads to that part."""
    for option in _leaves(value):
        if option.__class__ is Ref:
            yield option.address
        elif isinstance(option, Slot):
            yield from _placed(option)


def _leaves(value: Value, depth: int = 0) -> Iterator[Value]:
    """What a value may be, with what tuples, partial functions and pointers hold in their place."""
    for option in options(value):
        if option.__class__ is Tuple and depth < _DEPTH:
            for item in option.items:
                yield from _leaves(item, depth + 1)
        elif isinstance(option, Partial) and depth < _DEPTH:
            for item in (*option.arguments, *(v for _, v in option.keywords)):
                yield from _leaves(item, depth + 1)
        elif isinstance(option, Pointer):
            yield from _leaves(option.target, depth + 1)
        else:
            yield option


def _placed(slot: Slot) -> Iterator[Place]:
    """A slot: of how much of the object it is known to be, 'one' element, 'any' of them, or a 'part' of one."""
    for base in options(slot.base):
        if isinstance(base, Slot):
            yield from (
                p if isinstance(p, int) else (*p[:3], "any" if p[3] == "any" else "part") for p in _placed(base)
            )
        elif isinstance(base, Ref):
            key = slot.key
            if slot.kind == "cell":
                yield ("slot", base.address, "value", "one")
            elif isinstance(key, str):
                yield ("slot", base.address, key, "one")
            elif key.__class__ is Const and slot.kind != "reverse":
                assert isinstance(key, Const)
                yield ("slot", base.address, key.value, "one" if slot.kind == "item" else "part")
            else:
                yield ("slot", base.address, None, "any")


class Handed(NamedTuple):
    """One argument of a call: in which registers of the caller it stands as it is, and the objects that it is.

    `more`: it is not only these.
    """

    registers: frozenset[int]
    refs: frozenset[int]
    more: bool

    def joined(self, other: Handed) -> Handed:
        """This one or another one that stands in the same registers."""
        return Handed(self.registers, self.refs | other.refs, self.more or other.more)


class Called(NamedTuple):
    """A function that an operation calls, with what."""

    function: Function
    args: tuple[Handed, ...]
    keywords: tuple[tuple[str, Handed], ...]


class Performed(NamedTuple):
    """A native, or what nobody knows, that an operation runs but does not call as it is written, with what; `keys`: which arguments are constants.

    `written`: the operation calls it through a partial function, or with `*`; else something else calls it. Of what nobody knows, the first
    argument is what is called.
    """

    callee: Value
    args: tuple[Handed, ...]
    keywords: tuple[tuple[str, Handed], ...]
    keys: tuple[object, ...]
    written: bool

    @property
    def kind(self) -> object:
        """Those of one kind are told together."""
        handed = (*self.args, *(h for _, h in self.keywords))
        return (self.callee, self.written, tuple([h.registers for h in handed]), *[n for n, _ in self.keywords])

    def joined(self, other: Performed) -> Performed:
        """This one or another of its kind."""
        args = tuple(a.joined(b) for a, b in zip(self.args, other.args, strict=True))
        keywords = tuple((n, a.joined(b)) for (n, a), (_, b) in zip(self.keywords, other.keywords, strict=True))
        keys = tuple(a if a == b else None for a, b in zip(self.keys, other.keys, strict=True))
        return Performed(self.callee, args, keywords, keys, self.written)


class Given(NamedTuple):
    """What stands in one parameter of a function in C++: in which registers of the caller it stood, and where it leads.

    `kind`: 'none' where there is nothing in it, 'place' where it only leads somewhere, else 'value'.
    """

    registers: frozenset[int]
    places: frozenset[Place]
    kind: str


class Bound(NamedTuple):
    """A function in C++ that an operation calls, with what."""

    function: Function
    given: tuple[Given, ...]


_NO_DICT: Final[Any] = MappingProxyType({})
_NO_SET: Final[Any] = frozenset()


@final
class Seen:
    """What was seen of one operation in one activation. There are very many, which hold little: what is not said stands in the class.

    `refs`: the objects that its results are,
    `parts`: those of each of several; `reasons` and `origins`: those of its results; `several`: it gave more than one value.
    `untupled`: what it takes an element of, or takes apart, was something else than a tuple.
    `swallows`: a `with` that may swallow an exception. `opaque`: something that nobody knows, and that may change.
    `effects`: the entities that it creates and what it sends, `scheduled`: the callbacks that it registers, each with the context of the turn.
    `alive`: control came out behind it. `callees`: the functions that it ran, `summaries`: those of which it took a summary.
    `performed`: the natives that it runs but does not call as it is written.
    Of an operation of C++: `bound` are its calls, `made` the objects that it makes, each with what it is made of,
    `wrote` those that it writes to, `natives` the models in code, and `strange` the names of code that nobody knows.
    """

    alive = False
    gave: Value | None = None  # the last value, of an operation that gives one
    called: Value | None = None  # the last function, of a call
    written: tuple[object, ...] | None = None  # the last function of the program, with its arguments
    several = False
    swallows = False
    untupled = False
    opaque = False
    refs: set[Place] = _NO_SET
    cells: set[int] = _NO_SET
    wrote: set[int] = _NO_SET
    parts: dict[int, set[Place]] = _NO_DICT
    reasons: Collection[Reason] = ()
    origins: Collection[Origin] = ()
    externals: dict[str, None] = _NO_DICT
    keys: dict[int, Value | None] = _NO_DICT
    functions: dict[Value, None] = _NO_DICT
    calls: dict[object, Called] = _NO_DICT
    callees: dict[Activation, None] = _NO_DICT
    summaries: dict[tuple[str, int], None] = _NO_DICT
    effects: dict[tuple[int, EntityEffect | SentEffect], None] = _NO_DICT
    scheduled: dict[tuple[int, Scheduled], None] = _NO_DICT
    performed: dict[object, Performed] = _NO_DICT
    bound: dict[object, Bound] = _NO_DICT
    made: dict[int, object] = _NO_DICT
    natives: dict[str, None] = _NO_DICT
    strange: dict[str, None] = _NO_DICT

    def note(self, name: str, key: object, value: object = None) -> None:
        """Something is in one of the dicts from now on."""
        known = getattr(self, name)
        if known is _NO_DICT:
            setattr(self, name, {key: value})
        else:
            known[key] = value

    def perform(self, native: Performed) -> None:
        """A native runs."""
        kind = native.kind
        known = self.performed.get(kind)
        if native != known:
            self.note("performed", kind, native if known is None else known.joined(native))

    def hold(self, name: str, found: Iterable[object]) -> None:
        """These are in one of the sets from now on."""
        known = getattr(self, name)
        if known is not _NO_SET:
            known.update(found)
        elif several := set(found):
            setattr(self, name, several)

    def _say(self, name: str, found: Collection[object]) -> None:
        """These reasons, or origins, are said of its results. Where they are always the same, they are not copied."""
        known = getattr(self, name)
        if not known:
            setattr(self, name, found.copy() if isinstance(found, dict) else found)
        elif known.__class__ is dict:
            known.update(dict.fromkeys(found))
        elif known != found:
            setattr(self, name, dict.fromkeys((*known, *found)))

    def _part(self, number: int, found: Iterable[Place]) -> None:
        """The objects that one of several results is."""
        if self.parts is _NO_DICT:
            self.parts = {}
        self.parts.setdefault(number, set()).update(found)

    def absorb(self, other: Seen) -> None:
        """What was seen of the same operation in another activation counts too."""
        for name, found in vars(other).items():
            if name in _FLAGS:
                if found:
                    setattr(self, name, True)
            elif name in _SETS:
                self.hold(name, found)
            elif name in _SAID:
                self._say(name, found)
            elif name in _GATHERED:
                known = getattr(self, name)
                if known is _NO_DICT:
                    setattr(self, name, found.copy())
                else:
                    known.update(found)
        for number, refs in other.parts.items():
            self._part(number, refs)
        for register, value in other.keys.items():
            self.note("keys", register, value if self.keys.get(register, value) == value else None)
        for native in other.performed.values():
            self.perform(native)

    def key(self, register: int, value: Value) -> None:
        """The operation finds a value in a register that may name a slot: what it is, where it is always the same constant."""
        keys = self.keys
        if keys is _NO_DICT:
            keys = self.keys = {}
        known = keys.get(register, value)
        if known is not None:
            settled = value.__class__ is Const and value.is_settled
            keys[register] = value if settled and known == value else None

    def constant(self, register: int) -> object:
        """The constant that a register always holds here; None where it does not."""
        found = self.keys.get(register)
        return found.value if isinstance(found, Const) else None

    def give(self, value: Value, places: Places = refs_of) -> None:
        """The operation gave this value. Often it is the one that it gave before, or the same made anew."""
        before, self.gave = self.gave, value
        if value is before or (value.__class__ in _COMPARED and value == before):
            return
        if value.__class__ is Ref:
            if before.__class__ is not Ref or before.address != value.address:
                self._give(value, places)
            return
        for option in options(value):
            self._give(option, places)
        if value.__class__ is Text:
            self._say("reasons", reasons_of(value))

    def give_several(self, values: Iterable[Value], places: Places = refs_of) -> None:
        """The operation gave these values, each its own result."""
        for number, value in enumerate(values):
            self._part(number, places(value))
            self.give(value, places)

    def _give(self, value: Value, places: Places) -> None:
        """One of the alternatives. Most say one thing."""
        if value.__class__ is Ref:
            if self.refs is _NO_SET:
                self.refs = {value.address}
            else:
                self.refs.add(value.address)
        elif value.__class__ is Unknown:
            if value.hint not in _UNCHANGING:
                self.opaque = True
            if value.reasons != self.reasons:
                self._say("reasons", value.reasons)
        elif value.__class__ is Const or value.__class__ is Text:
            if value.origins:
                self._say("origins", value.origins)
        elif value.__class__ is External:
            self.note("externals", value.name)
        elif value.__class__ not in SILENT:
            self.hold("refs", places(value))


_UNCHANGING: Final = frozenset(("str", "int", "float", "bool", "bytes", "complex", "NoneType"))
"""Types whose objects never change."""
SILENT: Final = frozenset((BoundMethod, Function, Native, Range, Slice))
"""Values of which nothing is noted: they are no object, and hold none as a part."""
_COMPARED: Final = frozenset((Choice, Tuple))
"""Values that are compared more quickly than looked through."""
_FLAGS: Final = frozenset(("alive", "several", "swallows", "untupled", "opaque"))
_SETS: Final = frozenset(("refs", "cells", "wrote"))
_SAID: Final = frozenset(("reasons", "origins"))
_GATHERED: Final = frozenset(
    (
        *("effects", "externals", "scheduled", "functions", "calls", "callees", "summaries"),
        *("bound", "made", "natives", "strange"),
    )
)


REACHED: Final = Seen()
"""Of all operations of which nothing more is seen than that they ran."""
ALIVE: Final = Seen()
"""The same of those behind which control came out."""
ALIVE.alive = True


@final
class Activation:
    """What was seen of one body in one context, whenever it ran there."""

    __slots__ = ("begun", "cells", "code", "context", "module", "names", "seen")

    def __init__(self, code: Code, context: int, cells: tuple[int, ...], module: int) -> None:
        self.code = code
        self.module = module  # the address of its variables
        self.context = context
        self.cells = cells
        self.seen: dict[int, Seen] = {}
        self.names: set[int] = set()  # the classes whose names it defines
        self.begun: list[set[Place]] = []  # where its parameters lead, of a body in C++

    def of(self, number: int) -> Seen:
        """That of an operation, by its number, to note something of it."""
        found = self.seen.get(number)
        if found is None or found is REACHED:
            found = self.seen[number] = Seen()
        elif found is ALIVE:
            found = self.seen[number] = Seen()
            found.alive = True
        return found

    def __repr__(self) -> str:
        return f"Activation({self.code.qualname}, {self.context})"
