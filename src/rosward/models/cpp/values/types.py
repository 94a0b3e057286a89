# SPDX-License-Identifier: Apache-2.0
"""What is a type, as far as values of it are concerned?

    shape_of(TypeOf('unsigned long', ()))       Shape.INT
    shape_of(External('std.string'))            Shape.TEXT
    shape_of(TypeOf('std.deque', (T,)))         Shape.LIST

And what natives answer for a value: `method_types(machine, value)` are the types whose methods it has, the nearest first.
"""

from __future__ import annotations

import enum
from typing import Final, TypeGuard

from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.slots import Overloads, Pointer, TypeOf
from rosward.domain.values import NONE, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.models.native import Machine
from rosward.models.python.plain import EXCEPTION_HINT

__all__ = [
    "INT",
    "NOT_OF_ONE",
    "REFERENCE",
    "Shape",
    "argument",
    "hint_of",
    "is_reference",
    "is_type",
    "method_types",
    "name_of",
    "of_record",
    "shape_of",
]


class Shape(enum.Enum):
    """How a value of a type is kept."""

    BOOL = "bool"
    INT = "int"
    FLOAT = "float"
    CHAR = "char"
    TEXT = "str"
    POINTER = "pointer"
    CALLABLE = "function"
    ARRAY = "array"
    LIST = "list"
    SET = "set"
    MAP = "dict"
    MULTIMAP = "multimap"
    PAIR = "pair"
    TUPLE = "tuple"
    OPTIONAL = "optional"
    ANY = "any"
    REFERENCE = "reference"
    VOID = "void"
    STREAM = "stream"
    CLASS = "class"
    OTHER = ""


NOT_OF_ONE: Final = frozenset(
    f"std.{name}"
    for name in (
        *("array", "deque", "forward_list", "list", "map", "multimap", "multiset", "pair", "priority_queue", "queue"),
        *("set", "stack", "unordered_map", "unordered_multimap", "unordered_multiset", "unordered_set", "vector"),
        *("function", "future", "promise", "thread", "mutex"),
    )
)
"""Types of the library that are never made of a single number or text without saying so."""
INT: Final = TypeOf("int", ())
_STREAMS: Final = frozenset(
    f"std.{name}" for name in ["stringstream", "ostringstream", "istringstream", "ifstream", "ofstream", "fstream"]
)
_STD: Final[dict[str, Shape]] = {
    **dict.fromkeys(("string", "string_view", "basic_string", "wstring", "u16string", "filesystem.path"), Shape.TEXT),
    **dict.fromkeys(("basic_string_view", "experimental.filesystem.path"), Shape.TEXT),
    **dict.fromkeys(("shared_ptr", "unique_ptr", "weak_ptr", "auto_ptr", "nullptr_t"), Shape.POINTER),
    **dict.fromkeys(("function", "move_only_function", "function_ref"), Shape.CALLABLE),
    **dict.fromkeys(
        ("vector", "deque", "list", "forward_list", "initializer_list", "span", "queue", "stack", "priority_queue"),
        Shape.LIST,
    ),
    **dict.fromkeys(("set", "unordered_set", "multiset", "unordered_multiset"), Shape.SET),
    **dict.fromkeys(("map", "unordered_map"), Shape.MAP),
    **dict.fromkeys(("multimap", "unordered_multimap"), Shape.MULTIMAP),
    **dict.fromkeys(("variant", "any"), Shape.ANY),
    **dict.fromkeys(("size_t", "ssize_t", "ptrdiff_t", "byte", "streamsize", "time_t", "errc", "intmax_t"), Shape.INT),
    **dict.fromkeys(("strong_ordering", "weak_ordering", "partial_ordering"), Shape.INT),
    **dict.fromkeys(("uintptr_t", "intptr_t", "uintmax_t", "max_align_t", "clock_t"), Shape.INT),
    **{
        f"{sign}int{kind}{bits}_t": Shape.INT
        for sign in ("", "u")
        for kind in ("", "_fast", "_least")
        for bits in (8, 16, 32, 64)
    },
    "atomic_bool": Shape.BOOL,
    "atomic_int": Shape.INT,
    "true_type": Shape.BOOL,
    "false_type": Shape.BOOL,
    "array": Shape.ARRAY,
    "pair": Shape.PAIR,
    "tuple": Shape.TUPLE,
    "optional": Shape.OPTIONAL,
    "reference_wrapper": Shape.REFERENCE,
}
_OTHERS: Final[dict[str, Shape]] = {
    "auto": Shape.OTHER,
    "void": Shape.VOID,
    "pointer": Shape.POINTER,
    "reference": Shape.REFERENCE,
    "array": Shape.ARRAY,
    "function": Shape.CALLABLE,
    "boost.optional": Shape.OPTIONAL,
    "tl.optional": Shape.OPTIONAL,
    "boost.shared_ptr": Shape.POINTER,
    "boost.function": Shape.CALLABLE,
    "boost.filesystem.path": Shape.TEXT,
    "rcpputils.fs.path": Shape.TEXT,
    "absl.string_view": Shape.TEXT,
}
_INT_WORDS: Final = frozenset(
    ["int", "long", "short", "signed", "unsigned", "__int128", "char8_t", "char16_t", "char32_t", "wchar_t"]
)


