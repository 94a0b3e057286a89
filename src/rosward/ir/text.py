# SPDX-License-Identifier: Apache-2.0
"""IR as text, to read and to compare in tests.

    function Talker.tick(self) registers 4
      %1 = self.pub
      if %1:
        assume %2 = %1 true

A local variable goes by its name, a temporary by its number (`%3`), a cell by `&` and its name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, final

from rosward.ir import cpp_text, ops
from rosward.ir.ops import NO_REGISTER, Argument, Block, Op
from rosward.ir.program import Code, Parameters


def code_text(code: Code, *, positions: bool = False) -> str:
    """A body and after it the bodies inside it; with `positions`, each line begins with its place in the source."""
    bodies: list[str] = []
    waiting = [code]
    while waiting:
        current = waiting.pop(0)
        printer = _Printer(current, positions)
        bodies.append(printer.text())
        waiting[:0] = printer.inner
    return "\n".join(bodies)


def _parameters(parameters: Parameters) -> str:
    names = list(parameters.positional)
    if parameters.posonly:
        names.insert(parameters.posonly, "/")
    if parameters.vararg is not None:
        names.append(f"*{parameters.vararg}")
    elif parameters.kwonly:
        names.append("*")
    names.extend(parameters.kwonly)
    if parameters.kwarg is not None:
        names.append(f"**{parameters.kwarg}")
    return ", ".join(names)


@final
class _Printer:
    __slots__ = ("code", "indent", "inner", "lines", "positions")

    def __init__(self, code: Code, positions: bool) -> None:
        self.code = code
        self.positions = positions
        self.indent = 1
        self.lines: list[str] = []
        self.inner: list[Code] = []

    def text(self) -> str:
        code = self.code
        head = f"{code.kind.value} {code.qualname}({_parameters(code.parameters)}) registers {code.registers}"
        if code.cells:
            head += f" cells {', '.join(code.cells)}"
        if code.free:
            head += f" free {', '.join(code.free)}"
        words = ("coroutine", code.is_coroutine), ("generator", code.is_generator), ("stub", code.is_stub)
        head += "".join(f" {word}" for word, holds in words if holds)
        self.block(code.ops)
        return "\n".join([head, *self.lines, ""])

    def line(self, op: Op | None, text: str) -> None:
        place = f"{op.line:4}:{op.column:<3}" if self.positions and op is not None else ""
        self.lines.append(f"{place}{'  ' * self.indent}{text}")

    def block(self, block: Block) -> None:
        for op in block:
            printed = _PRINT[type(op)](self, op)
            if printed is not None:
                self.line(op, printed)

    def nested(self, op: Op | None, head: str, block: Block) -> None:
        self.line(op, head)
        self.indent += 1
        self.block(block)
        self.indent -= 1

    def r(self, register: int) -> str:
        if register == NO_REGISTER:
            return "-"
        variables = self.code.variables
        return variables[register] if register < len(variables) else f"%{register}"

    def many(self, registers: Sequence[int]) -> str:
        return ", ".join(self.r(register) for register in registers)

    def cell(self, number: int) -> str:
        names = (*self.code.cells, *self.code.free)
        return f"&{names[number]}" if 0 <= number < len(names) else f"&{number}?"

    def captured(self, cells: Sequence[int]) -> str:
        return f" captures {', '.join(self.cell(number) for number in cells)}" if cells else ""

    def arguments(self, arguments: Sequence[Argument]) -> str:
        before = {"positional": "", "star": "*", "doublestar": "**"}
        return ", ".join(
            f"{argument.name}={self.r(argument.register)}"
            if argument.kind == "keyword"
            else before[argument.kind] + self.r(argument.register)
            for argument in arguments
        )


def _store(prefix: str, op: Any, p: _Printer) -> str:
    return f"{prefix} = {p.r(op.src)}{' (narrowing)' if op.narrowing else ''}"


def _delete(p: _Printer, op: ops.Delete) -> str:
    what = {
        "local": lambda: p.r(op.obj),
        "cell": lambda: p.cell(op.obj),
        "global": lambda: f"global {op.name}",
        "name": lambda: f"name {op.name}",
        "attr": lambda: f"{p.r(op.obj)}.{op.name}",
        "item": lambda: f"{p.r(op.obj)}[{p.r(op.index)}]",
    }
    return f"del {what[op.kind]()}"


def _load_name(p: _Printer, op: ops.LoadName) -> str:
    return f"{p.r(op.dst)} = name {op.name}" + (f" or {p.cell(op.cell)}" if op.cell != NO_REGISTER else "")


def _build(p: _Printer, op: ops.Build) -> str:
    star = "**" if op.kind == "dict" else "*"
    items = ", ".join((star if starred else "") + p.r(register) for starred, register in op.items)
    return f"{p.r(op.dst)} = {op.kind}({items})"


def _format(p: _Printer, op: ops.Format) -> str:
    parts: list[str] = []
    for part in op.parts:
        if isinstance(part, str):
            parts.append(repr(part))
            continue
        value, conversion, spec = part
        after = (f"!{conversion}" if conversion else "") + (f":{p.r(spec)}" if spec != NO_REGISTER else "")
        parts.append("{" + p.r(value) + after + "}")
    return " ".join([f"{p.r(op.dst)} = format", *parts])


def _make_function(p: _Printer, op: ops.MakeFunction) -> str:
    p.inner.append(op.code)
    defaults = [p.r(register) for register in op.defaults]
    defaults += [f"{name}={p.r(register)}" for name, register in op.kwdefaults]
    given = f"({', '.join(defaults)})" if defaults else ""
    return f"{p.r(op.dst)} = function {op.code.qualname}{given}{p.captured(op.captures)}"


def _make_class(p: _Printer, op: ops.MakeClass) -> str:
    p.inner.append(op.code)
    return f"{p.r(op.dst)} = class {op.code.qualname}({p.arguments(op.arguments)}){p.captured(op.captures)}"


def _assume(p: _Printer, op: ops.Assume) -> str:
    test = "true" if op.test == "true" else f"{op.test} {p.r(op.other)}"
    return f"assume {p.r(op.dst)} = {p.r(op.src)} {'' if op.sense else 'not '}{test}"


def _unpack(p: _Printer, op: ops.Unpack) -> str:
    names = [("*" if number == op.star else "") + p.r(register) for number, register in enumerate(op.dsts)]
    return f"unpack {', '.join(names)} = {p.r(op.src)}"


def _if(p: _Printer, op: ops.If) -> None:
    p.nested(op, f"if {p.r(op.test)}:", op.then)
    if op.orelse:
        p.nested(None, "else:", op.orelse)


def _while(p: _Printer, op: ops.While) -> None:
    p.nested(op, "loop:", op.condition)
    p.nested(None, f"while {p.r(op.test)}:", op.body)
    if op.orelse:
        p.nested(None, "else:", op.orelse)


def _for(p: _Printer, op: ops.ForEach) -> None:
    p.nested(op, f"{'async ' if op.is_async else ''}for {p.r(op.item)} in {p.r(op.iterable)}:", op.body)
    if op.orelse:
        p.nested(None, "else:", op.orelse)


def _with(p: _Printer, op: ops.With) -> None:
    bind = "" if op.bind == NO_REGISTER else f" as {p.r(op.bind)}"
    p.nested(op, f"{'async ' if op.is_async else ''}with {p.r(op.context)}{bind}:", op.body)


def _try(p: _Printer, op: ops.Try) -> None:
    p.nested(op, "try:", op.body)
    for handler in op.handlers:
        if handler.match:
            p.nested(None, "match:", handler.match)
        caught = "" if handler.type == NO_REGISTER else f" {p.r(handler.type)}"
        bind = "" if handler.bind == NO_REGISTER else f" as {p.r(handler.bind)}"
        p.nested(None, f"except{'*' if op.star else ''}{caught}{bind}:", handler.body)
    if op.orelse:
        p.nested(None, "else:", op.orelse)
    if op.final:
        p.nested(None, "finally:", op.final)


_PRINT: Final[Mapping[type, Callable[[_Printer, Any], str | None]]] = {
    **cpp_text.PRINT,
    ops.Const: lambda p, op: f"{p.r(op.dst)} = {op.value!r}",
    ops.Move: lambda p, op: f"{p.r(op.dst)} = {p.r(op.src)}",
    ops.LoadGlobal: lambda p, op: f"{p.r(op.dst)} = global {op.name}",
    ops.StoreGlobal: lambda p, op: _store(f"global {op.name}", op, p),
    ops.LoadName: _load_name,
    ops.StoreName: lambda p, op: f"name {op.name} = {p.r(op.src)}",
    ops.LoadCell: lambda p, op: f"{p.r(op.dst)} = {p.cell(op.cell)}",
    ops.StoreCell: lambda p, op: _store(p.cell(op.cell), op, p),
    ops.NewCell: lambda p, op: f"new cell {p.cell(op.cell)}",
    ops.LoadAttr: lambda p, op: f"{p.r(op.dst)} = {p.r(op.obj)}.{op.name}",
    ops.StoreAttr: lambda p, op: _store(f"{p.r(op.obj)}.{op.name}", op, p),
    ops.LoadItem: lambda p, op: f"{p.r(op.dst)} = {p.r(op.obj)}[{p.r(op.index)}]",
    ops.StoreItem: lambda p, op: (
        f"{p.r(op.obj)}[{p.r(op.index)}] = {p.r(op.src)}{' (narrowing)' if op.narrowing else ''}"
    ),
    ops.Delete: _delete,
    ops.Unary: lambda p, op: f"{p.r(op.dst)} = {op.operator} {p.r(op.src)}",
    ops.Binary: lambda p, op: (
        f"{p.r(op.dst)} = {p.r(op.left)} {op.operator}{'=' if op.inplace else ''} {p.r(op.right)}"
    ),
    ops.Compare: lambda p, op: f"{p.r(op.dst)} = {p.r(op.left)} {op.operator} {p.r(op.right)}",
    ops.Call: lambda p, op: f"{p.r(op.dst)} = call {p.r(op.func)}({p.arguments(op.arguments)})",
    ops.Build: _build,
    ops.Format: _format,
    ops.MakeFunction: _make_function,
    ops.MakeClass: _make_class,
    ops.Import: lambda p, op: f"{p.r(op.dst)} = import {op.module}{' leaf' if op.leaf else ''}",
    ops.ImportFrom: lambda p, op: f"{p.r(op.dst)} = from {'.' * op.level}{op.module} import {op.name}",
    ops.ImportStar: lambda _p, op: f"from {'.' * op.level}{op.module} import *",
    ops.Unpack: _unpack,
    ops.Intrinsic: lambda p, op: f"{p.r(op.dst)} = intrinsic {op.name}({p.many(op.arguments)})",
    ops.Assume: _assume,
    ops.Yield: lambda p, op: f"{p.r(op.dst)} = yield {'from ' if op.many else ''}{p.r(op.src)}",
    ops.Await: lambda p, op: f"{p.r(op.dst)} = await {p.r(op.src)}",
    ops.If: _if,
    ops.While: _while,
    ops.ForEach: _for,
    ops.Try: _try,
    ops.With: _with,
    ops.Return: lambda p, op: f"return {p.r(op.src)}",
    ops.Raise: lambda p, op: (
        "raise"
        + (f" {p.r(op.src)}" if op.src != NO_REGISTER else "")
        + (f" from {p.r(op.cause)}" if op.cause != NO_REGISTER else "")
    ),
    ops.Break: lambda _p, _op: "break",
    ops.Continue: lambda _p, _op: "continue",
}
