# SPDX-License-Identifier: Apache-2.0
"""Which local variables of a function need a place of their own, and which names does each lambda use?

    const int k = 2;                               nobody can change k: a register
    int n = 0;  node->get_parameter("n", n);       n is handed over as a place: a cell
    for (int i = 0; i < n; ++i) {}                 i is only a number: a register

One walk over the body without recursion, by name alone: where two variables of a function share a name, both are cells, which is
right as well, only slower.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Final

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from tree_sitter import Node

_USED: Final = frozenset({"identifier", "type_identifier", "namespace_identifier"})
_LISTS: Final = frozenset({"argument_list", "initializer_list"})
_VALUES: Final = frozenset({"initializer_pair", "lambda_capture_initializer"})
_LOOKED_AT: Final = 1_000


class Survey(NamedTuple):
    """`placed`: variables that something refers to; `addressed`: those to which something points; `assigned`: variables that change; `used`:
    what each lambda names, by its node.
    """

    placed: frozenset[str]
    addressed: frozenset[str]
    assigned: frozenset[str]
    used: dict[int, dict[str, None]]

    def changes(self, name: str) -> bool:
        """Whether a variable may be written, here or by what refers to it."""
        return name in self.placed or name in self.assigned


def survey(root: Node) -> Survey:
    """Walk a function, or what else has code of its own."""
    placed: set[str] = set()
    addressed: set[str] = set()
    assigned: set[str] = set()
    used: dict[int, dict[str, None]] = {}
    lambdas: list[tuple[Node, dict[str, None]]] = []
    waiting: list[tuple[Node, bool]] = [(root, False)]
    while waiting:
        node, done = waiting.pop()
        if done:
            _leave(lambdas, placed)
            continue
        kind = node.type
        if kind in _USED:
            if lambdas:
                lambdas[-1][1][word(node)] = None
            continue
        if not node.child_count:
            continue
        if kind == "lambda_expression":
            names: dict[str, None] = {}
            used[node.id] = names
            lambdas.append((node, names))
            waiting.append((node, True))
        else:
            placed.update(_placed(node, kind))
            assigned.update(_assigned(node, kind))
            addressed.update(_addressed(node, kind))
        waiting += [(child, False) for child in reversed(node.children)]
    return Survey(frozenset(placed), frozenset(addressed), frozenset(assigned), used)


def word(node: Node | None) -> str:
    """The text of a leaf."""
    return "" if node is None else (node.text or b"").decode("utf-8", "replace")


_WORDS: Final[Mapping[str, str]] = {
    "and": "&&", "or": "||", "not": "!", "bitand": "&", "bitor": "|", "xor": "^", "compl": "~", "not_eq": "!=",
    "and_eq": "&=", "or_eq": "|=", "xor_eq": "^=",
}  # fmt: skip


def operator_of(node: Node) -> str:
    """The operator of an expression; of those that may be written as a word, the sign."""
    text = word(node.child_by_field_name("operator"))
    return _WORDS.get(text, text)


def through_member(node: Node) -> tuple[Node, Node] | None:
    """The object and the member of `o.*m` and `p->*m`, which the parser gets as `o%~m` and `p%~~m`; None for any other expression."""
    inner, left = member_behind(node), node.child_by_field_name("left")
    if inner is None or left is None or inner.type == "assignment_expression" or _is_product(left):
        return None
    return left, inner


def assigned_member(node: Node) -> tuple[Node, Node] | None:
    """The object of `o.*m = a` and the assignment, which the parser reads as `m = a`; None for any other expression."""
    inner, left = member_behind(node), node.child_by_field_name("left")
    return (left, inner) if inner is not None and left is not None and inner.type == "assignment_expression" else None


def is_through(node: Node) -> bool:
    """Whether an expression is a member behind a pointer to it, or assigns one."""
    return through_member(node) is not None or assigned_member(node) is not None


def member_behind(node: Node) -> Node | None:
    """What stands behind `.*` or `->*`; before it is a product, of which the last factor is meant: `2 * o.*m`."""
    operator, left, right = (node.child_by_field_name(name) for name in ("operator", "left", "right"))
    if node.type != "binary_expression" or operator is None or left is None or right is None or operator.type != "%":
        return None
    inner, end = right, operator.end_byte
    for _ in range(2):
        sign, argument = inner.child_by_field_name("operator"), inner.child_by_field_name("argument")
        if inner.type != "unary_expression" or sign is None or sign.type != "~" or inner.start_byte != end:
            break
        if argument is None:
            return None
        inner, end = argument, sign.end_byte
    return inner if inner is not right else None


def _is_product(node: Node) -> bool:
    return node.type == "binary_expression" and operator_of(node) in ("*", "/", "%") and through_member(node) is None


def is_apart(node: Node) -> bool:
    """Whether an expression with two sides is none of operators that are asked one after the other."""
    return is_through(node) or through_number(node) is not None


_CONSTANTS: Final = frozenset({"number_literal", "char_literal", "true", "false"})
_FUNCTIONS: Final = frozenset({"identifier", "qualified_identifier", "field_expression"})


def through_number(node: Node) -> tuple[Node, Node, Node] | None:
    """The function, the argument of its template and what is given, where the parser reads a comparison: of `o.f<1>(a)` it makes
    `(o.f < 1) > (a)`, of `make<Pair<A, a::B, A>>(a)` sometimes `(make < Pair<A, a::B, A>) > (a)`."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    if node.type != "binary_expression" or left is None or right is None or left.type != "binary_expression":
        return None
    function, argument = left.child_by_field_name("left"), left.child_by_field_name("right")
    if function is None or argument is None:
        return None
    fits = (function.type == "field_expression" and argument.type in _CONSTANTS) or (
        function.type in _FUNCTIONS and argument.type == "template_function"  # a function is not compared
    )
    is_call = right.type == "parenthesized_expression" and operator_of(node) == ">" and operator_of(left) == "<"
    return (function, argument, right) if fits and is_call else None


