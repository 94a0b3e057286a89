# SPDX-License-Identifier: Apache-2.0
"""Computing with constants as Python itself does, and with alternatives one by one.

    evaluate(machine, "upper", str.upper, (Const('a'),))        Const('A')
    spread(f, Choice(a, b), c)                                  join of f(a, c) and f(b, c); one that raises is left out

What the analysed program raises travels as `Raised` through these models; `native` and `operation` end the path there.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Iterable, Sequence
from typing import Concatenate, Final, ParamSpec, TypeVar

from rosward.domain.choice import MAX_OPTIONS, MAX_REASONS, generalise, join, join_all, options, reasons_of
from rosward.domain.compound import Native, Range, Slice, Tuple
from rosward.domain.heap import Obj, ObjKind, fields_of
from rosward.domain.series import Series, joined
from rosward.domain.text import MAX_LENGTH, make, readable
from rosward.domain.unknown import NO_ORIGINS, Cause, Origins, derived
from rosward.domain.values import UNBOUND, Choice, Const, Hole, Ref, Text, Unknown, Value
from rosward.models.native import Arguments, Items, Machine, MissingArgumentError, NativeCall, NativeFunction
from rosward.models.python.cost import A_STEP, MAX_WORK, work
from rosward.records import NamedTuple

MAX_BITS: Final = 4096
MAX_ITEMS: Final = 1_000
MAX_COMBINATIONS: Final = MAX_OPTIONS * 4
NOT_PLAIN: Final = object()
FILE_HINT: Final = "file"
"""What is known of the type of an opened file of which nothing else is."""
EXCEPTION_HINT: Final = "exception"
"""The same of an exception that Python or a library raises."""
LOOSE_HINTS: Final = frozenset({FILE_HINT, EXCEPTION_HINT})
"""Hints that are no names of builtin types."""
_FAILURES: Final = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
_P = ParamSpec("_P")
_R = TypeVar("_R")


class Raised(Exception):  # noqa: N818 - an exception of the analysed program, no error of ours
    """The analysed program raises the builtin exception `error` here; `given` are its arguments, where they are known."""

    def __init__(self, error: str, message: str, given: tuple[Value, ...] | None = None) -> None:
        super().__init__(error, message)
        self.error = error
        self.message = message
        self.given = given


def native(function: Callable[[NativeCall], Value], least: int = 0, names: str = "") -> NativeFunction:
    """A native in which `Raised` ends the path, and which is never entered with fewer than `least` positional arguments.

    `names` are those of the parameters that may be set by name too, by position: `native(_sum, 1, "_ start")`; `_` for one that may not.
    """
    parameters = tuple(names.split())

    def guarded(call: NativeCall) -> Value:
        if parameters and call.keywords:
            call = _in_order(call, parameters)
        if len(call.args) < least:
            raise MissingArgumentError
        try:
            return function(call)
        except Raised as raised:
            return _die(call.machine, raised, (*call.args, *call.keywords.values()))

    return guarded


def _in_order(call: NativeCall, parameters: tuple[str, ...]) -> NativeCall:
    """The call with arguments by position where they were given by name, as far as no gap is before them."""
    args, keywords = list(call.args), dict(call.keywords)
    for name in parameters[len(args) :]:
        if name not in keywords or name in call.unsure:
            break
        args.append(keywords.pop(name))
    return call._replace(args=Arguments(args), keywords=keywords)


def operation(function: Callable[Concatenate[Machine, _P], Value]) -> Callable[Concatenate[Machine, _P], Value]:
    """The same for a function of a machine."""

    def guarded(machine: Machine, /, *args: _P.args, **keywords: _P.kwargs) -> Value:
        try:
            return function(machine, *args, **keywords)
        except Raised as raised:
            return _die(machine, raised, args)

    return guarded


def _die(machine: Machine, raised: Raised, operands: tuple[object, ...]) -> Value:
    """The program raises for these operands: for sure, where none of them is a mere default."""
    values = [o for o in operands if isinstance(o, Value)]
    known = origins(*values)
    given = None if raised.given is None else tuple(with_origins(g, known) for g in raised.given)
    plainly = all(plain(v) is not NOT_PLAIN for v in values)
    return machine.die(raised.error, raised.message, given, sure=all(o.settled for o in known), plain=plainly)


def run(function: Callable[..., _R], *args: object) -> _R:
    """function(*args) of Python itself; what it raises is what the program raises."""
    try:
        return function(*args)
    except _FAILURES as error:
        known = all(isinstance(a, (str, int, float)) or a is None for a in error.args)
        given = tuple(Const(a) for a in error.args) if known else None
        raise Raised(error.__class__.__name__, str(error), given) from error


def spread(function: Callable[..., Value], *values: Value) -> Value:
    """The join over all combinations of alternatives; those that raise are left out, unless all do."""
    for value in values:
        if value.__class__ is Choice:
            return join_all(_combined(function, values))
    return function(*values)


def _combined(function: Callable[..., _R], values: tuple[Value, ...]) -> list[_R]:
    for value in values:
        if value.__class__ is Choice:
            break
    else:
        return [function(*values)]
    results: list[_R] = []
    failure: Raised | None = None
    for combination in itertools.product(*_bounded([options(v) for v in values])):
        try:
            results.append(function(*combination))
        except Raised as raised:  # noqa: PERF203 - one alternative that fails must not end the others
            failure = failure or raised
    if not results and failure is not None:
        raise failure
    return results


class Fresh(NamedTuple):
    """A list or set that an operation would make; `cls` is the name of its builtin class."""

    kind: ObjKind
    cls: str
    items: Series


def spread_fresh(machine: Machine, site: object, function: Callable[..., Value | Fresh], *values: Value) -> Value:
    """The same for a function that may make lists: all alternatives together make one of each class.

    So `x = x + [y]` in a loop does not make one list more in each turn.
    """
    results = _combined(function, values)
    found = [r for r in results if not isinstance(r, Fresh)]
    if len(found) == len(results):
        return found[0] if len(found) == 1 else join_all(found)
    for kind, cls in dict.fromkeys((r.kind, r.cls) for r in results if isinstance(r, Fresh)):
        several = [r.items for r in results if isinstance(r, Fresh) and (r.kind, r.cls) == (kind, cls)]
        if kind == "set" and len(several) > 1:
            several = [s.loose() for s in several]
        together = functools.reduce(lambda a, b: joined(a, b, join), several)
        found.append(listed(machine, site, *together, kind=kind, cls=cls))
    return join_all(found)


def join_items(several: list[Items]) -> Items:
    """Item by item where all have one length, else any number of any item."""
    if len(several) == 1:
        return several[0]
    if len({len(i.known) for i in several}) == 1 and all(i.rest is None for i in several):
        return Items(tuple(join_all(column) for column in zip(*(i.known for i in several), strict=True)))
    loose = [v for i in several for v in all_of(i)]
    return Items((), join_all(loose)) if loose else Items(())


def all_of(items: Items) -> tuple[Value, ...]:
    """The known items and what joins the rest."""
    return (*items.known, *(() if items.rest is None else (items.rest,)))


def _bounded(alternatives: list[tuple[Value, ...]]) -> list[tuple[Value, ...]]:
    """Alternatives with at most `MAX_COMBINATIONS` combinations: the most numerous are generalised."""
    while True:
        count = 1
        for one in alternatives:
            count *= len(one)
        if count <= MAX_COMBINATIONS:
            return alternatives
        widest = max(range(len(alternatives)), key=lambda n: len(alternatives[n]))
        alternatives[widest] = (generalise(alternatives[widest]),)


def plain(value: Value) -> object:
    """The Python object that a value surely is (a constant or a tuple of such), else NOT_PLAIN."""
    if isinstance(value, Const):
        return value.value
    if isinstance(value, Tuple):
        items = tuple(plain(v) for v in value.items)
        return NOT_PLAIN if NOT_PLAIN in items else items
    return NOT_PLAIN


def text_of(value: Value | None) -> str | None:
    """The str that a value surely is, else None."""
    return value.value if isinstance(value, Const) and isinstance(value.value, str) else None


def int_of(value: Value | None) -> int | None:
    """The int that a value surely is, else None."""
    return int(value.value) if isinstance(value, Const) and isinstance(value.value, int) else None


def range_of(value: Range) -> range | None:
    """The Python range that a range surely is; what is no range raises."""
    start, stop, step = (int_of(e) for e in value.fields())
    return None if start is None or stop is None or step is None else run(range, start, stop, step)


def slice_of(value: Slice) -> slice | None:
    """The Python slice that a slice surely is."""
    ends = [plain(e) for e in value.fields()]
    known = [e for e in ends if e is None or isinstance(e, int)]
    return slice(*known) if len(known) == 3 else None


def origins(*values: Value | None) -> Origins:
    """The origins of values and of their parts."""
    found: Origins = NO_ORIGINS
    for value in values:
        if value.__class__ is Unknown or value.__class__ is Ref:
            continue
        if value.__class__ is Const or value.__class__ is Text:
            if value.origins:
                found |= value.origins
        elif value.__class__ is Choice:
            found |= origins(*value.options)
        elif value.__class__ is Tuple:
            found |= origins(*value.items)
        elif value.__class__ is Range or value.__class__ is Slice:
            found |= origins(*value.fields())
    return found


def with_origins(value: Value, more: Origins) -> Value:
    """The value, computed from these origins too."""
    if not more or value is UNBOUND:
        return value
    if isinstance(value, Const):
        return value if more <= value.origins else Const(value.value, value.origins | more)
    if isinstance(value, Text):
        return value if more <= value.origins else Text(value.parts, value.origins | more)
    if isinstance(value, Choice):
        return join_all(with_origins(o, more) for o in value.options)
    if isinstance(value, Tuple):
        return Tuple(tuple(with_origins(v, more) for v in value.items))
    return value


def unknown_from(machine: Machine, what: str, hint: str, *values: Value | None) -> Unknown:
    """An unknown for the reasons of the operands, or because of the operation where these have none."""
    found = [why for v in values if v is not None and (why := reasons_of(v))]
    if not found:
        return machine.unknown(Cause.OPERATION, what, hint)
    reasons = found[0]
    if len(found) > 1 or len(reasons) > 1:
        reasons = tuple(dict.fromkeys([r for why in found for r in why]))[:MAX_REASONS]
    return Unknown(derived(reasons), hint)


def hole_from(machine: Machine, what: str, *values: Value | None, shape: str = "") -> Hole:
    """A hole for the reasons of the operands."""
    return Hole(unknown_from(machine, what, "str", *values).reasons, shape)


def truth_const(machine: Machine, value: Value, what: str = "bool") -> Value:
    """bool(value): a constant keeps its origins."""
    if isinstance(value, Const):
        return Const(bool(value.value), value.origins)
    decided = machine.truth(value)
    return unknown_from(machine, what, "bool", value) if decided is None else Const(decided, origins(value))


def from_python(machine: Machine, value: object, source: Origins = NO_ORIGINS, what: str = "") -> Value:
    """The abstract value of what Python computed; a text or number beyond the bounds is not kept."""
    if isinstance(value, str):
        if len(value) <= MAX_LENGTH:
            return Const(value, source)
        return make((value[: MAX_LENGTH // 2], Hole(machine.unknown(Cause.LIMIT, what).reasons)), source)
    if (isinstance(value, int) and value.bit_length() > MAX_BITS) or (
        isinstance(value, bytes) and len(value) > MAX_LENGTH
    ):
        return machine.unknown(Cause.LIMIT, what, value.__class__.__name__)
    if value is None or isinstance(value, (bool, int, float, complex, bytes)):
        return Const(value, source)
    if isinstance(value, (tuple, list, dict)):
        return _collection(machine, value, source, what)
    return machine.unknown(Cause.OPERATION, what, value.__class__.__name__)


def _collection(
    machine: Machine, value: tuple[object, ...] | list[object] | dict[object, object], source: Origins, what: str
) -> Value:
    if isinstance(value, dict):
        entries = {from_python(machine, k, what=what): from_python(machine, v, source, what) for k, v in value.items()}
        return machine.allocate(Obj("dict", Native("builtins.dict"), entries=entries), tuple(entries.items()))
    items = tuple(from_python(machine, v, source, what) for v in value)
    return Tuple(items) if isinstance(value, tuple) else exact_list(machine, items)


def listed(
    machine: Machine,
    site: object,
    known: Iterable[Value],
    rest: Value | None = None,
    tail: tuple[Value, ...] = (),
    *,
    kind: ObjKind = "list",
    cls: str = "",
) -> Ref:
    """A new list or set: of `known`, then any number of `rest`, then `tail`.

    `site` keeps it apart from those that other operations make at the same place.
    """
    elements = fields_of(Series(tuple(known), rest, tail), kind, MAX_ITEMS)
    return machine.allocate(Obj(kind, Native(f"builtins.{cls or kind}"), **elements), site)


def exact_list(machine: Machine, items: tuple[Value, ...]) -> Value:
    """A list of these elements, apart from others that the same call makes for other alternatives."""
    return listed(machine, items, items)


def affordable(machine: Machine, what: str, operands: Sequence[object]) -> bool:
    """Whether Python may be asked; what takes longer than a step is counted."""
    needed = work(what, operands)
    if needed >= A_STEP:
        if needed > MAX_WORK:
            return False
        machine.spend(needed // A_STEP)
    return True


def evaluate(
    machine: Machine, what: str, function: Callable[..., object], values: Sequence[Value], hint: str = ""
) -> Value | None:
    """function of Python itself on values that are all plain; None where one is not."""
    operands = [plain(v) for v in values]
    if NOT_PLAIN in operands:
        return None
    if not affordable(machine, what, operands):
        return machine.unknown(Cause.LIMIT, what, hint)
    return from_python(machine, run(function, *operands), origins(*values), what)


def key_shown(value: Value) -> str:
    """A key that is not there, as the error of Python says it."""
    if isinstance(value, Tuple):
        return f"({', '.join(map(key_shown, value.items))})"
    if isinstance(value, Const):
        return repr(value.value)
    return readable(value) if isinstance(value, (Text, Unknown)) else "…"
