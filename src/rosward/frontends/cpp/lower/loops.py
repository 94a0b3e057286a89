# SPDX-License-Identifier: Apache-2.0
"""Loops and `switch`, as the IR has them: one kind of endless loop, one kind of loop over elements.

for (i = 0; i < n; ++i) body          loop: i < n;  while: body, ++i (before each `continue` as well)
switch (x) { case 1: f(); break; }    loop: true;   while: if x == 1: f(), break;  break
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.frontends.cpp.lower.body import Body
from rosward.frontends.cpp.lower.choices import statements
from rosward.frontends.cpp.lower.declarations import bind
from rosward.frontends.cpp.lower.jumps import behind_loop
from rosward.frontends.cpp.lower.narrowing import Fact, Outcome, Subject, assumed, condition
from rosward.frontends.cpp.lower.operators import choose
from rosward.frontends.cpp.lower.seen import over
from rosward.frontends.cpp.lower.statements import branch, continue_, tested
from rosward.frontends.cpp.lower.survey import word
from rosward.frontends.cpp.lower.types import (
    ARRAYS,
    DECLARATORS,
    FUNCTIONS,
    POINTERS,
    REFERENCES,
    builtin,
    declared_type,
    has,
    is_as_written,
    within,
)
from rosward.frontends.cpp.lower.variables import Loop
from rosward.frontends.cpp.patterns import has_const
from rosward.ir.control import Break, ForEach, If, While
from rosward.ir.core import NO_REGISTER, Compare
from rosward.ir.cpp import Convert, Copy, Elements
from rosward.ir.cpp_names import ELEMENT, NUMBERED

if TYPE_CHECKING:
    from tree_sitter import Node

_STEP: Final = 200
"""Nodes in what is done before each turn, which is lowered once for each `continue`."""
_AUTO: Final = frozenset({"placeholder_type_specifier", "auto"})


def _looped(body: Body, node: Node | None, step: Callable[[], None] | None) -> None:
    body.loops.append(Loop(len(body.scopes), step))
    branch(body, node)
    body.loops.pop()


def _while(body: Body, node: Node) -> None:
    body.open()
    _loop(
        body,
        node,
        lambda: tested(body, node.child_by_field_name("condition")),
        lambda: _looped(body, node.child_by_field_name("body"), None),
    )
    body.close(node)
    behind_loop(body, node)


def _loop(
    body: Body, node: Node, test: Callable[[], Outcome], turn: Callable[[], None], *, counted: bool = False
) -> None:
    """What the condition tells holds in each turn, and its contrary behind the loop."""
    found = Outcome(NO_REGISTER, [], [])

    def before() -> None:
        nonlocal found
        found = test()

    condition = body.block(before)
    inner = assumed(body, node, found.true, turn)
    behind = assumed(body, node, found.false, lambda: None)
    body.emit(While(*body.place(node), condition, found.register, inner, behind, counted=counted))


def _endless(body: Body, node: Node, lower: Callable[[], None]) -> None:
    test = NO_REGISTER

    def before() -> None:
        nonlocal test
        test = body.constant(node, True)

    asked = body.block(before)
    body.emit(While(*body.place(node), asked, test, body.block(lower), []))


def _do(body: Body, node: Node) -> None:
    """A loop whose condition is asked from the second turn on, so that `continue` goes there by itself."""
    test = node.child_by_field_name("condition")
    body.open()
    begun = body.constant(node, False)
    body.floor = body.free_register
    asked = NO_REGISTER

    def first() -> int:
        body.move(node, begun, body.constant(node, True))
        return begun

    def before() -> None:
        nonlocal asked
        asked = choose(body, node, begun, lambda: body.value(test), first)

    test_block = body.block(before)
    turn = body.block(lambda: _looped(body, node.child_by_field_name("body"), None))
    body.emit(While(*body.place(node), test_block, asked, turn, []))
    body.close(node)
    behind_loop(body, node)


def _for(body: Body, node: Node) -> None:
    body.open()
    first = node.child_by_field_name("initializer")
    if first is not None:
        if first.type == "declaration":
            body.statement(first)
        else:
            body.expression(first, "effect")
            body.free_register = body.floor
    asked, update = node.child_by_field_name("condition"), node.child_by_field_name("update")

    def test() -> Outcome:
        return Outcome(body.constant(node, True), [], []) if asked is None else condition(body, asked)

    def step() -> None:
        if update is None:
            return
        if update.descendant_count > _STEP:
            body.unknown(update, "syntax")
        else:
            body.expression(update, "effect")

    def turn() -> None:
        _looped(body, node.child_by_field_name("body"), step)
        if not body.ends():
            step()

    _loop(body, node, test, turn, counted=asked is not None and update is not None)
    body.close(node)
    behind_loop(body, node)


def _range(body: Body, node: Node) -> None:
    """`for (init; auto & x : v)`."""
    body.open()
    before = node.child_by_field_name("initializer")
    for child in before.named_children if before is not None else ():
        body.statement(child)
    shape, right = node.child_by_field_name("declarator"), node.child_by_field_name("right")
    if shape is None or right is None:
        body.unknown(node, "syntax")
        body.close(node)
        return
    reference = has(shape, REFERENCES) or is_as_written(node.child_by_field_name("type"))
    source = body.slot(right)
    elements = body.register()
    body.floor = body.free_register
    body.emit(Elements(*body.place(node), elements, source, slot=reference))
    item = body.register()
    body.floor = body.free_register

    def turn() -> None:
        body.open()
        _element(body, node, shape, item, reference)
        _looped(body, node.child_by_field_name("body"), None)
        body.close(node)

    body.emit(ForEach(*body.place(node), item, elements, body.block(turn), []))
    body.close(node)
    behind_loop(body, node)


def _element(body: Body, node: Node, shape: Node, item: int, reference: bool) -> None:
    """The variable of the loop, from the element."""
    place = body.place(node)
    src = item
    type_node = node.child_by_field_name("type")
    kind = NO_REGISTER
    if not reference:
        src = body.register()
        if type_node is not None and type_node.type not in _AUTO:
            kind = declared_type(body, type_node, shape)
        body.emit(Copy(*place, src, item, kind))
    names, right = shape, node.child_by_field_name("right")
    for _ in range(DECLARATORS):
        inner = None if names.type == "structured_binding_declarator" else within(names)
        if inner is None:
            break
        names = inner
    if names.type == "structured_binding_declarator":
        listed = names.named_children if right is not None else []
        parts = [over(body, right, ELEMENT, f"{NUMBERED}{i}") for i in range(len(listed)) if right is not None]
        bind(body, node, shape, names, src)
        for child, part in zip(listed, parts, strict=True):
            bound = body.variable(word(child))
            if bound is not None:
                bound.over, bound.counts = part, True
        return
    points = has(shape, POINTERS | ARRAYS | FUNCTIONS)
    if kind != NO_REGISTER:
        body.emit(Convert(*place, src, src, kind, "init"))
    number = "" if points or reference else builtin(type_node)
    constant = has_const(node) and not points
    is_auto = type_node is None or type_node.type in _AUTO
    whole = over(body, right, ELEMENT) if is_auto and right is not None else None
    found = body.declare(
        word(names), reference=reference, builtin=number, pointer=has(shape, POINTERS), constant=constant
    )
    found.written = None if type_node is None or is_auto else (type_node, shape)
    found.over = whole
    found.counts = whole is not None and not points
    body.write(node, found, src)
    body.free_register = body.floor


_BEFORE_CASES: Final = frozenset(
    {"declaration", "expression_statement", "break_statement", "continue_statement", "return_statement"}
)
"""What may stand before the first case: nothing leads there."""


def _switch(body: Body, node: Node) -> None:
    """Cases are tests in their order; one that is not left by `break` sets a register that opens the next."""
    body.open()
    found = tested(body, node.child_by_field_name("condition"))
    value = body.register()  # a case may assign to what is asked
    body.move(node, value, found.register)
    subjects = [Subject(value), *(fact.subject for fact in found.true if fact.test == "true")]
    inner = node.child_by_field_name("body")
    groups = [child for child in (inner.named_children if inner is not None else ()) if child.type != "comment"]
    opened = body.constant(node, False)
    continues = bool(body.loops) and b"continue" in (node.text or b"")
    goes_on = body.constant(node, False) if continues else NO_REGISTER
    body.floor = body.free_register
    cases = [child for child in groups if child.type == "case_statement"]

    def run() -> None:
        body.loops.append(Loop(len(body.scopes), None, True, goes_on))
        body.open()
        open_before = False
        for child in groups:
            if child.type == "case_statement":
                open_before = _case(body, child, cases, subjects, opened, open_before)
                body.free_register = body.floor
            elif child.type not in _BEFORE_CASES:
                body.unknown(child, "syntax")
        body.close(node)
        body.loops.pop()
        if not body.ends():
            body.emit(Break(*body.place(node)))

    _endless(body, node, run)
    if goes_on != NO_REGISTER:
        body.emit(If(*body.place(node), goes_on, body.block(lambda: continue_(body, node)), []))
    body.close(node)
    behind_loop(body, node)


def _case(body: Body, node: Node, cases: list[Node], subjects: list[Subject], opened: int, open_before: bool) -> bool:
    """One case; whether it goes on with the next. What is asked is the value of the case, unless the one before goes on with this one."""
    wanted = node.child_by_field_name("value")
    content = [child for child in node.named_children if child.type != "comment" and child != wanted]
    value = subjects[0].register
    other = NO_REGISTER if wanted is None else body.value(wanted)
    is_one, is_none = ([Fact(s, "==", other, sense) for s in subjects if wanted is not None] for sense in (True, False))

    def matches() -> int:
        if wanted is None:
            return _none(body, node, [case for case in cases if case != node], value)
        return _equal(body, wanted, value, other)

    if wanted is None and node == cases[-1]:
        statements(body, content)
        return False
    test = choose(body, node, opened, lambda: opened, matches) if open_before else matches()
    falls = True

    def run() -> None:
        nonlocal falls
        statements(body, content)
        falls = not body.ends()
        if falls and node != cases[-1]:
            body.move(node, opened, body.constant(node, True))

    then = assumed(body, node, [] if open_before else is_one, run)
    orelse = assumed(body, node, is_none, lambda: None)
    body.emit(If(*body.place(node), test, then, orelse))
    return open_before or falls


def _equal(body: Body, wanted: Node, value: int, other: int) -> int:
    dst = body.register()
    body.emit(Compare(*body.place(wanted), dst, "==", value, other))
    return dst


def _none(body: Body, node: Node, cases: list[Node], value: int) -> int:
    """Whether no case matches: for a `default` that is not the last."""
    found = body.register()
    body.move(node, found, body.constant(node, True))
    for case in cases:
        wanted = case.child_by_field_name("value")
        if wanted is not None:
            test = _equal(body, wanted, value, body.value(wanted))
            no = body.block(lambda: body.move(node, found, body.constant(node, False)))
            body.emit(If(*body.place(node), test, no, []))
    return found


STATEMENTS: Final = {
    "while_statement": _while,
    "do_statement": _do,
    "for_statement": _for,
    "for_range_loop": _range,
    "switch_statement": _switch,
}
