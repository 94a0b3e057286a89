# SPDX-License-Identifier: Apache-2.0
"""A model in code runs for an operation of C++; who watches is told of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.values import Value
from rosward.models.native import NativeCall, NativeFunction, perform

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["run_native"]


def run_native(
    machine: Engine, native: NativeFunction, name: str, args: tuple[Value, ...], keywords: dict[str, Value]
) -> Value:
    """What a native of that name gives."""
    if machine.watch is not None:
        machine.watch.native(name)
    return perform(native, NativeCall(machine, name, args, keywords))
