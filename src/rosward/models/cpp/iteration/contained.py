# SPDX-License-Identifier: Apache-2.0
"""What have all containers in common: what they keep of a value that is put in, where an element stands, what is taken away?

v.push_back(lamp)           a copy of it, as a value of the type of the elements
v.emplace_back("a", 1)      an object made of these
v[0]                        the slot of an element, or the object that it is
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.series import Series
from rosward.domain.slots import Pointer, Slot
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Value
from rosward.models.cpp.iteration.elements import between, series_of
from rosward.models.cpp.iteration.iterators import as_iterator, iterator
from rosward.models.cpp.values.characters import text_behind
from rosward.models.cpp.values.conversions import convert, default_value, owned
from rosward.models.cpp.values.copies import copied, for_each, several
from rosward.models.cpp.values.slots import plain_number, read
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of
from rosward.models.native import Machine, NativeCall
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import int_of, unknown_from

__all__ = [
    "are_pointers",
    "cls_of",
    "element_from",
    "erased",
    "initial",
    "lost",
    "made_of",
    "nothing",
    "place_of",
    "receivers",
    "swap",
    "texts_given",
]

_MOST: Final = 1_000


def receivers(call: NativeCall) -> list[Ref]:
    """The containers on which a method is called."""
    found = options(read(call.machine, call.args[0]))
    return [o for o in found if isinstance(o, Ref) and call.machine.obj(o).kind in ("list", "set", "dict")]


def lost(call: NativeCall, hint: str = "") -> Value:
    """The receiver is no container that is known."""
    return unknown_from(call.machine, call.name, hint, read(call.machine, call.args[0]))


def element_from(machine: Machine, type_: Value, value: Value, index: int = 0) -> Value:
    """What a container of a type keeps of a value: a copy of its own, as a value of the type of its elements."""
    return owned(machine, value, argument(type_, index))


def made_of(machine: Machine, type_: Value, args: tuple[Value, ...], index: int = 0) -> Value:
    """An element made in place, as `emplace` does."""
    wanted = argument(type_, index)
    if name_of(wanted) == "auto":
        return copied(machine, args[0]) if args else NONE
    if shape_of(wanted) in (Shape.CLASS, Shape.OTHER, Shape.LIST, Shape.SET, Shape.MAP, Shape.STREAM):
        return machine.call(wanted, args)
    if not args:
        return default_value(machine, wanted)
    if shape_of(wanted) in (Shape.PAIR, Shape.TUPLE):
        return convert(machine, Tuple(tuple(read(machine, arg) for arg in args)) if len(args) > 1 else args[0], wanted)
    return element_from(machine, type_, args[0], index) if len(args) == 1 else machine.call(wanted, args)


def place_of(machine: Machine, ref: Ref, index: Value) -> Value:
    """The slot of an element; an object itself, and where a reference leads (`std::tie`)."""
    index = plain_number(read(machine, index))
    slot = Slot(ref, "item", index)
    held = read(machine, slot)
    return held if all(isinstance(option, (Ref, Slot)) for option in options(held)) else slot


def cls_of(machine: Machine, ref: Ref) -> Value:
    """The type of a container."""
    return machine.obj(ref).cls


def initial(machine: Machine, type_: Value, args: tuple[Value, ...]) -> Series:
    """The elements that `assign`, `insert` and constructors are given: (n, value), (first, last), (list)."""
    values = [read(machine, arg) for arg in texts_given(machine, type_, args)]
    if not values:
        return Series()
    if len(values) > 1 and leads(values[0]):
        return for_each(machine, between(machine, values[0], values[1]), lambda v: element_from(machine, type_, v))
    first = values[0]
    if any(isinstance(option, (Tuple, Ref)) for option in options(first)):
        refers = shape_of(argument(type_, 0)) is Shape.REFERENCE
        return for_each(machine, series_of(machine, first, slots=refers), lambda v: element_from(machine, type_, v))
    many = [int_of(option) for option in options(first)]
    fill = values[1] if len(values) > 1 else None

    def one() -> Value:
        return default_value(machine, argument(type_, 0)) if fill is None else element_from(machine, type_, fill)

    count = many[0]
    if len(many) == 1 and count is not None and 0 <= count <= _MOST:
        return Series(tuple(one() for _ in range(count)))
    return Series((), several(machine, one()))


def texts_given(machine: Machine, type_: Value, args: tuple[Value, ...]) -> tuple[Value, ...]:
    """What the constructor of a container is given; where that is one of texts, pointers to characters are no iterators but texts."""
    if shape_of(argument(type_, 0)) is not Shape.TEXT:
        return args
    return tuple(text_behind(machine, read(machine, arg)) for arg in args)


def leads(value: Value) -> bool:
    """Whether a value is an iterator, of one container or of one of several."""
    return any(as_iterator(option) is not None for option in options(value))


def are_pointers(machine: Machine, type_: Value, value: Value) -> bool:
    """Whether what leads to an element is one itself, of a container of pointers: `std::vector<const char *>{name, name + 1}`."""
    if shape_of(argument(type_, 0)) is not Shape.POINTER:
        return False
    slots = [as_iterator(option) for option in options(read(machine, value))]
    held = [NONE if slot is None or slot.key == NONE else read(machine, slot) for slot in slots]
    return not any(option == NONE or isinstance(option, Pointer) for each in held for option in options(each))


def erased(machine: Machine, ref: Ref, first: Value, last: Value | None) -> Value:
    """container.erase(first, last): what leads to the element behind."""
    series = machine.obj(ref).series()
    a = as_iterator(first)
    b = as_iterator(last) if last is not None else None
    start = int_of(a.key) if a is not None and isinstance(a.key, Value) else None
    if a is not None and a.key == NONE and (last is None or first == last):
        return iterator(ref, NONE)
    if start is not None and start >= 0:
        if last is None:
            rest = series.without_at(start) if series.at(start) is not None else series
            return _without(machine, ref, rest, start)
        if b is not None and b.key == NONE:
            return _without(machine, ref, series.part(slice(None, start)), start)
        stop = int_of(b.key) if b is not None and isinstance(b.key, Value) else None
        if stop is not None and start <= stop and (series.exact or stop <= len(series.head)):
            return _without(machine, ref, series.without_part(slice(start, stop)), start)
    write_series(machine, ref, series.loose())
    return join_all((iterator(ref, machine.unknown(Cause.OPERATION, "erase", "int")), iterator(ref, NONE)))


def _without(machine: Machine, ref: Ref, series: Series, start: int) -> Value:
    write_series(machine, ref, series)
    return iterator(ref, NONE if series.exact and start >= len(series.head) else Const(start))


def swap(call: NativeCall) -> Value:
    """Two containers change what they hold."""
    machine = call.machine
    ours, theirs = (read(machine, arg) for arg in call.exactly(2))
    if isinstance(ours, Ref) and isinstance(theirs, Ref):
        a, b = machine.obj(ours), machine.obj(theirs)
        machine.update(ours, b.replace(many=a.many, cls=a.cls))
        machine.update(theirs, a.replace(many=b.many, cls=b.cls))
    return NONE


def nothing(call: NativeCall) -> Value:
    """A method that matters to nobody."""
    del call
    return NONE
