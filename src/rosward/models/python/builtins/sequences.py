# SPDX-License-Identifier: Apache-2.0
"""Builtin functions over iterables. An iterator is a list that `next` takes from, computed when it is made.

sorted(names), zip(a, b), enumerate(x, 1), sum(parts, ''), any(flags), next(iter(x), None)
"""

from __future__ import annotations

from typing import Any, Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Native, Range, Tuple
from rosward.domain.series import Series
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, Ref, Value
from rosward.models.native import Items, Machine, MissingArgumentError, NativeCall, NativeFunction
from rosward.models.python.builtins.attributes import has_attribute
from rosward.models.python.builtins.lazy import acts, lazily, shared, stepped
from rosward.models.python.comparing.compare import comparable
from rosward.models.python.comparing.equal_objects import member_value
from rosward.models.python.containers.any_order import in_places
from rosward.models.python.containers.lists import ITERATOR, order, write_series
from rosward.models.python.containers.views import renewed
from rosward.models.python.plain import (
    NOT_PLAIN,
    Raised,
    all_of,
    int_of,
    listed,
    native,
    origins,
    range_of,
    run,
    spread,
    unknown_from,
    with_origins,
)

_LIST: Final = Native("builtins.list")


def iterator(machine: Machine, items: Items | Series) -> Value:
    """A list that stands for an iterator."""
    made = listed(machine, "iterator", *items)
    machine.update(made, machine.obj(made).replace(payload=ITERATOR))
    return made


def _range(call: NativeCall) -> Value:
    args = tuple(member_value(call.machine, a) or a for a in call.args)
    start, stop, step = (Const(0), args[0], Const(1)) if len(args) == 1 else (*args, Const(1))[:3]
    for end in (start, stop, step):
        if isinstance(end, Const) and not isinstance(end.value, int):
            raise Raised("TypeError", f"'{end.value.__class__.__name__}' object cannot be interpreted as an integer")
    return spread(Range, start, stop, step)


def _enumerate(call: NativeCall) -> Value:
    machine = call.machine
    if stepped(call, call.args[:1]):
        return lazily(call, "enumerate", call.args[0], call.arg(1, "start", Const(0)) or Const(0))
    known, rest = in_places(machine, call.args[0])
    begin = call.arg(1, "start", Const(0)) or Const(0)
    first = int_of(begin)
    number = unknown_from(machine, "enumerate", "int", begin if first is None else rest)
    counted = [Tuple((number if first is None else Const(first + n, origins(begin)), v)) for n, v in enumerate(known)]
    return iterator(machine, Items(tuple(counted), None if rest is None else Tuple((number, rest))))


def _zip(call: NativeCall) -> Value:
    if shared(call, call.args):
        return lazily(call, "zip", *call.args, **call.keywords)
    columns = [in_places(call.machine, a) for a in call.args]
    if call.loose is not None:  # `zip(*rows)`: rows of unknown length
        cells = (element for c in (*columns, call.machine.iterate(call.loose)) for element in all_of(c))
        row = join_all((*cells, unknown_from(call.machine, "zip", "", call.loose)))
        return iterator(call.machine, Items((), listed(call.machine, "zip", (), row, cls="tuple")))
    if not columns:
        return iterator(call.machine, Items(()))
    if all(c.rest is None for c in columns):
        return iterator(
            call.machine, Items(tuple(Tuple(row) for row in zip(*(c.known for c in columns), strict=False)))
        )
    sure = min(len(c.known) for c in columns)
    rows = tuple(Tuple(tuple(c.known[n] for c in columns)) for n in range(sure))
    later = [all_of(Items(c.known[sure:], c.rest)) for c in columns]
    rest = Tuple(tuple(join_all(cells) for cells in later)) if all(later) else None
    return iterator(call.machine, Items(rows, rest))


def _map(call: NativeCall) -> Value:
    machine, function = call.machine, call.args[0]
    if acts(machine, function) or shared(call, call.args[1:]):
        return lazily(call, "map" if len(call.args) == 2 else "map_rows", *call.args)
    columns = [machine.iterate(a) for a in call.args[1:]]
    if all(c.rest is None for c in columns):
        results = [machine.call(function, row) for row in zip(*(c.known for c in columns), strict=False)]
        return UNBOUND if UNBOUND in results else iterator(machine, Items(tuple(results)))
    cells = [all_of(c) for c in columns]
    if not all(cells):
        return iterator(machine, Items(()))
    result = machine.call(function, [join_all(c) for c in cells])
    return iterator(machine, Items(()) if result is UNBOUND else Items((), result))


