# SPDX-License-Identifier: Apache-2.0
"""Subscripts and slices of values of builtin types.

names[unknown]                      any of the names
Text('/robot_', hole)[1:]           Text('robot_', hole)
"""

from __future__ import annotations

import operator

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import External, Range, Slice, Tuple
from rosward.domain.series import Series, concatenated, joined
from rosward.domain.text import make, parts_of
from rosward.domain.unknown import derived
from rosward.domain.values import NONE, Choice, Const, Ref, Text, Unknown, Value
from rosward.models.native import Machine
from rosward.models.python.comparing.compare import kind_of
from rosward.models.python.comparing.equal_objects import member_value
from rosward.models.python.containers import dicts
from rosward.models.python.containers.lists import add_to_rest, write, write_series
from rosward.models.python.plain import (
    Fresh,
    Raised,
    from_python,
    int_of,
    operation,
    origins,
    range_of,
    run,
    slice_of,
    spread_fresh,
    text_of,
    unknown_from,
    with_origins,
)
from rosward.models.python.strings import text_parts


@operation
def load_item(machine: Machine, value: Value, index: Value) -> Value:
    """value[index]."""
    if isinstance(index, Slice):
        return spread_fresh(
            machine,
            "slice",
            lambda v, *ends: _slice(machine, v, Slice(*(member_value(machine, end) or end for end in ends))),
            value,
            *index.fields(),
        )

    def one(v: Value, i: Value) -> Value | Fresh:
        return _slice(machine, v, i) if isinstance(i, Slice) else _load(machine, v, i)

    return spread_fresh(machine, "slice", one, value, index)


def _load(machine: Machine, value: Value, index: Value) -> Value:
    if not (isinstance(value, Ref) and machine.obj(value).kind == "dict"):
        index = member_value(machine, index) or index
    if isinstance(value, Const):
        if isinstance(index, Const):
            return from_python(machine, run(operator.getitem, value.value, index.value), origins(value, index), "[]")
        if not isinstance(value.value, (str, bytes)):
            raise Raised("TypeError", f"'{value.value.__class__.__name__}' object is not subscriptable")
        return unknown_from(machine, "[]", "str" if isinstance(value.value, str) else "int", index)
    if isinstance(value, Text):
        return with_origins(_character(machine, value, index), origins(value, index))
    if isinstance(value, Tuple):
        return _element(machine, value.items, index, "tuple")
    if isinstance(value, Range):
        numbers, number = range_of(value), int_of(index)
        if number is None or numbers is None:
            return unknown_from(machine, "[]", "int", *value.fields(), index)
        return from_python(machine, run(operator.getitem, numbers, number), origins(value, index), "[]")
    if isinstance(value, Ref):
        return _of_object(machine, value, index)
    return (
        Unknown(derived(value.reasons)) if isinstance(value, Unknown) else unknown_from(machine, "[]", "", value, index)
    )


def _of_object(machine: Machine, ref: Ref, index: Value) -> Value:
    obj = machine.obj(ref)
    if obj.kind == "dict":
        return dicts.load(machine, ref, index)
    if obj.kind == "list":
        if obj.items is not None:
            return _element(machine, obj.items, index, "list")
        number = int_of(index)
        found = obj.rest if number is None else obj.series().at(number)
        if found is None:
            raise Raised("IndexError", "list index out of range", (Const("list index out of range"),))
        return with_origins(found, origins(index))
    if obj.kind == "set":
        raise Raised("TypeError", "'set' object is not subscriptable")
    return unknown_from(machine, "[]", "", ref, index)


def _element(machine: Machine, items: tuple[Value, ...], index: Value, kind: str) -> Value:
    number = int_of(index)
    if number is not None:
        if not -len(items) <= number < len(items):
            raise Raised("IndexError", f"{kind} index out of range", (Const(f"{kind} index out of range"),))
        return with_origins(items[number], origins(index))
    if isinstance(index, Const) or not items:
        raise Raised("IndexError" if not items else "TypeError", "indices must be integers or slices")
    del machine
    return join_all(items)


def _character(machine: Machine, value: Text, index: Value) -> Value:
    number = int_of(index)
    edge = value.parts[0 if number is not None and number >= 0 else -1]
    if number is not None and isinstance(edge, str) and -len(edge) <= number < len(edge):
        return Const(edge[number])
    return unknown_from(machine, "[]", "str", value, index)


# Slices


