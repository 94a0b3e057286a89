# SPDX-License-Identifier: Apache-2.0
"""`match`: each case becomes a test, computed into one register, and an `If` whose else branch holds the other cases.

    match message:               %3 = isinstance(%1, %2)
        case Point(x=0, y=y):    if %3: { %4 = %1.x, if it is there; %3 = it is; if %3: { %3 = %4 == 0; … } }
            use(y)               if %3: { y = %7; … } else: { … the next case … }

What a pattern captures goes to temporaries first, and to the variables when the whole pattern has matched.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final, final

from rosward.frontends.python.body import Body, Located
from rosward.frontends.python.narrowing import condition
from rosward.frontends.python.scopes import PlaceKind
from rosward.ir.ops import NO_REGISTER, Assume, Block, Compare, If, LoadItem, Unpack

_SELF_MATCHING: Final = frozenset(
    {"bool", "bytearray", "bytes", "dict", "float", "frozenset", "int", "list", "set", "str", "tuple"}
)
"""Builtin classes whose one positional sub-pattern matches the object itself."""


@final
class Case:
    """One case being lowered: register `matched` tells the result, `captures` holds the temporaries by variable."""

    __slots__ = ("body", "captures", "matched")

    def __init__(self, body: Body, matched: int) -> None:
        self.body = body
        self.matched = matched
        self.captures: dict[str, tuple[Located, int]] = {}

    def test(self, node: ast.pattern, subject: int) -> None:
        """Write to `matched` whether the pattern matches."""
        handler = PATTERNS.get(type(node))
        if handler is None:
            self.body.move(node, self.matched, self.body.unsupported(node))
        else:
            handler(self, node, subject)

    def put(self, node: Located, src: int) -> None:
        """matched = src, a temporary that ends here."""
        self.body.settle(node, self.matched, src)

    def intrinsic(self, node: Located, name: str, *arguments: int) -> None:
        """matched = an intrinsic."""
        self.put(node, self.body.intrinsic(node, name, arguments))

    def then(self, node: Located, lower: Callable[[], None]) -> None:
        """Go on only where it matched so far."""
        block = self.body.block(lower)
        if block:
            self.body.ops.append(If(node.lineno, node.col_offset + 1, self.matched, block, []))

    def capture(self, node: Located, name: str | None, src: int) -> None:
        """Keep src for the variable `name`."""
        if name is None:
            return
        kept = self.captures.get(name)
        if kept is None:
            kept = self.captures[name] = (node, self.body.register())
        self.body.move(node, kept[1], src)

    def bind(self) -> None:
        """Assign the captures to their variables."""
        for name, (node, register) in self.captures.items():
            self.body.store(node, name, register)


def _match(body: Body, node: ast.Match) -> None:
    value = body.expression(node.subject)
    subject = body.register()
    body.move(node.subject, subject, value)
    variable = _narrowable(body, node)
    outer = body.ops
    for case in node.cases:
        pattern = case.pattern
        matched = body.register()
        state = Case(body, matched)
        state.test(pattern, subject)
        if case.guard is not None:
            _guard(state, case.guard)
        line, column = pattern.lineno, pattern.col_offset + 1
        then: Block = []
        orelse: Block = []
        always = case.guard is None and _is_irrefutable(pattern)
        if not always:
            body.ops.append(If(line, column, matched, then, orelse))
            body.ops = then
            _narrow(body, pattern, (subject, variable), True)
        state.bind()
        body.statements(case.body)
        if always:
            break
        body.ops = orelse
        if case.guard is None:
            _narrow(body, pattern, (subject, variable), False)
    body.ops = outer


def _guard(case: Case, guard: ast.expr) -> None:
    def ask() -> None:
        case.bind()
        register, _, _ = condition(case.body, guard)
        case.body.move(guard, case.matched, register)

    case.then(guard, ask)


def _is_irrefutable(node: ast.pattern) -> bool:
    if isinstance(node, ast.MatchOr):
        return any(_is_irrefutable(option) for option in node.patterns)
    return isinstance(node, ast.MatchAs) and (node.pattern is None or _is_irrefutable(node.pattern))


def _narrowable(body: Body, node: ast.Match) -> int:
    """The register of the variable that is matched, where no pattern assigns to it."""
    if not isinstance(node.subject, ast.Name):
        return NO_REGISTER
    name = node.subject.id
    kind, register = body.place(name)
    if kind is not PlaceKind.REGISTER:
        return NO_REGISTER
    for case in node.cases:
        for part in ast.walk(case.pattern):
            if isinstance(part, (ast.MatchAs, ast.MatchStar)) and part.name == name:
                return NO_REGISTER
            if isinstance(part, ast.MatchMapping) and part.rest == name:
                return NO_REGISTER
    return NO_REGISTER if name in body.owner.walrus else register


def _narrow(body: Body, pattern: ast.pattern, registers: Sequence[int], sense: bool) -> None:
    """What a matched or failed pattern tells about the subject, for patterns that tell it in one word."""
    while isinstance(pattern, ast.MatchAs) and pattern.pattern is not None:
        pattern = pattern.pattern
    if isinstance(pattern, ast.MatchSingleton):
        test, other = "is", body.constant(pattern, pattern.value)
    elif isinstance(pattern, ast.MatchValue) and isinstance(pattern.value, ast.Constant):
        test, other = "==", body.expression(pattern.value)
    elif (
        isinstance(pattern, ast.MatchClass)
        and isinstance(pattern.cls, ast.Name)
        and (sense or not (pattern.patterns or pattern.kwd_patterns))
    ):
        test, other = "isinstance", body.expression(pattern.cls)
    else:
        return
    line, column = pattern.lineno, pattern.col_offset + 1
    for register in registers:
        if register != NO_REGISTER:
            body.ops.append(Assume(line, column, register, register, test, other, sense))


def _value(case: Case, node: ast.MatchValue, subject: int) -> None:
    value = case.body.expression(node.value)
    case.body.ops.append(Compare(node.lineno, node.col_offset + 1, case.matched, "==", subject, value))


def _singleton(case: Case, node: ast.MatchSingleton, subject: int) -> None:
    value = case.body.constant(node, node.value)
    case.body.ops.append(Compare(node.lineno, node.col_offset + 1, case.matched, "is", subject, value))


def _as(case: Case, node: ast.MatchAs, subject: int) -> None:
    if node.pattern is None:
        case.put(node, case.body.constant(node, True))
        case.capture(node, node.name, subject)
    else:
        case.test(node.pattern, subject)
        case.then(node, lambda: case.capture(node, node.name, subject))


def _star(case: Case, node: ast.MatchStar, subject: int) -> None:
    case.put(node, case.body.constant(node, True))
    case.capture(node, node.name, subject)


def _or(case: Case, node: ast.MatchOr, subject: int) -> None:
    body = case.body
    outer = body.ops
    for number, option in enumerate(node.patterns):
        if number:
            inner: Block = []
            body.ops.append(If(option.lineno, option.col_offset + 1, case.matched, [], inner))
            body.ops = inner
        case.test(option, subject)
    body.ops = outer


def _sequence(case: Case, node: ast.MatchSequence, subject: int) -> None:
    body = case.body
    patterns = node.patterns
    star = next((number for number, part in enumerate(patterns) if isinstance(part, ast.MatchStar)), NO_REGISTER)

    def length() -> None:
        wanted = body.constant(node, len(patterns) if star == NO_REGISTER else len(patterns) - 1)
        case.intrinsic(node, "length_is" if star == NO_REGISTER else "length_at_least", subject, wanted)

    def items() -> None:
        registers = tuple(body.register() for _ in patterns)
        body.ops.append(Unpack(node.lineno, node.col_offset + 1, registers, star, subject))
        _all(case, list(zip(patterns, registers, strict=True)))

    case.intrinsic(node, "is_sequence", subject)
    case.then(node, length)
    if any(not _is_wildcard(part) for part in patterns):
        case.then(node, items)


def _is_wildcard(node: ast.pattern) -> bool:
    if isinstance(node, ast.MatchStar):
        return node.name is None
    return isinstance(node, ast.MatchAs) and node.name is None and node.pattern is None


def _all(case: Case, parts: Sequence[tuple[ast.pattern, int]]) -> None:
    """All of the sub-patterns match: each is tried where those before it matched."""
    outer = case.body.ops
    telling = [part for part in parts if not _is_wildcard(part[0])]
    for number, (node, register) in enumerate(telling):
        case.test(node, register)
        if number + 1 == len(telling):
            break
        inner: Block = []
        case.body.ops.append(If(node.lineno, node.col_offset + 1, case.matched, inner, []))
        case.body.ops = inner
    case.body.ops = outer


def _mapping(case: Case, node: ast.MatchMapping, subject: int) -> None:
    body = case.body
    line, column = node.lineno, node.col_offset + 1

    def rest(keys: list[int]) -> None:
        if node.rest is not None:
            case.capture(node, node.rest, body.intrinsic(node, "mapping_rest", (subject, *keys)))

    def entry(number: int, keys: list[int]) -> None:
        if number == len(node.keys):
            rest(keys)
            return
        key = body.expression(node.keys[number])
        body.ops.append(Compare(line, column, case.matched, "in", key, subject))

        def value() -> None:
            dst = body.register()
            body.ops.append(LoadItem(line, column, dst, subject, key))
            case.test(node.patterns[number], dst)
            case.then(node, lambda: entry(number + 1, [*keys, key]))

        case.then(node, value)

    case.intrinsic(node, "is_mapping", subject)
    case.then(node, lambda: entry(0, []))


def _class(case: Case, node: ast.MatchClass, subject: int) -> None:
    body = case.body
    line, column = node.lineno, node.col_offset + 1
    cls = body.expression(node.cls)

    def attributes() -> None:
        body.ops.append(Assume(line, column, subject, subject, "isinstance", cls, True))
        positional(0, NO_REGISTER)

    def positional(number: int, names: int) -> None:
        if number == len(node.patterns):
            keyword(0)
            return
        pattern = node.patterns[number]
        if number == 0 and _is_self_matching(body, node.cls):
            case.test(pattern, subject)
            case.then(pattern, lambda: keyword(0))
            return
        if names == NO_REGISTER:
            names = body.intrinsic(node, "match_args", (cls, body.constant(node, len(node.patterns))))
        name = body.register()
        body.ops.append(LoadItem(line, column, name, names, body.constant(node, number)))
        attribute(name, pattern, lambda: positional(number + 1, names))

    def keyword(number: int) -> None:
        if number == len(node.kwd_attrs):
            return
        name = body.constant(node, node.kwd_attrs[number])
        attribute(name, node.kwd_patterns[number], lambda: keyword(number + 1))

    def attribute(name: int, pattern: ast.pattern, rest: Callable[[], None]) -> None:
        value = body.intrinsic(node, "attribute", (subject, name))  # a property runs once
        case.intrinsic(node, "is_there", value)

        def lower() -> None:
            case.test(pattern, body.intrinsic(node, "there", (value,)))
            case.then(pattern, rest)

        case.then(pattern, lower)

    case.intrinsic(node, "isinstance", subject, cls)
    if node.patterns or node.kwd_attrs:
        case.then(node, attributes)


def _is_self_matching(body: Body, cls: ast.expr) -> bool:
    return isinstance(cls, ast.Name) and cls.id in _SELF_MATCHING and body.place(cls.id).kind is not PlaceKind.REGISTER


PATTERNS: Final[Mapping[type, Callable[[Case, Any, int], None]]] = {
    ast.MatchValue: _value,
    ast.MatchSingleton: _singleton,
    ast.MatchAs: _as,
    ast.MatchStar: _star,
    ast.MatchOr: _or,
    ast.MatchSequence: _sequence,
    ast.MatchMapping: _mapping,
    ast.MatchClass: _class,
}

STATEMENTS: Final[Mapping[type, Callable[[Body, Any], None]]] = {ast.Match: _match}
