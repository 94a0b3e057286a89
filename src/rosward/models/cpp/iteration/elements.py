# SPDX-License-Identifier: Apache-2.0
"""What does `for (auto & x : v)` run through, and into which parts does `auto & [a, b] = v` take apart?

vector of strings       the slots of its elements, or the texts themselves
vector of objects       the objects: each is its own slot
map                     the slots of its entries, or pairs of key and value, in the order of the keys

The same for what lies between two iterators, of which algorithms are given pairs.
"""

from __future__ import annotations

import functools

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.series import Series, joined
from rosward.domain.slots import Slot, SlotKind, TypeOf
from rosward.domain.unknown import Cause, derived
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Ref, Text, Unknown, Value
from rosward.models.cpp.iteration.iterators import as_iterator, keys_in_order, length
from rosward.models.cpp.values.slots import key_value, read, read_field
from rosward.models.native import Machine
from rosward.models.python.operators.operators import iterate as iterate_text
from rosward.models.python.plain import MAX_ITEMS, int_of, text_of, unknown_from

__all__ = ["between", "elements", "parts", "series_of"]


def elements(machine: Machine, value: Value, *, slots: bool) -> Value:
    """What a range-based `for` runs through: a tuple, or a list where the number is not known; its slots where `slots`."""
    found = [_elements(machine, option, slots=slots) for option in _bases(machine, value)]
    series = functools.reduce(lambda a, b: joined(a, b, join), found) if found else Series()
    if series.exact:
        return Tuple(series.head) if len(series.head) <= MAX_ITEMS else machine.new_list((), series.element())
    return machine.new_list(series.head, series.middle, series.tail)


def series_of(machine: Machine, value: Value, *, slots: bool = False) -> Series:
    """The elements of a container, as far as their order is known."""
    found = [_elements(machine, option, slots=slots) for option in _bases(machine, value)]
    return functools.reduce(lambda a, b: joined(a, b, join), found) if found else Series()


def _bases(machine: Machine, value: Value) -> tuple[Value, ...]:
    """The alternatives of a container; the slot of a string stays a slot, so that its characters can be written."""
    found: list[Value] = []
    for option in options(value):
        held = read(machine, option)
        texts = any(text_of(o) is not None or isinstance(o, Text) for o in options(held))
        found.extend((option,) if texts and option.__class__ is Slot else options(held))
    return tuple(found)


def _elements(machine: Machine, base: Value, *, slots: bool) -> Series:
    held = read(machine, base)
    if isinstance(held, Tuple):
        return Series(tuple(item if slots else read(machine, item) for item in held.items))
    if isinstance(held, Ref):
        return _of_object(machine, held, slots=slots)
    count = length(machine, held)
    if count is not None and count <= MAX_ITEMS:
        places = (Slot(base, "item", Const(n)) for n in range(count))
        return Series(tuple(place if slots else read(machine, place) for place in places))
    if isinstance(held, (Text, Const)):
        return Series((), iterate_text(machine, held).rest or unknown_from(machine, "for", "str", held))
    if isinstance(held, Unknown):
        return Series((), Unknown(derived(held.reasons), "str" if held.hint == "str" else ""))
    return Series((), unknown_from(machine, "for", "", held))


def _of_object(machine: Machine, ref: Ref, *, slots: bool) -> Series:
    obj = machine.obj(ref)
    if obj.kind == "dict":
        keys = keys_in_order(machine, ref)
        places = Series(keys.known, keys.rest).mapped(lambda key: Slot(ref, "entry", key))
        return places if slots else places.mapped(lambda place: read(machine, place))
    if obj.kind in ("list", "set"):
        return _of_list(machine, ref, slots=slots)
    if isinstance(obj.cls, Class):
        return _of_own_range(machine, ref, slots=slots)
    if isinstance(obj.cls, TypeOf) and obj.cls.name == _RANGE:
        first, last = (obj.attrs.get(name, NONE) for name in ("begin", "end"))
        return between(machine, first, last, slots=slots)
    return Series((), unknown_from(machine, "for", "", ref))


_RANGE = "std.ranges.subrange"


def _of_list(machine: Machine, ref: Ref, *, slots: bool) -> Series:
    series = machine.obj(ref).series()
    is_set = _is_set(machine, ref)
    if is_set:
        return series.mapped(lambda key: key_value(machine, ref, key))
    if not slots:
        return series
    head = tuple(_place(ref, number, item) for number, item in enumerate(series.head))
    if series.middle is None:
        return Series(head)
    anywhere = machine.unknown(Cause.OPERATION, "position", "int")

    def loose(value: Value) -> Value:
        return value if all(o.__class__ is Ref for o in options(value)) else Slot(ref, "item", anywhere)

    return Series(head, loose(series.middle), tuple(map(loose, series.tail)))


def _place(ref: Ref, number: int, item: Value) -> Value:
    """The slot of an element; an object is its own."""
    return item if item.__class__ is Ref else Slot(ref, "item", Const(number))


def _is_set(machine: Machine, ref: Ref) -> bool:
    cls = machine.obj(ref).cls
    return isinstance(cls, TypeOf) and cls.name.endswith("set") and cls.name.startswith("std.")


