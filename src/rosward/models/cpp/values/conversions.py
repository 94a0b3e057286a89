# SPDX-License-Identifier: Apache-2.0
"""What is a value of a type made of another value, and what does one hold that is made of nothing?

    convert(machine, Const('a'), External('std.string'))                    Const('a')
    convert(machine, Tuple((Const(1), Const(2))), TypeOf('std.vector', (TypeOf('double', ()),)))     a list of 1.0 and 2.0
    default_value(machine, TypeOf('std.map', (K, V)))                       an empty dict

Types that are classes of the program are the engine's: it is asked by a call of the class.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import External, Partial, Tuple
from rosward.domain.heap import Obj, ObjKind, fields_of
from rosward.domain.series import Series
from rosward.domain.slots import Pointer, Slot, TypeOf, is_char_text
from rosward.domain.unknown import Cause
from rosward.domain.values import EMPTY, FALSE, NONE, UNBOUND, Choice, Class, Const, Ref, Text, Unknown, Value
from rosward.ir.core import CharText
from rosward.models.cpp.values.characters import as_string, character_of, text_in
from rosward.models.cpp.values.chrono import as_duration, unit_of
from rosward.models.cpp.values.contents import within
from rosward.models.cpp.values.copies import copied, several
from rosward.models.cpp.values.number_conversions import NUMBERS
from rosward.models.cpp.values.ordering import unique
from rosward.models.cpp.values.owners import as_pointer
from rosward.models.cpp.values.slots import key_of, new_pair, read, read_field
from rosward.models.cpp.values.types import REFERENCE, Shape, argument, hint_of, is_reference, name_of, shape_of
from rosward.models.native import Machine
from rosward.models.python.containers import dicts
from rosward.models.python.plain import MAX_ITEMS, from_python, int_of, origins, text_of, unknown_from

__all__ = [
    "COMPOUND",
    "NULLOPT",
    "as_characters",
    "convert",
    "default_value",
    "is_empty_optional",
    "is_one",
    "new_container",
    "new_map",
    "new_set",
    "owned",
]

NULLOPT: Final = External("std.nullopt")
_DEEPEST: Final = 12
_MOST_DEFAULT: Final = 1_000
_ZERO: Final = Const(0)
_LISTS: Final = frozenset({Shape.LIST, Shape.ARRAY, Shape.TUPLE, Shape.OPTIONAL, Shape.MULTIMAP, Shape.SET})


# Making


def new_container(machine: Machine, type_: Value, series: Series, site: object = None) -> Ref:
    """A new container of a type, with these elements."""
    kind: ObjKind = "list"
    cls = type_ if isinstance(type_, TypeOf) else TypeOf(name_of(type_) or "std.vector", ())
    return machine.allocate(Obj(kind, cls, **fields_of(series, kind, MAX_ITEMS)), (cls, site))


def new_set(machine: Machine, type_: Value, series: Series, site: object = None) -> Ref:
    """A new set of a type, of keys."""
    made = unique(machine, series, type_, several="multi" in name_of(type_))
    return new_container(machine, type_, made, site)


def new_map(machine: Machine, type_: Value, pairs: Iterable[tuple[Value, Value]] = (), site: object = None) -> Ref:
    """A new map of a type; of two pairs with one key the first counts."""
    cls = type_ if isinstance(type_, TypeOf) else TypeOf(name_of(type_) or "std.map", ())
    made = machine.allocate(Obj("dict", cls), (cls, site))
    for key, value in pairs:
        found = dicts.look_up(machine, machine.obj(made), key)
        if found.missing is not False:
            dicts.store(machine, made, key, value, weak=found.missing is None and found.value is not UNBOUND)
    return made


# Defaults


def default_value(machine: Machine, type_: Value, depth: int = 0) -> Value:
    """What `T()` gives."""
    shape = shape_of(type_)
    simple = _DEFAULTS.get(shape)
    if simple is not None:
        return simple
    if depth > _DEEPEST:
        return machine.unknown(Cause.LIMIT, "type")
    if name_of(type_) == "std.atomic":
        return default_value(machine, argument(type_, 0), depth + 1)
    if shape is Shape.MAP:
        return new_map(machine, type_)
    if shape is Shape.PAIR:
        first, second = (default_value(machine, argument(type_, n), depth + 1) for n in (0, 1))
        return new_pair(machine, first, second, type_.arguments if isinstance(type_, TypeOf) else ())
    if shape is Shape.SET:
        return new_container(machine, type_, Series())
    if shape in _LISTS:
        return new_container(machine, type_, _default_series(machine, type_, shape, depth))
    if shape is Shape.ANY:
        first_type = argument(type_, 0)
        return NONE if name_of(first_type) == "auto" else default_value(machine, first_type, depth + 1)
    if shape in (Shape.CLASS, Shape.STREAM) or (shape is Shape.OTHER and "." in name_of(type_)):
        return machine.call(type_, ())
    return machine.unknown(Cause.OPERATION, f"a new {name_of(type_) or 'value'}")


def _default_series(machine: Machine, type_: Value, shape: Shape, depth: int) -> Series:
    if shape is Shape.TUPLE and isinstance(type_, TypeOf):
        return Series(tuple(default_value(machine, each, depth + 1) for each in type_.arguments))
    if shape is not Shape.ARRAY:
        return Series()
    count = int_of(argument(type_, 1))
    if count is None:
        return Series((), several(machine, default_value(machine, argument(type_, 0), depth + 1)))
    if not 0 <= count <= _MOST_DEFAULT:
        return Series((), machine.unknown(Cause.LIMIT, "array", hint_of(argument(type_, 0))))
    return Series(tuple(default_value(machine, argument(type_, 0), depth + 1) for _ in range(count)))


_DEFAULTS: Final[dict[Shape, Value]] = {
    Shape.BOOL: FALSE,
    Shape.INT: _ZERO,
    Shape.FLOAT: Const(0.0),
    Shape.CHAR: Const("\0"),
    Shape.TEXT: EMPTY,
    Shape.POINTER: NONE,
    Shape.CALLABLE: NONE,
    Shape.VOID: NONE,
}


# Converting


def convert(machine: Machine, value: Value, type_: Value, kind: str = "init", depth: int = 0) -> Value:
    """A value as one of a type. What is of that type already is itself: who needs a copy has made one."""
    if isinstance(type_, Choice):
        return join_all(convert(machine, value, each, kind, depth) for each in type_.options)
    shape = shape_of(type_)
    if name_of(type_) == "std.reference_wrapper":
        is_place = value.__class__ in (Slot, Ref)
        return Partial(REFERENCE, (value,), ()) if is_place and not is_reference(read(machine, value)) else value
    if shape is Shape.REFERENCE or name_of(type_) == "auto":
        return value
    if name_of(type_) == "std.atomic":
        return convert(machine, value, argument(type_, 0), kind, depth)
    value = read(machine, value)
    if unit_of(type_) is not None and not isinstance(value, Tuple):
        return as_duration(machine, value, type_)
    if isinstance(value, Choice):
        kept = [each for each in value.options if each != NONE or shape is not Shape.TEXT]  # no string is made of null
        return join_all(convert(machine, each, type_, kind, depth) for each in kept)
    if depth > _DEEPEST:
        return machine.unknown(Cause.LIMIT, "conversion", hint_of(type_))
    if value.__class__ is Ref and shape is not Shape.CLASS:
        value = read(machine, within(machine, value))
    number = NUMBERS.get(shape)
    if number is not None:
        return _unbraced(machine, value, type_, depth) if isinstance(value, Tuple) else number(machine, value, type_)
    if shape is Shape.TEXT and name_of(type_) == "array":
        return lift(as_characters, _text(machine, _up_to_zero(machine, value) if isinstance(value, Tuple) else value))
    if shape is Shape.TEXT:
        return _text(machine, value)
    if shape in _LISTS or shape in (Shape.MAP, Shape.PAIR):
        return _container(machine, value, type_, shape, depth)
    if isinstance(value, Tuple):
        return _unbraced(machine, value, type_, depth)
    if shape is Shape.CLASS and isinstance(type_, Class):
        return _object(machine, value, type_)
    return NONE if shape is Shape.VOID else as_pointer(value, type_)


def owned(machine: Machine, value: Value, type_: Value, depth: int = 0) -> Value:
    """A value of its own of a type: a copy, where the conversion has made none."""
    held = convert(machine, value, type_, "init", depth)
    made = isinstance(type_, Class) and isinstance(held, Ref) and held not in options(read(machine, value))
    return held if made else copied(machine, held)


COMPOUND: Final = frozenset({Shape.ARRAY, Shape.LIST, Shape.MAP, Shape.PAIR, Shape.SET, Shape.TUPLE})


def is_one(type_: Value, braces: Tuple) -> bool:
    """Whether the inner braces in `std::vector<T> v{{a, b}}` are those of one T."""
    shape = shape_of(type_)
    if isinstance(type_, Class) or shape not in COMPOUND:
        return isinstance(type_, Class)
    inner = argument(type_, 0)
    plain = not isinstance(inner, Class) and shape_of(inner) not in COMPOUND
    several = any(isinstance(item, Tuple) and len(item.items) > 1 for item in braces.items)
    return not (plain and several and shape in (Shape.ARRAY, Shape.LIST, Shape.SET))


def _unbraced(machine: Machine, value: Tuple, type_: Value, depth: int) -> Value:
    """`{}` and `{x}` for something that is no container; of a class, what its constructors make of it."""
    shape = shape_of(type_)
    if not value.items:
        return default_value(machine, type_, depth)
    if shape in (Shape.CLASS, Shape.STREAM) or (shape is Shape.OTHER and name_of(type_)):
        return machine.call(type_, value.items)
    return convert(machine, value.items[0], type_, "init", depth + 1)


def _object(machine: Machine, value: Value, type_: Class) -> Value:
    """A value as an object of a class: by a constructor of one argument, where it is none already."""
    if isinstance(value, (Unknown, External)):
        return value
    if isinstance(value, Ref):
        cls = machine.obj(value).cls
        if not isinstance(cls, Class) or cls == type_:
            return value
    return machine.call(type_, (value,))


def as_characters(value: Value) -> Value:
    """A text as an array of characters holds it, which is no string object."""
    return (
        Const(CharText(value.value), value.origins)
        if text_of(value) is not None and isinstance(value, Const)
        else value
    )


def _up_to_zero(machine: Machine, braces: Tuple) -> Value:
    """The text that the characters in braces make, of an array; the braces where they are not known."""
    found = [character_of(read(machine, item)) for item in braces.items]
    if not found or None in found or any(len(str(each)) != 1 for each in found):
        return braces
    return from_python(machine, "".join(map(str, found)).partition("\0")[0], what="string")


def _text(machine: Machine, value: Value) -> Value:
    if is_char_text(value) and isinstance(value, Const):
        return Const(str(value.value), value.origins)
    if isinstance(value, Text) or text_of(value) is not None:
        return value
    if isinstance(value, Tuple):
        if not value.items:
            return EMPTY
        parts = [read(machine, item) for item in value.items]
        if len(parts) == 1:
            return _text(machine, parts[0])
        texts = [text_of(part) for part in parts]
        if all(text is not None and len(text) == 1 for text in texts):
            return from_python(machine, "".join(map(str, texts)), what="string")
    if isinstance(value, Unknown):
        return value if value.hint == "str" else Unknown(value.reasons, "str")
    if isinstance(value, Ref) and isinstance(machine.obj(value).cls, Class):
        return value  # an object that says itself what it is as a string
    if isinstance(value, Pointer) and isinstance(value.target, Slot) and isinstance(value.target.base, (Ref, Slot)):
        begin = int_of(value.target.key) if isinstance(value.target.key, Value) else None
        if isinstance(value.target.base, Ref):
            text = None if begin is None else text_in(machine, value.target.base, begin)
            return unknown_from(machine, "string", "str", value) if text is None else text
        whole = read(machine, value.target.base)
        if begin == 0 or (begin is not None and text_of(whole) is not None):
            return (
                lift(lambda o: _text(machine, o), whole)
                if begin == 0
                else from_python(machine, str(text_of(whole))[begin:], origins(whole))
            )
    return unknown_from(machine, "string", "str", value)


# Containers


def _container(machine: Machine, value: Value, type_: Value, shape: Shape, depth: int) -> Value:
    if isinstance(value, Ref):
        return _of_object(machine, value, type_, shape, depth)
    if shape is Shape.OPTIONAL:
        if value in (NULLOPT, NONE) or value == Tuple(()):
            return new_container(machine, type_, Series())
        if isinstance(value, Unknown):
            return value
        inner = convert(machine, value, argument(type_, 0), "init", depth + 1)
        return new_container(machine, type_, Series((inner,)), inner)
    if not isinstance(value, Tuple):
        if isinstance(value, Unknown) or (shape is Shape.ARRAY and (isinstance(value, Pointer) or value == NONE)):
            return value  # a parameter that is declared as an array is a pointer
        return unknown_from(machine, "conversion", hint_of(type_), value)
    items = value.items
    if shape is Shape.PAIR:
        return _pair(machine, items, type_, depth)
    if shape is Shape.MAP:
        pairs = [_parts_of_pair(machine, item, type_, depth) for item in items]
        return new_map(machine, type_, pairs, value)
    if shape is Shape.MULTIMAP:
        inner = TypeOf("std.pair", (argument(type_, 0), argument(type_, 1)))
        return new_container(
            machine, type_, Series(tuple(convert(machine, i, inner, "init", depth + 1) for i in items))
        )
    if shape is Shape.TUPLE:
        given = tuple(convert(machine, i, argument(type_, n), "init", depth + 1) for n, i in enumerate(items))
        return new_container(machine, type_, Series(given), value)
    if shape is Shape.ARRAY:
        return _array(machine, items, type_, depth)
    made = tuple(_element(machine, item, type_, shape, depth) for item in items)
    return (new_set if shape is Shape.SET else new_container)(machine, type_, Series(made), value)


def _element(machine: Machine, item: Value, type_: Value, shape: Shape, depth: int) -> Value:
    made = owned(machine, item, argument(type_, 0), depth + 1)
    return key_of(machine, made) if shape is Shape.SET else made


def _array(machine: Machine, items: tuple[Value, ...], type_: Value, depth: int) -> Value:
    """`{1, 2}` and `{{1, 2}}`; what is not given has its default."""
    inner = argument(type_, 0)
    nested = (
        name_of(type_) == "std.array"  # whose elements are those of an array in it
        and len(items) == 1
        and isinstance(items[0], Tuple)
        and shape_of(inner) not in _LISTS | {Shape.CLASS, Shape.PAIR}
    )
    if nested and isinstance(items[0], Tuple):
        items = items[0].items
    made = [owned(machine, item, inner, depth + 1) for item in items]
    count = int_of(argument(type_, 1))
    if count is not None and len(made) < count <= _MOST_DEFAULT:
        made.extend(default_value(machine, inner, depth + 1) for _ in range(count - len(made)))
    return new_container(machine, type_, Series(tuple(made)), Tuple(items))


def _pair(machine: Machine, items: tuple[Value, ...], type_: Value, depth: int) -> Value:
    if len(items) != 2:
        return default_value(machine, type_, depth) if not items else unknown_from(machine, "pair", "", *items)
    first, second = (owned(machine, item, argument(type_, n), depth + 1) for n, item in enumerate(items))
    return new_pair(machine, first, second, type_.arguments if isinstance(type_, TypeOf) else ())


def _parts_of_pair(machine: Machine, item: Value, type_: Value, depth: int) -> tuple[Value, Value]:
    """The key, and the value, of what is put into a map."""
    item = read(machine, item)
    first: Value
    second: Value
    if isinstance(item, Tuple) and len(item.items) == 2:
        first, second = item.items
    elif isinstance(item, Ref) and machine.obj(item).kind == "instance":
        first, second = read_field(machine, item, "first"), read_field(machine, item, "second")
    else:
        first = second = unknown_from(machine, "pair", "", item)
    key = key_of(machine, convert(machine, first, argument(type_, 0), "init", depth + 1))
    return key, owned(machine, second, argument(type_, 1), depth + 1)


def _of_object(machine: Machine, value: Ref, type_: Value, shape: Shape, depth: int) -> Value:
    """An object as a container: itself where it is one of that kind; what came without a type gets it."""
    obj = machine.obj(value)
    if isinstance(obj.cls, Class) and shape is not Shape.OPTIONAL:
        return value
    if shape is Shape.OPTIONAL and name_of(obj.cls) != name_of(type_):
        inner = convert(machine, value, argument(type_, 0), "init", depth + 1)
        return new_container(machine, type_, Series((inner,)), inner)
    if shape is Shape.TUPLE and obj.kind == "instance":
        pair = Tuple((read_field(machine, value, "first"), read_field(machine, value, "second")))
        return _container(machine, pair, type_, shape, depth)
    if isinstance(type_, TypeOf) and shape in (Shape.PAIR, Shape.TUPLE) and obj.cls != type_:
        value, obj = _with_texts(machine, value, type_)
    if isinstance(type_, TypeOf) and obj.kind in ("list", "dict") and obj.cls != type_:
        if shape is Shape.SET and obj.kind == "list" and name_of(obj.cls) != name_of(type_):
            series = obj.series().mapped(lambda item: key_of(machine, item))
            return new_set(machine, type_, series, value)
        machine.update(value, obj.replace(cls=type_))
    return value


def _with_texts(machine: Machine, value: Ref, type_: TypeOf) -> tuple[Ref, Obj]:
    """A pair or tuple as one that has strings where another has pointers to characters: `std::make_pair(name, 1)`."""
    obj, types = machine.obj(value), type_.arguments
    pair = obj.kind == "instance"
    items = tuple(read_field(machine, value, name) for name in ("first", "second")) if pair else obj.items or ()
    made = tuple(as_string(machine, o) if shape_of(t) is Shape.TEXT else o for o, t in zip(items, types, strict=False))
    if len(items) != len(types) or all(new is old for new, old in zip(made, items, strict=True)):
        return value, obj
    fresh = new_pair(machine, made[0], made[1], types) if pair else new_container(machine, type_, Series(made))
    return fresh, machine.obj(fresh)


def is_empty_optional(machine: Machine, value: Value) -> bool | None:
    """Whether an optional surely has, or has not, a value."""
    answers: set[bool | None] = set()
    for option in options(read(machine, value)):
        if option in (NULLOPT, NONE):
            answers.add(True)
        elif isinstance(option, Ref) and machine.obj(option).kind == "list":
            series = machine.obj(option).series()
            answers.add((not series.head) if series.exact else (False if series.least else None))
        else:
            answers.add(None)
    return answers.pop() if len(answers) == 1 else None
