# SPDX-License-Identifier: Apache-2.0
"""A model in code runs for an operation of C++; who watches is told of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.values import Value
from rosward.models.cpp.values.contents import within
from rosward.models.native import NativeCall, NativeFunction, perform

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["run_native"]

_PLACES: Final = frozenset(f"{c}{r}{place}" for c in ("", "c") for r in ("", "r") for place in ("begin", "end"))
_OF_CONTENTS: Final = frozenset(
    f"std.{name}"
    for name in (*_PLACES, "apply", "data", "empty", "get", "get_if", "holds_alternative", "size", "ssize", "visit")
)
"""Functions that see of an object with a content nothing else: `std::get<0>(entry)`."""


def run_native(
    machine: Engine, native: NativeFunction, name: str, args: tuple[Value, ...], keywords: dict[str, Value]
) -> Value:
    """What a native of that name gives."""
    if machine.watch is not None:
        machine.watch.native(name)
    if name in _OF_CONTENTS:
        args = tuple(within(machine, arg) for arg in args)
    return perform(native, NativeCall(machine, name, args, keywords))
