# SPDX-License-Identifier: Apache-2.0
"""What is the value of an expression that consists of constants, without running it?

    name = "demo";  [f"{n} = {name}.{n}:main" for n in ("talker", "listener")]
    ->  ["talker = demo.talker:main", "listener = demo.listener:main"]

A small reader over `ast`, for the declarations in build scripts. What it cannot tell is `UNKNOWN`, never a guess. It
has no loops of its own but comprehensions over known lists, and every value is bounded, so it ends soon.
"""

from __future__ import annotations

import ast
import itertools
import os.path
import string
from collections.abc import Callable, Mapping
from typing import Any, Final, final

from rosward.source.surroundings import ROS_2

_SIZE_LIMIT: Final = 10_000
"""Longest list."""

_TEXT_LIMIT: Final = 100_000
"""Longest text."""

_TEXT_METHODS: Final = frozenset(
    {
        "format",
        "join",
        "lower",
        "lstrip",
        "removeprefix",
        "removesuffix",
        "replace",
        "rstrip",
        "split",
        "strip",
        "title",
        "upper",
    }
)


@final
class UnknownLiteral:
    """The value that cannot be told."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "UNKNOWN"


UNKNOWN: Final = UnknownLiteral()


@final
class LiteralScope:
    """The names that are known so far, and how many more steps may be taken; inner scopes share the steps."""

    __slots__ = ("_fuel", "_names", "_outer", "environment", "glob")

    def __init__(
        self,
        names: dict[str, Any],
        outer: LiteralScope | None = None,
        *,
        glob: Callable[[str, bool], Any] | None = None,
        environment: Mapping[str, str] = ROS_2,
    ) -> None:
        self._names = names
        self._outer = outer
        self.glob: Callable[[str, bool], Any] | None = outer.glob if outer is not None else glob
        """What `glob.glob(pattern, recursive=…)` gives, where that can be told."""
        self.environment: Mapping[str, str] = outer.environment if outer is not None else environment
        """The environment variables that are known."""
        self._fuel: list[int] = outer._fuel if outer is not None else [200_000]

    def inner(self) -> LiteralScope:
        """A scope that sees the same names and keeps its own to itself."""
        return LiteralScope({}, self)

    def bind(self, name: str, value: Any) -> None:
        """Let `name` stand for `value` from here on."""
        self._names[name] = value

    def value(self, name: str) -> Any:
        """What `name` stands for."""
        scope: LiteralScope | None = self
        while scope is not None:
            if name in scope._names:
                return scope._names[name]
            scope = scope._outer
        return UNKNOWN

    def step(self) -> bool:
        """Whether one more step may be taken."""
        self._fuel[0] -= 1
        return self._fuel[0] > 0


def evaluate(node: ast.expr | None, scope: LiteralScope) -> Any:
    """The value of `node` under the names of `scope`; `UNKNOWN` where it cannot be told."""
    if not scope.step():
        return UNKNOWN
    try:
        return _bounded(_evaluate(node, scope))
    except (RecursionError, TypeError, ValueError, LookupError, AttributeError, OverflowError, MemoryError):
        return UNKNOWN


def _bounded(value: Any) -> Any:
    if isinstance(value, str):
        return value if len(value) <= _TEXT_LIMIT else UNKNOWN
    if isinstance(value, list | tuple | dict):
        return value if len(value) <= _SIZE_LIMIT else UNKNOWN
    return value


def _evaluate(node: ast.expr | None, scope: LiteralScope) -> Any:
    match node:
        case ast.Constant(value=str() | int() | float() | None as value):
            return value
        case ast.Name(id=name):
            return scope.value(name)
        case ast.JoinedStr(values=parts):
            return _joined([_format_part(part, scope) for part in parts])
        case ast.List(elts=elements):
            return _elements(elements, scope)
        case ast.Tuple(elts=elements) | ast.Set(elts=elements):
            items = _elements(elements, scope)
            return UNKNOWN if items is UNKNOWN else tuple(items)
        case ast.Dict(keys=keys, values=values):
            return _dict(keys, values, scope)
        case ast.BinOp(left=left, op=ast.Add() | ast.Mod() | ast.Div() as op, right=right):
            return _binary(op, evaluate(left, scope), evaluate(right, scope))
        case ast.Subscript(value=value, slice=index):
            base, key = evaluate(value, scope), evaluate(index, scope)
            if _dotted(value) == "os.environ" and isinstance(key, str):
                return scope.environment.get(key, UNKNOWN)
            return UNKNOWN if UNKNOWN in (base, key) else base[key]
        case ast.ListComp() | ast.GeneratorExp() | ast.SetComp():
            found: list[Any] = []
            _comprehend(node.elt, node.generators, scope, found)
            return found
        case ast.NamedExpr(target=ast.Name(id=name), value=value):
            result = evaluate(value, scope)
            scope.bind(name, result)
            return result
        case ast.Call():
            return _call(node, scope)
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            return _compare(op, evaluate(left, scope), evaluate(right, scope))
        case _:
            return UNKNOWN


def _elements(elements: list[ast.expr], scope: LiteralScope) -> Any:
    """The items; one that cannot be told stays in its place as `UNKNOWN`."""
    items: list[Any] = []
    for element in elements:
        if isinstance(element, ast.Starred):
            inner = evaluate(element.value, scope)
            items.extend(inner if isinstance(inner, list | tuple) else [UNKNOWN])
        else:
            items.append(evaluate(element, scope))
    return items


def _dict(keys: list[ast.expr | None], values: list[ast.expr], scope: LiteralScope) -> Any:
    result: dict[Any, Any] = {}
    for key, value in zip(keys, values, strict=True):
        if key is None:  # {**other}
            inner = evaluate(value, scope)
            result.update(inner if isinstance(inner, dict) else {UNKNOWN: UNKNOWN})
        else:
            result[evaluate(key, scope)] = evaluate(value, scope)
    return result


def _format_part(part: ast.expr, scope: LiteralScope) -> Any:
    if not isinstance(part, ast.FormattedValue):
        return evaluate(part, scope)
    value = evaluate(part.value, scope)
    if value is UNKNOWN or part.format_spec is not None or part.conversion not in {-1, ord("s")}:
        return UNKNOWN
    return str(value) if isinstance(value, str | int) else UNKNOWN


def _joined(parts: list[Any]) -> Any:
    known = all(isinstance(part, str) for part in parts) and sum(map(len, parts)) <= _TEXT_LIMIT
    return "".join(parts) if known else UNKNOWN


def _binary(op: ast.operator, left: Any, right: Any) -> Any:
    if left is UNKNOWN or right is UNKNOWN:
        if isinstance(op, ast.Add) and (isinstance(left, list) or isinstance(right, list)):
            return [*(left if isinstance(left, list) else [left]), *(right if isinstance(right, list) else [right])]
        return UNKNOWN
    if isinstance(op, ast.Add):
        return left + right
    if (
        isinstance(op, ast.Mod)
        and isinstance(left, str)
        and not _has_unknown(right)
        and "*" not in left
        and not _wide(left)
    ):
        return left % right if _small(left, right) else UNKNOWN
    return UNKNOWN


def _compare(op: ast.cmpop, left: Any, right: Any) -> Any:
    if _has_unknown(left) or _has_unknown(right):
        return UNKNOWN
    match op:
        case ast.Eq():
            return left == right
        case ast.NotEq():
            return left != right
        case ast.In():
            return left in right
        case ast.NotIn():
            return left not in right
        case _:
            return UNKNOWN


def _has_unknown(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return any(_has_unknown(item) for item in value)
    return value is UNKNOWN


def _plain_field(field: tuple[str, str | None, str | None, str | None]) -> bool:
    """Whether a replacement field puts in a value as it is: no attribute, no width, no conversion."""
    _, name, spec, conversion = field
    return not spec and not conversion and (name is None or not set(".[") & set(name))


def _small(base: str, value: Any) -> bool:
    """Whether any method of `base` with `value` has a result of bearable size."""
    return (len(base) + 1) * (_length(value) + 1) <= 100 * _TEXT_LIMIT


def _length(value: Any) -> int:
    return (
        1 + sum(map(_length, value))
        if isinstance(value, list | tuple)
        else len(value)
        if isinstance(value, str)
        else 30
    )


def _wide(text: str) -> bool:
    """Whether a format asks for a width, which could be any number."""
    return any(a in "%:0123456789" and b.isdigit() for a, b in itertools.pairwise(text))


def _comprehend(element: ast.expr, generators: list[ast.comprehension], scope: LiteralScope, found: list[Any]) -> None:
    if len(found) > _SIZE_LIMIT:
        return
    if not generators:
        found.append(evaluate(element, scope))
        return
    first, *rest = generators
    items = evaluate(first.iter, scope)
    if not isinstance(items, list | tuple) or first.is_async:
        found.append(UNKNOWN)
        return
    for item in items:
        if not scope.step():
            found.append(UNKNOWN)
            return
        inner = scope.inner()
        bind(first.target, item, inner)
        conditions = [evaluate(condition, inner) for condition in first.ifs]
        if UNKNOWN in conditions:
            found.append(UNKNOWN)
        elif all(conditions):
            _comprehend(element, rest, inner, found)


def bind(target: ast.expr, value: Any, scope: LiteralScope) -> None:
    """Bind the names in `target` to `value`."""
    if isinstance(target, ast.Name):
        scope.bind(target.id, value)
    elif isinstance(target, ast.Tuple | ast.List):
        exact = isinstance(value, list | tuple) and len(value) == len(target.elts)
        for index, element in enumerate(target.elts):
            bind(element, value[index] if exact else UNKNOWN, scope)


def _call(node: ast.Call, scope: LiteralScope) -> Any:
    arguments = _elements(node.args, scope)
    keywords = {keyword.arg: evaluate(keyword.value, scope) for keyword in node.keywords}
    if None in keywords:
        return UNKNOWN
    dotted = _dotted(node.func)
    if dotted == "dict" and not arguments:
        return keywords
    if dotted.rpartition(".")[2] == "generate_distutils_setup":
        return keywords  # of catkin_pkg: beside these, what package.xml says, which names no executable
    if dotted in {"os.getenv", "os.environ.get"} and arguments and isinstance(arguments[0], str):
        return scope.environment.get(arguments[0], UNKNOWN)
    if dotted == "int" and len(arguments) == 1 and isinstance(arguments[0], str | int):
        return int(arguments[0])
    if dotted == "str" and len(arguments) == 1 and isinstance(arguments[0], str | int):
        return str(arguments[0])
    if dotted in {"list", "tuple", "sorted"} and len(arguments) == 1 and isinstance(arguments[0], list | tuple):
        return arguments[0] if dotted != "sorted" or _has_unknown(arguments[0]) else sorted(arguments[0])
    if (
        dotted in {"os.path.join", "path.join", "join"}
        and arguments
        and all(isinstance(part, str) for part in arguments)
    ):
        return os.path.join(*arguments).replace(os.sep, "/")  # noqa: PTH118
    if dotted in {"glob", "iglob", "glob.glob", "glob.iglob"} and scope.glob is not None and len(arguments) == 1:
        known = isinstance(arguments[0], str) and keywords.keys() <= {"recursive"} and UNKNOWN not in keywords.values()
        return scope.glob(arguments[0], bool(keywords.get("recursive", False))) if known else UNKNOWN
    if isinstance(node.func, ast.Attribute):
        return _method(evaluate(node.func.value, scope), node.func.attr, arguments, keywords)
    return UNKNOWN


def _method(base: Any, name: str, arguments: list[Any], keywords: dict[Any, Any]) -> Any:
    if isinstance(base, dict) and name in {"keys", "values", "items"} and not arguments:
        return [tuple(i) if name == "items" else i for i in getattr(base, name)()]
    if isinstance(base, dict) and name == "get" and arguments:
        return base.get(*arguments) if UNKNOWN not in base else UNKNOWN
    if (
        not isinstance(base, str)
        or name not in _TEXT_METHODS
        or _has_unknown(arguments)
        or UNKNOWN in keywords.values()
    ):
        return UNKNOWN
    values = [*arguments, *keywords.values()]
    if not _small(base, values) or any(not isinstance(value, str | int | list | tuple) for value in values):
        return UNKNOWN
    if name == "format" and not all(map(_plain_field, string.Formatter().parse(base))):
        return UNKNOWN
    return getattr(base, name)(*arguments, **keywords)


def _dotted(node: ast.expr) -> str:
    parts: list[str] = []
    while isinstance(node, ast.Attribute):
        parts.append(node.attr)
        node = node.value
    return ".".join([node.id, *reversed(parts)]) if isinstance(node, ast.Name) else ""