def _filter(call: NativeCall) -> Value:
    machine, (function, iterable) = call.machine, call.args[:2]
    if acts(machine, function) or stepped(call, (iterable,)):
        return lazily(call, "filter", function, iterable)
    known, rest = in_places(machine, iterable)
    kept: list[Value] = []
    exact = rest is None
    for item in all_of(Items(known, rest)):
        answer = machine.truth(item if function == NONE else machine.call(function, (item,)))
        if answer is not False:
            kept.append(item)
            exact = exact and answer is True
    if exact:
        return iterator(machine, Items(tuple(kept)))
    return iterator(machine, Items((), join_all(kept)) if kept else Items(()))


def _sorted(call: NativeCall) -> Value:
    items = call.machine.iterate(call.args[0])
    ordered = order(call.machine, items, call.keywords.get("key"), call.keywords.get("reverse"))
    return listed(call.machine, "sorted", *ordered)


def _reversed(call: NativeCall) -> Value:
    return iterator(call.machine, call.machine.series(call.args[0]).reversed())


def _iter(call: NativeCall) -> Value:
    if len(call.args) > 1:
        return lazily(call, "iter_calls", *call.args[:2])
    return spread(lambda value: _iterator_of(call.machine, value), call.args[0])


def _iterator_of(machine: Machine, value: Value) -> Value:
    """What an object of the program gives is not asked for its elements yet."""
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if obj.payload == ITERATOR or obj.kind == "generator":
            return value
        if obj.kind == "instance" and has_attribute(machine, value, "__iter__"):
            made = machine.call(machine.load_attr(value, "__iter__"), ())
            if made is UNBOUND or all(machine.is_stepped(o) for o in options(made)):
                return made
            if made != value:
                return spread(lambda v: _iterator_of(machine, v), made)
    return iterator(machine, machine.series(value))


def _next(call: NativeCall) -> Value:
    return spread(lambda value: _next_of(call, value), call.args[0])


def _next_of(call: NativeCall, value: Value) -> Value:
    """The first element of an iterator that we follow; any element of another one, or the default."""
    machine = call.machine
    obj = machine.obj(value) if isinstance(value, Ref) else None
    if obj is None or not isinstance(value, Ref):
        return _any_of(call, all_of(machine.iterate(value)))
    if obj.payload == ITERATOR and not obj.many and (series := obj.series()).head:
        write_series(machine, value, series.without(1))
        return series.head[0]
    if obj.kind == "generator":
        return machine.next_of(value, "next", NONE, *call.args[1:2])
    if obj.kind == "instance":
        if len(call.args) > 1:
            return machine.next_of(value, "next", NONE, call.args[1])
        return machine.call(machine.load_attr(value, "__next__"), ())
    return _any_of(call, all_of(machine.iterate(value)))


def _any_of(call: NativeCall, values: tuple[Value, ...]) -> Value:
    """Any of these elements, or the default; without both there is nothing."""
    default = call.args[1:2]
    if not values and not default:
        raise Raised("StopIteration", "")
    return join_all((*values, *default))


def _sum(call: NativeCall) -> Value:
    machine, total = call.machine, call.arg(1, "start", Const(0)) or Const(0)
    known, rest = machine.iterate(call.args[0])
    for item in known:
        total = machine.binary("+", total, item)
    if rest is None:
        return total
    return unknown_from(machine, "sum", "int" if getattr(rest, "hint", "") == "int" else "", total, rest)


