# SPDX-License-Identifier: Apache-2.0
"""What does a test tell about the variables in it?

    if self.pub is not None and ok:        %1 = self.pub; %2 = None; %3 = %1 is-not %2
        …                                  if %3: { assume %4 = %1, not is %2; self.pub = %4; … }

`condition` lowers a test and returns the facts that hold where it is true and where it is false; `assume` writes them
out at the start of a branch: what is narrowed there stands in memory, until something assigns to it. Only within the test itself, a fact
about memory doesn't outlive a call, which might have assigned already.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Final, Literal

from rosward.frontends.python.body import Body, Located
from rosward.frontends.python.scopes import PlaceKind
from rosward.ir.ops import (
    NO_REGISTER,
    Argument,
    Assume,
    Block,
    Call,
    Compare,
    If,
    LoadAttr,
    LoadItem,
    StoreAttr,
    StoreCell,
    StoreGlobal,
    StoreItem,
    Unary,
)
from rosward.records import NamedTuple

COMPARE: Final[Mapping[type, str]] = {
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Is: "is",
    ast.IsNot: "is-not",
    ast.In: "in",
    ast.NotIn: "not-in",
}

_TESTS: Final[Mapping[str, tuple[str, bool]]] = {
    "==": ("==", True),
    "!=": ("==", False),
    "is": ("is", True),
    "is-not": ("is", False),
    "in": ("in", True),
    "not-in": ("in", False),
}
_ORDER: Final[Mapping[str, tuple[str, bool]]] = {
    "<": ("<", True),
    ">=": ("<", False),
    ">": (">", True),
    "<=": (">", False),
}
_MIRRORED: Final[Mapping[str, str]] = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}

NESTED_AT_MOST: Final = 32
"""So many operands of `and` or `or` become nested branches; more of them stand one after the other, not too deep."""


_PLAIN: Final = (ast.Name, ast.Constant)
"""What is narrowed where it stands, if at all: no temporary holds it."""


class Subject(NamedTuple):
    """Something that can be narrowed: kind is 'register', 'attr', 'item', 'cell' or 'global'; `register` holds its value.

    Of an attribute or item, `obj` holds the object, whatever expression gave that; `key` its key.
    """

    kind: Literal["register", "attr", "item", "cell", "global"]
    register: int
    obj: int = NO_REGISTER
    name: str = ""
    key: int = NO_REGISTER


class Fact(NamedTuple):
    """`subject` passes `test` against register `other`, or doesn't."""

    subject: Subject
    test: str
    other: int
    sense: bool


Facts = list[Fact]
Outcome = tuple[int, Facts, Facts]
"""The register of a test, what holds where it is true, what holds where it is false."""


def condition(body: Body, node: ast.expr) -> Outcome:
    """Lower a test."""
    kind = type(node)
    if isinstance(node, ast.UnaryOp) and type(node.op) is ast.Not:
        src, true, false = condition(body, node.operand)
        dst = body.register()
        body.ops.append(Unary(node.lineno, node.col_offset + 1, dst, "not", src))
        return dst, false, true
    if isinstance(node, ast.BoolOp):
        return conjunction(body, node)
    if isinstance(node, ast.Compare):
        return compare(body, node)
    if kind is ast.Call and isinstance(node, ast.Call) and _is_isinstance(body, node):
        return _isinstance(body, node)
    register, subject = _subject(body, node)
    return register, *_both(subject, "true", NO_REGISTER, True)


def assume(body: Body, node: Located, facts: Facts) -> None:
    """Write facts into the current block."""
    line, column = node.lineno, node.col_offset + 1
    ops = body.ops
    for (kind, register, obj, name, key), test, other, sense in facts:
        if kind == "register":
            ops.append(Assume(line, column, register, register, test, other, sense))
            continue
        narrowed = body.register()
        ops.append(Assume(line, column, narrowed, register, test, other, sense))
        if kind == "attr":
            ops.append(StoreAttr(line, column, obj, name, narrowed, True))
        elif kind == "item":
            ops.append(StoreItem(line, column, obj, key, narrowed, True))
        elif kind == "cell":
            ops.append(StoreCell(line, column, obj, narrowed, True))
        else:
            ops.append(StoreGlobal(line, column, name, narrowed, True))


