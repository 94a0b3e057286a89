# SPDX-License-Identifier: Apache-2.0
"""How are the operations of C++ printed?

%2 = name create slot        %3 = construct %2("x", &%1) paren       %4 = invoke %2.f<%5>(%3)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, Protocol

from rosward.ir import cpp
from rosward.ir.core import NO_REGISTER
from rosward.ir.op import Block, Op
from rosward.ir.program import Code


class Printer(Protocol):
    """What prints a body."""

    @property
    def inner(self) -> list[Code]:
        """The bodies to be printed after this one."""

    def r(self, register: int) -> str:
        """A register."""

    def many(self, registers: Sequence[int]) -> str:
        """Several."""

    def cell(self, number: int) -> str:
        """A cell."""

    def captured(self, cells: Sequence[int]) -> str:
        """The cells that a function captures."""

    def nested(self, op: Op | None, head: str, block: Block) -> None:
        """A line, and a block below it."""


_KINDS: Final = {"value": "", "slot": "&", "result": "", "constant": "", "moved": "", "forwarded": "", "pack": "*"}


def _types(p: Printer, types: tuple[int, ...] | None) -> str:
    return "" if types is None else f"<{p.many(types)}>"


def _given(p: Printer, arguments: Sequence[cpp.Argued]) -> str:
    return ", ".join(_KINDS[argument.kind] + p.r(argument.register) for argument in arguments)


def _given_names(p: Printer, names: Sequence[str], registers: Sequence[int]) -> str:
    return " with " + ", ".join(f"{n} = {p.r(r)}" for n, r in zip(names, registers, strict=True)) if names else ""


def _slot(op: Any) -> str:
    return " slot" if op.slot else ""


def _copied(op: cpp.Invoke | cpp.InvokeMember) -> str:
    return " copied" if op.copied else ""


def _name(p: Printer, op: cpp.Name) -> str:
    parts = [part.name + _types(p, part.arguments) for part in op.parts]
    if op.base != NO_REGISTER:
        parts.insert(0, p.r(op.base))
    return f"{p.r(op.dst)} = name {'::' * op.absolute}{'::'.join(parts)}{_slot(op)}"


def _declared(p: Printer, op: cpp.Declared) -> str:
    return f"{p.r(op.dst)} = type of field {op.name}" + (f" of {p.r(op.obj)}" if op.obj != NO_REGISTER else "")


def _assign(p: Printer, op: cpp.Assign) -> str:
    head = "" if op.dst == NO_REGISTER else f"{p.r(op.dst)} = "
    return f"{head}assign {p.r(op.slot)} {op.operator} {p.r(op.src)}"


def _step(p: Printer, op: cpp.Step) -> str:
    head = "" if op.dst == NO_REGISTER else f"{p.r(op.dst)} = "
    return f"{head}{op.operator + p.r(op.slot) if op.prefix else p.r(op.slot) + op.operator}"


def _invoke_member(p: Printer, op: cpp.InvokeMember) -> str:
    scope = "" if op.scope == NO_REGISTER else f"{p.r(op.scope)}::"
    function = f"{'const ' * op.constant}{p.r(op.obj)}.{scope}{op.name}{_types(p, op.types)}"
    return f"{p.r(op.dst)} = invoke {function}({_given(p, op.arguments)}){_copied(op)}"


def _make_lambda(p: Printer, op: cpp.MakeLambda) -> str:
    p.inner.append(op.code)
    copies = f" copies {p.many(op.copies)}" if op.copies else ""
    return f"{p.r(op.dst)} = lambda {op.code.qualname}{copies}{p.captured(op.captures)}"


def _make_type(p: Printer, op: cpp.MakeType) -> str:
    return f"{p.r(op.dst)} = type {op.kind}" + (f" of {p.many(op.inner)}" if op.inner else "")


def _braces(p: Printer, op: cpp.Braces) -> str:
    names = op.names or ("",) * len(op.items)
    items = [(f".{name} = " if name else "") + _given(p, (item,)) for name, item in zip(names, op.items, strict=True)]
    return f"{p.r(op.dst)} = {{{', '.join(items)}}}"


def _initialise(p: Printer, op: cpp.Initialise) -> None:
    p.nested(op, "initialise:", [])
    for member in op.members:
        if member.type_body:
            p.nested(None, f"  type {member.name or p.r(member.type)}:", member.type_body)
        head = f"{member.name or p.r(member.type)}{'...' * member.pack}"
        p.nested(None, f"  {head}({_given(p, member.arguments)}) {member.form}:", member.body)


def _spread(p: Printer, op: cpp.Spread) -> None:
    init = "" if op.init == NO_REGISTER else f" {'before' if op.right else 'after'} {p.r(op.init)}"
    operator = f" fold {op.operator}{' from the right' * op.right}" if op.operator else ""
    head = f"{p.r(op.dst)} = spread {p.many(op.items)} of {p.many(op.packs)} gives {p.r(op.result)}"
    p.nested(op, f"{head}{operator}{init}:", op.body)


def _default(p: Printer, op: cpp.Default) -> None:
    p.nested(op, f"default {p.r(op.dst)}:", op.body)


def _static(p: Printer, op: cpp.StaticLocal) -> None:
    p.nested(op, f"{p.r(op.dst)} = static {p.r(op.result)}:", op.body)


PRINT: Final[Mapping[type, Callable[[Any, Any], str | None]]] = {
    cpp.Name: _name,
    cpp.CellSlot: lambda p, op: f"{p.r(op.dst)} = {p.cell(op.cell)} slot",
    cpp.Member: lambda p, op: f"{p.r(op.dst)} = {p.r(op.obj)}.{op.name}{_types(p, op.arguments)}{_slot(op)}",
    cpp.Item: lambda p, op: f"{p.r(op.dst)} = {p.r(op.obj)}[{p.r(op.index)}]{_slot(op)}",
    cpp.Deref: lambda p, op: f"{p.r(op.dst)} = *{p.r(op.src)}{_slot(op)}",
    cpp.AddressOf: lambda p, op: f"{p.r(op.dst)} = address {p.r(op.src)}",
    cpp.Read: lambda p, op: f"{p.r(op.dst)} = read {p.r(op.src)}",
    cpp.Assign: _assign,
    cpp.Step: _step,
    cpp.Copy: lambda p, op: (
        f"{p.r(op.dst)} = copy {p.r(op.src)}" + (f" as {p.r(op.type)}" if op.type != NO_REGISTER else "")
    ),
    cpp.Convert: lambda p, op: f"{p.r(op.dst)} = convert {p.r(op.src)} to {p.r(op.type)} {op.kind}",
    cpp.Construct: lambda p, op: f"{p.r(op.dst)} = construct {p.r(op.type)}({_given(p, op.arguments)}) {op.form}",
    cpp.Initialise: _initialise,
    cpp.Declared: _declared,
    cpp.Narrow: lambda p, op: f"narrow {p.r(op.slot)} from {p.r(op.before)} to {p.r(op.src)}",
    cpp.Elements: lambda p, op: f"{p.r(op.dst)} = elements {p.r(op.src)}{_slot(op)}",
    cpp.Destructure: lambda p, op: f"{p.many(op.dsts)} = parts {p.r(op.src)}{_slot(op)}",
    cpp.LocalSymbol: lambda p, op: (
        f"{p.r(op.dst)} = local {op.symbol.kind.value} {op.symbol.name}{_given_names(p, op.names, op.registers)}"
    ),
    cpp.Invoke: lambda p, op: f"{p.r(op.dst)} = invoke {p.r(op.func)}({_given(p, op.arguments)}){_copied(op)}",
    cpp.InvokeMember: _invoke_member,
    cpp.MakeLambda: _make_lambda,
    cpp.MakeType: _make_type,
    cpp.TypeOfValue: lambda p, op: f"{p.r(op.dst)} = type of {p.r(op.src)}" + (op.member and f".{op.member}"),
    cpp.Braces: _braces,
    cpp.Spread: _spread,
    cpp.Placed: lambda p, op: f"{p.r(op.dst)} = place {op.how} {'pack ' * op.pack}{p.r(op.src)}",
    cpp.Default: _default,
    cpp.StaticLocal: _static,
    cpp.EndScope: lambda p, op: f"end {p.many(op.variables)}",
    cpp.UnknownValue: lambda p, op: f"{p.r(op.dst)} = unknown {op.cause} {op.subject!r}",
}
