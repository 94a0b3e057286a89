# SPDX-License-Identifier: Apache-2.0
"""What does `<type_traits>` say of types?

is_same_v<std::string, T>       True, False, or not known where the types of values that were deduced do not tell
decay_t<const T &>              T
enable_if_t<false>              no type at all: `NO_TYPE`, by which an overload is none
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.compound import External
from rosward.domain.slots import TypeOf
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import TRUE, Choice, Class, Const, Unknown, Value
from rosward.ir.arithmetic import UNSIGNED, WIDE
from rosward.location import Place
from rosward.models.cpp.values.number_conversions import number_named
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of

__all__ = ["NO_TYPE", "SOME_TYPE", "TRAITS"]

NO_TYPE: Final = External("std.enable_if.none")
"""What stands for the type that `std::enable_if_t<false>` does not have."""
_NOWHERE: Final = Place("", 0)
SOME_TYPE: Final = Unknown((Reason(Cause.OPERATION, "type of a member", _NOWHERE),))
"""A type that is there, whichever it is."""
_VOID: Final = TypeOf("void", ())
_WRAPPERS: Final = frozenset(("reference", "const", "volatile", "rvalue"))
_POINTERS: Final = frozenset(("pointer", "std.shared_ptr", "std.unique_ptr", "std.weak_ptr"))
_NUMBERS: Final = frozenset({Shape.INT, Shape.FLOAT, Shape.BOOL, Shape.CHAR})
_WHOLE: Final = frozenset({Shape.INT, Shape.BOOL, Shape.CHAR})
_WRITTEN: Final = frozenset({UNSIGNED, "float", "int8_t", "short", "uint8_t", "unsigned short"})
"""Types of numbers that a value has only where they are written."""
_DEEPEST: Final = 12
Types = tuple[Value, ...]
Trait = Callable[[Types], Value]


def _unknown(what: str, hint: str = "") -> Unknown:
    return Unknown((Reason(Cause.OPERATION, what, _NOWHERE),), hint)


def _told(what: str, answer: bool | None) -> Value:
    return _unknown(what, "bool") if answer is None else Const(answer)


def _bare(type_: Value) -> Value:
    """A type without references and qualifiers."""
    for _ in range(_DEEPEST):
        if not (isinstance(type_, TypeOf) and type_.name in _WRAPPERS and type_.arguments):
            break
        type_ = type_.arguments[0]
    return type_


# Questions


def _same(a: Value, b: Value, depth: int = 0) -> bool | None:
    """Whether two types are one. What is known of a type that was deduced of a value may not tell which one it is."""
    if a == b:
        return None if isinstance(a, (Unknown, Choice)) else True
    if isinstance(a, (Unknown, Choice)) or isinstance(b, (Unknown, Choice)) or depth > _DEEPEST:
        return None
    first, second = name_of(a), name_of(b)
    ours, theirs = shape_of(a), shape_of(b)
    if ours is theirs and ours in (Shape.INT, Shape.FLOAT, Shape.TEXT):
        return _same_number(first, second)
    if first in _POINTERS and second in _POINTERS:
        inner = _same(argument(a, 0), argument(b, 0), depth + 1)
        return False if inner is False else None
    if first != second or not isinstance(a, TypeOf) or not isinstance(b, TypeOf):
        return None if first == second else False
    if len(a.arguments) != len(b.arguments):
        return None
    answers = {_same(x, y, depth + 1) for x, y in zip(a.arguments, b.arguments, strict=True)}
    return False if False in answers else None if None in answers else True


def _same_number(one: str, other: str) -> bool | None:
    """Whether two types of numbers are one, where a value is taken for one of them only if it is written to be of that."""
    names = {number_named(one), number_named(other)}
    if names <= _WRITTEN:
        return len(names) == 1
    return False if WIDE in names and names & _WRITTEN else None


def _is_same(types: Types) -> Value:
    return _told("is_same", _same(types[0], types[1]) if len(types) > 1 else None)


def _derives(base: Value, derived: Value) -> bool | None:
    if isinstance(derived, Class):
        if base in derived.mro:
            return True
        return False if all(isinstance(each, Class) for each in derived.mro) else None
    if isinstance(derived, (Unknown, Choice)) or isinstance(base, (Unknown, Choice)):
        return None
    if base == derived:
        return True
    return None if shape_of(derived) is Shape.OTHER else False


def _is_base_of(types: Types) -> Value:
    return _told("is_base_of", _derives(_bare(types[0]), _bare(types[1])) if len(types) > 1 else None)


def _converts(source: Value, target: Value) -> bool | None:
    source, target = _bare(source), _bare(target)
    shapes = (shape_of(source), shape_of(target))
    if all(shape in _NUMBERS for shape in shapes) or _same(source, target):
        return True
    if isinstance(source, Class) and isinstance(target, Class) and target in source.mro:
        return True
    apart = (shapes[0] in _NUMBERS and shapes[1] is Shape.TEXT) or (shapes[1] in _NUMBERS and shapes[0] is Shape.TEXT)
    return False if apart and Shape.CHAR not in shapes else None


def _is_convertible(types: Types) -> Value:
    return _told("is_convertible", _converts(types[0], types[1]) if len(types) > 1 else None)


def _of_shape(name: str, shapes: frozenset[Shape]) -> Trait:
    """Whether values of a type are kept in one of some ways."""

    def ask(types: Types) -> Value:
        type_ = _bare(types[0]) if types else _VOID
        if isinstance(type_, (Unknown, Choice)) or name_of(type_) == "auto":
            return _unknown(name, "bool")
        return Const(shape_of(type_) in shapes)

    return ask


def _is_raw_pointer(types: Types) -> Value:
    name = name_of(types[0]) if types else ""
    if isinstance(types[0] if types else _VOID, (Unknown, Choice)):
        return _unknown("is_pointer", "bool")
    return Const(name == "pointer")


def _is_class(types: Types) -> Value:
    type_ = _bare(types[0]) if types else _VOID
    if isinstance(type_, (Unknown, Choice)):
        return _unknown("is_class", "bool")
    plain = shape_of(type_) in _NUMBERS or name_of(type_) in ("pointer", "void", "array", "function")
    if isinstance(type_, External) and not plain and not type_.name.startswith("std."):
        return _unknown("is_class", "bool")  # it may be an enum
    return Const(not plain)


def _is_enum(types: Types) -> Value:
    type_ = _bare(types[0]) if types else _VOID
    known = isinstance(type_, (Class, TypeOf)) or (isinstance(type_, External) and type_.name.startswith("std."))
    return Const(False) if known else _unknown("is_enum", "bool")


def _is_signed(types: Types) -> Value:
    type_ = _bare(types[0]) if types else _VOID
    if isinstance(type_, (Unknown, Choice)):
        return _unknown("is_signed", "bool")
    words = name_of(type_).removeprefix("std.")
    unsigned = words.startswith("u") or words in ("size_t", "bool")
    return Const(shape_of(type_) in _NUMBERS and not unsigned)


def _is_unsigned(types: Types) -> Value:
    signed = _is_signed(types)
    if not types or not isinstance(signed, Const):
        return signed
    return Const(not signed.value and shape_of(_bare(types[0])) in _WHOLE)


def _is_wrapped(name: str) -> Trait:
    """What a type is by `&` or `const` is not kept of most types: nobody knows that it is not."""
    return lambda types: TRUE if types and name_of(types[0]) == name else _unknown(f"is_{name}", "bool")


def _asked(name: str) -> Trait:
    return lambda _types: _unknown(name, "bool")


def _all(types: Types) -> Value:
    return _joined(types, decisive=False)


def _any(types: Types) -> Value:
    return _joined(types, decisive=True)


def _joined(types: Types, *, decisive: bool) -> Value:
    """conjunction, disjunction."""
    values = [_value(type_) for type_ in types]
    if decisive in values:
        return Const(decisive)
    return _unknown("conjunction", "bool") if None in values else Const(not decisive)


def _value(type_: Value) -> bool | None:
    """`type::value` of one of these traits."""
    if isinstance(type_, Const):
        return bool(type_.value)
    name = name_of(type_)
    if name in ("std.true_type", "std.false_type"):
        return name == "std.true_type"
    if name in ("std.integral_constant", "std.bool_constant"):
        return _value(argument(type_, 1 if name == "std.integral_constant" else 0))
    trait = TRAITS.get(f"{name}_v")
    found = trait(type_.arguments) if trait is not None and isinstance(type_, TypeOf) else None
    return bool(found.value) if isinstance(found, Const) else None


def _negation(types: Types) -> Value:
    value = _value(types[0]) if types else None
    return _told("negation", None if value is None else not value)


# Types


def _first(types: Types) -> Value:
    return types[0] if types else _VOID


def _bare_first(types: Types) -> Value:
    return _bare(_first(types))


def _pointee(types: Types) -> Value:
    type_ = _bare_first(types)
    return argument(type_, 0) if name_of(type_) in ("pointer", "array") else type_


def _pointer(types: Types) -> Value:
    return TypeOf("pointer", (_bare_first(types),))


def _conditional(types: Types) -> Value:
    if len(types) < 3:
        return _unknown("conditional")
    truth = _value(types[0])
    return _unknown("conditional") if truth is None else types[1] if truth else types[2]


def _enable_if(types: Types) -> Value:
    if not types:
        return NO_TYPE
    truth = _value(types[0])
    given = types[1] if len(types) > 1 else _VOID
    return NO_TYPE if truth is False else given if truth else _unknown("enable_if")


def _void(types: Types) -> Value:
    if NO_TYPE in types:
        return NO_TYPE
    is_open = any(isinstance(each, (Unknown, Choice)) and each != SOME_TYPE for each in types)
    return _unknown("void_t") if is_open else _VOID


def _common(types: Types) -> Value:
    if any(shape_of(type_) is Shape.FLOAT for type_ in types):
        return TypeOf("double", ())
    return types[0] if types and all(type_ == types[0] for type_ in types) else _unknown("common_type")


def _count(types: Types) -> Value:
    """tuple_size, variant_size."""
    type_ = _bare_first(types)
    if name_of(type_) == "std.array":
        return argument(type_, 1)
    return Const(len(type_.arguments)) if isinstance(type_, TypeOf) and type_.arguments else _unknown("size", "int")


def _part(types: Types) -> Value:
    """tuple_element, variant_alternative."""
    index = types[0].value if types and isinstance(types[0], Const) else None
    if len(types) < 2 or not isinstance(index, int):
        return _unknown("element")
    type_ = _bare(types[1])
    return argument(type_, 0 if name_of(type_) == "std.array" else index)


_QUESTIONS: Final[dict[str, Trait]] = {
    "is_same": _is_same,
    "is_base_of": _is_base_of,
    "is_convertible": _is_convertible,
    "is_integral": _of_shape("is_integral", _WHOLE),
    "is_floating_point": _of_shape("is_floating_point", frozenset({Shape.FLOAT})),
    "is_arithmetic": _of_shape("is_arithmetic", _NUMBERS),
    "is_void": _of_shape("is_void", frozenset({Shape.VOID})),
    "is_array": _of_shape("is_array", frozenset({Shape.ARRAY})),
    "is_pointer": _is_raw_pointer,
    "is_class": _is_class,
    "is_enum": _is_enum,
    "is_signed": _is_signed,
    "is_unsigned": _is_unsigned,
    "is_reference": _is_wrapped("reference"),
    "is_lvalue_reference": _is_wrapped("reference"),
    "is_const": _is_wrapped("const"),
    "conjunction": _all,
    "disjunction": _any,
    "negation": _negation,
    "tuple_size": _count,
    "variant_size": _count,
    **{
        name: _asked(name)
        for name in (
            "is_constructible", "is_default_constructible", "is_copy_constructible", "is_move_constructible",
            "is_assignable", "is_copy_assignable", "is_invocable", "is_invocable_r", "is_abstract", "is_polymorphic",
            "is_final", "is_trivial", "is_trivially_copyable", "is_scalar", "is_function", "is_object", "is_empty",
            "is_member_function_pointer", "is_nothrow_move_constructible", "is_nothrow_move_assignable",
        )
    },
}  # fmt: skip
_MADE: Final[dict[str, Trait]] = {
    **dict.fromkeys(("decay", "remove_reference", "remove_const", "remove_cv", "remove_cvref"), _bare_first),
    **dict.fromkeys(
        ("add_const", "add_lvalue_reference", "add_rvalue_reference", "type_identity", "unwrap_ref_decay"), _first
    ),
    **dict.fromkeys(("remove_pointer", "remove_extent"), _pointee),
    "add_pointer": _pointer,
    "conditional": _conditional,
    "enable_if": _enable_if,
    "common_type": _common,
    "underlying_type": lambda _types: TypeOf("int", ()),
    **dict.fromkeys(("make_signed", "make_unsigned"), _first),
    **dict.fromkeys(("tuple_element", "variant_alternative"), _part),
    **dict.fromkeys(("invoke_result", "result_of"), lambda _types: _unknown("invoke_result")),
}

_CONCEPTS: Final[dict[str, Trait]] = {
    "same_as": _is_same,
    "convertible_to": _is_convertible,
    "derived_from": lambda types: _is_base_of(types[::-1]),
    "integral": _QUESTIONS["is_integral"],
    "floating_point": _QUESTIONS["is_floating_point"],
    **{name: _asked(name) for name in ("signed_integral", "unsigned_integral", "invocable", "constructible_from")},
}

TRAITS: Final[dict[str, Trait]] = {
    **{f"std.{name}_v": trait for name, trait in _QUESTIONS.items()},
    **{f"std.{name}_t": trait for name, trait in _MADE.items()},
    **{f"std.{name}": trait for name, trait in _CONCEPTS.items()},
    "std.void_t": _void,
    "std.type_identity_t": _first,
}
"""By the name of a variable or alias template: its value for some types."""