def branch(
    body: Body, node: Located, test: ast.expr, then: Callable[[], None], orelse: Callable[[], None] | None
) -> None:
    """`if test: then else: orelse`."""
    outer = body.ops
    parts: Sequence[ast.expr] = (test,)
    if orelse is None and isinstance(test, ast.BoolOp) and _nests(test):
        parts = test.values  # nested: what the first part tells holds while the others are evaluated
    for part in parts:
        register, true, false = condition(body, part)
        inner: Block = []
        other: Block = []
        body.ops.append(If(node.lineno, node.col_offset + 1, register, inner, other))
        body.ops = other
        assume(body, part, false)
        if orelse is not None:
            orelse()
        body.ops = inner
        assume(body, part, true)
    then()
    body.ops = outer


def _nests(test: ast.BoolOp) -> bool:
    return type(test.op) is ast.And and len(test.values) <= NESTED_AT_MOST


def guards(body: Body, node: ast.If) -> bool:
    """`if a or b: return`, `if a and b: … else: return`: a branch that only leaves is repeated after each part."""
    test = node.test
    if not isinstance(test, ast.BoolOp):
        return False
    leaves_if_true = type(test.op) is ast.Or
    leaving, staying = (node.body, node.orelse) if leaves_if_true else (node.orelse, node.body)
    if not _only_leaves(leaving):
        return False
    for part in test.values:
        register, true, false = condition(body, part)
        leave: Block = []
        stay: Block = []
        blocks = (leave, stay) if leaves_if_true else (stay, leave)
        outer = body.ops
        outer.append(If(node.lineno, node.col_offset + 1, register, *blocks))
        for block, facts in ((leave, true if leaves_if_true else false), (stay, false if leaves_if_true else true)):
            body.ops = block
            assume(body, part, facts)
            if block is leave:
                body.statements(leaving)
        body.ops = outer
    body.statements(staying)
    return True


def _only_leaves(nodes: Sequence[ast.stmt]) -> bool:
    if len(nodes) != 1:
        return False
    node = nodes[0]
    if isinstance(node, ast.Return):
        return node.value is None or isinstance(node.value, (ast.Constant, ast.Name))
    return isinstance(node, (ast.Break, ast.Continue))


def conjunction(body: Body, node: ast.BoolOp) -> Outcome:
    """`and` and `or`."""
    is_and = type(node.op) is ast.And
    dst = body.register()
    facts: Facts = []
    outer = body.ops
    depth = 0
    last = len(node.values) - 1
    for number, value in enumerate(node.values):
        before = body.effects
        if number and not isinstance(value, _PLAIN):
            body.free_register = (
                body.registers
            )  # behind the test, what earlier statements left there would be among what it asks of
        register, true, false = condition(body, value)
        if body.effects != before:
            facts = [fact for fact in facts if fact.subject.kind == "register"]
        body.move(value, dst, register)
        known = true if is_and else false
        facts += known
        if number == last:
            break
        if depth == NESTED_AT_MOST:
            body.ops = outer
            depth = 0
        depth += 1
        decided: Block = [Assume(value.lineno, value.col_offset + 1, dst, dst, "true", NO_REGISTER, not is_and)]
        inner: Block = []
        blocks = (inner, decided) if is_and else (decided, inner)
        body.ops.append(If(value.lineno, value.col_offset + 1, dst, *blocks))
        body.ops = inner
        assume(body, value, known)
    body.ops = outer
    return (dst, facts, []) if is_and else (dst, [], facts)


def compare(body: Body, node: ast.Compare) -> Outcome:
    """A comparison, or a chain of them: `a < b < c` is `a < b and b < c` with b evaluated once."""
    line, column = node.lineno, node.col_offset + 1
    left, subject = _subject(body, node.left)
    outer = body.ops
    dst = body.register()
    for number, (operator, comparator) in enumerate(zip(node.ops, node.comparators, strict=True)):
        before = body.effects
        right, other = _subject(body, comparator)
        if subject is not None and subject.kind != "register" and body.effects != before:
            subject = None
        sign = COMPARE[type(operator)]
        body.ops.append(Compare(line, column, dst, sign, left, right))
        if len(node.ops) == 1:
            return dst, *_comparison_facts(node, sign, (left, subject), (right, other))
        if number + 1 < len(node.ops):
            inner: Block = []
            if number and number % NESTED_AT_MOST == 0:
                body.ops = outer
            body.ops.append(If(line, column, dst, inner, []))
            body.ops = inner
        left = right
    body.ops = outer
    return dst, [], []


