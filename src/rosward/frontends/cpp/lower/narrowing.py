# SPDX-License-Identifier: Apache-2.0
"""What does a test tell about the variables in it?

    if (name.empty()) { name = "x"; }      %1 = cell slot name; %2 = read %1; %3 = invoke %1.empty()
    …                                      if %3: { assume %4 = %2 empty; narrow %1 from %2 to %4; … }

`condition` lowers a test and returns the facts that hold where it is true and where it is false; `assume` writes them out at the start of a
branch: what is narrowed there stands in memory, until something assigns to it. Only within the test itself, a fact about memory does not
outlive a call, which might have assigned already.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.survey import operator_of, word
from rosward.frontends.cpp.lower.variables import Variable
from rosward.ir.control import If
from rosward.ir.core import NO_REGISTER, Assume, Compare, Move, Unary
from rosward.ir.cpp import Narrow, Read
from rosward.ir.op import Block
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

COMPARE: Final = frozenset({"==", "!=", "<", "<=", ">", ">="})
_LITERALS: Final = frozenset(
    {
        "string_literal", "raw_string_literal", "concatenated_string", "char_literal", "number_literal", "null", "true", "false",
    }
)  # fmt: skip
_PLACES: Final = frozenset({"identifier", "qualified_identifier", "field_expression"})
_CHANGING: Final = frozenset({"update_expression", "assignment_expression"})
_MIRRORED: Final[Mapping[str, str]] = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "==": "==", "!=": "!="}
_TESTS: Final[Mapping[str, tuple[str, bool]]] = {
    "==": ("==", True), "!=": ("==", False), "<": ("<", True), ">=": ("<", False), ">": (">", True), "<=": (">", False),
}  # fmt: skip
"""The test that an operator is, and whether it is meant as it is or turned round."""
_QUERIES: Final[Mapping[str, tuple[str, bool]]] = {"empty": ("empty", True), "has_value": ("true", True)}
"""Methods that ask for what a test is."""
_SIZES: Final = frozenset({"size", "length"})
_OF_SIZE: Final[Mapping[tuple[str, str], bool]] = {
    ("==", "0"): True, ("<=", "0"): True, ("<", "1"): True, ("!=", "0"): False, (">", "0"): False, (">=", "1"): False,
}  # fmt: skip
"""Which comparisons of a size say that there is nothing."""
NESTED_AT_MOST: Final = 32
"""So many operands of `&&` or `||` become nested branches; more of them stand one after the other, not too deep."""
_REPEATED: Final = 120
"""Nodes in a branch that only leaves, which is repeated for each operand of `||`."""
_DEPTH: Final = 60


class Subject(NamedTuple):
    """Something that can be narrowed: the register with its value, and the slot where that stands; none where the register is the variable."""

    register: int
    slot: int = NO_REGISTER


class Fact(NamedTuple):
    """`subject` passes `test` against register `other`, or does not."""

    subject: Subject
    test: str
    other: int
    sense: bool


Facts = list[Fact]


class Outcome(NamedTuple):
    """The register of a test, what holds where it is true, what holds where it is false."""

    register: int
    true: Facts
    false: Facts


def condition(body: Body, node: Node | None, depth: int = 0) -> Outcome:
    """Lower a test."""
    node = bare(node)
    if node is None or depth >= _DEPTH or node.has_error:
        return Outcome(body.value(node), [], [])
    operator = operator_of(node) if node.type in ("unary_expression", "binary_expression") else ""
    if node.type == "unary_expression" and operator == "!":
        found = condition(body, node.child_by_field_name("argument"), depth + 1)
        dst = body.register()
        body.emit(Unary(*body.place(node), dst, "not", found.register))
        return Outcome(dst, found.false, found.true)
    if operator in ("&&", "||"):
        return conjunction(body, node, operator, depth)
    if operator in COMPARE:
        return _comparison(body, node, operator)
    if node.type == "call_expression":
        return _query(body, node)
    register, subject = _subject(body, node)
    return Outcome(register, *_both(subject, "true", NO_REGISTER, True))


def tested(body: Body, node: Node, variable: Variable) -> Outcome:
    """The test of a variable that a condition declares."""
    if variable.register != NO_REGISTER and not variable.reference:
        subject = Subject(variable.register)
    else:
        slot, register = body.of_variable(node, variable, "slot"), body.register()
        body.emit(Read(*body.place(node), register, slot))
        subject = Subject(register, slot)
    return Outcome(subject.register, *_both(subject, "true", NO_REGISTER, True))


def bare(node: Node | None) -> Node | None:
    """An expression without the parentheses around it."""
    while node is not None and node.type == "parenthesized_expression":
        inner = [child for child in node.named_children if child.type != "comment"]
        if len(inner) != 1:
            return node
        node = inner[0]
    return node


def assume(body: Body, node: Node, facts: Facts) -> None:
    """Write facts into the current block."""
    place = body.place(node)
    for subject, test, other, sense in facts:
        if subject.slot == NO_REGISTER:
            body.emit(Assume(*place, subject.register, subject.register, test, other, sense))
            continue
        narrowed = body.register()
        body.emit(Assume(*place, narrowed, subject.register, test, other, sense))
        body.emit(Narrow(*place, subject.slot, subject.register, narrowed))


def assumed(body: Body, node: Node, facts: Facts, lower: Callable[[], object]) -> Block:
    """A block in which facts hold. What the test left in temporaries is not overwritten before they are read."""
    free, outer = body.free_register, body.ops
    block: Block = []
    body.ops = block
    assume(body, node, facts)
    lower()
    body.ops = outer
    body.free_register = max(free, body.floor)
    return block


def branch(
    body: Body, node: Node, test: Node | None, then: Callable[[], object], orelse: Callable[[], object] | None
) -> None:
    """`if (test) then else orelse`."""
    test = bare(test)
    parts = _operands(test, "&&") if test is not None and orelse is None else []
    if test is None or not 1 < len(parts) <= NESTED_AT_MOST:
        split(body, node, condition(body, test), then, orelse)
        return
    outer = body.ops
    for part in parts:  # nested: what the first part tells holds while the others are evaluated
        found = condition(body, part)
        free = body.free_register
        other = assumed(body, node, found.false, _nothing)
        inner: Block = []
        body.emit(If(*body.place(node), found.register, inner, other))
        body.ops = inner
        body.free_register = free
        assume(body, node, found.true)
    then()
    body.ops = outer


def split(
    body: Body, node: Node, found: Outcome, then: Callable[[], object], orelse: Callable[[], object] | None
) -> None:
    """The two ways behind a test."""
    first = assumed(body, node, found.true, then)
    second = assumed(body, node, found.false, orelse or _nothing)
    body.emit(If(*body.place(node), found.register, first, second))


def guards(body: Body, node: Node, test: Node | None, then: Callable[[], object], size: int) -> bool:
    """`if (a || b) { return; }`: a branch that only leaves, of so many nodes, is repeated behind each part."""
    parts = _operands(bare(test), "||")
    if len(parts) < 2 or size * len(parts) > _REPEATED:
        return False
    outer = body.ops
    for depth, part in enumerate(parts):
        found = condition(body, part)
        leave = assumed(body, node, found.true, then)
        free = body.free_register
        stay: Block = []
        body.emit(If(*body.place(node), found.register, leave, stay))
        if depth < NESTED_AT_MOST:
            body.ops = stay
        body.free_register = free
        assume(body, node, found.false)
    body.ops = outer
    return True


def _nothing() -> None:
    pass


def conjunction(body: Body, node: Node, operator: str, depth: int = 0) -> Outcome:
    """`a && b`, `a || b`."""
    is_and = operator == "&&"
    parts = _operands(node, operator)
    dst = body.register()
    facts: Facts = []
    outer = body.ops
    nested = 0
    for number, part in enumerate(parts):
        before, assigned = body.effects, body.assignments
        found = condition(body, part, depth + 1)
        if body.assignments != assigned:
            facts = []
        elif body.effects != before:
            facts = [fact for fact in facts if fact.subject.slot == NO_REGISTER]
        place = body.place(part)
        body.emit(Move(*place, dst, found.register))
        known = found.true if is_and else found.false
        facts += known
        if number + 1 == len(parts):
            break
        if nested == NESTED_AT_MOST:
            body.ops = outer
            nested = 0
        nested += 1
        decided: Block = [Assume(*place, dst, dst, "decided", NO_REGISTER, not is_and)]
        inner: Block = []
        body.emit(If(*place, dst, *((inner, decided) if is_and else (decided, inner))))
        body.ops = inner
        assume(body, part, known)
    body.ops = outer
    return Outcome(dst, facts, []) if is_and else Outcome(dst, [], facts)


def _operands(node: Node | None, operator: str) -> list[Node]:
    """`a && b && c`, which leans to the left: generated code has thousands of links."""
    found: list[Node] = []
    here = node
    while here is not None and here.type == "binary_expression" and operator_of(here) == operator:
        right = here.child_by_field_name("right")
        if right is None or here.has_error:
            return []
        found.append(right)
        here = here.child_by_field_name("left")
    return [here, *reversed(found)] if here is not None and found else []


def _comparison(body: Body, node: Node, operator: str) -> Outcome:
    """What is compared is read when the other side is known, as an operator of a class does that is given a reference."""
    left, right = bare(node.child_by_field_name("left")), bare(node.child_by_field_name("right"))
    if left is None or right is None or left.type == "binary_expression":
        return Outcome(body.value(node), [], [])
    turned = left.type in _LITERALS
    known, literal = (right, left) if turned else (left, right)
    mirrored = _MIRRORED[operator] if turned else operator
    of_size = _OF_SIZE.get((mirrored, word(literal))) if _method(known) in _SIZES else None
    if of_size is not None:
        register, subject = _asked(body, known)
        other = body.value(literal)
    else:
        held = _place(body, known)
        other = body.value(literal)
        register, subject = _read(body, known, held)
    dst = body.register()
    body.emit(Compare(*body.place(node), dst, operator, *((other, register) if turned else (register, other))))
    if of_size is not None:
        return Outcome(dst, *_both(subject, "empty", NO_REGISTER, of_size))
    test, sense = _TESTS[mirrored]
    return Outcome(dst, *_both(subject, test, other, sense))


def _method(node: Node) -> str:
    """The name of a method that is called without arguments; '' for anything else."""
    function, given = node.child_by_field_name("function"), node.child_by_field_name("arguments")
    if node.type != "call_expression" or function is None or function.type != "field_expression":
        return ""
    return "" if given is None or given.named_children else word(function.child_by_field_name("field"))


def _asked(body: Body, node: Node) -> tuple[int, Subject | None]:
    """A call of a method, and what it is asked of."""
    function = node.child_by_field_name("function")
    asked = None if function is None else bare(function.child_by_field_name("argument"))
    if (
        function is None
        or asked is None
        or asked.type not in _PLACES
        or word(function.child_by_field_name("operator")) != "."
    ):
        return body.value(node), None
    _, subject = _subject(body, asked)
    return body.value(node), subject


def _query(body: Body, node: Node) -> Outcome:
    test = _QUERIES.get(_method(node)) or (("empty", False) if _method(node) in _SIZES else None)
    if test is None:
        return Outcome(body.value(node), [], [])
    register, subject = _asked(body, node)
    return Outcome(register, *_both(subject, test[0], NO_REGISTER, test[1]))


def _both(subject: Subject | None, test: str, other: int, sense: bool) -> tuple[Facts, Facts]:
    if subject is None:
        return [], []
    return [Fact(subject, test, other, sense)], [Fact(subject, test, other, not sense)]


def _subject(body: Body, node: Node) -> tuple[int, Subject | None]:
    """Lower an expression, and say how it can be narrowed, if it can."""
    return _read(body, node, _place(body, node))


def _place(body: Body, node: Node) -> tuple[int, bool]:
    """Where an expression stands, if anywhere; else its value. Whether that is a slot."""
    if (
        node.type not in _PLACES | _CHANGING
        or node.has_error
        or (node.type == "update_expression" and _is_postfix(node))
    ):
        return body.value(node), False
    if node.type in _CHANGING:
        held = body.slot(node)
        return held, _variable(body, _changed(node)) is None
    variable = body.variable(word(node)) if node.type == "identifier" else None
    if variable is not None and (variable.raw or (not variable.reference and variable.register != NO_REGISTER)):
        return body.value(node), False
    return body.slot(node), True


def _read(body: Body, node: Node, place: tuple[int, bool]) -> tuple[int, Subject | None]:
    held, is_slot = place
    if is_slot:
        register = body.register()
        body.emit(Read(*body.place(node), register, held))
        return register, Subject(register, held)
    variable = _variable(body, _changed(node))
    is_variable = variable is not None and not variable.raw and variable.register == held
    return held, Subject(held) if is_variable else None


def _variable(body: Body, node: Node | None) -> Variable | None:
    """The variable in a register that an expression names."""
    variable = body.variable(word(node)) if node is not None and node.type == "identifier" else None
    return None if variable is None or variable.reference or variable.register == NO_REGISTER else variable


def _changed(node: Node) -> Node | None:
    """`x` of `++x` and `x = a`."""
    if node.type not in _CHANGING:
        return node
    return bare(node.child_by_field_name("argument" if node.type == "update_expression" else "left"))


def _is_postfix(node: Node) -> bool:
    return node.children[0].type not in ("++", "--")