def name_of(type_: Value) -> str:
    """The dotted name of a type, without its arguments."""
    if isinstance(type_, Class):
        return type_.dotted
    return type_.name if isinstance(type_, (TypeOf, External, Native)) else ""


def is_type(value: Value) -> bool:
    """Whether a value is a type."""
    return isinstance(value, (Class, External, TypeOf))


def argument(type_: Value, index: int) -> Value:
    """A template argument of a type of a library; `auto` where it is not given."""
    found = type_.arguments if isinstance(type_, TypeOf) else ()
    return found[index] if index < len(found) else TypeOf("auto", ())


def shape_of(type_: Value) -> Shape:
    """How values of a type are kept."""
    if isinstance(type_, Class):
        return Shape.CLASS
    name = name_of(type_)
    known = _OTHERS.get(name)
    if known is Shape.ARRAY and name_of(argument(type_, 0)) == "char":
        return Shape.TEXT  # characters are kept as the text that they make
    if known is not None:
        return known
    short = name.removeprefix("std.")
    if name in _STREAMS:
        return Shape.STREAM
    found = _STD.get(short)
    if found is not None and (short != name or found is Shape.INT):
        return found
    return _builtin(name.split())


def _builtin(words: list[str]) -> Shape:
    """What the words of a builtin type say."""
    if "bool" in words:
        return Shape.BOOL
    if "double" in words or "float" in words:
        return Shape.FLOAT
    if words == ["char"]:
        return Shape.CHAR
    if words and all(word in _INT_WORDS or word == "char" for word in words):
        return Shape.INT
    return Shape.OTHER


_HINTS: Final = {
    Shape.BOOL: "bool",
    Shape.INT: "int",
    Shape.FLOAT: "float",
    Shape.CHAR: "str",
    Shape.TEXT: "str",
    Shape.ARRAY: "list",
    Shape.LIST: "list",
    Shape.TUPLE: "list",
    Shape.OPTIONAL: "list",
    Shape.MULTIMAP: "list",
    Shape.SET: "list",
    Shape.MAP: "dict",
}


def hint_of(type_: Value) -> str:
    """The name of the Python type by which values of a type are kept, '' where that says nothing."""
    return _HINTS.get(shape_of(type_), "")


_AS: Final = {
    **dict.fromkeys(("std.unordered_set", "std.multiset", "std.unordered_multiset"), "std.set"),
    **dict.fromkeys(("std.unordered_map",), "std.map"),
    **dict.fromkeys(("std.unordered_multimap",), "std.multimap"),
    **dict.fromkeys(_STREAMS, "std.stringstream"),
    **dict.fromkeys(("boost.optional", "tl.optional"), "std.optional"),
}
"""The types whose methods those of another have the same of."""


def of_record(cls: Value, kind: str) -> tuple[str, ...]:
    """The types whose methods a record of a class has."""
    own = name_of(cls) if isinstance(cls, (TypeOf, External)) else ""
    general = {"list": "std.vector", "set": "std.set", "dict": "std.map"}.get(kind, "")
    return tuple(dict.fromkeys(name for name in (own, _AS.get(own, ""), general) if name))


_OF_HINT: Final = {
    "str": "std.string",
    "list": "std.vector",
    "dict": "std.map",
    **dict.fromkeys(("int", "bool", "float"), "std.atomic"),
    EXCEPTION_HINT: "std.exception",
}


REFERENCE: Final = External("std.reference_wrapper.made")
"""What a `std::ref` calls: a `Partial` of it and of the place that it refers to."""


def is_reference(value: Value) -> TypeGuard[Partial]:
    """Whether a value is a `std::reference_wrapper`."""
    return isinstance(value, Partial) and value.function == REFERENCE


def method_types(machine: Machine, value: Value) -> tuple[str, ...]:
    """The types whose methods a value has, the nearest first: `TYPE.method` is the name of the native. None for objects of classes."""
    if isinstance(value, Ref):
        obj = machine.obj(value)
        return of_record(obj.cls, obj.kind) if not isinstance(obj.cls, Class) else ()
    if isinstance(value, Text) or (isinstance(value, Const) and isinstance(value.value, str)):
        return ("std.string",)
    if isinstance(value, Pointer) or value == NONE:
        return ("std.shared_ptr", "std.function")
    if isinstance(value, Tuple):
        return ("std.vector",)
    if is_reference(value):
        return ("std.reference_wrapper",)
    if isinstance(value, (Function, BoundMethod, Partial, Overloads, Native)):
        return ("std.function",)
    if isinstance(value, External):
        return (value.name,)
    if isinstance(value, Unknown):
        known = _OF_HINT.get(value.hint)
        return (known,) if known else ()
    return ("std.atomic",) if isinstance(value, Const) else ()