def _comparison_facts(
    node: ast.Compare, sign: str, left: tuple[int, Subject | None], right: tuple[int, Subject | None]
) -> tuple[Facts, Facts]:
    if sign in _ORDER:
        return _order_facts(node, sign, left, right)
    test, sense = _TESTS[sign]
    if isinstance(node.left, ast.Constant) and test != "in":
        return _both(right[1], test, left[0], sense)
    return _both(left[1], test, right[0], sense)


def _order_facts(
    node: ast.Compare, sign: str, left: tuple[int, Subject | None], right: tuple[int, Subject | None]
) -> tuple[Facts, Facts]:
    """What `count > 3` tells of `count`. Of two variables it tells nothing: numeric code is full of such."""
    if isinstance(node.comparators[0], ast.Constant):
        test, sense = _ORDER[sign]
        return _both(left[1], test, right[0], sense)
    if isinstance(node.left, ast.Constant):
        test, sense = _ORDER[_MIRRORED[sign]]
        return _both(right[1], test, left[0], sense)
    return [], []


def _both(subject: Subject | None, test: str, other: int, sense: bool) -> tuple[Facts, Facts]:
    if subject is None:
        return [], []
    return [Fact(subject, test, other, sense)], [Fact(subject, test, other, not sense)]


def _is_isinstance(body: Body, node: ast.Call) -> bool:
    function = node.func
    return (
        isinstance(function, ast.Name)
        and function.id == "isinstance"
        and len(node.args) == 2
        and not node.keywords
        and not any(isinstance(argument, ast.Starred) for argument in node.args)
        and body.place("isinstance").kind in (PlaceKind.GLOBAL, PlaceKind.NAME)
    )


def _isinstance(body: Body, node: ast.Call) -> Outcome:
    function = body.expression(node.func)
    value, subject = _subject(body, node.args[0])
    before = body.effects
    classes = body.expression(node.args[1])
    if subject is not None and subject.kind != "register" and body.effects != before:
        subject = None
    dst = body.register()
    given = (Argument("positional", value), Argument("positional", classes))
    body.ops.append(Call(node.lineno, node.col_offset + 1, dst, function, given))
    return dst, *_both(subject, "isinstance", classes, True)


def _subject(body: Body, node: ast.expr) -> tuple[int, Subject | None]:
    """Lower an expression, and say how it can be narrowed, if it can."""
    if isinstance(node, ast.Name):
        register = body.expression(node)
        return register, _variable(body, node, register, 0)
    if isinstance(node, ast.NamedExpr):
        register = body.expression(node)
        return register, _variable(body, node.target, register, 1)
    if isinstance(node, ast.Attribute):
        obj = _held(body, node.value)
        dst = body.register()
        name = body.scope.mangle(node.attr)
        body.ops.append(LoadAttr(node.lineno, node.col_offset + 1, dst, obj, name))
        return dst, Subject("attr", dst, obj, name)
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
        obj = _held(body, node.value)
        index = body.expression(node.slice)
        dst = body.register()
        body.ops.append(LoadItem(node.lineno, node.col_offset + 1, dst, obj, index))
        return dst, Subject("item", dst, obj, key=index)
    register = body.expression(node)
    return register, Subject("register", register) if isinstance(node, ast.Call) else None


def _held(body: Body, node: ast.expr) -> int:
    """The value of an expression in a register that no `:=` of the same test gives another one."""
    register = body.expression(node)
    if not isinstance(node, ast.Name) or not _walrus_count(body, node):
        return register
    kept = body.register()
    body.move(node, kept, register)
    return kept


def _walrus_count(body: Body, node: ast.Name) -> int:
    return body.owner.walrus.get(body.scope.mangle(node.id), 0)


def _variable(body: Body, node: ast.Name, register: int, assigned: int) -> Subject | None:
    """A variable can be narrowed where no `:=` can have changed it since; `assigned` counts the one we stand on."""
    if _walrus_count(body, node) != assigned:
        return None
    kind, number = body.place(node.id)
    if kind is PlaceKind.REGISTER:
        return Subject("register", number)
    if kind is PlaceKind.CELL:
        return Subject("cell", register, number)
    if kind is PlaceKind.GLOBAL and not (node.id.startswith("__") and node.id.endswith("__")):
        return Subject("global", register, NO_REGISTER, body.scope.mangle(node.id))
    return None
