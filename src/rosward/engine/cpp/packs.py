# SPDX-License-Identifier: Apache-2.0
"""What is in a parameter pack, and which body is made of a template for a call?

template<typename T, typename... Rest> void open(T first, Rest... rest)     one body for each T and for each number of `rest`
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.slots import Pointer
from rosward.domain.values import Class, Function, Ref, Value
from rosward.engine.cpp.linked import linked

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["body_of", "items_of"]


def items_of(pack: Value) -> tuple[Value, ...] | None:
    """The items of a pack; None for what is none. Where a body is followed for several calls at once, each item is one of several."""
    if isinstance(pack, Tuple):
        return pack.items
    several = [o.items for o in options(pack) if isinstance(o, Tuple)]
    if len(several) < len(options(pack)) or len(set(map(len, several))) != 1:
        return None
    return tuple(map(join_all, zip(*several, strict=True)))


def body_of(machine: Engine, function: Function, registers: Sequence[Value]) -> tuple[object, ...]:
    """What tells apart the bodies that are made of one code: the class around it, the template arguments, how many items packs have.

    And what it is given that is being constructed: a virtual function of that is the one of the class that it is as yet.
    """
    signature = function.code.signature
    making = tuple(_constructed(machine, registers))
    if signature is None:
        return (function.module.address, making)
    behind = registers[len(registers) - len(signature.parameters) :]
    packs = [value for parameter, value in zip(signature.parameters, behind, strict=False) if parameter.pack]
    sizes = [len(pack.items) for pack in packs if isinstance(pack, Tuple)]
    return (function.module.address, making, signature.types(registers), *sizes)


def _constructed(machine: Engine, registers: Sequence[Value]) -> Iterator[tuple[int, Class]]:
    """The registers with an object whose constructor runs, and each class that it is as yet."""
    constructing = linked(machine).constructing
    for number, value in enumerate(registers if constructing else ()):
        target = value.target if isinstance(value, Pointer) else value
        if isinstance(target, Ref):
            yield from ((number, cls) for address, cls in constructing if address == target.address)
