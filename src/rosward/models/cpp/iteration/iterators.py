# SPDX-License-Identifier: Apache-2.0
"""To what does an iterator lead, and where does it go from there?

    v.begin() + 2           Pointer(Slot(v, 'item', 2)); v.end() is Pointer(Slot(v, 'item', None))
    m.find("a")             Pointer(Slot(m, 'entry', 'a')), or m.end(), or both
    s.rbegin()              Pointer(Slot(s, 'reverse', 2)) of a string of three

Pointers to elements of an array are the same. A map is run through in the order of its keys where all are known.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.slots import Pointer, Slot, SlotKind, TypeOf
from rosward.domain.values import FALSE, NONE, UNBOUND, Choice, Const, Ref, Text, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.ordering import in_order, is_asked
from rosward.models.cpp.values.slots import read
from rosward.models.native import Items, Machine, NativeCall, NativeFunction
from rosward.models.python.plain import all_of, int_of, text_of, unknown_from

__all__ = [
    "OF_PLACES",
    "as_iterator",
    "begin",
    "distance",
    "end",
    "entry",
    "in_pairs",
    "iterator",
    "keys_in_order",
    "leading_into",
    "length",
    "moved",
    "same_place",
]

_ZERO: Final = Const(0)


def iterator(base: Value, position: Value, kind: SlotKind = "item") -> Pointer:
    """An iterator to an element."""
    return Pointer(Slot(base, kind, position))


def entry(ref: Ref, key: Value) -> Pointer:
    """An iterator to an entry of a map."""
    return Pointer(Slot(ref, "entry", key))


def as_iterator(value: Value) -> Slot | None:
    """The element to which a value that is an iterator leads."""
    if (
        isinstance(value, Pointer)
        and isinstance(value.target, Slot)
        and value.target.kind in ("item", "entry", "reverse")
    ):
        return value.target
    return None


def leading_into(ref: Ref, value: Value) -> tuple[Value, ...]:
    """The alternatives of an iterator that a container is given: those into another one are none of them, where there are any of its own."""
    several = options(value)
    if len(several) == 1:
        return several
    return tuple([option for option in several if _container(option) in (None, ref)]) or several


def _container(value: Value) -> Ref | None:
    slot = as_iterator(value)
    return slot.base if slot is not None and isinstance(slot.base, Ref) else None


def in_pairs(left: Value, right: Value) -> list[tuple[Value, Value]]:
    """Which alternatives of two values are compared: an iterator only with the end of its own container, where that is among them.

    for (auto it = t.begin(); it != t.end(); ++it)      t is one of several
    """
    ends = {_container(o): o for o in options(right) if _is_end(o)}
    if not ends:
        turned = {_container(o) for o in options(left) if _is_end(o)}
        return [(a, b) for b, a in in_pairs(right, left)] if turned else [(left, right)]
    several, own = options(left), [o for o in options(left) if _container(o) in ends]
    if len(ends) == 1 or not own:
        return [(left, right)]
    pairs = [(join_all(o for o in own if _container(o) == container), end) for container, end in ends.items()]
    others = join_all(o for o in options(right) if not _is_end(o))
    pairs += [(join_all(own), others), (join_all(o for o in several if o not in own), right)]
    return [(a, b) for a, b in pairs if UNBOUND not in (a, b)]


def _is_end(value: Value) -> bool:
    slot = as_iterator(value)
    return slot is not None and slot.key == NONE and isinstance(slot.base, Ref)


def keys_in_order(machine: Machine, ref: Ref) -> Items:
    """The keys of a map, as iteration gives them; all in `rest` where it is not known which there are."""
    obj = machine.obj(ref)
    keys = list(obj.entries)
    if obj.rest is not None or obj.maybe:
        more = () if obj.rest is None else (obj.rest_key or unknown_from(machine, "key", "", obj.rest),)
        return Items((), join_all((*keys, *more)))
    if isinstance(obj.cls, TypeOf) and "unordered" not in obj.cls.name:
        order = in_order(machine, keys, obj.cls)
        if order is None and is_asked(obj.cls):
            return Items((), join_all(keys))
        if order is not None:
            keys = [keys[n] for n in order]
    return Items(tuple(keys))


def length(machine: Machine, base: Value) -> int | None:
    """How many elements a container, or characters a string, surely has."""
    base = read(machine, base)
    text = text_of(base)
    if text is not None:
        return len(text)
    if isinstance(base, Ref):
        obj = machine.obj(base)
        if obj.kind == "dict":
            return len(obj.entries) if obj.rest is None and not obj.maybe else None
        if obj.kind in ("list", "set") and obj.series().exact:
            return len(obj.series().head)
    return None


# Ends


def begin(machine: Machine, base: Value) -> Value:
    """container.begin(); `base` is the container, or the slot of a string."""
    if isinstance(base, Choice):
        return join_all(begin(machine, option) for option in base.options)
    held = read(machine, base)
    if as_iterator(held) is not None:  # an array of characters
        return held
    if isinstance(held, Ref) and machine.obj(held).kind == "dict":
        keys = keys_in_order(machine, held)
        if keys.known:
            return entry(held, keys.known[0])
        return entry(held, keys.rest or NONE)
    if isinstance(held, Choice) and not any(text_of(o) is not None for o in held.options):
        return join_all(begin(machine, option) for option in held.options)
    if isinstance(held, Unknown) and held.hint != "str":
        return unknown_from(machine, "begin", "", held)
    return iterator(held if isinstance(held, Ref) else base, _ZERO)


def end(machine: Machine, base: Value) -> Value:
    """container.end()."""
    if isinstance(base, Choice):
        return join_all(end(machine, option) for option in base.options)
    held = read(machine, base)
    first = as_iterator(held)
    if first is not None:
        return iterator(first.base, NONE)
    if isinstance(held, Choice) and not any(text_of(o) is not None for o in held.options):
        return join_all(end(machine, option) for option in held.options)
    if isinstance(held, Unknown) and held.hint != "str":
        return unknown_from(machine, "end", "", held)
    kind: SlotKind = "entry" if isinstance(held, Ref) and machine.obj(held).kind == "dict" else "item"
    return iterator(held if isinstance(held, Ref) else base, NONE, kind)


def _reverse_begin(machine: Machine, base: Value) -> Value:
    held = read(machine, base)
    count = length(machine, held)
    if isinstance(held, Ref) and machine.obj(held).kind == "dict":
        keys = keys_in_order(machine, held)
        return entry(held, keys.known[-1] if keys.known else keys.rest or NONE)
    place = held if isinstance(held, Ref) else base
    if isinstance(held, Ref) and count is None:
        tail = machine.obj(held).series().tail
        if tail:
            return iterator(place, Const(-1), "reverse")
    position: Value = (
        NONE if count == 0 else unknown_from(machine, "rbegin", "int", held) if count is None else Const(count - 1)
    )
    return iterator(place, position, "reverse")


def _reverse_end(machine: Machine, base: Value) -> Value:
    held = read(machine, base)
    is_map = isinstance(held, Ref) and machine.obj(held).kind == "dict"
    return iterator(held if isinstance(held, Ref) else base, NONE, "entry" if is_map else "reverse")


# Moving


def moved(machine: Machine, value: Value, count: Value) -> Value:
    """iterator + count."""
    if isinstance(value, Choice) or isinstance(count, Choice):
        return join_all(moved(machine, v, c) for v in options(value) for c in options(count))
    slot, number = as_iterator(value), int_of(count)
    if slot is None or not isinstance(slot.key, Value):
        return unknown_from(machine, "+", "", value, count)
    if number == 0:
        return value
    if slot.kind == "entry":
        return _moved_in_map(machine, slot, number)
    size = length(machine, slot.base)
    at = int_of(slot.key)
    if slot.kind == "reverse":
        number = None if number is None else -number
    elif slot.key == NONE:
        at = size
    if at is None or number is None or (slot.kind == "reverse" and at < 0):
        return iterator(slot.base, unknown_from(machine, "+", "int", slot.key, count), slot.kind)
    place = at + number
    beyond = place < 0
    if slot.kind == "item":  # where a text ends may be elsewhere later
        beyond = place == size and isinstance(slot.base, Ref)
    return iterator(slot.base, NONE if beyond else Const(place), slot.kind)


def _moved_in_map(machine: Machine, slot: Slot, number: int | None) -> Value:
    assert isinstance(slot.base, Ref)
    assert isinstance(slot.key, Value)
    keys = keys_in_order(machine, slot.base)
    if keys.rest is not None or number is None or (slot.key != NONE and slot.key not in keys.known):
        anything = join_all(all_of(keys)) if keys.known or keys.rest is not None else NONE
        return join_all((entry(slot.base, anything), entry(slot.base, NONE)))
    place = (len(keys.known) if slot.key == NONE else keys.known.index(slot.key)) + number
    return entry(slot.base, keys.known[place] if 0 <= place < len(keys.known) else NONE)


def _position(machine: Machine, slot: Slot) -> int | None:
    """Which element an iterator leads to, counted from the beginning."""
    if not isinstance(slot.key, Value):
        return None
    if slot.kind == "entry":
        if not isinstance(slot.base, Ref):
            return None
        keys = keys_in_order(machine, slot.base)
        if keys.rest is not None:
            return None
        return len(keys.known) if slot.key == NONE else keys.known.index(slot.key) if slot.key in keys.known else None
    if slot.key == NONE:
        return -1 if slot.kind == "reverse" else length(machine, slot.base)
    return int_of(slot.key)


def distance(machine: Machine, first: Value, last: Value) -> Value:
    """last - first."""
    a, b = as_iterator(first), as_iterator(last)
    if a is None or b is None or a.base != b.base or a.kind != b.kind:
        return unknown_from(machine, "distance", "int", first, last)
    start, stop = _position(machine, a), _position(machine, b)
    if start is None or stop is None:
        return unknown_from(machine, "distance", "int", a.key if isinstance(a.key, Value) else None)
    return Const(start - stop if a.kind == "reverse" else stop - start)


def same_place(machine: Machine, first: Slot, second: Slot) -> bool | None:
    """Whether two iterators lead to the same element; None where that is not known."""
    if first == second and (
        first.key == NONE or (isinstance(first.key, Value) and not isinstance(first.key, (Choice, Unknown, Text)))
    ):
        return True
    if first.base != second.base:
        return None
    if NONE in (first.key, second.key):
        other = second if first.key == NONE else first
        at, size = _position(machine, other), length(machine, other.base)
        if other.kind == "reverse" and at is not None:
            return False
        if at is not None and size is not None:
            return at == size
        return _surely_inside(machine, other, at)
    a, b = _position(machine, first), _position(machine, second)
    return None if a is None or b is None else a == b


def _surely_inside(machine: Machine, slot: Slot, at: int | None) -> bool | None:
    """False where an iterator surely leads to an element, so that it is not the end."""
    if not isinstance(slot.base, Ref):
        return None
    obj = machine.obj(slot.base)
    if slot.kind == "entry":
        key = slot.key
        return False if isinstance(key, Value) and key in obj.entries and key not in obj.maybe else None
    return False if at is not None and 0 <= at < obj.series().least else None


# Natives


def _next(call: NativeCall) -> Value:
    count = read(call.machine, call.args[1]) if len(call.args) > 1 else Const(1)
    return moved(call.machine, read(call.machine, call.args[0]), count)


def _prev(call: NativeCall) -> Value:
    count = int_of(read(call.machine, call.args[1])) if len(call.args) > 1 else 1
    back = unknown_from(call.machine, "prev", "int", call.args[1]) if count is None else Const(-count)
    return moved(call.machine, read(call.machine, call.args[0]), back)


def _advance(call: NativeCall) -> Value:
    write(call.machine, call.args[0], _next(call))
    return NONE


def _distance(call: NativeCall) -> Value:
    return distance(call.machine, read(call.machine, call.args[0]), read(call.machine, call.args[1]))


def _begin(call: NativeCall) -> Value:
    return begin(call.machine, call.args[0])


def _end(call: NativeCall) -> Value:
    return end(call.machine, call.args[0])


def _rbegin(call: NativeCall) -> Value:
    return join_all(_reverse_begin(call.machine, option) for option in options(call.args[0]))


def _rend(call: NativeCall) -> Value:
    return join_all(_reverse_end(call.machine, option) for option in options(call.args[0]))


def _data(call: NativeCall) -> Value:
    """A pointer to the first element, the same whether there is one or not."""
    held = read(call.machine, call.args[0])
    if call.args[0].__class__ is not Slot and (text_of(held) is not None or isinstance(held, Text)):
        return held
    return begin(call.machine, call.args[0])


def size(machine: Machine, base: Value) -> Value:
    """container.size()."""
    held = read(machine, base)
    if isinstance(held, Choice):
        return join_all(size(machine, option) for option in held.options)
    count = length(machine, held)
    if count is None:
        return unknown_from(machine, "size", "int", held, machine.obj(held).rest if isinstance(held, Ref) else None)
    return Const(count, held.origins if isinstance(held, Const) else frozenset())


def is_empty(machine: Machine, base: Value) -> Value:
    """container.empty()."""
    held = read(machine, base)
    if isinstance(held, Choice):
        return join_all(is_empty(machine, option) for option in held.options)
    count = length(machine, held)
    if count is not None:
        return Const(count == 0, held.origins if isinstance(held, Const) else frozenset())
    some = isinstance(held, Text)
    if isinstance(held, Ref):
        obj = machine.obj(held)
        some = any(k not in obj.maybe for k in obj.entries) if obj.kind == "dict" else obj.series().least > 0
    return FALSE if some else unknown_from(machine, "empty", "bool", held)


def _size(call: NativeCall) -> Value:
    return size(call.machine, call.args[0])


def _empty(call: NativeCall) -> Value:
    return is_empty(call.machine, call.args[0])


_OF_CONTAINERS: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("begin", "cbegin"), _begin),
    **dict.fromkeys(("end", "cend"), _end),
    **dict.fromkeys(("rbegin", "crbegin"), _rbegin),
    **dict.fromkeys(("rend", "crend"), _rend),
    "size": _size,
    "empty": _empty,
    "data": _data,
}
_CONTAINERS: Final = ("std.vector", "std.map", "std.string")

OF_PLACES: Final = frozenset(f"std.string.{name}" for name in _OF_CONTAINERS) - {"std.string.size", "std.string.empty"}
NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.{name}": function for name, function in with_least(_OF_CONTAINERS, 1, None).items()},
    **{
        f"{type_}.{name}": function
        for type_ in _CONTAINERS
        for name, function in with_least(_OF_CONTAINERS, 1, None).items()
    },
    "std.string.length": _size,
    "std.ssize": _size,
    "std.next": _next,
    "std.prev": _prev,
    "std.advance": _advance,
    "std.distance": _distance,
}
