# SPDX-License-Identifier: Apache-2.0
"""Which elements lie between two iterators, where does each stand, and how are they given other values?

std::find_if(v.begin(), v.end(), f)     each place in turn
std::sort(v.begin(), v.end())           the elements in another order: `rewrite`
std::copy(a, b, std::back_inserter(v))  `emit`: what an output iterator takes
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import options
from rosward.domain.compound import External, Partial, Tuple
from rosward.domain.series import Series, concatenated
from rosward.domain.slots import Pointer, Slot
from rosward.domain.values import NONE, Const, Ref, Text, Value
from rosward.models.cpp.iteration.contained import element_from
from rosward.models.cpp.iteration.iterators import as_iterator, iterator, length, moved, same_place
from rosward.models.cpp.strings import streams
from rosward.models.cpp.strings.string_parts import characters, from_characters
from rosward.models.cpp.values.characters import as_kept
from rosward.models.cpp.values.copies import copied, for_each, write
from rosward.models.cpp.values.slots import key_of, read
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of
from rosward.models.native import Machine
from rosward.models.python.containers import dicts
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import MAX_ITEMS, int_of, text_of, unknown_from

__all__ = ["INSERTERS", "emit", "is_inserter", "is_whole", "place", "places", "rewrite", "whole_text"]

INSERTERS: Final = ("std.back_inserter", "std.front_inserter", "std.inserter", "std.ostream_iterator")


def places(machine: Machine, first: Value, last: Value) -> list[Value] | None:
    """The iterators to the elements from one to another; None where it is not known which there are."""
    first, last = read(machine, first), read(machine, last)
    a, b = as_iterator(first), as_iterator(last)
    if a is None or b is None or a.base != b.base or a.kind != b.kind:
        return None
    if length(machine, a.base) is None:
        return None
    found: list[Value] = []
    here: Value = first
    while here != last and len(found) <= MAX_ITEMS:
        slot = as_iterator(here)
        if slot is not None and isinstance(slot.base, (Const, Slot)) and same_place(machine, slot, b):
            return found  # where a text ends, also by its number
        if (
            slot is None
            or slot.key == NONE
            or (b.key != NONE and not isinstance(slot.key, Const) and slot.kind != "entry")
        ):
            return found if slot is not None and slot.key == NONE and b.key == NONE else None
        found.append(here)
        here = moved(machine, here, Const(1))
    return found if len(found) <= MAX_ITEMS else None


def place(machine: Machine, where: Value) -> Value:
    """What an iterator leads to: the slot of an element, or the object itself."""
    slot = as_iterator(where)
    if slot is None:
        return where.target if isinstance(where, Pointer) else read(machine, where)
    held = read(machine, slot) if slot.kind != "entry" else slot
    return held if all(isinstance(option, Ref) for option in options(held)) else slot


def _span(machine: Machine, first: Slot, last: Slot) -> tuple[int, int] | None:
    """The numbers of the elements between two iterators of a sequence."""
    size = length(machine, first.base)
    start = size if first.key == NONE else int_of(first.key) if isinstance(first.key, Value) else None
    stop = size if last.key == NONE else int_of(last.key) if isinstance(last.key, Value) else None
    if start is None or stop is None or first.kind != "item" or not 0 <= start <= stop:
        return None
    return start, stop


def _forward(machine: Machine, slot: Slot) -> Slot:
    """What `reverse_iterator::base()` gives: where a range ends, or begins, that is run through from the end."""
    size, at = (
        length(machine, slot.base),
        -1 if slot.key == NONE else int_of(slot.key) if isinstance(slot.key, Value) else None,
    )
    if at is None or at < -1:
        return Slot(slot.base, "item", NONE if slot.key == Const(-1) else unknown_from(machine, "base", "int"))
    return Slot(slot.base, "item", NONE if size == at + 1 else Const(at + 1))


def is_whole(machine: Machine, first: Value, last: Value) -> Slot | None:
    """The base of two iterators that lead from its beginning to its end."""
    a, b = as_iterator(read(machine, first)), as_iterator(read(machine, last))
    if a is None or b is None or a.base != b.base or a.kind != "item":
        return None
    return a if a.key in (Const(0), NONE) and b.key == NONE else None


def whole_text(machine: Machine, first: Value, last: Value) -> tuple[Value, Value] | None:
    """The slot and the text of a string that lies between two iterators; None for anything else."""
    slot = is_whole(machine, first, last)
    if slot is None or isinstance(slot.base, Ref):
        return None
    held = read(machine, slot.base)
    kinds = {getattr(option, "hint", "str") for option in options(held)}
    texts = all(isinstance(o, Text) or text_of(o) is not None or getattr(o, "hint", "") == "str" for o in options(held))
    return (slot.base, held) if texts and kinds == {"str"} else None


def rewrite(machine: Machine, first: Value, last: Value, series: Series) -> None:
    """The elements between two iterators become others, as many; where that is not known, any of them."""
    a, b = as_iterator(read(machine, first)), as_iterator(read(machine, last))
    if a is None or b is None:
        return
    if a.kind == "reverse":
        a, b, series = _forward(machine, b), _forward(machine, a), series.reversed()
    span = _span(machine, a, b)
    if isinstance(a.base, Ref) and machine.obj(a.base).kind in ("list", "set"):
        old, cls = machine.obj(a.base).series(), machine.obj(a.base).cls
        series = series.mapped(lambda v: element_from(machine, cls, v)) if _of_strings(cls) else series
        if span is not None and old.exact and series.exact:
            start, stop = span
            write_series(machine, a.base, concatenated((Series(old.head[:start]), series, Series(old.head[stop:]))))
            return
        new = series.element()
        if a.key == Const(0) and b.key == NONE:
            write_series(machine, a.base, series)
        elif new is not None:
            write_series(machine, a.base, concatenated((old, Series((), new))).loose())
        return
    if isinstance(a.base, Ref):
        return
    held = characters(read(machine, a.base))
    if held is not None and span is not None and series.exact:
        write(machine, a.base, from_characters(machine, (*held[: span[0]], *series.head, *held[span[1] :])))
    else:
        write(machine, a.base, unknown_from(machine, "range", "str", read(machine, a.base), series.element()))


def _of_strings(type_: Value) -> bool:
    """Whether a container is one of strings."""
    inner = argument(type_, 0)
    return shape_of(inner) is Shape.TEXT and name_of(inner) != "array"


# Output


def is_inserter(value: Value) -> bool:
    """Whether a value is what `std::back_inserter` and the like give."""
    return isinstance(value, Partial) and isinstance(value.function, External) and value.function.name in INSERTERS


def emit(machine: Machine, out: Value, series: Series) -> Value:
    """What an output iterator takes; gives the iterator behind it."""
    out = read(machine, out)
    if isinstance(out, Partial) and isinstance(out.function, External) and out.function.name in INSERTERS:
        _insert(machine, out.function.name, out.arguments, series)
        return out
    slot = as_iterator(out)
    if slot is None:
        return unknown_from(machine, "copy", "", out)
    if not series.exact:
        behind = unknown_from(machine, "copy", "int", series.middle)
        for value in (*series.head, *(() if series.middle is None else (series.middle,)), *series.tail):
            somewhere = Slot(slot.base, slot.kind, behind)
            write(machine, somewhere, as_kept(machine, somewhere, copied(machine, value)), weak=True)
        return iterator(slot.base, behind)
    size = length(machine, slot.base)
    start = size if slot.key == NONE else int_of(slot.key) if isinstance(slot.key, Value) else None
    if start is not None and size is not None and start + len(series.head) <= size:
        stop = iterator(slot.base, Const(start + len(series.head)))
        rewrite(machine, out, stop, for_each(machine, series, lambda v: copied(machine, v)))
        return moved(machine, out, Const(len(series.head)))
    for number, value in enumerate(series.head):
        target = as_iterator(moved(machine, out, Const(number)))
        if target is not None:
            write(machine, target, as_kept(machine, target, copied(machine, value)))
    return moved(machine, out, Const(len(series.head)))


def _insert(machine: Machine, kind: str, arguments: tuple[Value, ...], series: Series) -> None:
    for option in options(read(machine, arguments[0])):
        if kind == "std.ostream_iterator":
            for value in (*series.head, *(() if series.middle is None else (series.middle,)), *series.tail):
                for each in (value, *arguments[1:2]):
                    streams.insert(machine, option, each)
        elif isinstance(option, Ref):
            _insert_into(machine, kind, option, series)
        else:
            _append_text(machine, arguments[0], series)


def _insert_into(machine: Machine, kind: str, ref: Ref, series: Series) -> None:
    obj = machine.obj(ref)
    cls = obj.cls
    if obj.kind == "dict":
        for pair in (*series.head, *series.tail, *(() if series.middle is None else options(series.middle))):
            if isinstance(pair, Tuple) and len(pair.items) == 2:
                first, second = pair.items
            else:
                first, second = (
                    read(machine, Slot(read(machine, pair), "field", name)) for name in ("first", "second")
                )
            dicts.store(machine, ref, key_of(machine, first), copied(machine, second), weak=not series.exact)
        return
    fresh = for_each(machine, series, lambda v: element_from(machine, cls, v))
    if name_of(cls).endswith("set"):
        fresh = fresh.mapped(lambda v: key_of(machine, v))
    old = obj.series()
    together = (fresh.reversed(), old) if kind == "std.front_inserter" else (old, fresh)
    write_series(machine, ref, concatenated(together))


def _append_text(machine: Machine, slot: Value, series: Series) -> None:
    held = read(machine, slot)
    if series.exact:
        more = from_characters(machine, series.head)
    else:
        more = unknown_from(machine, "copy", "str", series.element())
    write(machine, slot, machine.binary("+", held, more))
