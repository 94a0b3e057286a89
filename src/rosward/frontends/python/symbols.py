# SPDX-License-Identifier: Apache-2.0
"""Which names does each scope of a file bind and use?

One walk over the tree, without recursion (a tree can be deeper than the stack). Annotations are not walked: they are
kept as text.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from typing import Any, Final

from rosward.frontends.python.scopes import CLASS_CELL, Scope, ScopeKind, defines
from rosward.ir.ops import NO_REGISTER

_NOT_WALKED: Final = frozenset({"ctx", "op", "ops", "type_comment", "annotation", "returns", "type_params"})


def _walked_fields() -> dict[type, tuple[str, ...]]:
    table: dict[type, tuple[str, ...]] = {}
    for kind in vars(ast).values():
        if isinstance(kind, type) and issubclass(kind, ast.AST) and kind is not ast.Constant:
            fields = tuple(name for name in reversed(kind._fields) if name not in _NOT_WALKED)
            if fields:
                table[kind] = fields
    return table


_FIELDS: Final[Mapping[type, tuple[str, ...]]] = _walked_fields()


class Symbols:
    """The scopes of a file, by the node that opens them (type parameter scopes: by the tuple of node and 'type')."""

    __slots__ = ("at_once", "by_node", "drained", "scopes", "stack", "taken", "waiting")

    def __init__(self) -> None:
        self.drained: set[ast.AST] = set()  # generator expressions of which a call takes all
        self.at_once: set[ast.AST] = set()  # those of which a call takes some, and that nothing has afterwards
        self.taken: list[tuple[ast.GeneratorExp, Scope, str]] = []  # both, with the function that does, or '.method'
        self.scopes: list[Scope] = []
        self.by_node: dict[ast.AST, Scope] = {}
        self.stack: list[Any] = []
        self.waiting: list[tuple[Scope, list[Any]]] = []

    def open(self, node: ast.AST, scope: Scope, content: list[Any]) -> None:
        """`scope` belongs to `node`; walk `content` in it, later."""
        self.by_node[node] = scope
        self.scopes.append(scope)
        self.waiting.append((scope, content))


def collect(tree: ast.Module) -> Symbols:
    """Walk a module."""
    symbols = Symbols()
    symbols.open(tree, Scope(ScopeKind.MODULE, None, ""), list(tree.body))
    stack = symbols.stack
    name_kind = ast.Name
    while symbols.waiting:
        scope, content = symbols.waiting.pop()
        stack.extend(reversed(content))
        while stack:
            node = stack.pop()
            kind = type(node)
            if kind is name_kind:
                _name(scope, node)
                continue
            special = _SPECIAL.get(kind)
            if special is not None:
                special(symbols, scope, node)
                continue
            _children(stack, node)
    _untake(symbols)
    return symbols


def _children(stack: list[Any], node: ast.AST) -> None:
    for field in _FIELDS.get(type(node), ()):
        value = getattr(node, field)
        if type(value) is list:
            stack.extend(reversed(value))
        else:
            stack.append(value)


def _name(scope: Scope, node: ast.Name) -> None:
    name = node.id
    if name.startswith("__"):
        name = scope.mangle(name)
    if type(node.ctx) is ast.Load:
        scope.used[name] = None
        if name == "super" and scope.owner.kind is ScopeKind.FUNCTION:
            scope.used[CLASS_CELL] = None
    else:
        scope.bound[name] = None
        scope.used[name] = None


def _bind(scope: Scope, name: str | None) -> None:
    if name is not None:
        mangled = scope.mangle(name)
        scope.bound[mangled] = None
        scope.used[mangled] = None


def _type_scope(symbols: Symbols, scope: Scope, node: Any) -> Scope:
    parameters = getattr(node, "type_params", None)
    if not parameters:
        return scope
    inner = Scope(ScopeKind.INLINE, scope, scope.private, sees_class=scope.kind is ScopeKind.CLASS)
    symbols.open(parameters[0], inner, [])
    for parameter in parameters:
        _bind(inner, parameter.name)
    return inner


def _function(symbols: Symbols, scope: Scope, node: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
    _bind(scope, node.name)
    inner = Scope(ScopeKind.FUNCTION, _type_scope(symbols, scope, node), scope.private)
    _parameters(inner, node.args)
    symbols.open(node, inner, list(node.body))
    symbols.stack.extend(reversed([*node.decorator_list, *node.args.defaults, *node.args.kw_defaults]))


def _lambda(symbols: Symbols, scope: Scope, node: ast.Lambda) -> None:
    inner = Scope(ScopeKind.FUNCTION, scope, scope.private)
    _parameters(inner, node.args)
    symbols.open(node, inner, [node.body])
    symbols.stack.extend(reversed([*node.args.defaults, *node.args.kw_defaults]))


def _parameters(scope: Scope, arguments: ast.arguments) -> None:
    for argument in (*arguments.posonlyargs, *arguments.args, arguments.vararg, *arguments.kwonlyargs, arguments.kwarg):
        if argument is not None:
            _bind(scope, argument.arg)


def _class(symbols: Symbols, scope: Scope, node: ast.ClassDef) -> None:
    _bind(scope, node.name)
    outer = _type_scope(symbols, scope, node)
    content = [*node.bases, *node.keywords]
    if outer is scope:
        symbols.stack.extend(reversed([*node.decorator_list, *content]))
    else:
        symbols.waiting.append((outer, content))
        symbols.stack.extend(reversed(node.decorator_list))
    symbols.open(node, Scope(ScopeKind.CLASS, outer, node.name.lstrip("_")), list(node.body))


def _comprehension(
    symbols: Symbols, scope: Scope, node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp
) -> None:
    lazy = isinstance(node, ast.GeneratorExp) and node not in symbols.drained and not _runs_elsewhere(node)
    inner = Scope(ScopeKind.INLINE, scope, scope.private)
    content: list[Any] = []
    if lazy:
        inner.at_once = node in symbols.at_once
        _becomes_generator(inner)
    else:
        for name in _read_too_early(node.generators):
            inner.captured[scope.mangle(name)] = NO_REGISTER
    for number, generator in enumerate(node.generators):
        content.append(generator.target)
        if number:
            content.append(generator.iter)
        content.extend(generator.ifs)
    content.extend((node.key, node.value) if isinstance(node, ast.DictComp) else (node.elt,))
    symbols.open(node, inner, content)
    symbols.stack.append(node.generators[0].iter)


FIRST: Final = ".0"
"""The parameter of a generator expression: what its outermost loop runs over."""
_DRAINS: Final = frozenset({"list", "tuple", "set", "frozenset", "dict", "sorted", "sum", "min", "max"})
_DRAINING_METHODS: Final = frozenset({"join", "extend", "update", "union"})
_AT_ONCE: Final = frozenset({"any", "all", "next"})


def _call(symbols: Symbols, scope: Scope, node: ast.Call) -> None:
    """What a call does with a generator expression: take all of it, take of it and drop it, or (any other call) who knows."""
    first, function = node.args[0] if node.args else None, node.func
    if isinstance(first, ast.GeneratorExp):
        name = function.id if isinstance(function, ast.Name) else ""
        method = function.attr if isinstance(function, ast.Attribute) else ""
        if len(node.args) == 1 and (name in _DRAINS or method in _DRAINING_METHODS):
            symbols.drained.add(first)
            symbols.taken.append((first, scope, name or f".{method}"))
        elif name in _AT_ONCE:
            symbols.at_once.add(first)
            symbols.taken.append((first, scope, name))
    _children(symbols.stack, node)


def _untake(symbols: Symbols) -> None:
    """Where the file itself defines the function or method of that name, who knows what it does with a generator."""
    methods = (
        {name for s in symbols.scopes if s.kind is ScopeKind.CLASS for name in s.bound} if symbols.taken else set()
    )
    own = [
        symbols.by_node[node]
        for node, scope, name in symbols.taken
        if (name[1:] in methods if name.startswith(".") else defines(scope, name)) and not _runs_elsewhere(node)
    ]
    for scope in own:
        scope.at_once = False
        if scope.kind is ScopeKind.INLINE:
            scope.captured.clear()
            _becomes_generator(scope)
    if own:
        for scope in symbols.scopes:
            if scope.kind is ScopeKind.INLINE and scope.parent is not None:
                scope.owner = scope.parent.owner


def _becomes_generator(scope: Scope) -> None:
    scope.kind, scope.owner, scope.is_generator = ScopeKind.FUNCTION, scope, True
    _bind(scope, FIRST)


def _runs_elsewhere(node: ast.GeneratorExp) -> bool:
    """Whether a generator expression awaits: it is taken for a list."""
    return any(isinstance(n, ast.Await) or getattr(n, "is_async", 0) for n in ast.walk(node))


def _read_too_early(generators: list[ast.comprehension]) -> list[str]:
    """Variables of a comprehension that it reads before they have a value (`[y for x in xs for y in y]`).

    They become cells, which start empty; registers hold what was in them before.
    """
    simple = (ast.Name, ast.Tuple, ast.List, ast.Starred, ast.expr_context)
    found: list[str] = []
    unset: set[str] = set()
    for number in reversed(range(len(generators))):
        targets = list(ast.walk(generators[number].target))
        unset.update(part.id for part in targets if isinstance(part, ast.Name) and type(part.ctx) is ast.Store)
        early = [part for part in targets if not all(isinstance(other, simple) for other in targets)]
        if number:
            early.extend(ast.walk(generators[number].iter))
        found.extend(part.id for part in early if isinstance(part, ast.Name) and part.id in unset)
    return sorted(set(found))


def _global(_symbols: Symbols, scope: Scope, node: ast.Global) -> None:
    scope.global_names.update(scope.mangle(name) for name in node.names)


def _nonlocal(_symbols: Symbols, scope: Scope, node: ast.Nonlocal) -> None:
    for name in node.names:
        scope.nonlocal_names.setdefault(scope.mangle(name), node)
        scope.used[scope.mangle(name)] = None


def _import(_symbols: Symbols, scope: Scope, node: ast.Import) -> None:
    for alias in node.names:
        _bind(scope, alias.asname or alias.name.partition(".")[0])


def _import_from(_symbols: Symbols, scope: Scope, node: ast.ImportFrom) -> None:
    for alias in node.names:
        if alias.name != "*":
            _bind(scope, alias.asname or alias.name)


def _named(symbols: Symbols, scope: Scope, node: ast.ExceptHandler | ast.MatchAs | ast.MatchStar) -> None:
    _bind(scope, node.name)
    _children(symbols.stack, node)


def _match_mapping(symbols: Symbols, scope: Scope, node: ast.MatchMapping) -> None:
    _bind(scope, node.rest)
    _children(symbols.stack, node)


def _walrus(symbols: Symbols, scope: Scope, node: ast.NamedExpr) -> None:
    name = scope.mangle(node.target.id)
    owner = scope.owner
    while FIRST in owner.bound and owner.parent is not None:  # a generator expression assigns to a variable around it
        owner.at_once = False
        owner = owner.parent.owner
    owner.bound[name] = None
    owner.walrus[name] = owner.walrus.get(name, 0) + 1
    scope.used[name] = None
    symbols.stack.append(node.value)


def _yield(symbols: Symbols, scope: Scope, node: ast.Yield | ast.YieldFrom) -> None:
    scope.owner.is_generator = True
    symbols.stack.append(node.value)


def _type_alias(_symbols: Symbols, scope: Scope, node: Any) -> None:
    _name(scope, node.name)


def _special() -> dict[type, Callable[[Symbols, Scope, Any], None]]:
    table: dict[type, Callable[[Symbols, Scope, Any], None]] = {
        ast.FunctionDef: _function,
        ast.AsyncFunctionDef: _function,
        ast.Lambda: _lambda,
        ast.Call: _call,
        ast.ClassDef: _class,
        ast.ListComp: _comprehension,
        ast.SetComp: _comprehension,
        ast.DictComp: _comprehension,
        ast.GeneratorExp: _comprehension,
        ast.Global: _global,
        ast.Nonlocal: _nonlocal,
        ast.Import: _import,
        ast.ImportFrom: _import_from,
        ast.ExceptHandler: _named,
        ast.MatchAs: _named,
        ast.MatchStar: _named,
        ast.MatchMapping: _match_mapping,
        ast.NamedExpr: _walrus,
        ast.Yield: _yield,
        ast.YieldFrom: _yield,
    }
    alias = getattr(ast, "TypeAlias", None)
    if alias is not None:
        table[alias] = _type_alias
    return table


_SPECIAL: Final[Mapping[type, Callable[[Symbols, Scope, Any], None]]] = _special()