def _leave(lambdas: list[tuple[Node, dict[str, None]]], placed: set[str]) -> None:
    """What a lambda uses, the one around it uses as well; what it captures by reference has a place."""
    node, names = lambdas.pop()
    if lambdas:
        lambdas[-1][1].update(names)
    captures = node.child_by_field_name("captures")
    before = ""
    for child in captures.children if captures is not None else ():
        if child.type == "lambda_default_capture" and child.text == b"&":
            placed.update(names)
        elif child.type == "identifier" and before == "&":
            placed.add(word(child))
        before = child.type


def _behind_which(node: Node) -> Node | None:
    """The object of which `.*` takes a member."""
    left = node.child_by_field_name("left") if member_behind(node) is not None else None
    return left.child_by_field_name("right") if left is not None and _is_product(left) else left


def _placed(node: Node, kind: str) -> Iterator[str]:
    if kind in _LISTS:
        for child in node.named_children:
            yield from named(child)
    elif kind == "call_expression":
        yield from _receiver(node.child_by_field_name("function"))
    elif kind == "pointer_expression":
        if node.children[0].type == "&":
            yield from named(node.child_by_field_name("argument"))
    elif kind == "binary_expression":
        operator = node.child_by_field_name("operator")
        yield from named(_behind_which(node))
        numbered = through_number(node)
        if numbered is not None:
            yield from _receiver(numbered[0])
            yield from _given(numbered[2])
        if operator is not None and operator.type in {">>", "<<"}:
            yield from named(node.child_by_field_name("left"))
            if operator.type == ">>":
                yield from named(node.child_by_field_name("right"))
    elif kind == "init_declarator":
        declarator = node.child_by_field_name("declarator")
        if declarator is not None and declarator.type == "reference_declarator":
            yield from named(node.child_by_field_name("value"))
    elif kind == "for_range_loop":
        declarator = node.child_by_field_name("declarator")
        if declarator is not None and declarator.type == "reference_declarator":
            yield from named(node.child_by_field_name("right"))
    elif kind == "declaration":
        yield from _vexing(node)
    elif kind in _CHANGES:  # `(more ? a : b) = 1`, `(x += 1) *= 2`
        changed = node.child_by_field_name(_CHANGES[kind])
        yield from named(changed if changed is not None and changed.type in _AROUND else None)
    elif kind in _VALUES:
        yield from named(node.child_by_field_name("value") or node.child_by_field_name("right"))
    elif kind in _OF_PACKS:
        yield from named(node.child_by_field_name(_OF_PACKS[kind]))


_OF_PACKS: Final = {"parameter_pack_expansion": "pattern", "fold_expression": "left"}  # `(sum += … += pack)`
_CHANGES: Final = {"assignment_expression": "left", "update_expression": "argument"}
_AROUND: Final = frozenset(
    {"parenthesized_expression", "conditional_expression", "assignment_expression", "update_expression"}
)


def _assigned(node: Node, kind: str) -> Iterator[str]:
    if kind == "assignment_expression":
        yield from named(node.child_by_field_name("left"))
    elif kind == "update_expression":
        yield from named(node.child_by_field_name("argument"))


def _addressed(node: Node, kind: str) -> Iterator[str]:
    if kind == "pointer_expression" and node.children[0].type == "&":
        yield from named(node.child_by_field_name("argument"))


def _receiver(function: Node | None) -> Iterator[str]:
    """`text.append(…)`: what is called may change the variable."""
    if function is not None and function.type == "field_expression":
        operator = function.child_by_field_name("operator")
        if operator is not None and operator.type != "->":
            yield from named(function.child_by_field_name("argument"))


def _given(node: Node) -> Iterator[str]:
    """The variables that stand alone among arguments that read like brackets of an expression."""
    waiting = [*node.named_children]
    while waiting:
        here = waiting.pop()
        if here.type == "comma_expression":
            waiting += here.named_children
        else:
            yield from named(here)


def _vexing(node: Node) -> Iterator[str]:
    """`Guard guard(mutex);` reads like the declaration of a function, as does `Lamp & other(lamp);`."""
    shapes = [
        d.named_children[-1] if d.type == "reference_declarator" and d.named_children else d
        for d in node.children_by_field_name("declarator")
    ]
    waiting = [d for d in shapes if d.type == "function_declarator"]
    for _ in range(_LOOKED_AT):
        if not waiting:
            return
        listed = waiting.pop().child_by_field_name("parameters")
        for child in listed.named_children if listed is not None else ():
            type_node, inner = child.child_by_field_name("type"), child.child_by_field_name("declarator")
            if inner is not None and inner.type == "abstract_function_declarator":
                waiting.append(inner)
            elif type_node is not None and type_node.type == "type_identifier":
                yield word(type_node)


def named(node: Node | None) -> Iterator[str]:
    """The variables that an expression may stand for, where it stands for a place."""
    waiting = [node]
    for _ in range(_LOOKED_AT):
        if not waiting:
            return
        here = waiting.pop()
        if here is None:
            continue
        kind = here.type
        if kind == "identifier":
            yield word(here)
        elif kind == "parenthesized_expression":
            waiting += here.named_children
        elif kind == "conditional_expression":
            waiting += [here.child_by_field_name("consequence"), here.child_by_field_name("alternative")]
        elif kind in {"comma_expression"}:
            waiting.append(here.child_by_field_name("right"))
        elif kind == "assignment_expression":
            waiting.append(here.child_by_field_name("left"))
        elif kind in {"update_expression", "subscript_expression"}:
            waiting.append(here.child_by_field_name("argument"))
