# SPDX-License-Identifier: Apache-2.0
"""How well does a value fit the type of a parameter? From 0, not at all, to `EXACT`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.slots import Overloads, Pointer, TypeOf, is_char_text
from rosward.domain.values import NONE, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.engine.cpp.convertible import NUMBERS, TEXTS, converts, is_convertible
from rosward.engine.cpp.enumerations import enumeration_of, is_enumeration
from rosward.engine.cpp.function_types import may_be, of_type
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.types import CHARACTERS, STRING, dotted, pointee, type_of
from rosward.ir.arithmetic import INT, LONG
from rosward.models.cpp.values.number_conversions import OCTETS
from rosward.models.cpp.values.types import NOT_OF_ONE, argument

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = [
    "CALLABLES",
    "CONVERTED",
    "DEDUCED",
    "EXACT",
    "FORWARDED",
    "NEAR",
    "NEVER",
    "TEMPLATE",
    "as_base",
    "fit",
    "fit_object",
    "is_number",
]

SCALE: Final = 100
EXACT: Final = 5 * SCALE
FORWARDED: Final = EXACT - 1
DEDUCED: Final = 4 * SCALE + SCALE // 2
NEAR: Final = 4 * SCALE
TEMPLATE: Final = 3 * SCALE
STANDARD: Final = 2 * SCALE
CONVERTED: Final = SCALE
NEVER: Final = 0
_INTEGERS: Final = frozenset({"int", "long", "short", "unsigned", "size_t", "char"})
_FLOATS: Final = frozenset({"float", "double"})
CALLABLES: Final = (Function, BoundMethod, Partial, Overloads)


def fit(machine: Engine, value: Value, type_: Value) -> int:
    """How well a value fits a type: 0 not at all, 500 exactly."""
    if isinstance(value, Unknown) and not value.hint:
        return CONVERTED
    name = dotted(type_)
    target = pointee(type_)
    if isinstance(type_, Unknown) or name == "auto":
        return TEMPLATE
    if isinstance(value, Pointer) or value == Const(None):
        is_text = value != Const(None) and type_of(machine, value) == CHARACTERS
        return _characters(machine, value, type_, name, target) if is_text else _pointer(machine, value, target, name)
    if isinstance(value, CALLABLES):
        return _callable(machine, value, type_, name)
    if isinstance(value, (Const, Text, Unknown)):
        return _plain(machine, value, type_, name, target)
    if isinstance(value, Tuple):
        return _braces(machine, value, type_, name)
    if isinstance(value, Ref):
        return fit_object(machine, machine.obj(value).cls, type_, name)
    return CONVERTED if type_ != value else EXACT


def _braces(machine: Engine, value: Tuple, type_: Value, name: str) -> int:
    """How well what stands in braces fits a type: rather a list of such elements than what is made of one."""
    if len(value.items) > 1 and (name == "pointer" or _is_of_one(name, value)):
        return NEVER
    element = argument(type_, 0) if name in _LISTS else NONE
    if element == NONE:
        return CONVERTED
    if any(fit(machine, each, element) == NEVER for each in value.items):
        return NEVER
    return TEMPLATE if name == "std.initializer_list" else CONVERTED


def _is_of_one(name: str, value: Tuple) -> bool:
    """Whether a type is made of a single value: a function, a string not of several texts."""
    return name in _INTEGERS | _FLOATS | _EMPTY | {"bool"} or (name in TEXTS and all(map(is_char_text, value.items)))


_LISTS: Final = frozenset({"std.deque", "std.initializer_list", "std.list", "std.set", "std.vector"})
_TRUTHS: Final = frozenset({"bool", "nullptr", "std.nullptr_t", "void"})
_EMPTY: Final = frozenset({"function", "std.function"})
"""Types that are made of the null pointer, beside pointers."""


def _pointer(machine: Engine, value: Value, target: Value | None, name: str) -> int:
    if target is None:
        if value == Const(None) and name in {"nullptr", "std.nullptr_t"}:
            return EXACT
        empty = _EMPTY if value == Const(None) else frozenset[str]()
        return CONVERTED if name in _TRUTHS | empty or _is_open(machine, name) else NEVER
    if not isinstance(value, Pointer):
        return NEAR if name == "pointer" else CONVERTED
    cls = type_of(machine, value.target)
    other = bool(value.owner) is not name.endswith(".shared_ptr") and name in ("pointer", "std.shared_ptr")
    if cls == target or dotted(target) == "void":
        # A weak pointer may be made of a shared one: nobody knows which of them the value is.
        return TEMPLATE if name.endswith("weak_ptr") or other else EXACT
    if isinstance(cls, Class) and isinstance(target, Class):
        return (
            (TEMPLATE if other else as_base(cls, target))
            if target in cls.mro
            else NEVER
            if linked(machine).info(target)
            else CONVERTED
        )
    return CONVERTED


def as_base(cls: Class, base: Value) -> int:
    """How well an object fits the type of one of its bases: rather the nearer one."""
    return NEAR - min(cls.mro.index(base), SCALE // 2)


def _is_open(machine: Engine, name: str) -> bool:
    """Whether nothing is known of a type of that name."""
    return "." in name and not name.startswith("std.") and machine.library.native(f"{name}.new") is None


def _callable(machine: Engine, value: Value, type_: Value, name: str) -> int:
    wanted = of_type(type_)
    if wanted is not None:
        fits = may_be(machine, value, wanted)
        return NEVER if fits is False else EXACT if fits else NEAR
    if name in {"function", "std.function"}:
        return EXACT
    if name in _INTEGERS | _FLOATS | TEXTS | {"bool"}:
        return NEVER
    if isinstance(type_, Class):
        return CONVERTED if converts(machine, type_, TypeOf("function", ())) else NEVER
    return CONVERTED


def _plain(machine: Engine, value: Value, type_: Value, name: str, target: Value | None) -> int:
    if name in NOT_OF_ONE:
        return NEVER
    if name == "std.optional":
        return min(fit(machine, value, argument(type_, 0)), CONVERTED)
    own = type_of(machine, value)
    if enumeration_of(value):
        return _enumerator(own, type_, name)
    if is_char_text(value):
        return _characters(machine, value, type_, name, target)
    words = set(name.replace("std.", "").split())
    if own == STRING:
        if name in TEXTS:
            return EXACT
        if target is not None and dotted(target) == "char":
            return CONVERTED if isinstance(value, Const) else EXACT
        if words & _INTEGERS:
            is_char = isinstance(value, Const) and len(str(value.value)) == 1
            return NEVER if not is_char else EXACT if name == "char" else TEMPLATE if name == "int" else STANDARD
    elif (kind := dotted(own)) in NUMBERS:
        if name == kind or OCTETS.get(name.removeprefix("std.")) == kind:
            return EXACT
        if kind in OCTETS:
            return NEAR if name == "int" else TEMPLATE if is_number(name) else NEVER if name in TEXTS else CONVERTED
        integer = bool(words & _INTEGERS) or name.endswith("_t")
        if integer and (kind in (INT, LONG) or (kind == "bool" and name == "int")):
            return NEAR
        if name == "bool" or integer or words & _FLOATS:
            is_other = name == "bool" or integer == (kind == "double")
            return STANDARD if is_other else TEMPLATE
        if name in TEXTS:
            return NEVER
    if target is not None or (isinstance(value, Const) and is_enumeration(machine, type_)):
        return NEVER
    if isinstance(type_, Class):
        return CONVERTED if converts(machine, type_, own) else NEVER
    return CONVERTED if isinstance(type_, (External, Native)) or name.startswith("std.") else NEVER


def _characters(machine: Engine, value: Value, type_: Value, name: str, target: Value | None) -> int:
    """A literal: rather a truth than a string, which has to be made of it."""
    if target is not None:
        return EXACT if dotted(target) == "char" else STANDARD if dotted(target) == "void" else NEVER
    if name == "bool":
        return STANDARD
    if is_number(name) or name in {"char", "float", "double"}:
        return NEVER
    if isinstance(type_, Class):
        return CONVERTED if converts(machine, type_, type_of(machine, value)) else NEVER
    return CONVERTED


def _enumerator(own: Value, type_: Value, name: str) -> int:
    """A value of an enumeration is converted to a number, if anything."""
    if own == type_:
        return EXACT
    if name in TEXTS or (isinstance(type_, (Class, TypeOf)) and not is_number(name)):
        return NEVER
    return TEMPLATE if name == "int" else CONVERTED


def is_number(name: str) -> bool:
    """Whether a type of that name is one of numbers or truths."""
    return bool(set(name.replace("std.", "").split()) & (_INTEGERS | _FLOATS)) or name == "bool" or name.endswith("_t")


def fit_object(machine: Engine, cls: Value, type_: Value, name: str) -> int:
    """How well an object of a class fits a type."""
    if cls == type_:
        return EXACT
    if isinstance(cls, Class) and type_ in cls.mro:
        return as_base(cls, type_)
    if isinstance(type_, Class):
        if isinstance(cls, Class) and linked(machine).info(type_) is not None:
            return CONVERTED if is_convertible(machine, type_, cls) else NEVER
        return CONVERTED
    if name.startswith("std.chrono.") and isinstance(cls, TypeOf):
        return CONVERTED if dotted(cls).startswith("std.chrono.") else NEVER  # a container is no time
    if isinstance(type_, TypeOf):
        own = dotted(cls)
        if own.rpartition(".")[2] == name.rpartition(".")[2] or isinstance(cls, Native):
            return NEAR
        return NEVER if name in _INTEGERS | _FLOATS or "." not in name or name == "pointer" else CONVERTED
    if isinstance(cls, Class) and not any(isinstance(b, External) for b in cls.mro):
        return CONVERTED if name in TEXTS else NEVER if name.startswith("std.") else CONVERTED
    return NEVER if name in TEXTS and isinstance(cls, External) else CONVERTED
