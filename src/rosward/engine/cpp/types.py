# SPDX-License-Identifier: Apache-2.0
"""Types as values: which type has a value, which one does a pattern stand for, and what must the parameters of a template be to fit?

const std::shared_ptr<T> &   against a pointer to a Lamp      T is Lamp
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.enumerated import Whole
from rosward.domain.heap import Obj
from rosward.domain.slots import Enumerated, Overloads, Owner, Pointer, Slot, TypeOf, is_char_text
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.engine.cpp.enumerations import is_enumeration
from rosward.engine.cpp.linked import linked
from rosward.ir.arithmetic import LONG, same_type
from rosward.ir.symbols import TypePattern
from rosward.models.cpp.values.characters import is_text
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, argument, name_of, shape_of
from rosward.models.interfaces import message_name

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = [
    "CHARACTERS",
    "POINTERS",
    "STRING",
    "dotted",
    "flat",
    "is_message",
    "is_of_language",
    "is_pointer_pattern",
    "is_type",
    "match",
    "plain_type",
    "pointee",
    "pointer_member",
    "pointer_to",
    "type_of",
]

STRING: Final = External("std.string")
POINTERS: Final = frozenset({"pointer", "std.shared_ptr", "std.unique_ptr", "std.weak_ptr"})
_SMART: Final = POINTERS - {"pointer"}
_POINTER_MEMBERS: Final = frozenset(
    f"{const}{kind}Ptr{of}"
    for const in ("", "Const")
    for kind in ("Shared", "Unique", "Weak")
    for of in ("", "WithDeleter")
)
_OF_PLAIN: Final[dict[type, Value]] = {
    bool: TypeOf("bool", ()),
    int: TypeOf("int", ()),
    float: TypeOf("double", ()),
    str: STRING,
    type(None): TypeOf("nullptr", ()),
}
_OF_OWNER: Final[dict[Owner, str]] = {"": "pointer", "shared": "std.shared_ptr", "unique": "std.unique_ptr"}
_LONG: Final = TypeOf(LONG, ())
CHARACTERS: Final = TypeOf("pointer", (TypeOf("char", ()),))
_OF_HINT: Final[dict[str, Value]] = {
    "str": STRING, "int": TypeOf("int", ()), "float": TypeOf("double", ()), "bool": TypeOf("bool", ()),
}  # fmt: skip
_DEPTH: Final = 20
_WRITTEN: Final = frozenset({"array", "const", "function", "pointer", "reference", "rvalue", "volatile"})


def pointer_to(type_: Value) -> TypeOf:
    """The type of pointers to a type; which kind of pointer makes no difference."""
    return TypeOf("pointer", (type_,))


def pointee(type_: Value) -> Value | None:
    """What a pointer type points to; None for any other type."""
    return type_.arguments[0] if isinstance(type_, TypeOf) and type_.name in POINTERS and type_.arguments else None


def pointer_member(name: str) -> bool:
    """Whether a class conventionally calls a pointer to itself so: `SharedPtr`, `ConstSharedPtr`, `UniquePtr`, …"""
    return name in _POINTER_MEMBERS


def is_message(type_: Value) -> bool:
    """Whether a type is a message, or the request of a service, and the like."""
    return isinstance(type_, External) and message_name(type_.name) is not None


def is_type(machine: Engine, value: Value) -> bool:
    """Whether a value of a library is a type that something can be made of."""
    if isinstance(value, Class) or is_message(value):
        return True
    if not isinstance(value, (External, TypeOf)):
        return False
    if shape_of(value) is not Shape.OTHER or is_enumeration(machine, value):
        return True
    name = dotted(value)
    return (isinstance(value, TypeOf) and is_of_language(value)) or machine.library.native(f"{name}.new") is not None


def is_of_language(type_: TypeOf) -> bool:
    """Whether a type is one of the language, not a template that nothing declares (`Box<A>`, which may be a function)."""
    return "." not in type_.name and (not type_.arguments or type_.name in _WRITTEN)


def dotted(type_: Value) -> str:
    """The name of a type, without its arguments."""
    if isinstance(type_, Class):
        return type_.dotted
    return type_.name if isinstance(type_, (External, TypeOf, Native)) else ""


def plain_type(machine: Engine, value: Value) -> Value:
    """The type of a value, or a type; that of numbers by the one of its names that stands for all, so that it can be compared."""
    found = type_of(machine, value)
    return TypeOf(same_type(found.name), ()) if isinstance(found, TypeOf) and not found.arguments else found


def type_of(machine: Engine, value: Value, depth: int = 0) -> Value:
    """The type of a value, as far as it shows."""
    value = read(machine, value)
    if len(options(value)) > 1:
        found = {
            type_of(machine, o, depth + 1) for o in options(value) if not (isinstance(o, Const) and o.value is None)
        }
        if _LONG in found:
            found.discard(_OF_PLAIN[int])
        for target in [pointee(each) for each in found if dotted(each) in _SMART]:
            found.discard(TypeOf("pointer", (target,)) if target is not None else NONE)  # whether it owns, did not show
        return found.pop() if len(found) == 1 else machine.unknown(Cause.CALL, "type of one of several values")
    if isinstance(value, Const):
        if isinstance(value.value, Enumerated):
            return External(value.value.enumeration)
        if is_char_text(value):
            return CHARACTERS
        if isinstance(value.value, Whole):
            return TypeOf(value.value.named, ())
        if value.value.__class__ is int and 2**31 <= value.value < 2**32:
            return _LONG  # an int cannot be as great
        return _OF_PLAIN.get(value.value.__class__, STRING)
    if isinstance(value, Text):
        return STRING
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if isinstance(obj.cls, TypeOf) and not obj.cls.arguments and depth < _DEPTH:
            return _of_parts(machine, obj, obj.cls.name, depth + 1)
        return TypeOf("std.vector", ()) if isinstance(obj.cls, Native) else obj.cls
    if isinstance(value, Pointer) and _is_in_text(machine, value.target):
        return CHARACTERS
    if isinstance(value, Pointer):
        target = type_of(machine, value.target, depth + 1) if depth < _DEPTH else None
        return value if target is None else TypeOf(_OF_OWNER[value.owner], (target,))
    if isinstance(value, (Function, BoundMethod, Partial, Overloads)):
        return TypeOf("function", ())
    if isinstance(value, Tuple):
        return TypeOf("std.initializer_list", ())
    if isinstance(value, Unknown):
        return _OF_HINT.get(value.hint, value)
    return value


def _is_in_text(machine: Engine, place: Value) -> bool:
    """Whether a place is that of a character, in a text or in a container of characters."""
    if not isinstance(place, Slot) or place.kind != "item":
        return False
    if isinstance(place.base, Ref):
        return name_of(argument(machine.obj(place.base).cls, 0)) == "char"
    return all(map(is_text, options(read(machine, place.base))))


def _of_parts(machine: Engine, obj: Obj, name: str, depth: int) -> Value:
    """The type of what was made without saying it (`std::make_tuple(1, "a")`), by what is in it."""
    parts: tuple[Value, ...] = ()
    if name == "std.tuple" and obj.items is not None:
        parts = obj.items
    elif name == "std.pair" and obj.attrs.keys() >= {"first", "second"}:
        parts = obj.attrs["first"], obj.attrs["second"]
    return TypeOf(name, tuple(type_of(machine, part, depth) for part in parts))


def is_pointer_pattern(pattern: TypePattern) -> bool:
    """Whether a type as it is written is surely that of a pointer."""
    if pattern.pointers:
        return True
    last = pattern.names[-1] if pattern.names else ""
    return pointer_member(last) or last in {"shared_ptr", "unique_ptr", "weak_ptr"}


def match(
    machine: Engine,
    pattern: TypePattern,
    type_: Value,
    wanted: frozenset[str],
    bindings: dict[str, Value],
    depth: int = 0,
    *,
    sure: bool = False,
    written: bool = False,
) -> bool:
    """Bind the template parameters in `wanted` so that a pattern is the type; False where it can't be that (`sure`: or may be another).

    `written`: the type is one as it is written, not that of a value, of which it need not show what kind of pointer it is."""
    if depth > _DEPTH:
        return not sure
    if pattern.pointers or (pattern.names and pattern.names[-1] in {"shared_ptr", "unique_ptr", "weak_ptr"}):
        target = pointee(type_)
        if target is None:
            return isinstance(type_, (Unknown, External)) and not sure
        if (sure or written) and dotted(type_).rpartition(".")[2] != (
            "pointer" if pattern.pointers else pattern.names[-1]
        ):
            return False
        inner = pattern._replace(pointers=pattern.pointers - 1) if pattern.pointers else _first(pattern)
        return match(machine, inner, target, wanted, bindings, depth + 1, sure=sure, written=written)
    if len(pattern.names) == 1 and pattern.names[0] in wanted and not pattern.arguments:
        name = pattern.names[0]
        if name in bindings and not isinstance(bindings[name], Unknown):
            return bindings[name] == type_ or (isinstance(type_, Unknown) and not sure)
        bindings[name] = type_
        return True
    if not pattern.arguments:
        return True
    if pattern.names[-1:] == ("integer_sequence",) and dotted(type_) == "std.index_sequence":
        kind, *numbers = pattern.arguments
        match(machine, kind, TypeOf("int", ()), wanted, bindings, depth + 1)
        pattern = pattern._replace(names=("std", "index_sequence"), arguments=tuple(numbers))
    if pattern.names and pattern.names[-1].endswith("_") and is_message(type_):  # `String_<A>` is what a String is
        named = ".".join(pattern.names)[:-1]
        if not f".{dotted(type_)}".endswith(f".{named.removeprefix('.')}"):
            return False
        type_ = TypeOf(f"{dotted(type_)}_", (_ALLOCATOR,))
    types = _arguments(machine, type_)
    if pattern.builtin == "function" and not isinstance(type_, Unknown) and name_of(type_) != "function":
        return False
    if types is None or (pattern.names and pattern.names[-1] != dotted(type_).rpartition(".")[2]):
        return isinstance(type_, Unknown) and not sure
    for index, each in enumerate(pattern.arguments):
        if each.pack and len(each.names) == 1 and each.names[0] in wanted:
            open_ = isinstance(type_, TypeOf) and not types  # nobody has said what it is made of
            found = machine.unknown(Cause.CALL, each.names[0]) if open_ else Tuple(types[index:])
            bindings.setdefault(each.names[0], found)
            return True
        if index < len(types) and not match(
            machine, each, types[index], wanted, bindings, depth + 1, sure=sure, written=written
        ):
            return False
    return True


_ALLOCATOR: Final = TypeOf("std.allocator", (TypeOf("void", ()),))
"""What messages are made with."""


def _first(pattern: TypePattern) -> TypePattern:
    return pattern.arguments[0] if pattern.arguments else TypePattern()


def _arguments(machine: Engine, type_: Value) -> tuple[Value, ...] | None:
    if isinstance(type_, TypeOf):
        return type_.arguments
    info = linked(machine).info(type_) if isinstance(type_, Class) else None
    return flat(info.types) if info is not None else None


def flat(types: tuple[Value, ...]) -> tuple[Value, ...]:
    """The arguments of a template as they are written: a pack is several."""
    return tuple(each for type_ in types for each in (type_.items if isinstance(type_, Tuple) else (type_,)))


def slot_free(value: Value) -> bool:
    """Whether a value is no slot."""
    return not isinstance(value, Slot)