def _slice(machine: Machine, value: Value, index: Slice) -> Value | Fresh:
    ends, source = slice_of(index), origins(index)
    if isinstance(value, Text) or (text_of(value) is not None and ends is None):
        return with_origins(_text_slice(machine, value, index), source | origins(value))
    if isinstance(value, Const):
        if ends is None:
            return unknown_from(machine, "[:]", value.value.__class__.__name__, *index.fields())
        return from_python(machine, run(operator.getitem, value.value, ends), source | origins(value), "[:]")
    if isinstance(value, Tuple):
        if ends is not None:
            return with_origins(Tuple(value.items[ends]), source)
        return Fresh("list", "tuple", Series(value.items).loose()) if value.items else value
    if isinstance(value, Ref) and machine.obj(value).kind == "list":
        series, kind = machine.obj(value).series(), kind_of(machine, value)
        if ends is not None and ends.step == 0:
            raise Raised("ValueError", "slice step cannot be zero")
        part = series.loose() if ends is None else series.part(ends)
        return Tuple(part.head) if kind == "tuple" and part.exact else Fresh("list", kind, part)
    if isinstance(value, Range) and ends is not None:
        return _range_slice(machine, value, ends)
    return (
        Unknown(derived(value.reasons), value.hint)
        if isinstance(value, Unknown)
        else unknown_from(machine, "[:]", "", value)
    )


def _range_slice(machine: Machine, value: Range, ends: slice) -> Value:
    numbers = range_of(value)
    if numbers is None:
        return unknown_from(machine, "[:]", "range", *value.fields())
    part, source = numbers[ends], origins(value)
    return Range(Const(part.start, source), Const(part.stop, source), Const(part.step, source))


def _text_slice(machine: Machine, value: Value, index: Slice) -> Value:
    """A slice of a text with holes, or with unknown ends."""
    start, stop = int_of(index.lower), int_of(index.upper)
    step_known = index.step in (NONE, Const(1))
    unknown_ends = [v for v, n in ((index.lower, start), (index.upper, stop)) if n is None and v != NONE]
    parts = parts_of(value)
    if unknown_ends or not step_known or (start is not None and start < 0 and stop is not None):
        return unknown_from(machine, "[:]", "str", value, *index.fields())
    if start is not None and start < 0:
        return make(text_parts.mirror(text_parts.take_front(text_parts.mirror(parts), -start)))
    found = [parts]
    if stop is not None and stop < 0:
        found = [text_parts.mirror(p) for p in text_parts.drop_front(text_parts.mirror(parts), -stop)]
    if start:
        found = [q for p in found for q in text_parts.drop_front(p, start)]
    if stop is not None and stop >= 0:
        found = [text_parts.take_front(p, max(0, stop - (start or 0))) for p in found]
    if len(found) > text_parts.MAX_RESULTS:
        return make((text_parts.anything(parts),))
    return join_all(make(p) for p in dict.fromkeys(found))


# Writing


def store_item(machine: Machine, target: Value, index: Value, value: Value, weak: bool = False) -> None:
    """target[index] = value; `weak` where it may not happen, as for one of several targets."""
    several = weak or isinstance(target, Choice)
    for option in options(target):
        if isinstance(option, Ref):
            kind = machine.obj(option).kind
            if kind == "dict":
                dicts.store(machine, option, index, value, several)
            elif kind == "list":
                for where in options(index):
                    _store_element(machine, option, where, value, several or isinstance(index, Choice))
        elif isinstance(option, (Unknown, External)):
            machine.escape((value,), "an item of something unknown", option)


def _store_element(machine: Machine, ref: Ref, index: Value, value: Value, weak: bool) -> None:
    items = machine.obj(ref).items
    if isinstance(index, Slice):
        _store_slice(machine, ref, index, value, weak)
        return
    number, series = int_of(member_value(machine, index) or index), machine.obj(ref).series()
    if number is not None and not series.exact:
        write_series(
            machine, ref, joined(series, series.with_at(number, value), join) if weak else series.with_at(number, value)
        )
    elif items is None:
        add_to_rest(machine, ref, (value,))
    elif number is None:
        write(machine, ref, (join(old, value) for old in items))
    elif -len(items) <= number < len(items):
        changed = list(items)
        changed[number] = join(changed[number], value) if weak else value
        write(machine, ref, changed)
    elif not weak:
        machine.die("IndexError", "list assignment index out of range")


def _store_slice(machine: Machine, ref: Ref, index: Slice, value: Value, weak: bool) -> None:
    old, new, ends = machine.obj(ref).series(), machine.series(value), slice_of(index)
    if not weak and ends is not None and old.exact and new.exact:
        changed = list(old.head)
        try:
            changed[ends] = new.head
        except ValueError as error:  # a slice with steps takes as many as it has places
            machine.die("ValueError", str(error))
        else:
            write(machine, ref, changed)
        return
    if not weak and ends is not None and ends.step in (None, 1):
        begin = ends.start or 0
        if begin >= 0 and (ends.stop is None or 0 <= begin <= ends.stop):
            parts = [old.part(slice(begin)), new, *([] if ends.stop is None else [old.part(slice(ends.stop, None))])]
            write_series(machine, ref, concatenated(parts))
            return
    add_to_rest(machine, ref, (v for v in (new.element(),) if v is not None))