def _of_own_range(machine: Machine, ref: Ref, *, slots: bool) -> Series:
    """An object of a class of the program: what lies between its `begin()` and `end()`."""
    ends = [machine.call(machine.load_attr(ref, name), ()) for name in ("begin", "end")]
    if UNBOUND in ends:
        return Series()
    if any(place is not None and place.base == ref for place in map(as_iterator, options(read(machine, ends[0])))):
        return Series((), unknown_from(machine, "for", "", ref))  # those of a container that it is derived from
    return between(machine, ends[0], ends[1], slots=slots)


# Between iterators


def between(machine: Machine, first: Value, last: Value, *, slots: bool = False) -> Series:
    """The elements from one iterator to another."""
    first, last = read(machine, first), read(machine, last)
    if isinstance(first, Choice) or isinstance(last, Choice):
        pairs = [(a, b) for a in options(first) for b in options(last) if _same_base(a, b)]
        if len(pairs) > 16 or not pairs:
            return Series((), unknown_from(machine, "range", "", first, last))
        found = [between(machine, a, b, slots=slots) for a, b in pairs]
        return functools.reduce(lambda a, b: joined(a, b, join), found)
    a, b = as_iterator(first), as_iterator(last)
    if a is None or b is None or a.base != b.base:
        return Series((), unknown_from(machine, "range", "", first, last))
    whole = _elements(machine, a.base, slots=slots)
    start, stop = _place_of(machine, a), _place_of(machine, b)
    if a.kind == "reverse":
        if whole.exact and start is not None and stop is not None:
            return Series(whole.head[max(0, stop + 1) : start + 1][::-1])
        return whole.reversed() if b.key == NONE and _is_begin(a) else whole.loose()
    if start is not None and stop is not None and whole.exact:
        return Series(whole.head[start:stop])
    if start is not None and a.kind == "item" and b.key == NONE:
        return whole.without(start)
    if start is not None and stop is not None and a.kind == "item" and start <= stop <= len(whole.head):
        return Series(whole.head[start:stop])
    return (whole.without(start) if start is not None and a.kind == "item" else whole).loose()


def _same_base(a: Value, b: Value) -> bool:
    one, other = as_iterator(a), as_iterator(b)
    return one is not None and other is not None and one.base == other.base


def _is_begin(slot: Slot) -> bool:
    return slot.key == Const(-1)


def _place_of(machine: Machine, slot: Slot) -> int | None:
    """Which element an iterator leads to; None where that is not known, or it is the end of an unknown number."""
    if not isinstance(slot.key, Value):
        return None
    if slot.kind == "entry":
        assert isinstance(slot.base, Ref)
        keys = keys_in_order(machine, slot.base)
        if keys.rest is not None:
            return None
        known = list(keys.known)
        return len(known) if slot.key == NONE else known.index(slot.key) if slot.key in known else None
    if slot.key == NONE:
        return -1 if slot.kind == "reverse" else length(machine, slot.base)
    number = int_of(slot.key)
    return number if number is None or number >= 0 else None


# Taking apart


def parts(machine: Machine, value: Value, count: int, *, slots: bool) -> tuple[Value, ...]:
    """The parts of a pair, tuple, array or entry of a map; their slots where `slots`."""
    found = [_parts(machine, option, count, slots=slots) for option in options(value)]
    return tuple(join_all(column) for column in zip(*found, strict=True))


def _parts(machine: Machine, value: Value, count: int, *, slots: bool) -> tuple[Value, ...]:
    if (
        value.__class__ is Slot
        and value.kind == "entry"
        and isinstance(value.base, Ref)
        and isinstance(value.key, Value)
    ):
        second = Slot(value.base, "item", value.key)
        held = read(machine, second)
        return _fitting(
            machine,
            (key_value(machine, value.base, value.key), second if slots and not _is_object(held) else held),
            count,
        )
    held = read(machine, value)
    if isinstance(held, Choice):
        return parts(machine, held, count, slots=slots)
    if isinstance(held, Ref):
        obj = machine.obj(held)
        if obj.kind == "instance" and isinstance(obj.cls, TypeOf) and obj.cls.name == "std.pair":
            return _fitting(
                machine, tuple(_field(machine, held, name, "field", slots=slots) for name in ("first", "second")), count
            )
        if obj.kind == "list":
            series = _elements(machine, held, slots=slots)
            if series.exact:
                return _fitting(machine, series.head, count)
            return tuple(series.at(number) or unknown_from(machine, "part", "", held) for number in range(count))
    if isinstance(held, Tuple):
        return _fitting(machine, held.items, count)
    return (unknown_from(machine, "part", "", held),) * count


def _field(machine: Machine, ref: Ref, name: str, kind: SlotKind, *, slots: bool) -> Value:
    held = read_field(machine, ref, name)
    return Slot(ref, kind, name) if slots and not _is_object(held) else held


def _is_object(value: Value) -> bool:
    return value.__class__ is Ref


def _fitting(machine: Machine, found: tuple[Value, ...], count: int) -> tuple[Value, ...]:
    """So many parts."""
    missing = max(0, count - len(found))
    return (*found[:count], *(machine.unknown(Cause.OPERATION, "part") for _ in range(missing)))