def _extreme(call: NativeCall) -> Value:
    """min and max."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    items = machine.iterate(call.args[0]) if len(call.args) == 1 and call.loose is None else Items(call.args)
    default = call.keywords.get("default")
    if not items.known and items.rest is None:
        if not call.args:
            raise MissingArgumentError
        if default is None:
            raise Raised("ValueError", f"{name}() arg is an empty sequence")
        return default
    key = call.keywords.get("key")
    if items.rest is not None:
        if key is not None:
            machine.call(key, (join_all(all_of(items)),))
        return join_all((*all_of(items), *(() if default is None else (default,))))
    keys = list(items.known) if key is None or key == NONE else [machine.call(key, (v,)) for v in items.known]
    ranks = [comparable(machine, k) for k in keys]
    if any(r is NOT_PLAIN for r in ranks):
        best = _by_comparing(machine, "<" if name == "min" else ">", keys)
        return join_all(items.known) if best is None else items.known[best]
    chosen = run(_BEST[name], range(len(ranks)), ranks)
    return with_origins(items.known[chosen], origins(*keys))


def _by_comparing(machine: Machine, sign: str, keys: list[Value]) -> int | None:
    """The place of the key that comes first, as the objects themselves compare; None where they do not say surely."""
    best = 0
    for number in range(1, len(keys)):
        before = machine.truth(machine.compare(sign, keys[number], keys[best]))
        if before is None:
            return None
        best = number if before else best
    return best


def _least(numbers: range, ranks: list[Any]) -> int:
    return min(numbers, key=lambda n: ranks[n])


def _greatest(numbers: range, ranks: list[Any]) -> int:
    return max(numbers, key=lambda n: ranks[n])


_BEST: Final = {"min": _least, "max": _greatest}


def _quantified(call: NativeCall) -> Value:
    """any and all."""
    machine, wanted = call.machine, call.name.endswith("any")
    if stepped(call, call.args[:1]):
        return lazily(call, "any" if wanted else "all", call.args[0])
    items = machine.iterate(call.args[0])
    answers = {machine.truth(o) for v in items.known for o in options(v)} if items.known else set()
    several = any(len(options(v)) > 1 for v in items.known)
    sure = {machine.truth(v) for v in items.known} if several else answers
    if wanted in sure:
        return Const(wanted)
    if items.rest is None and sure <= {not wanted}:
        return Const(not wanted, origins(*items.known))
    return unknown_from(machine, call.name, "bool", *all_of(items))


def _len(call: NativeCall) -> Value:
    return spread(lambda value: _len_of(call, value), call.args[0])


def _len_of(call: NativeCall, value: Value) -> Value:
    machine = call.machine
    if isinstance(value, Const):
        if not isinstance(value.value, (str, bytes)):
            raise Raised("TypeError", f"object of type '{value.value.__class__.__name__}' has no len()")
        return Const(len(value.value), value.origins)
    if isinstance(value, Tuple):
        return Const(len(value.items))
    if isinstance(value, Range) and (numbers := range_of(value)) is not None:
        return Const(run(len, numbers), origins(value))
    if isinstance(value, Ref):
        obj = renewed(machine, value)
        if obj.kind in ("list", "set") and (obj.items is not None or obj.rest is None):
            return Const(len(obj.items or ()))
        if obj.kind == "dict" and obj.rest is None and not obj.maybe:
            return Const(len(obj.entries))
        if obj.kind == "instance":
            return machine.call(machine.load_attr(value, "__len__"), ())
        return machine.unknown(Cause.OPERATION, "len", "int")
    if isinstance(value, Class):
        metaclass = machine.obj(Ref(value.address)).cls
        asked = machine.load_attr(metaclass, "__len__") if isinstance(metaclass, Class) else None
        return (
            machine.call(asked, (value,))
            if isinstance(asked, Function)
            else machine.call_native("enum.length", (value,))
        )
    return unknown_from(machine, "len", "int", value)


def joined_elements(machine: Machine, value: Value) -> Value:
    """One value that covers all elements; UNBOUND where there are none."""
    known, rest = machine.iterate(value)
    found = join_all(known)
    return found if rest is None else join(found, rest)


NATIVES: Final[dict[str, NativeFunction]] = {
    "builtins.range": native(_range, 1),
    "builtins.enumerate": native(_enumerate, 1, "iterable start"),
    "builtins.zip": native(_zip),
    "builtins.map": native(_map, 2),
    "builtins.filter": native(_filter, 2),
    "builtins.sorted": native(_sorted, 1),
    "builtins.reversed": native(_reversed, 1),
    "builtins.iter": native(_iter, 1),
    "builtins.next": native(_next, 1),
    "builtins.sum": native(_sum, 1, "_ start"),
    "builtins.min": native(_extreme),
    "builtins.max": native(_extreme),
    "builtins.any": native(_quantified, 1),
    "builtins.all": native(_quantified, 1),
    "builtins.len": native(_len, 1),
    "list.__next__": native(_next, 1),
}
