# SPDX-License-Identifier: Apache-2.0
"""What is in a parameter pack, and which body is made of a template for a call?

template<typename T, typename... Rest> void open(T first, Rest... rest)     one body for each T and for each number of `rest`
"""

from __future__ import annotations

from collections.abc import Sequence

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.values import Function, Value

__all__ = ["body_of", "items_of"]


def items_of(pack: Value) -> tuple[Value, ...] | None:
    """The items of a pack; None for what is none. Where a body is followed for several calls at once, each item is one of several."""
    if isinstance(pack, Tuple):
        return pack.items
    several = [o.items for o in options(pack) if isinstance(o, Tuple)]
    if len(several) < len(options(pack)) or len(set(map(len, several))) != 1:
        return None
    return tuple(map(join_all, zip(*several, strict=True)))


def body_of(function: Function, registers: Sequence[Value]) -> tuple[object, ...]:
    """What tells apart the bodies that are made of one code: the class around it, the template arguments, how many items packs have."""
    signature = function.code.signature
    if signature is None:
        return (function.module.address,)
    behind = registers[len(registers) - len(signature.parameters) :]
    packs = [value for parameter, value in zip(signature.parameters, behind, strict=False) if parameter.pack]
    sizes = [len(pack.items) for pack in packs if isinstance(pack, Tuple)]
    return (function.module.address, signature.types(registers), *sizes)
