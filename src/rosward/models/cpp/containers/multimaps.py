# SPDX-License-Identifier: Apache-2.0
"""Maps that keep several values under one key: lists of pairs, in the order of their keys.

many.emplace("k", 1); many.emplace("k", 2)
many.equal_range("k")           the iterators around both
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all
from rosward.domain.compound import Tuple
from rosward.domain.series import Series, concatenated
from rosward.domain.slots import TypeOf
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.contained import cls_of, erased, nothing, receivers
from rosward.models.cpp.iteration.elements import between, series_of
from rosward.models.cpp.iteration.iterators import as_iterator, iterator
from rosward.models.cpp.values.conversions import convert, new_container
from rosward.models.cpp.values.copies import copied, for_each
from rosward.models.cpp.values.ordering import in_order, same_key, without_comparison
from rosward.models.cpp.values.slots import key_of, new_pair, read, read_field
from rosward.models.cpp.values.types import argument, name_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import unknown_from

__all__ = ["NATIVES"]


def _pair(machine: Machine, type_: Value, args: tuple[Value, ...]) -> Value:
    """What is kept of a pair, or of a key and a value."""
    wanted = TypeOf("std.pair", (argument(type_, 0), argument(type_, 1)))
    value = Tuple(tuple(read(machine, arg) for arg in args)) if len(args) > 1 else read(machine, args[0])
    return copied(machine, convert(machine, value, wanted))


def _keys(machine: Machine, series: Series) -> list[Value]:
    return [
        key_of(machine, read_field(machine, pair, "first")) if isinstance(pair, Ref) else pair for pair in series.head
    ]


def _sorted(machine: Machine, ref: Ref, series: Series) -> None:
    order = in_order(machine, _keys(machine, series), cls_of(machine, ref)) if series.exact else None
    known = "unordered" in name_of(cls_of(machine, ref)) and series.exact
    if order is not None:
        write_series(machine, ref, Series(tuple(series.head[n] for n in order)))
    else:
        write_series(machine, ref, series if known else series.loose())


def _insert(call: NativeCall) -> Value:
    machine, found = call.machine, []
    args = call.args[1:]
    values = [read(machine, arg) for arg in args]
    for ref in receivers(call):
        cls, old = cls_of(machine, ref), machine.obj(ref).series()
        if len(values) == 2 and all(as_iterator(value) is not None for value in values):
            more = between(machine, values[0], values[1])
        elif (
            len(values) == 1
            and isinstance(values[0], Tuple)
            and not call.name.endswith("emplace")
            and _several(values[0])
        ):
            more = Series(values[0].items)
        else:
            fresh = _pair(machine, cls, args[1:] if len(args) > 1 and as_iterator(values[0]) is not None else args)
            if fresh is UNBOUND:
                return UNBOUND
            _sorted(machine, ref, concatenated((old, Series((fresh,)))))
            series = machine.obj(ref).series()
            found.append(
                iterator(
                    ref,
                    Const(series.head.index(fresh)) if fresh in series.head else unknown_from(machine, "insert", "int"),
                )
            )
            continue
        _sorted(machine, ref, concatenated((old, for_each(machine, more, lambda v, c=cls: _pair(machine, c, (v,))))))  # type: ignore[misc]
    return join_all(found) if found else NONE


def _several(value: Tuple) -> bool:
    return all(isinstance(item, (Tuple, Ref)) for item in value.items)


def _bounds(call: NativeCall, ref: Ref) -> tuple[Value, Value] | None:
    """The iterators around all that stands under a key; None where it is not known which that is."""
    machine = call.machine
    series = machine.obj(ref).series()
    key = key_of(machine, convert(machine, call.args[1], argument(cls_of(machine, ref), 0)))
    keys = _keys(machine, series)
    cls = cls_of(machine, ref)
    if not series.exact or in_order(machine, [*keys, key], cls) is None:
        return None
    same = [same_key(machine, cls, other, key) for other in keys]
    if None in same:
        return None
    start = sum(
        not alike and in_order(machine, [other, key], cls) == [0, 1] for other, alike in zip(keys, same, strict=True)
    )
    stop = start + sum(map(bool, same))
    size = len(keys)
    return iterator(ref, Const(start) if start < size else NONE), iterator(ref, Const(stop) if stop < size else NONE)


def _anywhere(call: NativeCall, ref: Ref) -> Value:
    return iterator(ref, unknown_from(call.machine, call.name, "int", read(call.machine, call.args[1])))


def _range(call: NativeCall) -> Value:
    """equal_range, lower_bound, upper_bound, find."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    found: list[Value] = []
    for ref in receivers(call):
        bounds = _bounds(call, ref)
        first, last = bounds if bounds is not None else (_anywhere(call, ref), iterator(ref, NONE))
        if name == "equal_range":
            found.append(new_pair(machine, first, last))
        elif name == "find":
            found.append(join_all((first, last)) if bounds is None else iterator(ref, NONE) if first == last else first)
        else:
            found.append(last if name == "upper_bound" else first)
    return join_all(found) if found else unknown_from(machine, name, "", read(machine, call.args[0]))


