# SPDX-License-Identifier: Apache-2.0
"""`check` finds IR that breaks the rules."""

from __future__ import annotations

import pytest

from rosward.ir import ops
from rosward.ir.check import check
from rosward.ir.ops import Block, Op
from rosward.ir.program import Code, CodeKind, Parameters


def code(block: Block, kind: CodeKind = CodeKind.FUNCTION) -> Code:
    return Code(kind, "f", "f", "a.py", 1, Parameters(("a",), 0, None, (), None), block, 3, ("a",), ("c",), ())


def made(captures: tuple[int, ...]) -> Op:
    empty = Parameters((), 0, None, (), None)
    inner = Code(CodeKind.FUNCTION, "g", "f.g", "a.py", 1, empty, [], 0, (), (), ("c",))
    return ops.MakeFunction(1, 1, 1, inner, (), (), captures)


@pytest.mark.parametrize(
    ("op", "fault"),
    [
        (ops.Move(1, 1, 0, 7), "register 7 out of range"),
        (ops.Move(1, 1, 9, 0), "register 9 out of range"),
        (ops.Move(1, 1, 0, 2), "read before it is written"),
        (ops.Move(0, 1, 1, 0), "no place in the source"),
        (ops.LoadCell(1, 1, 1, 4), "cell 4 out of range"),
        (ops.LoadName(1, 1, 1, "x"), "outside of a class body"),
        (ops.Unary(1, 1, 1, "!", 0), "unknown operator"),
        (ops.Assume(1, 1, 0, 0, "maybe", -1, True), "unknown test"),
        (ops.Break(1, 1), "outside of a loop"),
        (ops.If(1, 1, 0, [ops.Continue(1, 1)], []), "outside of a loop"),
        (ops.ForEach(1, 1, 1, 0, [], [ops.Break(1, 1)]), "outside of a loop"),
        (ops.Try(1, 1, [], (ops.Handler([], 2, -1, []),), [], []), "read before it is written"),
        (ops.With(1, 1, 0, 8, []), "register 8 out of range"),
        (ops.Delete(1, 1, "cell", 3), "cell 3 out of range"),
        (made(()), "0 captures for 1 free cells"),
        (made((5,)), "cell 5 out of range"),
    ],
)
def test_fault(op: Op, fault: str) -> None:
    assert any(fault in found for found in check(code([op])))


def test_return_outside_of_a_function() -> None:
    assert len(check(code([ops.Return(1, 1, 0)], CodeKind.CLASS))) == 1


def test_nothing_wrong() -> None:
    loop = ops.ForEach(1, 1, 1, 0, [ops.If(1, 1, 1, [ops.Break(1, 1)], []), ops.Move(1, 1, 2, 1)], [])
    assert check(code([loop, made((0,)), ops.Return(1, 1, 2)])) == []
