# SPDX-License-Identifier: Apache-2.0
"""`functools` and `itertools`, exact on known inputs of up to a thousand items.

partial(self.on_scan, 'left')                 Partial(on_scan, ('left',))
itertools.product(['a', 'b'], range(2))       an iterator over four tuples
itertools.chain(known, unknown)               of unknown length, its element what any of them holds
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, Descriptor, Native, Partial, Tuple
from rosward.domain.table import marked
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, Ref, Unbound, Value
from rosward.models.native import Items, Machine, NativeCall, NativeFunction
from rosward.models.python.builtins.attributes import ANY_ATTRIBUTE
from rosward.models.python.builtins.lazy import is_drained, lazily, shared, stepped
from rosward.models.python.containers.any_order import each_order, in_places
from rosward.models.python.plain import int_of, native

MAX_ITEMS: Final = 1_000


def _partial(call: NativeCall) -> Value:
    if not call.args:
        return call.machine.die("TypeError", "partial expected at least 1 argument")
    function = call.args[0]
    arguments, keywords = call.args[1:], tuple(sorted(call.keywords.items()))
    if isinstance(function, Partial):
        merged = {**dict(function.keywords), **dict(keywords)}
        return Partial(function.function, (*function.arguments, *arguments), tuple(sorted(merged.items())))
    return Partial(function, arguments, keywords)


def _wraps(call: NativeCall) -> Value:
    """functools.wraps(f): a decorator that gives a function the name and the docstring of f."""
    updated = tuple((name, value) for name, value in call.keywords.items() if name == "updated")
    return Partial(Native("functools._wrapped"), call.args[:1], updated)


def _wrapped(call: NativeCall) -> Value:
    """A function under the name of another; `update_wrapper` has them the other way round."""
    machine = call.machine
    if len(call.args) < 2:
        return machine.unknown(Cause.CALL, call.name)
    wrapped, wrapper = call.args[:2]
    if call.name == "functools.update_wrapper":
        wrapped, wrapper = wrapper, wrapped
    if isinstance(wrapper, Function) or (isinstance(wrapper, Ref) and machine.obj(wrapper).kind == "instance"):
        for name in ("__module__", "__name__", "__qualname__", "__doc__"):
            machine.store_attr(wrapper, name, machine.load_attr(wrapped, name))
        if call.keywords.get("updated") != Tuple(()):
            _hand_on(machine, wrapped, wrapper)
        machine.store_attr(wrapper, "__wrapped__", wrapped)
    return wrapper


def _hand_on(machine: Machine, wrapped: Value, wrapper: Value) -> None:
    """What the program set on a function is set on what takes its place, too."""
    while isinstance(wrapped, BoundMethod):
        wrapped = wrapped.function
    kept = machine.function_record(wrapped) if isinstance(wrapped, Function) else None
    cls = machine.obj(wrapped).cls if isinstance(wrapped, Ref) else None
    if kept is None and (not isinstance(cls, Class) or cls.stub):
        return
    table = machine.load_attr(wrapper, "__dict__")
    machine.call(machine.load_attr(table, "update"), (machine.load_attr(wrapped, "__dict__"),))
    owner = machine.obj(table).payload if isinstance(table, Ref) else None
    if kept is not None and ANY_ATTRIBUTE in kept.partial and isinstance(owner, Ref):
        record = machine.obj(owner)
        machine.update(owner, record.replace(partial=marked(record.partial, ANY_ATTRIBUTE)))


def _bound(call: NativeCall) -> Value:
    """function.__get__(object, class): the method of that object; the function itself where there is none."""
    function, receiver = call.args[:2]
    return join_all(function if o == NONE else BoundMethod(o, function) for o in options(receiver))


def _same(call: NativeCall) -> Value:
    return call.args[0] if call.args else NONE


def _cached_property(call: NativeCall) -> Value:
    return Descriptor("cached_property", call.args[0], None, None) if call.args else NONE


def _reduce(call: NativeCall) -> Value:
    """reduce(f, items[, first]): exact on known items; three steps are run for any number of others."""
    orders = each_order(call.machine, call.args[1]) or [in_places(call.machine, call.args[1])]
    return join_all(_reduced(call, *order) for order in orders)


def _reduced(call: NativeCall, known: tuple[Value, ...], rest: Value | None) -> Value:
    machine, function = call.machine, call.args[0]
    if len(call.args) > 2:
        known = (call.args[2], *known)
    if not known and rest is None:
        return machine.die("TypeError", "reduce() of empty iterable with no initial value")
    result: Value = known[0] if known else rest if rest is not None else UNBOUND
    for item in known[1:MAX_ITEMS]:
        result = machine.call(function, (result, item))
    if rest is not None:
        for _ in range(3):
            result = join_all((result, machine.call(function, (result, rest))))
    return result


def _product(inputs: Sequence[Items], repeat: int) -> Iterable[tuple[Value, ...]] | None:
    size = 1
    for one in (*inputs,) * max(repeat, 1):
        size *= len(one.known)
    return itertools.product(*(i.known for i in inputs), repeat=repeat) if size <= MAX_ITEMS else None


def _listed(call: NativeCall, items: Iterable[Value] | None, rest: Value | None = None) -> Value:
    """The iterator of a list; of unknown length where there is a rest."""
    if items is None:
        made = call.machine.new_list((), UNBOUND if rest is None else rest)
    else:
        made = call.machine.new_list(items, None if isinstance(rest, Unbound) else rest)
    return call.machine.call_native("builtins.iter", (made,))


def _element(items: Items) -> Value:
    return join_all((*items.known, *(() if items.rest is None else (items.rest,))))


def _combine(call: NativeCall) -> Value:
    """product, combinations, permutations, …: tuples of elements."""
    name = call.name.rpartition(".")[2]
    machine = call.machine
    if name == "product":
        inputs = [machine.iterate(a) for a in call.args]
        repeat = int_of(call.keywords.get("repeat", Const(1)))
        exact = repeat is not None and 0 <= repeat <= 8 and all(i.rest is None for i in inputs)
        found = _product(inputs, repeat) if exact and repeat is not None else None
        if found is not None:
            return _listed(call, [Tuple(t) for t in found])
        if repeat is not None and 0 <= repeat <= 8:
            return _listed(call, (), Tuple(tuple(_element(i) for i in inputs) * repeat))
        return _listed(
            call, (), machine.call_native("builtins.tuple", (machine.new_list((), join_all(map(_element, inputs))),))
        )
    items = machine.iterate(call.args[0])
    size = call.arg(1, "r")
    count = len(items.known) if size in (None, NONE) else int_of(size)
    element = _element(items)
    if count is None or items.rest is not None or len(items.known) ** min(count, len(items.known)) > 10 * MAX_ITEMS:
        if count is None or not 0 <= count <= 8:
            return _listed(call, (), machine.call_native("builtins.tuple", (machine.new_list((), element),)))
        return _listed(call, (), Tuple((element,) * count))
    function = getattr(itertools, name)
    return _listed(call, [Tuple(t) for t in itertools.islice(function(items.known, count), MAX_ITEMS)])


def _islice(call: NativeCall) -> Value:
    call.exactly(2)
    bounds = [None if a == NONE else int_of(a) for a in call.args[1:]]
    follow = stepped(call, call.args[:1]) or is_drained(call.machine, call.args[0])
    if follow and 2 <= len(call.args) <= 4:
        start, stop, step = (NONE, call.args[1], NONE) if len(call.args) == 2 else (*call.args[1:], NONE)[:3]
        begin, width = Const(0) if start == NONE else start, Const(1) if step == NONE else step
        return lazily(call, "islice", call.args[0], begin, stop, width)
    items = in_places(call.machine, call.args[0])
    exact = all(b is not None or a == NONE for a, b in zip(call.args[1:], bounds, strict=True))
    if not exact or items.rest is not None or any(b is not None and b < 0 for b in bounds):
        return _listed(call, (), _element(items))
    return _listed(call, itertools.islice(items.known, *bounds))


def _followed(call: NativeCall) -> Value:
    """itertools._followed(iterables): whether there is one among them that is followed step by step."""
    iterables = call.args[0]
    if stepped(call, (iterables,)):
        return Const(True)
    known, rest = call.machine.iterate(iterables)
    return Const(stepped(call, (*known, *(() if rest is None else (rest,)))))


def _zip_longest(call: NativeCall) -> Value:
    if shared(call, call.args):
        return lazily(call, "zip_longest", *call.args, fillvalue=call.keywords.get("fillvalue", NONE))
    inputs = [call.machine.iterate(a) for a in call.args]
    fill = call.keywords.get("fillvalue", NONE)
    if any(i.rest is not None for i in inputs):
        return _listed(call, (), Tuple(tuple(join_all((_element(i), fill)) for i in inputs)))
    return _listed(call, [Tuple(t) for t in itertools.zip_longest(*(i.known for i in inputs), fillvalue=fill)])


def _pairwise(call: NativeCall) -> Value:
    if stepped(call, call.args[:1]):
        return lazily(call, "pairwise", call.args[0])
    items = call.machine.iterate(call.args[0])
    if items.rest is not None:
        return _listed(call, (), Tuple((_element(items),) * 2))
    return _listed(call, [Tuple(pair) for pair in zip(items.known, items.known[1:], strict=False)])


def _cycle(call: NativeCall) -> Value:
    if stepped(call, call.args[:1]):
        return lazily(call, "cycle", call.args[0])
    return _listed(call, None, _element(call.machine.iterate(call.args[0])))


def _repeat(call: NativeCall) -> Value:
    value = call.arg(0, "object") or NONE
    times = call.arg(1, "times")
    count = int_of(times)
    if count is not None and count <= MAX_ITEMS:
        return _listed(call, [value] * max(0, count))
    return _listed(call, None, value)


NATIVES: Final[dict[str, NativeFunction]] = {
    "functools.partial": _partial,
    "functools.wraps": _wraps,
    "function.__get__": native(_bound, 2),
    "functools._wrapped": _wrapped,
    "functools.update_wrapper": _wrapped,
    "functools.total_ordering": _same,
    "functools.cached_property": _cached_property,
    "functools.reduce": _reduce,
    "itertools.product": _combine,
    "itertools.combinations": _combine,
    "itertools.combinations_with_replacement": _combine,
    "itertools.permutations": _combine,
    "itertools._followed": _followed,
    "itertools.islice": _islice,
    "itertools.zip_longest": _zip_longest,
    "itertools.pairwise": _pairwise,
    "itertools.cycle": _cycle,
    "itertools.repeat": _repeat,
}
