# SPDX-License-Identifier: Apache-2.0
"""Smart pointers: what do they lead to, and who makes it?

std::make_shared<Talker>("talker")      Pointer of a new object
p.reset(); p.get(); p.use_count()       of the pointer itself
std::dynamic_pointer_cast<Base>(p)      the same pointer, or null
weak.lock()                             the pointer, or null where the object may be gone

Which kind of pointer it is makes no difference to what it leads to.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import BoundMethod, External, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.slots import Overloads, Owner, Pointer, Slot, TypeOf
from rosward.domain.values import EMPTY, NONE, UNBOUND, Class, Const, Function, Ref, Unknown, Value
from rosward.models.cpp.algorithms.ranges import place, places
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.iterators import as_iterator
from rosward.models.cpp.values.characters import as_kept
from rosward.models.cpp.values.conversions import convert, default_value, new_container
from rosward.models.cpp.values.copies import copied, several, write
from rosward.models.cpp.values.owners import give_away, given_away, is_sole, owning
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import int_of, unknown_from

__all__ = ["NATIVES", "OF_PLACES", "pointer_to"]


def _owner(name: str) -> Owner:
    """What a pointer of a type, or made by a function, is to what it leads to."""
    return "unique" if "unique" in name else "shared" if "shared" in name else ""


def pointer_to(machine: Machine, value: Value) -> Value:
    """A pointer to what has just been made: an object, or a value, which gets a place of its own."""
    if value is UNBOUND or isinstance(value, Unknown):
        return value
    if isinstance(value, Ref):
        return Pointer(value)
    if len(options(value)) > 1:
        return join_all(pointer_to(machine, option) for option in options(value))
    return Pointer(Slot(machine.allocate(Obj("cell", NONE, {"value": value}), ("new", value)), "cell", None))


def _make(call: NativeCall) -> Value:
    """std::make_shared<T>(arguments…)."""
    return owning(_made(call), _owner(call.name))


def _made(call: NativeCall) -> Value:
    machine, types = call.machine, call.keywords.get("types")
    if not isinstance(types, Tuple) or not types.items:
        return unknown_from(machine, call.name, "", *call.args)
    type_ = types.items[0]
    if name_of(type_) == "array" or (isinstance(type_, TypeOf) and type_.name == "array"):
        return _make_array(machine, type_, call.args)
    if shape_of(type_) in (Shape.CLASS, Shape.OTHER, Shape.LIST, Shape.SET, Shape.MAP, Shape.STREAM, Shape.OPTIONAL):
        return pointer_to(machine, machine.call(type_, call.args))
    if not call.args:
        return pointer_to(machine, default_value(machine, type_))
    if len(call.args) == 1:
        return pointer_to(machine, copied(machine, convert(machine, call.args[0], type_)))
    return pointer_to(machine, machine.call(type_, call.args))


def _make_array(machine: Machine, type_: Value, args: tuple[Value, ...]) -> Value:
    """std::make_unique<T[]>(n)."""
    inner = type_.arguments[0] if isinstance(type_, TypeOf) and type_.arguments else TypeOf("auto", ())
    count = int_of(read(machine, args[0])) if args else None
    if name_of(inner) == "char":  # characters are kept as the text that they make
        text = pointer_to(machine, EMPTY)
        return Pointer(Slot(text.target, "item", Const(0))) if isinstance(text, Pointer) else text
    known = count is not None and 0 <= count <= 1_000
    series = (
        Series(tuple(default_value(machine, inner) for _ in range(count or 0)))
        if known
        else Series((), several(machine, default_value(machine, inner)))
    )
    made = new_container(machine, TypeOf("array", (inner,)), series, "new")
    return Pointer(Slot(made, "item", Const(0)))


def _new(call: NativeCall) -> Value:
    """std::shared_ptr<T>(pointer, deleter): the type comes first. A deleter may be called from then on; of which type it is says nothing."""
    type_ = call.args[0]
    if len(call.args) > 2:
        _deleted_by(call.machine, call.args[2], call.args[1])
    elif len(call.args) > 1 and isinstance(argument(type_, 1), Class):
        _deleted_by(call.machine, call.machine.call(argument(type_, 1), ()), call.args[1])
    has_deleter = len(call.args) > 2 or (isinstance(type_, TypeOf) and len(type_.arguments) > 1)
    return owning(_new_of(call), "" if has_deleter else _owner(call.name))


def _deleted_by(machine: Machine, deleter: Value, pointer: Value) -> None:
    """A pointer is given something to delete what it leads to: it may be called from then on."""
    held = read(machine, deleter)
    if any(
        isinstance(o, (Function, Overloads, Partial, BoundMethod)) or _is_of_a_class(machine, o) for o in options(held)
    ):
        machine.schedule(held, (read(machine, pointer),), "deleter")


def _is_of_a_class(machine: Machine, value: Value) -> bool:
    return isinstance(value, Ref) and isinstance(machine.obj(value).cls, Class)


def _new_of(call: NativeCall) -> Value:
    machine, args = call.machine, call.args[1:]
    if not args:
        return NONE
    value = read(machine, args[0])
    if isinstance(value, Tuple):
        value = read(machine, value.items[0]) if value.items else NONE
    if len(args) == 2 and isinstance(read(machine, args[1]), Pointer):
        return read(machine, args[1])  # the alias of a part of an object
    return value


# Methods


def _get(call: NativeCall) -> Value:
    return owning(read(call.machine, call.args[0]), "")


def _reset(call: NativeCall) -> Value:
    if len(call.args) > 2:
        _deleted_by(call.machine, call.args[2], call.args[1])
    given = read(call.machine, call.args[1]) if len(call.args) > 1 else NONE
    held = {o.owner for o in options(read(call.machine, call.args[0])) if isinstance(o, Pointer)}
    owner: Owner = held.pop() if len(held) == 1 else "" if held else "shared"  # a null pointer: of either kind
    write(call.machine, call.args[0], owning(given, owner if len(call.args) < 3 else ""))
    return NONE


def _release(call: NativeCall) -> Value:
    held = read(call.machine, call.args[0])
    write(call.machine, call.args[0], NONE)
    return owning(held, "")


def _swap(call: NativeCall) -> Value:
    ours, theirs = (read(call.machine, arg) for arg in call.args[:2])
    write(call.machine, call.args[0], theirs)
    write(call.machine, call.args[1], ours)
    return NONE


def _use_count(call: NativeCall) -> Value:
    held = read(call.machine, call.args[0])
    return Const(0) if held == NONE else unknown_from(call.machine, call.name, "int", held)


def _unique(call: NativeCall) -> Value:
    return unknown_from(call.machine, call.name, "bool", read(call.machine, call.args[0]))


def _lock(call: NativeCall) -> Value:
    """weak.lock(): nobody follows when an object ends, so it may be gone."""
    return join(owning(read(call.machine, call.args[0]), "shared"), NONE)


def _expired(call: NativeCall) -> Value:
    held = read(call.machine, call.args[0])
    return Const(True) if held == NONE else unknown_from(call.machine, "expired", "bool", held)


# Casts and kin


def _dynamic_cast(call: NativeCall) -> Value:
    """std::dynamic_pointer_cast<T>(pointer): null where the object is surely none of that class."""
    machine, types = call.machine, call.keywords.get("types")
    wanted = types.items[0] if isinstance(types, Tuple) and types.items else None

    def one(pointer: Value) -> Value:
        if not isinstance(pointer, Pointer) or not isinstance(pointer.target, Ref) or not isinstance(wanted, Class):
            return pointer if pointer == NONE or isinstance(pointer, Unknown) else join(pointer, NONE)
        cls = machine.obj(pointer.target).cls
        if isinstance(cls, Class):
            if wanted in cls.mro:
                return pointer
            return NONE if all(isinstance(base, Class) for base in cls.mro) else join(pointer, NONE)
        return join(pointer, NONE)

    return join_all(map(one, options(read(machine, call.args[0]))))


def _itself(call: NativeCall) -> Value:
    """What gives its argument again: move, forward, ref, static casts of pointers."""
    return call.exactly(1)[0]


def _move_all(call: NativeCall) -> Value:
    """std::move(first, last, out), which leaves elements where they were; they own nothing any more."""
    machine = call.machine
    behind = machine.call(External("std.copy"), call.args)
    for each in places(machine, call.args[0], call.args[1]) or ():
        left = place(machine, each)
        held = read(machine, left)
        if any(map(is_sole, options(held))):
            write(machine, left, join(given_away(held), NONE))
    return behind


def _moving(call: NativeCall) -> Value:
    """std::make_move_iterator(i): who gets the elements owns what they did; whether that ends is not followed then."""
    held = read(call.machine, call.args[0])
    slot = as_iterator(held)
    if slot is not None and isinstance(slot.base, Ref):
        give_away(call.machine, slot.base)
    return held


def _move(call: NativeCall) -> Value:
    """std::move(x): of a pointer its value; where it stood there may be nothing any more, and nothing that it owns."""
    if len(call.args) > 2:
        return _move_all(call)
    place = call.exactly(1)[0]
    held = read(call.machine, place)
    if isinstance(place, Slot) and any(isinstance(option, Pointer) for option in options(held)):
        write(call.machine, place, join(given_away(held), NONE))
        return held
    return place


def _value(call: NativeCall) -> Value:
    return read(call.machine, call.exactly(1)[0])


def _address(call: NativeCall) -> Value:
    """std::addressof(x)."""
    place = call.exactly(1)[0]
    return Pointer(place) if isinstance(place, (Ref, Slot)) else unknown_from(call.machine, call.name, "", place)


def _shared_from_this(call: NativeCall) -> Value:
    held = read(call.machine, call.args[0])
    return owning(held, "shared") if not isinstance(held, Ref) else Pointer(held, "shared")


def _exchange(call: NativeCall) -> Value:
    """std::exchange(slot, value): what was there before."""
    machine = call.machine
    old = copied(machine, call.args[0])
    write(machine, call.args[0], as_kept(machine, call.args[0], copied(machine, call.args[1])))
    return old


def _swap_values(call: NativeCall) -> Value:
    """std::swap(a, b)."""
    machine = call.machine
    places = [_array_of(arg) for arg in call.exactly(2)]
    values = [copied(machine, each) for each in places]
    for each, value in zip(places, reversed(values), strict=True):
        write(machine, each, value)
    return NONE


def _array_of(value: Value) -> Value:
    """The place of an array of characters, which comes as a pointer to the first; any other place as it is."""
    target = value.target if isinstance(value, Pointer) else None
    return target.base if isinstance(target, Slot) and isinstance(target.base, Slot) else value


_POINTER: Final[dict[str, NativeFunction]] = {
    "get": _get,
    "reset": _reset,
    "release": _release,
    "swap": _swap,
    "use_count": _use_count,
    "unique": _unique,
    "lock": _lock,
    "expired": _expired,
    "owner_before": _unique,
}

OF_PLACES: Final = frozenset(f"std.shared_ptr.{name}" for name in ("reset", "release", "swap"))
NATIVES: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("std.make_shared", "std.make_unique", "boost.make_shared", "std.allocate_shared"), _make),
    **{f"std.{kind}_ptr.new": _new for kind in ("shared", "unique", "weak", "auto")},
    "boost.shared_ptr.new": _new,
    **{f"std.shared_ptr.{name}": function for name, function in with_least(_POINTER, 1, {"swap": 2}).items()},
    **{
        f"{space}.enable_shared_from_this.{name}_from_this": _shared_from_this
        for space in ("std", "boost")
        for name in ("shared", "weak")
    },
    **dict.fromkeys(("std.dynamic_pointer_cast", "boost.dynamic_pointer_cast"), _dynamic_cast),
    **{
        f"{space}.{kind}_pointer_cast": _value
        for space in ("std", "boost")
        for kind in ("static", "const", "reinterpret")
    },
    **{f"std.{name}": _itself for name in ("forward", "as_const", "launder")},
    **dict.fromkeys(("std.move", "std.move_if_noexcept"), _move),
    "std.make_move_iterator": _moving,
    "std.addressof": _address,
    "std.exchange": _exchange,
    "std.swap": _swap_values,
}
