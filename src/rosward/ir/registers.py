# SPDX-License-Identifier: Apache-2.0
"""Which registers does an operation read and write? Its own, before its blocks run; `walk` goes through the operations in blocks."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final

from rosward.ir import ops
from rosward.ir.ops import NO_REGISTER, Argument, Op

_CPP: Final = "rosward.ir.cpp"

Fields = Mapping[type, tuple[str, ...]]
Several = Mapping[type, Callable[[Any], Iterator[int]]]


def reads(op: Op) -> Iterator[int]:
    """The registers that an operation reads before its blocks run."""
    kind = type(op)
    fields, several = _tables(kind)
    for field in fields.get(kind, ()):
        register = getattr(op, field)
        if register != NO_REGISTER:
            yield register
    collect = several.get(kind)
    if collect is not None:
        yield from collect(op)


def writes(op: Op) -> tuple[int, ...]:
    """The registers that an operation itself writes."""
    if isinstance(op, ops.ForEach):
        return (op.item,)
    if isinstance(op, ops.With):
        return () if op.bind == NO_REGISTER else (op.bind,)
    several: tuple[int, ...] | None = getattr(op, "dsts", None)
    if several is not None:
        return several
    dst: int = getattr(op, "dst", NO_REGISTER)
    return () if dst == NO_REGISTER else (dst,)


def _tables(kind: type) -> tuple[Fields, Several]:
    """What is known of the operations of a language: those of C++ are loaded where there are any."""
    if not kind.__module__.startswith(_CPP):
        return _READS, _READS_MANY
    from rosward.ir.cpp_registers import READS, READS_MANY

    return READS, READS_MANY


_READS: Final[Mapping[type, tuple[str, ...]]] = {
    ops.Move: ("src",),
    ops.StoreGlobal: ("src",),
    ops.StoreName: ("src",),
    ops.StoreCell: ("src",),
    ops.LoadAttr: ("obj",),
    ops.StoreAttr: ("obj", "src"),
    ops.LoadItem: ("obj", "index"),
    ops.StoreItem: ("obj", "index", "src"),
    ops.Unary: ("src",),
    ops.Binary: ("left", "right"),
    ops.Compare: ("left", "right"),
    ops.Call: ("func",),
    ops.Unpack: ("src",),
    ops.Assume: ("src", "other"),
    ops.Yield: ("src",),
    ops.Await: ("src",),
    ops.If: ("test",),
    ops.ForEach: ("iterable",),
    ops.With: ("context",),
    ops.Return: ("src",),
    ops.Raise: ("src", "cause"),
}


def _arguments(arguments: tuple[Argument, ...]) -> Iterator[int]:
    return (argument.register for argument in arguments)


def _format_reads(op: ops.Format) -> Iterator[int]:
    for part in op.parts:
        if not isinstance(part, str):
            yield part[0]
            if part[2] != NO_REGISTER:
                yield part[2]


def _delete_reads(op: ops.Delete) -> Iterator[int]:
    if op.kind in ("local", "attr", "item"):
        yield op.obj
    if op.kind == "item":
        yield op.index


def _function_reads(op: ops.MakeFunction) -> Iterator[int]:
    yield from op.defaults
    for _, register in op.kwdefaults:
        yield register


_READS_MANY: Final[Mapping[type, Callable[[Any], Iterator[int]]]] = {
    ops.Call: lambda op: _arguments(op.arguments),
    ops.MakeClass: lambda op: _arguments(op.arguments),
    ops.MakeFunction: _function_reads,
    ops.Build: lambda op: (register for _, register in op.items),
    ops.Intrinsic: lambda op: iter(op.arguments),
    ops.Format: _format_reads,
    ops.Delete: _delete_reads,
}
