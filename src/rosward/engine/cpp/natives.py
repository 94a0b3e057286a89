# SPDX-License-Identifier: Apache-2.0
"""A model in code runs for an operation of C++; who watches is told of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.slots import Pointer
from rosward.domain.values import Value
from rosward.models.cpp.values.contents import within
from rosward.models.native import NativeCall, NativeFunction, perform

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["run_native"]

_PLACES: Final = frozenset(f"{c}{r}{place}" for c in ("", "c") for r in ("", "r") for place in ("begin", "end"))
_INSERTERS: Final = ("back_inserter", "front_inserter", "inserter")
_OF_TEXTS: Final = ("getline", "quoted", *(f"sto{kind}" for kind in ("d", "f", "i", "l", "ld", "ll", "ul", "ull")))
_WITH_ANOTHER: Final = tuple(
    f"{type_}.{name}"
    for type_ in (
        *("deque", "function", "list", "map", "multimap", "multiset", "optional", "set", "shared_ptr", "string"),
        *("unordered_map", "unordered_set", "vector"),
    )
    for name in ("merge", "splice", "swap")
)
_OF_VARIANTS: Final = ("apply", "get", "get_if", "holds_alternative", "visit")
_OF_SIZES: Final = ("data", "empty", "erase", "erase_if", "size", "ssize")
_OF_CONTENTS: Final = frozenset(
    f"std.{name}" for name in (*_PLACES, *_INSERTERS, *_OF_TEXTS, *_WITH_ANOTHER, *_OF_VARIANTS, *_OF_SIZES)
)
"""Functions that see of an object with a content nothing else: `std::get<0>(entry)`."""


def run_native(
    machine: Engine, native: NativeFunction, name: str, args: tuple[Value, ...], keywords: dict[str, Value]
) -> Value:
    """What a native of that name gives."""
    if machine.watch is not None:
        machine.watch.native(name)
    if name in _OF_CONTENTS:
        args = tuple(_seen(machine, arg) for arg in args)
    return perform(native, NativeCall(machine, name, args, keywords))


def _seen(machine: Engine, arg: Value) -> Value:
    """The content of an object, or a pointer to it: `std::get_if<int>(this)`."""
    if isinstance(arg, Pointer):
        return Pointer(within(machine, arg.target), arg.owner)
    return within(machine, arg)
