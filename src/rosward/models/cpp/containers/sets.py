# SPDX-License-Identifier: Apache-2.0
"""Sets: each key once, in order where all are known.

names.insert("b"); names.insert("a"); names.insert("b")     'a', 'b'
names.count("a")                                            1
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.series import Series, concatenated
from rosward.domain.slots import TypeOf
from rosward.domain.values import NONE, Const, Ref, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.contained import erased, made_of, nothing, receivers, texts_given
from rosward.models.cpp.iteration.elements import between, series_of
from rosward.models.cpp.iteration.iterators import as_iterator, iterator, leading_into
from rosward.models.cpp.values.conversions import convert, new_set
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.ordering import in_order, own_key, same_key, unique, without_comparison
from rosward.models.cpp.values.slots import key_of, new_pair, read
from rosward.models.cpp.values.types import argument, name_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import unknown_from

__all__ = ["NATIVES"]

_KINDS: Final = ("set", "unordered_set", "multiset", "unordered_multiset")


def _key(machine: Machine, ref: Ref, value: Value) -> Value:
    return _own(machine, ref, key_of(machine, convert(machine, value, argument(machine.obj(ref).cls, 0))))


def _own(machine: Machine, ref: Ref, key: Value) -> Value:
    return key if _several(machine, ref) else own_key(machine, machine.obj(ref), key)


def _several(machine: Machine, ref: Ref) -> bool:
    return "multi" in name_of(machine.obj(ref).cls)


def _add(machine: Machine, ref: Ref, keys: Series) -> None:
    together = concatenated((machine.obj(ref).series(), keys))
    write_series(machine, ref, unique(machine, together, machine.obj(ref).cls, several=_several(machine, ref)))


def _found(machine: Machine, ref: Ref, key: Value) -> bool | None:
    """Whether a key is in a set."""
    obj = machine.obj(ref)
    series = obj.series()
    answers = {same_key(machine, obj.cls, key, item) for item in (*series.head, *series.tail)}
    if True in answers:
        return True
    middle = False if series.middle is None else same_key(machine, obj.cls, key, series.middle)
    return None if None in answers or middle is not False else False


def _place(machine: Machine, ref: Ref, key: Value) -> Value:
    """An iterator to a key that is in a set."""
    series = machine.obj(ref).series()
    same: list[bool | None] = _same(machine, ref, key) if series.exact else []
    if None not in same and True in same:
        return iterator(ref, Const(same.index(True)))
    return iterator(ref, unknown_from(machine, "find", "int", key))


def _same(machine: Machine, ref: Ref, key: Value) -> list[bool | None]:
    """For each element that is known, whether it is the same as a key."""
    obj = machine.obj(ref)
    return [item == key or same_key(machine, obj.cls, item, key) for item in obj.series().head]


def _insert(call: NativeCall) -> Value:
    machine, results = call.machine, []
    for ref in receivers(call):
        values = [read(machine, arg) for arg in call.args[1:]]
        iterators = [as_iterator(value) is not None for value in values]
        if len(values) == 2 and all(iterators):
            _add(machine, ref, between(machine, values[0], values[1]).mapped(lambda v, r=ref: _key(machine, r, v)))  # type: ignore[misc]
        elif len(values) == 1 and isinstance(values[0], Tuple) and not _takes_tuple(machine, ref):
            _add(machine, ref, Series(tuple(_key(machine, ref, v) for v in values[0].items)))
        elif values:
            key = _key(machine, ref, values[-1])
            results.append(_one(machine, ref, key))
    return join_all(results) if results else NONE


def _takes_tuple(machine: Machine, ref: Ref) -> bool:
    return name_of(argument(machine.obj(ref).cls, 0)) in ("std.pair", "std.tuple", "std.array")


def _one(machine: Machine, ref: Ref, key: Value) -> Value:
    there = _found(machine, ref, key)
    _add(machine, ref, Series((key,)))
    new = unknown_from(machine, "insert", "bool", key) if there is None else Const(not there)
    place = _place(machine, ref, key)
    return place if _several(machine, ref) else new_pair(machine, place, new)


def _emplace(call: NativeCall) -> Value:
    machine, results = call.machine, []
    for ref in receivers(call):
        made = made_of(machine, machine.obj(ref).cls, call.args[1:])
        results.append(_one(machine, ref, _own(machine, ref, key_of(machine, made))))
    return join_all(results) if results else NONE


def _find(call: NativeCall) -> Value:
    machine, results = call.machine, []
    for ref in receivers(call):
        for key in options(_key(machine, ref, call.args[1])):
            there = _found(machine, ref, key)
            if there is not False:
                results.append(_place(machine, ref, key))
            if not there:
                results.append(iterator(ref, NONE))
    return join_all(results) if results else unknown_from(machine, "find", "", read(machine, call.args[0]))


def _count(call: NativeCall) -> Value:
    machine = call.machine
    results: list[Value] = []
    is_bool = call.name.endswith("contains")
    for ref in receivers(call):
        key = _key(machine, ref, call.args[1])
        there = _found(machine, ref, key)
        series = machine.obj(ref).series()
        same = _same(machine, ref, key) if _several(machine, ref) else []
        if there is None or (_several(machine, ref) and (not series.exact or None in same)):
            results.append(unknown_from(machine, "count", "bool" if is_bool else "int", key))
        else:
            number = sum(map(bool, same)) if _several(machine, ref) else int(there)
            results.append(Const(there) if is_bool else Const(number))
    return join_all(results) if results else unknown_from(machine, "count", "int", read(machine, call.args[0]))


def _erase(call: NativeCall) -> Value:
    machine = call.machine
    results: list[Value] = []
    values = [read(machine, arg) for arg in call.args[1:]]
    for ref in receivers(call):
        for value in leading_into(ref, values[0]):
            if as_iterator(value) is not None:
                results.append(erased(machine, ref, value, values[1] if len(values) > 1 else None))
                continue
            key = _key(machine, ref, value)
            there, series, same = _found(machine, ref, key), machine.obj(ref).series(), _same(machine, ref, key)
            if there is None or not series.exact or None in same:
                write_series(machine, ref, series.loose())
                results.append(unknown_from(machine, "erase", "int", key))
            else:
                kept = tuple(item for item, alike in zip(series.head, same, strict=True) if not alike)
                write_series(machine, ref, Series(kept))
                results.append(Const(len(series.head) - len(kept)))
    return join_all(results) if results else unknown_from(machine, "erase", "", read(machine, call.args[0]))


def _bound(call: NativeCall) -> Value:
    machine = call.machine
    results: list[Value] = []
    for ref in receivers(call):
        key, series = _key(machine, ref, call.args[1]), machine.obj(ref).series()
        order = in_order(machine, [*series.head, key], machine.obj(ref).cls) if series.exact else None
        same = _same(machine, ref, key)
        if order is None or None in same:
            results.append(iterator(ref, unknown_from(machine, "bound", "int", key)))
            continue
        rank = order.index(len(series.head))
        place = rank - (sum(map(bool, same)) if not call.name.endswith("upper_bound") else 0)
        results.append(iterator(ref, Const(place) if place < len(series.head) else NONE))
    return join_all(results) if results else unknown_from(machine, "bound", "", read(machine, call.args[0]))


def _merge(call: NativeCall) -> Value:
    for ref in receivers(call):
        more = series_of(call.machine, call.args[1])
        _add(call.machine, ref, more.mapped(lambda v, r=ref: _key(call.machine, r, v)))  # type: ignore[misc]
    return NONE


def _new(call: NativeCall) -> Value:
    """std::set<T>(…): the type comes first."""
    machine, type_, args = call.machine, call.args[0], call.args[1:]
    cls: Value = type_ if isinstance(type_, TypeOf) else TypeOf(name_of(type_), ())
    values = [read(machine, arg) for arg in texts_given(machine, cls, args)]
    if values and isinstance(values[0], Unknown):
        return values[0]
    if values and isinstance(values[0], Ref) and name_of(machine.obj(values[0]).cls) == name_of(cls):
        return convert(machine, copied(machine, values[0]), cls)
    values, cls = without_comparison(machine, values, cls)
    made = new_set(machine, cls, Series(), "new")
    if len(values) > 1 and as_iterator(values[0]) is not None:
        _add(machine, made, between(machine, values[0], values[1]).mapped(lambda v: _key(machine, made, v)))
        return made
    items = (
        values[0].items
        if len(values) == 1 and isinstance(values[0], Tuple) and not _takes_tuple(machine, made)
        else None
    )
    if len(values) == 1 and isinstance(values[0], Tuple) and items is None:
        items = values[0].items if all(isinstance(item, (Tuple, Ref)) for item in values[0].items) else tuple(values)
    _add(machine, made, Series(tuple(_key(machine, made, v) for v in (values if items is None else items))))
    return made


_METHODS: Final[dict[str, NativeFunction]] = {
    "insert": _insert,
    **dict.fromkeys(("emplace", "emplace_hint"), _emplace),
    "find": _find,
    **dict.fromkeys(("count", "contains"), _count),
    "erase": _erase,
    **dict.fromkeys(("lower_bound", "upper_bound"), _bound),
    "merge": _merge,
    **dict.fromkeys(("reserve", "rehash"), nothing),
}

NATIVES: Final[dict[str, NativeFunction]] = {
    **{
        f"std.set.{name}": function
        for name, function in with_least(_METHODS, 2, dict.fromkeys(("emplace", "reserve", "rehash"), 1)).items()
    },
    **{f"std.{kind}.new": _new for kind in _KINDS},
}
