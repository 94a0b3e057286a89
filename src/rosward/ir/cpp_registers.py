# SPDX-License-Identifier: Apache-2.0
"""Which registers do the operations of C++ read and write? Those of their own, before their blocks run; blocks are walked by `check`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final

from rosward.ir import cpp

READS: Final[Mapping[type, tuple[str, ...]]] = {
    cpp.Name: ("base",),
    cpp.Declared: ("obj",),
    cpp.Member: ("obj",),
    cpp.Item: ("obj", "index"),
    cpp.Deref: ("src",),
    cpp.AddressOf: ("src",),
    cpp.Read: ("src",),
    cpp.Assign: ("slot", "src"),
    cpp.Narrow: ("slot", "before", "src"),
    cpp.Step: ("slot",),
    cpp.Copy: ("src", "type"),
    cpp.Convert: ("src", "type"),
    cpp.Construct: ("type",),
    cpp.Elements: ("src",),
    cpp.Destructure: ("src",),
    cpp.Invoke: ("func",),
    cpp.InvokeMember: ("obj", "scope"),
    cpp.TypeOfValue: ("src",),
    cpp.Spread: ("init",),
    cpp.Placed: ("src",),
}
"""The fields with one register each."""


def _given(arguments: tuple[cpp.Argued, ...]) -> Iterator[int]:
    return (argument.register for argument in arguments)


def _name(op: cpp.Name) -> Iterator[int]:
    for part in op.parts:
        yield from part.arguments or ()


def _invoke_member(op: cpp.InvokeMember) -> Iterator[int]:
    yield from op.types or ()
    yield from _given(op.arguments)


READS_MANY: Final[Mapping[type, Callable[[Any], Iterator[int]]]] = {
    cpp.Name: _name,
    cpp.Member: lambda op: iter(op.arguments or ()),
    cpp.Construct: lambda op: _given(op.arguments),
    cpp.Invoke: lambda op: _given(op.arguments),
    cpp.InvokeMember: _invoke_member,
    cpp.MakeLambda: lambda op: iter(op.copies),
    cpp.LocalSymbol: lambda op: iter(op.registers),
    cpp.MakeType: lambda op: iter(op.inner),
    cpp.Braces: lambda op: _given(op.items),
    cpp.Spread: lambda op: iter(op.packs),
    cpp.EndScope: lambda op: iter(op.variables),
}
"""Those with several."""
