# SPDX-License-Identifier: Apache-2.0
"""Sequences: `vector`, `deque`, `list`, `array`, `queue`, `stack`, C arrays. What do their methods do to the elements?

v.push_back(lamp)           a copy of it comes to the end
v.emplace_back("a", 1)      an object made of these
v.at(7)                     std::out_of_range, where there are surely fewer
v.insert(v.end(), w.begin(), w.end())
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Tuple
from rosward.domain.series import Series, concatenated
from rosward.domain.slots import Slot
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.containers.sorting import sorted_values
from rosward.models.cpp.iteration.contained import (
    are_pointers,
    cls_of,
    element_from,
    erased,
    initial,
    leads,
    lost,
    made_of,
    nothing,
    place_of,
    receivers,
    swap,
    texts_given,
)
from rosward.models.cpp.iteration.exceptions import is_settled, may_raise, raises
from rosward.models.cpp.iteration.iterators import as_iterator, iterator, leading_into
from rosward.models.cpp.iteration.iterators import begin as begin_of
from rosward.models.cpp.iteration.iterators import end as end_of
from rosward.models.cpp.strings.streams import words_of
from rosward.models.cpp.values.conversions import convert, default_value, is_one, new_container
from rosward.models.cpp.values.copies import copied, for_each
from rosward.models.cpp.values.ordering import foremost, without_comparison
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import MAX_ITEMS, int_of, unknown_from

__all__ = ["NATIVES"]


# Adding


def _add(call: NativeCall, *, front: bool, emplace: bool) -> Value:
    machine, found = call.machine, []
    for ref in receivers(call):
        cls = cls_of(machine, ref)
        fresh = made_of(machine, cls, call.args[1:]) if emplace else element_from(machine, cls, call.args[1])
        if fresh is UNBOUND:
            return UNBOUND
        old = machine.obj(ref).series()
        write_series(machine, ref, concatenated((Series((fresh,)), old) if front else (old, Series((fresh,)))))
        number = 0 if front else len(old.head)
        found.append(
            fresh if isinstance(fresh, Ref) else Slot(ref, "item", Const(number if front or old.exact else -1))
        )
    return join_all(found) if found and emplace else NONE


def _push_back(call: NativeCall) -> Value:
    return _add(call, front=False, emplace=False)


def _emplace_back(call: NativeCall) -> Value:
    return _add(call, front=False, emplace=True)


def _push_front(call: NativeCall) -> Value:
    return _add(call, front=True, emplace=False)


def _emplace_front(call: NativeCall) -> Value:
    return _add(call, front=True, emplace=True)


def _insert(call: NativeCall) -> Value:
    machine, result = call.machine, []
    for ref in receivers(call):
        cls = cls_of(machine, ref)
        where = as_iterator(read(machine, call.args[1]))
        if call.name.endswith("emplace"):
            fresh = Series((made_of(machine, cls, call.args[2:]),))
        elif len(call.args) == 3 and not isinstance(read(machine, call.args[2]), Tuple):
            fresh = Series((element_from(machine, cls, call.args[2]),))
        else:
            fresh = initial(machine, cls, call.args[2:])
        result.append(_inserted(machine, ref, where, fresh))
    return join_all(result) if result else lost(call)


def _inserted(machine: Machine, ref: Ref, where: Slot | None, fresh: Series) -> Value:
    old = machine.obj(ref).series()
    at = int_of(where.key) if where is not None and isinstance(where.key, Value) else None
    if where is not None and where.key == NONE:
        write_series(machine, ref, concatenated((old, fresh)))
        return iterator(ref, Const(len(old.head)) if old.exact else unknown_from(machine, "insert", "int", old.middle))
    if at is not None and 0 <= at <= len(old.head):
        behind = Series(old.head[at:], old.middle, old.tail)
        write_series(machine, ref, concatenated((Series(old.head[:at]), fresh, behind)))
        return iterator(ref, Const(at))
    everything = [v for v in (old.element(), fresh.element()) if v is not None]
    if everything:
        write_series(machine, ref, Series((), join_all(everything)))
    return iterator(ref, machine.unknown(Cause.OPERATION, "insert", "int"))


# Taking away


def _pop(call: NativeCall) -> Value:
    for ref in receivers(call):
        series = call.machine.obj(ref).series()
        front = call.name.endswith("front") or (call.name.endswith(".pop") and not _is_stack(call.machine, ref))
        if series.exact and not series.head:
            continue  # undefined
        if name_of(cls_of(call.machine, ref)) == "std.priority_queue":
            number = foremost(call.machine, series, cls_of(call.machine, ref))
            kept = series.loose() if number is None else Series((*series.head[:number], *series.head[number + 1 :]))
        else:
            kept = series.without_at(0 if front else -1)
        write_series(call.machine, ref, kept)
    return NONE


def _is_stack(machine: Machine, ref: Ref) -> bool:
    return name_of(cls_of(machine, ref)) in ("std.stack", "std.priority_queue")


def _erase(call: NativeCall) -> Value:
    machine = call.machine
    values = [read(machine, arg) for arg in call.args[1:3]]
    found = [
        erased(machine, ref, first, last)
        for ref in receivers(call)
        for first in leading_into(ref, values[0])
        for last in (options(values[1]) if len(values) > 1 else (None,))
    ]
    return join_all(found) if found else lost(call)


def _clear(call: NativeCall) -> Value:
    for ref in receivers(call):
        write_series(call.machine, ref, Series())
    return NONE


def _resize(call: NativeCall) -> Value:
    machine = call.machine
    count = int_of(read(machine, call.args[1]))
    for ref in receivers(call):
        series, cls = machine.obj(ref).series(), cls_of(machine, ref)
        if count is not None and 0 <= count <= MAX_ITEMS and not series.exact:
            fresh = initial(machine, cls, (Const(count), *call.args[2:])).head
            older = series.behind_head()
            behind = fresh if older is None else tuple(join_all((older, each)) for each in fresh)
            write_series(machine, ref, Series((*series.head[:count], *behind[len(series.head) :])))
        elif count is None or not 0 <= count <= MAX_ITEMS:
            more = initial(machine, cls, (machine.unknown(Cause.LIMIT, "size", "int"), *call.args[2:])).element()
            elements = [v for v in (series.element(), more) if v is not None]
            write_series(machine, ref, Series((), join_all(elements)))
        elif count <= len(series.head):
            write_series(machine, ref, Series(series.head[:count]))
        else:
            more_ones = initial(machine, cls, (Const(count - len(series.head)), *call.args[2:]))
            write_series(machine, ref, concatenated((series, more_ones)))
    return NONE


def _assign(call: NativeCall) -> Value:
    for ref in receivers(call):
        write_series(call.machine, ref, initial(call.machine, cls_of(call.machine, ref), call.args[1:]))
    return NONE


def _fill(call: NativeCall) -> Value:
    for ref in receivers(call):
        cls = cls_of(call.machine, ref)
        series = call.machine.obj(ref).series()
        filled = for_each(call.machine, series, lambda _, c=cls: element_from(call.machine, c, call.args[1]))  # type: ignore[misc]
        write_series(call.machine, ref, filled)
    return NONE


# Asking


def _at(call: NativeCall) -> Value:
    machine, found = call.machine, []
    index = read(machine, call.args[1])
    settled = is_settled(index)
    for ref in receivers(call):
        series, number = machine.obj(ref).series(), int_of(index)
        beyond = series.exact and number is not None and not 0 <= number < len(series.head)
        if beyond and settled:
            found.append(raises(machine, "out_of_range", "vector::_M_range_check"))
            continue
        if number is None or number >= series.least or not settled:
            may_raise(machine, "out_of_range", "vector::_M_range_check")
        found.append(place_of(machine, ref, unknown_from(machine, "at", "int", index) if beyond else index))
    return join_all(found) if found else lost(call)


def _index(call: NativeCall) -> Value:
    found = [place_of(call.machine, ref, call.args[1]) for ref in receivers(call)]
    return join_all(found) if found else lost(call)


def _edge(call: NativeCall) -> Value:
    """front(), back(), top()."""
    machine, found = call.machine, []
    for ref in receivers(call):
        series = machine.obj(ref).series()
        name = call.name.rpartition(".")[2]
        if name == "front" or (name == "top" and not _is_stack(machine, ref)):
            found.append(place_of(machine, ref, Const(0)))
            continue
        if name == "top" and name_of(cls_of(machine, ref)) == "std.priority_queue":
            number = foremost(machine, series, cls_of(machine, ref))
            found.append((series.element() if number is None else series.head[number]) or lost(call))
            continue
        last = series.at(-1)
        if last is None:
            found.append(machine.unknown(Cause.OPERATION, "back() of an empty container"))
        elif isinstance(last, Ref) or not series.exact:
            found.append(last)
        else:
            found.append(Slot(ref, "item", Const(len(series.head) - 1)))
    return join_all(found) if found else lost(call)


def _capacity(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.OPERATION, "capacity", "int")


# Lists


def _reverse(call: NativeCall) -> Value:
    for ref in receivers(call):
        write_series(call.machine, ref, call.machine.obj(ref).series().reversed())
    return NONE


def _remove(call: NativeCall) -> Value:
    """list.remove(value)."""
    machine = call.machine
    for ref in receivers(call):
        series = machine.obj(ref).series()
        answers = [machine.truth(machine.compare("==", item, read(machine, call.args[1]))) for item in series.head]
        if not series.exact or None in answers:
            write_series(machine, ref, series.loose())
        else:
            write_series(
                machine, ref, Series(tuple(v for v, gone in zip(series.head, answers, strict=True) if not gone))
            )
    return NONE


def _sort(call: NativeCall) -> Value:
    """list.sort(compare)."""
    function = read(call.machine, call.args[1]) if len(call.args) > 1 else None
    for ref in receivers(call):
        write_series(call.machine, ref, sorted_values(call.machine, call.machine.obj(ref).series(), function))
    return NONE


def _as_algorithm(name: str) -> NativeFunction:
    """list.remove_if(f), list.unique(): as the algorithm of that name, and what it leaves behind is gone."""

    def apply(call: NativeCall) -> Value:
        machine = call.machine
        for ref in receivers(call):
            end = machine.call(External(f"std.{name}"), (begin_of(machine, ref), end_of(machine, ref), *call.args[1:]))
            erased(machine, ref, end, end_of(machine, ref))
        return NONE

    return apply


# Making


def _new(call: NativeCall) -> Value:
    """std::vector<T>(…): the type comes first."""
    machine, type_, args = call.machine, call.args[0], call.args[1:]
    if name_of(type_) == "std.priority_queue":
        values, type_ = without_comparison(machine, [read(machine, arg) for arg in args], type_)
        args = tuple(values)
    args = texts_given(machine, type_, args)
    words = words_of(machine, read(machine, args[0]), shape_of(argument(type_, 0)) is Shape.TEXT) if args else None
    if words is not None:
        return new_container(machine, type_, words, "new")
    braced = "brace" in str(getattr(call.keywords.get("form"), "value", ""))
    if len(args) == 1:
        first = read(machine, args[0])
        if isinstance(first, Tuple):
            alone = braced and shape_of(type_) is Shape.LIST and is_one(argument(type_, 0), first)
            return convert(machine, Tuple((first,)) if alone else first, type_)
        if isinstance(first, Unknown) and first.hint not in ("int", "float", "bool"):
            return first
        if all(_is_whole(machine, type_, option) for option in options(first)):
            return convert(machine, copied(machine, first), type_)
    if braced and args and (not leads(read(machine, args[0])) or are_pointers(machine, type_, args[0])):
        return convert(machine, Tuple(tuple(args)), type_)
    if shape_of(type_) in (Shape.ARRAY, Shape.TUPLE) and args:
        return convert(machine, Tuple(tuple(args)), type_)
    if shape_of(type_) is Shape.ARRAY:
        return default_value(machine, type_)
    return new_container(machine, type_, initial(machine, type_, args), "new")


def _is_whole(machine: Machine, type_: Value, value: Value) -> bool:
    """Whether a container is a copy of a value; nobody knows a number of elements of it."""
    if isinstance(value, Ref):
        return machine.obj(value).kind in ("list", "set") and not _nests(machine, type_, value)
    return isinstance(value, Unknown) and value.hint not in ("int", "float", "bool")


def _nests(machine: Machine, type_: Value, value: Ref) -> bool:
    """Whether a container is an element of what is made of it, not what is copied."""
    return name_of(argument(type_, 0)) == name_of(machine.obj(value).cls) != name_of(type_)


_KINDS: Final = (
    "vector",
    "deque",
    "list",
    "forward_list",
    "array",
    "queue",
    "stack",
    "priority_queue",
    "initializer_list",
    "span",
)

_METHODS: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("push_back", "push"), _push_back),
    **dict.fromkeys(("emplace_back",), _emplace_back),
    "push_front": _push_front,
    "emplace_front": _emplace_front,
    **dict.fromkeys(("pop_back", "pop_front", "pop"), _pop),
    **dict.fromkeys(("insert", "emplace"), _insert),
    "erase": _erase,
    "clear": _clear,
    "resize": _resize,
    "assign": _assign,
    "fill": _fill,
    "at": _at,
    "operator[]": _index,
    **dict.fromkeys(("front", "back", "top"), _edge),
    "swap": swap,
    **dict.fromkeys(("reserve", "shrink_to_fit"), nothing),
    **dict.fromkeys(("capacity", "max_size"), _capacity),
    "reverse": _reverse,
    "remove": _remove,
    "sort": _sort,
    "remove_if": _as_algorithm("remove_if"),
    "unique": _as_algorithm("unique"),
}

_LEAST: Final = {
    **dict.fromkeys(
        (
            "push_back",
            "push",
            "push_front",
            "erase",
            "resize",
            "fill",
            "at",
            "operator[]",
            "swap",
            "remove",
            "remove_if",
        ),
        2,
    ),
    **dict.fromkeys(("insert",), 3),
    "emplace": 2,
}
NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.vector.{name}": function for name, function in with_least(_METHODS, 1, _LEAST).items()},
    **{f"std.{kind}.emplace": _emplace_back for kind in ("queue", "stack", "priority_queue")},
    **{f"std.{kind}.new": _new for kind in _KINDS},
}