def _count(call: NativeCall) -> Value:
    machine = call.machine
    found: list[Value] = []
    for ref in receivers(call):
        bounds = _bounds(call, ref)
        if bounds is None:
            found.append(unknown_from(machine, "count", "int", read(machine, call.args[1])))
        else:
            number = len(between(machine, *bounds).head)
            found.append(Const(number > 0) if call.name.endswith("contains") else Const(number))
    return join_all(found) if found else unknown_from(machine, "count", "int", read(machine, call.args[0]))


def _erase(call: NativeCall) -> Value:
    machine = call.machine
    found: list[Value] = []
    values = [read(machine, arg) for arg in call.args[1:]]
    for ref in receivers(call):
        if as_iterator(values[0]) is not None:
            found.append(erased(machine, ref, values[0], values[1] if len(values) > 1 else None))
            continue
        bounds = _bounds(call, ref)
        if bounds is None:
            write_series(machine, ref, machine.obj(ref).series().loose())
            found.append(unknown_from(machine, "erase", "int", values[0]))
        else:
            found.append(Const(len(between(machine, *bounds).head)))
            erased(machine, ref, *bounds)
    return join_all(found) if found else unknown_from(machine, "erase", "", read(machine, call.args[0]))


def _new(call: NativeCall) -> Value:
    """std::multimap<K, V>(…): the type comes first."""
    machine, type_, args = call.machine, call.args[0], call.args[1:]
    values = [read(machine, arg) for arg in args]
    if values and isinstance(values[0], Unknown):
        return values[0]
    if values and isinstance(values[0], Ref) and name_of(machine.obj(values[0]).cls) == name_of(type_):
        return copied(machine, values[0])
    values, type_ = without_comparison(machine, values, type_)
    made = new_container(machine, type_, Series(), "new")
    if len(values) == 2 and all(as_iterator(value) is not None for value in values):
        more = between(machine, values[0], values[1])
    elif len(values) == 1 and isinstance(values[0], Tuple) and _several(values[0]):
        more = Series(values[0].items)
    else:
        more = Series(tuple(values)) if values else series_of(machine, Tuple(()))
    _sorted(machine, made, for_each(machine, more, lambda v: _pair(machine, type_, (v,))))
    return made


_METHODS: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("insert", "emplace", "emplace_hint"), _insert),
    **dict.fromkeys(("equal_range", "lower_bound", "upper_bound", "find"), _range),
    **dict.fromkeys(("count", "contains"), _count),
    "erase": _erase,
    **dict.fromkeys(("reserve", "rehash"), nothing),
}

NATIVES: Final[dict[str, NativeFunction]] = {
    **{
        f"std.multimap.{name}": function
        for name, function in with_least(_METHODS, 2, dict.fromkeys(("reserve", "rehash"), 1)).items()
    },
    **{f"std.{kind}.new": _new for kind in ("multimap", "unordered_multimap")},
}
