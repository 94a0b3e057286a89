# SPDX-License-Identifier: Apache-2.0
"""What has a copy of a lambda to itself?

auto next = [n = 0]() mutable { return n++; };  auto other = next;      both count from 0
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.heap import Obj
from rosward.domain.values import NONE, UNBOUND, Function, Ref, Value
from rosward.models.native import Machine

__all__ = ["with_own_cells"]

_VALUE: Final = "value"


def with_own_cells(machine: Machine, function: Function, copied: Callable[[Machine, Value], Value]) -> Function:
    """A copy of a `mutable` lambda, with copies of what it has captured by copy."""
    cells = list(function.cells)
    signature = function.code.signature
    for index in signature.owned if signature is not None else ():
        held = machine.obj(Ref(cells[index])).attrs.get(_VALUE, UNBOUND)
        copy = held if held is UNBOUND else copied(machine, held)
        cells[index] = machine.allocate(Obj("cell", NONE, {_VALUE: copy}), ("capture", cells[index])).address
    return Function(
        function.code, function.module, tuple(cells), function.defaults, function.kwdefaults, function.effects
    )
