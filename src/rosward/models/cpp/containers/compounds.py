# SPDX-License-Identifier: Apache-2.0
"""Pairs, tuples, optionals, variants: what are they made of, and what is in them?

std::make_pair("a", 1)          a pair of 'a' and 1
std::get<0>(std::make_tuple(a, b))
extra(false).value_or("x")      'x', where the optional is empty
std::get<std::string>(variant)  a variant is the value that it holds
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.series import Series
from rosward.domain.slots import Pointer, Slot, TypeOf, is_char_text
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Unknown, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.contained import element_from, made_of, place_of
from rosward.models.cpp.iteration.elements import parts, series_of
from rosward.models.cpp.iteration.exceptions import may_raise, raises
from rosward.models.cpp.values.alternatives import is_of_type
from rosward.models.cpp.values.boxes import is_open, unboxed
from rosward.models.cpp.values.characters import as_kept
from rosward.models.cpp.values.conversions import NULLOPT, convert, default_value, is_empty_optional, new_container
from rosward.models.cpp.values.copies import copied, write
from rosward.models.cpp.values.slots import new_pair, read
from rosward.models.cpp.values.types import Shape, argument, hint_of, name_of, shape_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import int_of, unknown_from

__all__ = ["NATIVES", "alternative"]

_AUTO: Final = TypeOf("auto", ())


def _types(call: NativeCall) -> tuple[Value, ...]:
    given = call.keywords.get("types")
    return given.items if isinstance(given, Tuple) else ()


# Pairs and tuples


def _make_pair(call: NativeCall) -> Value:
    types = _types(call)
    first, second = (copied(call.machine, arg) for arg in call.exactly(2))
    return new_pair(call.machine, first, second, types if len(types) == 2 else ())


def _new_pair(call: NativeCall) -> Value:
    machine, type_, args = call.machine, call.args[0], call.args[1:]
    if len(args) == 2:
        return convert(machine, Tuple((read(machine, args[0]), read(machine, args[1]))), type_)
    if len(args) == 3:  # piecewise
        made = [made_of(machine, type_, series_of(machine, arg).head, n) for n, arg in enumerate(args[1:])]
        return UNBOUND if UNBOUND in made else new_pair(machine, made[0], made[1], getattr(type_, "arguments", ()))
    return convert(machine, copied(machine, args[0]), type_) if args else default_value(machine, type_)


def _make_tuple(call: NativeCall) -> Value:
    machine = call.machine
    items = tuple(copied(machine, arg) for arg in call.args)
    return new_container(machine, TypeOf("std.tuple", ()), Series(items), Tuple(items))


def _new_tuple(call: NativeCall) -> Value:
    machine, type_, args = call.machine, call.args[0], call.args[1:]
    if (
        len(args) == 1
        and isinstance(read(machine, args[0]), (Tuple, Ref))
        and shape_of(argument(type_, 0)) is not Shape.CLASS
    ):
        return convert(machine, copied(machine, args[0]), type_)
    if not args:
        return default_value(machine, type_)
    return convert(machine, Tuple(tuple(read(machine, arg) for arg in args)), type_)


def _tie(call: NativeCall) -> Value:
    """std::tie(a, b): slots, so that an assignment goes to these."""
    return new_container(call.machine, TypeOf("std.tuple", ()), Series(call.args), Tuple(call.args))


def _assign_tuple(call: NativeCall) -> Value:
    """tuple = other: of what `tie` made, each slot gets its part."""
    machine = call.machine
    for option in options(read(machine, call.args[0])):
        series = machine.obj(option).series() if isinstance(option, Ref) else Series()
        given = parts(machine, read(machine, call.args[1]), len(series.head), slots=False)
        kept: list[Value] = []
        for held, value in zip(series.head, given, strict=True):
            own = as_kept(machine, held, copied(machine, value))
            if isinstance(held, (Slot, Ref)):
                write(machine, held, own)
            kept.append(held if isinstance(held, (Slot, Ref)) else own)
        if isinstance(option, Ref) and series.exact:
            write_series(machine, option, Series(tuple(kept)))
    return call.args[0]


def _get(call: NativeCall) -> Value:
    """std::get<0>(tuple), std::get<T>(variant)."""
    machine, types = call.machine, _types(call)
    wanted = types[0] if types else _AUTO
    found = [_get_from(machine, option, option_read, wanted) for option, option_read in _apart(machine, call.args[0])]
    return join_all(found)


def _apart(machine: Machine, value: Value) -> list[tuple[Value, Value]]:
    value = unboxed(machine, value)
    held = read(machine, value)
    return [(value, held)] if len(options(held)) == 1 else [(option, option) for option in options(held)]


def _get_from(machine: Machine, place: Value, held: Value, wanted: Value) -> Value:
    number = int_of(wanted)
    if isinstance(held, Ref):
        obj = machine.obj(held)
        if isinstance(obj.cls, TypeOf) and obj.cls.name == "std.pair" and number in (0, 1):
            slot = Slot(held, "field", ("first", "second")[number])
            inner = read(machine, slot)
            return inner if isinstance(inner, Ref) else slot
        if obj.kind == "list" and shape_of(obj.cls) in (Shape.TUPLE, Shape.ARRAY):
            if number is not None:
                return place_of(machine, held, Const(number))
            types = obj.cls.arguments if isinstance(obj.cls, TypeOf) else ()
            if wanted in types:
                return place_of(machine, held, Const(types.index(wanted)))
            fitting = [n for n, item in enumerate(() if types else obj.items or ()) if _may_be(machine, item, wanted)]
            if len(fitting) == 1:
                return place_of(machine, held, Const(fitting[0]))
            return unknown_from(machine, "get", hint_of(wanted), held)
    if isinstance(held, Tuple) and number is not None and number < len(held.items):
        return held.items[number]
    if number is not None:  # of a variant, by the number of the alternative, which nobody keeps
        may_raise(machine, "bad_variant_access", "std::get: wrong index for variant")
        return held
    return _alternative(machine, place, held, wanted, ("bad_variant_access", "std::get: wrong index for variant"))


def _alternative(machine: Machine, place: Value, held: Value, wanted: Value, error: tuple[str, str]) -> Value:
    """What a variant or `any` holds as one of a type, or the exception that is thrown."""
    fits = is_of_type(machine, held, wanted)
    if fits is False:
        return raises(machine, *error)
    if fits is None:
        may_raise(machine, *error)
        if isinstance(held, Unknown):
            return Unknown(held.reasons, hint_of(wanted))
        is_one = isinstance(held, Ref) and machine.obj(held).cls == wanted
        return held if is_one or not is_open(machine, held) else unknown_from(machine, "get", hint_of(wanted), held)
    return place if isinstance(place, Slot) else held


def _may_be(machine: Machine, item: Value, type_: Value) -> bool:
    """Whether an element of a tuple may be of a type; a literal is no string."""
    is_text = shape_of(type_) is Shape.TEXT and is_char_text(read(machine, item))
    return not is_text and is_of_type(machine, item, type_) is not False


def _holds(call: NativeCall) -> Value:
    """std::holds_alternative<T>(variant)."""
    types = _types(call)
    answers: set[bool | None] = {
        is_of_type(call.machine, option, types[0]) if types else None
        for option in options(read(call.machine, unboxed(call.machine, call.args[0])))
    }
    decided = answers.pop() if len(answers) == 1 else None
    return (
        unknown_from(call.machine, "holds_alternative", "bool", read(call.machine, call.args[0]))
        if decided is None
        else Const(decided)
    )


def alternative(machine: Machine, value: Value, type_: Value) -> Value | None:
    """`variant.index()`: which of the types of a variant the value has; None for what is declared as none."""
    if name_of(type_) != "std.variant" or not isinstance(type_, TypeOf):
        return None
    own = machine.obj(value).cls if isinstance(value, Ref) else None
    if own is not None and type_.arguments.count(own) == 1:
        return Const(type_.arguments.index(own))
    fits = [is_of_type(machine, value, each) for each in type_.arguments]
    known = fits.count(True) == 1 and None not in fits
    return Const(fits.index(True)) if known else unknown_from(machine, "index", "int", value)


def _get_if(call: NativeCall) -> Value:
    """std::get_if<T>(&variant): a pointer to what it holds, or nullptr; of each variant that the pointer may lead to."""
    wanted = next(iter(_types(call)), _AUTO)
    return join_all([_held_as(call.machine, o, wanted) for o in options(read(call.machine, call.args[0]))])


def _held_as(machine: Machine, pointer: Value, wanted: Value) -> Value:
    if pointer == NONE:
        return NONE
    place = pointer.target if isinstance(pointer, Pointer) else pointer
    target = unboxed(machine, place)
    fits = None if int_of(wanted) is not None else is_of_type(machine, target, wanted)  # nobody keeps the numbers
    if fits is None and target is not place:
        kept = [o for o in options(read(machine, target)) if is_of_type(machine, o, wanted) is not False]
        target = join_all(kept) if kept and all(isinstance(o, Ref) for o in kept) else target
    found = pointer if isinstance(pointer, Pointer) and target is place else Pointer(target)
    return found if fits else NONE if fits is False else join(found, NONE)


def _visit(call: NativeCall) -> Value:
    """std::visit(callable, variants…)."""
    machine = call.machine
    held = [_visited(machine, unboxed(machine, each)) for each in call.args[1:]]
    return machine.call(read(machine, call.args[0]), tuple(held))


def _visited(machine: Machine, place: Value) -> Value:
    """What a variant holds; also anything, where nobody knows what was assigned to it."""
    held = read(machine, place)
    anything = any(is_open(machine, option) for option in options(held))
    return join(held, unknown_from(machine, "visit", "", held)) if anything else place


def _apply(call: NativeCall) -> Value:
    """std::apply(callable, tuple)."""
    machine = call.machine
    series = series_of(machine, call.args[1], slots=True)
    if not series.exact:
        return unknown_from(machine, "apply", "", series.element())
    return machine.call(read(machine, call.args[0]), series.head)


def _concatenated(call: NativeCall) -> Value:
    machine = call.machine
    several = [series_of(machine, arg) for arg in call.args]
    items = tuple(copied(machine, v) for series in several for v in series.head)
    return new_container(machine, TypeOf("std.tuple", ()), Series(items), Tuple(items))


def _held_value(call: NativeCall) -> Value:
    """A variant or `any` of something: that."""
    args = call.args[1:] if call.name.endswith(".new") else call.args
    if not args:
        return default_value(call.machine, call.args[0]) if call.name.endswith(".new") else NONE
    return copied(call.machine, args[-1])


def _any_cast(call: NativeCall) -> Value:
    types, value = _types(call), read(call.machine, call.args[0])
    if not types:
        return value
    pointers = [o for o in options(value) if o != NONE]
    if pointers and all(isinstance(o, Pointer) and not _holds_it(call.machine, o, types[0]) for o in pointers):
        return _get_if(call)
    error = ("bad_any_cast", "bad any_cast")
    found = [_alternative(call.machine, p, held, types[0], error) for p, held in _apart(call.machine, call.args[0])]
    return join_all(found)


def _holds_it(machine: Machine, pointer: Pointer, wanted: Value) -> bool:
    """Whether an `any` holds this pointer; else it is a pointer to an `any`, which holds something else."""
    inside = options(read(machine, pointer.target))
    return shape_of(wanted) is Shape.POINTER and not all(o == NONE or isinstance(o, Pointer) for o in inside)


# Optionals


def _optional(call: NativeCall) -> tuple[list[Ref], bool | None]:
    """The optionals on which a method is called, and whether they are empty."""
    held = read(call.machine, call.args[0])
    return [o for o in options(held) if isinstance(o, Ref)], is_empty_optional(call.machine, held)


def _value(call: NativeCall) -> Value:
    machine = call.machine
    refs, empty = _optional(call)
    if empty:
        return raises(machine, "bad_optional_access", "bad optional access")
    if empty is None:
        may_raise(machine, "bad_optional_access", "bad optional access")
    held = [_inside(machine, ref) for ref in refs]
    known = [v for v in held if v is not None]
    return join_all(known) if known else unknown_from(machine, "value", "", read(machine, call.args[0]))


def _inside(machine: Machine, ref: Ref) -> Value | None:
    """The slot of what an optional holds; None where it is surely empty."""
    return place_of(machine, ref, Const(0)) if machine.obj(ref).series().element() is not None else None


def _value_or(call: NativeCall) -> Value:
    machine = call.machine
    refs, empty = _optional(call)
    found: list[Value] = []
    types = [argument(machine.obj(ref).cls, 0) for ref in refs]
    if empty is not True:
        held = [_inside(machine, ref) for ref in refs]
        found.extend(read(machine, v) for v in held if v is not None)
        if not refs:
            found.append(unknown_from(machine, "value_or", "", read(machine, call.args[0])))
    if empty is not False:
        found.append(convert(machine, copied(machine, call.args[1]), types[0] if types else _AUTO))
    return join_all(found)


def _has_value(call: NativeCall) -> Value:
    _, empty = _optional(call)
    held = read(call.machine, call.args[0])
    return unknown_from(call.machine, "has_value", "bool", held) if empty is None else FALSE if empty else TRUE


def _reset(call: NativeCall) -> Value:
    for ref in _optional(call)[0]:
        write_series(call.machine, ref, Series())
    return NONE


def _emplace(call: NativeCall) -> Value:
    machine, found = call.machine, []
    for ref in _optional(call)[0]:
        made = made_of(machine, machine.obj(ref).cls, call.args[1:])
        if made is UNBOUND:
            return UNBOUND
        write_series(machine, ref, Series((made,)))
        found.append(place_of(machine, ref, Const(0)))
    return join_all(found) if found else NONE


def _make_optional(call: NativeCall) -> Value:
    machine, types = call.machine, _types(call)
    type_ = TypeOf("std.optional", types[:1])
    if types and len(call.args) != 1:
        return new_container(machine, type_, Series((made_of(machine, type_, call.args),)))
    return new_container(machine, type_, Series((element_from(machine, type_, call.args[0]),)))


def _new_optional(call: NativeCall) -> Value:
    machine, type_, args = call.machine, call.args[0], call.args[1:]
    if not args:
        return convert(machine, NULLOPT, type_)
    first = read(machine, args[0])
    if getattr(first, "name", "") == "std.in_place":
        return new_container(machine, type_, Series((made_of(machine, type_, args[1:]),)))
    return convert(machine, copied(machine, first) if first != NULLOPT else first, type_)


_OPTIONAL: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("value", "get"), _value),
    **dict.fromkeys(("value_or", "get_value_or"), _value_or),
    **dict.fromkeys(("has_value", "is_initialized"), _has_value),
    "reset": _reset,
    "emplace": _emplace,
    "new": _new_optional,
}

NATIVES: Final[dict[str, NativeFunction]] = {
    "std.make_pair": _make_pair,
    "std.pair.new": _new_pair,
    "std.make_tuple": _make_tuple,
    "std.forward_as_tuple": _tie,
    "std.tie": _tie,
    "std.tuple.new": _new_tuple,
    "std.tuple.operator=": _assign_tuple,
    "std.tuple_cat": _concatenated,
    "std.apply": _apply,
    "std.get": _get,
    "std.get_if": _get_if,
    "std.holds_alternative": _holds,
    "std.visit": _visit,
    "std.any_cast": _any_cast,
    "std.make_any": _held_value,
    "std.any.new": _held_value,
    "std.variant.new": _held_value,
    "std.make_optional": _make_optional,
    **{
        f"std.optional.{name}": function
        for name, function in with_least(_OPTIONAL, 1, {"value_or": 2, "get_value_or": 2}).items()
    },
    "boost.optional.new": _new_optional,
}
