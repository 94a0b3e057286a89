# SPDX-License-Identifier: Apache-2.0
"""Maps: what stands under a key, and what is inserted where nothing does?

pubs["a"] = p           the slot under 'a', which holds a default until something is assigned
m.at("b")               std::out_of_range, where there surely is no such key
m.find(unknown)         an entry, or end()
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.series import Series
from rosward.domain.slots import Slot
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.contained import element_from, made_of, nothing, receivers, swap
from rosward.models.cpp.iteration.elements import between, series_of
from rosward.models.cpp.iteration.exceptions import is_settled, may_raise, raises
from rosward.models.cpp.iteration.iterators import as_iterator, entry, keys_in_order, leading_into, moved
from rosward.models.cpp.values.conversions import convert, default_value, new_map
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.ordering import in_order, own_key, without_comparison
from rosward.models.cpp.values.slots import key_of, new_pair, read, read_field
from rosward.models.cpp.values.types import argument
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers import dicts
from rosward.models.python.plain import unknown_from

__all__ = ["NATIVES"]


def _maps(call: NativeCall) -> list[Ref]:
    return [ref for ref in receivers(call) if call.machine.obj(ref).kind == "dict"]


def _lost(call: NativeCall, hint: str = "") -> Value:
    return unknown_from(call.machine, call.name, hint, read(call.machine, call.args[0]))


def _key(machine: Machine, ref: Ref, value: Value) -> Value:
    """A value as a key of a map."""
    obj = machine.obj(ref)
    return own_key(machine, obj, key_of(machine, convert(machine, value, argument(obj.cls, 0))))


def _place(machine: Machine, ref: Ref, key: Value) -> Value:
    """The slot of what stands under a key; an object itself."""
    slot = Slot(ref, "item", key)
    held = dicts.look_up(machine, machine.obj(ref), key).value
    objects = held is not UNBOUND and all(isinstance(option, Ref) for option in options(held))
    return held if objects else slot


def _index(call: NativeCall) -> Value:
    machine, found = call.machine, []
    for ref in _maps(call):
        key = _key(machine, ref, call.args[1])
        present = dicts.look_up(machine, machine.obj(ref), key)
        if present.missing is not False:
            fresh = default_value(machine, argument(machine.obj(ref).cls, 1))
            _store(machine, ref, key, fresh, present)
        found.append(_place(machine, ref, key))
    return join_all(found) if found else _lost(call)


def _store(machine: Machine, ref: Ref, key: Value, value: Value, present: dicts.LookUp) -> None:
    """A value comes under a key where there is none."""
    if present.missing:
        dicts.store(machine, ref, key, value)
    elif present.missing is None and present.value is not UNBOUND:
        dicts.store(machine, ref, key, value, weak=True)


def _at(call: NativeCall) -> Value:
    machine, found = call.machine, []
    for ref in _maps(call):
        key = _key(machine, ref, call.args[1])
        present = dicts.look_up(machine, machine.obj(ref), key)
        settled = is_settled(key)
        if present.missing and settled:
            found.append(raises(machine, "out_of_range", "map::at"))
            continue
        if present.missing:
            key = unknown_from(machine, "at", "", key)
        if present.missing is not False or not settled:
            may_raise(machine, "out_of_range", "map::at")
        found.append(_place(machine, ref, key))
    return join_all(found) if found else _lost(call)


def _find(call: NativeCall) -> Value:
    machine, found = call.machine, []
    for ref in _maps(call):
        for key in options(_key(machine, ref, call.args[1])):
            present = dicts.look_up(machine, machine.obj(ref), key)
            if not present.missing:
                found.append(entry(ref, key))
            if present.missing is not False:
                found.append(entry(ref, NONE))
    return join_all(found) if found else _lost(call)


def _count(call: NativeCall) -> Value:
    machine = call.machine
    found: list[Value] = []
    is_bool = call.name.endswith("contains")
    for ref in _maps(call):
        missing = dicts.look_up(machine, machine.obj(ref), _key(machine, ref, call.args[1])).missing
        if missing is None:
            found.append(unknown_from(machine, call.name, "bool" if is_bool else "int", read(machine, call.args[1])))
        else:
            found.append(Const(not missing) if is_bool else Const(int(not missing)))
    return join_all(found) if found else _lost(call, "bool" if is_bool else "int")


# Putting in


def _put(machine: Machine, ref: Ref, key: Value, value: Value, *, over: bool) -> Value:
    """Put a value under a key, where there is none or `over` what stands there: the entry, and whether it is new."""
    present = dicts.look_up(machine, machine.obj(ref), key)
    if over:
        dicts.store(machine, ref, key, value)
    else:
        _store(machine, ref, key, value, present)
    new = unknown_from(machine, "insert", "bool", key) if present.missing is None else Const(present.missing)
    return new_pair(machine, entry(ref, key), new)


def _insert(call: NativeCall) -> Value:
    """insert(pair), insert(hint, pair), insert({…}), insert(first, last)."""
    machine, results = call.machine, []
    for ref in _maps(call):
        values = [read(machine, arg) for arg in call.args[1:]]
        if len(values) == 2 and as_iterator(values[0]) is not None and as_iterator(values[1]) is not None:
            results.append(_insert_all(machine, ref, between(machine, values[0], values[1])))
        elif isinstance(values[-1], Tuple) and not _is_pair(values[-1]):
            results.append(_insert_all(machine, ref, Series(values[-1].items)))
        else:
            key, value = _parts(machine, ref, values[-1])
            results.append(_put(machine, ref, key, value, over=False))
    return join_all(results) if results else _lost(call)


def _is_pair(value: Tuple) -> bool:
    return len(value.items) == 2 and not all(isinstance(item, Tuple) and len(item.items) == 2 for item in value.items)


def _insert_all(machine: Machine, ref: Ref, series: Series) -> Value:
    for item in (*series.head, *series.tail):
        _put(machine, ref, *_parts(machine, ref, item), over=False)
    for item in options(series.middle) if series.middle is not None else ():
        key, value = _parts(machine, ref, item)
        dicts.store(machine, ref, key, value, weak=True)
    return NONE


def _parts(machine: Machine, ref: Ref, pair: Value) -> tuple[Value, Value]:
    """Key and value of a pair that comes into a map."""
    pair = read(machine, pair)
    first: Value
    second: Value
    if isinstance(pair, Tuple) and len(pair.items) == 2:
        first, second = pair.items
    elif isinstance(pair, Ref) and machine.obj(pair).kind == "instance":
        first, second = read_field(machine, pair, "first"), read_field(machine, pair, "second")
    else:
        first = second = unknown_from(machine, "pair", "", pair)
    return _key(machine, ref, first), element_from(machine, machine.obj(ref).cls, second, 1)


def _emplace(call: NativeCall) -> Value:
    """emplace(key, value), try_emplace(key, arguments…), insert_or_assign(key, value)."""
    machine, results = call.machine, []
    args = call.args[1:]
    hint = as_iterator(read(machine, args[0])) if args else None
    if hint is not None and hint.kind == "entry":
        args = args[1:]
    for ref in _maps(call):
        if len(args) == 1 and not call.name.endswith("try_emplace"):
            key, value = _parts(machine, ref, args[0])
        elif len(args) == 3 and _is_piecewise(machine, args[0]):
            key, value = (join_all(series_of(machine, a).head) for a in args[1:])
            key = _key(machine, ref, key)
        elif not args:
            continue
        else:
            key = _key(machine, ref, args[0])
            value = made_of(machine, machine.obj(ref).cls, args[1:], 1)
        if value is UNBOUND:
            return UNBOUND
        results.append(_put(machine, ref, key, value, over=call.name.endswith("assign")))
    return join_all(results) if results else _lost(call)


def _is_piecewise(machine: Machine, value: Value) -> bool:
    return getattr(read(machine, value), "name", "") == "std.piecewise_construct"


# Taking away


def _erase(call: NativeCall) -> Value:
    machine = call.machine
    results: list[Value] = []
    values = [read(machine, arg) for arg in call.args[1:]]
    for ref in _maps(call):
        for value in leading_into(ref, values[0]):
            slot = as_iterator(value)
            if slot is None:
                found = dicts.take(machine, ref, _key(machine, ref, value))
                missing = found.missing
                results.append(
                    unknown_from(machine, "erase", "int", value) if missing is None else Const(int(not missing))
                )
            elif len(values) > 1:
                _erase_between(machine, ref, value, values[1])
                results.append(values[1])
            elif slot.key != NONE and isinstance(slot.key, Value):
                behind = moved(machine, value, Const(1))
                dicts.take(machine, ref, slot.key)
                results.append(behind)
    return join_all(results) if results else _lost(call)


def _extract(call: NativeCall) -> Value:
    """What is under a key, taken out: nobody follows where it is put."""
    taken = unknown_from(call.machine, "extract", "", read(call.machine, call.args[0]))
    _erase(call)
    return taken


def _erase_between(machine: Machine, ref: Ref, first: Value, last: Value) -> None:
    keys = keys_in_order(machine, ref)
    a, b = as_iterator(first), as_iterator(last)
    ends = [slot.key if slot is not None else None for slot in (a, b)]
    if keys.rest is None and all(key == NONE or key in keys.known for key in ends):
        known = list(keys.known)
        start, stop = (len(known) if key == NONE else known.index(key) for key in ends if isinstance(key, Value))
        for key in known[start:stop]:
            dicts.take(machine, ref, key)
    else:
        obj = machine.obj(ref)
        machine.update(ref, obj.replace(maybe=frozenset(obj.entries)))


def _clear(call: NativeCall) -> Value:
    for ref in _maps(call):
        obj = call.machine.obj(ref)
        call.machine.update(ref, obj.replace(entries={}, maybe=frozenset(), rest=None, rest_key=None))
    return NONE


def _bound(call: NativeCall) -> Value:
    """lower_bound, upper_bound."""
    machine = call.machine
    found: list[Value] = []
    for ref in _maps(call):
        key, keys = _key(machine, ref, call.args[1]), keys_in_order(machine, ref)
        order = in_order(machine, [*keys.known, key], machine.obj(ref).cls) if keys.rest is None else None
        if order is None:
            found.extend(entry(ref, k) for k in keys.known)
            found.append(entry(ref, NONE) if keys.rest is None else unknown_from(machine, "bound", "", key))
            continue
        rank = order.index(len(keys.known))
        same = key in keys.known
        place = rank - (1 if same and not call.name.endswith("upper_bound") else 0)
        found.append(entry(ref, keys.known[place] if place < len(keys.known) else NONE))
    return join_all(found) if found else _lost(call)


def _merge(call: NativeCall) -> Value:
    machine = call.machine
    for ref in _maps(call):
        _insert_all(machine, ref, series_of(machine, call.args[1]))
    return NONE


def _new(call: NativeCall) -> Value:
    """std::map<K, V>(…): the type comes first."""
    machine, type_, args = call.machine, call.args[0], call.args[1:]
    values = [read(machine, arg) for arg in args]
    if values and isinstance(values[0], Ref) and machine.obj(values[0]).kind == "dict":
        return convert(machine, copied(machine, values[0]), type_)
    if values and isinstance(values[0], Unknown):
        return values[0]
    values, type_ = without_comparison(machine, values, type_)
    made = new_map(machine, type_, (), "new")
    if len(values) > 1 and as_iterator(values[0]) is not None:
        _insert_all(machine, made, between(machine, values[0], values[1]))
    elif len(values) == 1 and isinstance(values[0], Tuple) and not _is_pair(values[0]):
        _insert_all(machine, made, Series(values[0].items))
    elif values:
        _insert_all(machine, made, Series(tuple(v for v in values if isinstance(v, (Tuple, Ref)))))
    return made


_METHODS: Final[dict[str, NativeFunction]] = {
    "operator[]": _index,
    "at": _at,
    "find": _find,
    **dict.fromkeys(("count", "contains"), _count),
    "insert": _insert,
    **dict.fromkeys(("emplace", "emplace_hint", "try_emplace", "insert_or_assign"), _emplace),
    "erase": _erase,
    "extract": _extract,
    "clear": _clear,
    **dict.fromkeys(("lower_bound", "upper_bound"), _bound),
    "merge": _merge,
    "swap": swap,
    **dict.fromkeys(("reserve", "rehash"), nothing),
}

_LEAST: Final = {
    **dict.fromkeys(
        (
            "clear",
            "emplace",
            "reserve",
            "rehash",
        ),
        1,
    ),
}
NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.map.{name}": function for name, function in with_least(_METHODS, 2, _LEAST).items()},
    **{f"std.{kind}.new": _new for kind in ("map", "unordered_map")},
}
