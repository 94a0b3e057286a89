# SPDX-License-Identifier: Apache-2.0
"""Which marks of information flow has a stub, and where? Only its text is read.

sink("network", __name__)                  every function of the module that has no mark of its own
class Link:
    @sink("network")                       Link.send
    def send(self, data): ...
    def channel(self) -> Channel: ...      Link.channel.send is Channel.send
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping
from typing import Final, NamedTuple, final

from rosward.models.flow_marks import MARKS, FlowMark, mark_of, wrong

_NOTATION: Final = "_rosward"
_FUNCTIONS: Final = (ast.FunctionDef, ast.AsyncFunctionDef)
_NEEDING_WORDS: Final = frozenset({"sink", "source", "changes", "releases", "hands"})


class Wrong(NamedTuple):
    """A mark that says nothing, by its line."""

    line: int
    message: str


@final
class Scope:
    """A module, class, function or variable: its mark, what is in it, the class of what it gives, and what it stands for elsewhere.

    `writes`: the body of a method stores into its object.
    """

    __slots__ = ("alias", "bases", "gives", "inner", "is_class", "mark", "writes")

    def __init__(self, mark: FlowMark | None = None, *, is_class: bool = False) -> None:
        self.mark = mark
        self.is_class = is_class
        self.inner: dict[str, Scope] = {}
        self.bases: tuple[str, ...] = ()
        self.gives = ""
        self.alias = ""
        self.writes = False

    def member(self, name: str, module: Scope) -> Scope | None:
        """What a class has under a name, itself or by a base of the same module."""
        work, seen = [self], {self}
        for scope in work:
            found = scope.inner.get(name)
            if found is not None:
                return found
            for base in scope.bases:
                above = module.inner.get(base)
                if above is not None and above not in seen:
                    seen.add(above)
                    work.append(above)
        return None


def scope_of(tree: ast.Module, complaints: list[Wrong] | None = None) -> Scope:
    """What stands in a stub; what is wrong with its marks is added to `complaints`."""
    return _Reader(tree, [] if complaints is None else complaints).module


class _Reader:
    def __init__(self, tree: ast.Module, complaints: list[Wrong]) -> None:
        self._complaints = complaints
        self._names = dict(_imported(tree))
        self.module = Scope()
        for node in tree.body:
            self._statement(node, self.module)

    def _statement(self, node: ast.stmt, scope: Scope) -> None:
        if isinstance(node, ast.ClassDef):
            inner = scope.inner[node.name] = Scope(self._mark(node.decorator_list), is_class=True)
            inner.bases = tuple(b.id for b in node.bases if isinstance(b, ast.Name))
            for each in node.body:
                self._statement(each, inner)
        elif isinstance(node, _FUNCTIONS):
            scope.inner[node.name] = self._function(node)
        elif isinstance(node, (ast.If, ast.Try)):
            for each in (*node.body, *node.orelse):
                self._statement(each, scope)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            inner = scope.inner[node.target.id] = Scope()
            inner.gives = _class_name(node.annotation)
        elif isinstance(node, ast.Assign) and isinstance(node.value, ast.Name):
            for target in node.targets:
                if isinstance(target, ast.Name) and node.value.id in scope.inner:
                    scope.inner[target.id] = scope.inner[node.value.id]
        elif isinstance(node, ast.ImportFrom) and node.module != _NOTATION and not node.level:
            for alias in node.names:
                inner = scope.inner[alias.asname or alias.name] = Scope()
                inner.alias = f"{node.module}.{alias.name}"
        elif scope is self.module and isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            self._of_module(node.value)

    def _function(self, node: ast.FunctionDef | ast.AsyncFunctionDef) -> Scope:
        placed = tuple(a.arg for a in (*node.args.posonlyargs, *node.args.args))
        mark = self._mark(node.decorator_list, (*placed, *(a.arg for a in node.args.kwonlyargs)))
        if mark is not None:
            mark = mark._replace(attribute=_is_property(node), parameters=placed if mark.changes else ())
        found = Scope(mark)
        found.gives = _class_name(node.returns)
        found.writes = _writes_to_self(node)
        return found

    def _of_module(self, call: ast.Call) -> None:
        """`pure(__name__)`, `sink("network", __name__)`."""
        name = self._name(call.func)
        if not name or not any(isinstance(a, ast.Name) and a.id == "__name__" for a in call.args):
            return
        words = [_text(a) for a in call.args if not (isinstance(a, ast.Name) and a.id == "__name__")]
        self._tell(call.lineno, wrong(name, words))
        said: dict[str, tuple[str, ...]] = {name: tuple(w for w in words if w is not None)}
        before = self.module.mark
        mark = mark_of(said)
        if mark is not None:
            self.module.mark = mark if before is None else _both(before, mark)

    def _mark(self, decorators: Iterable[ast.expr], parameters: Iterable[str] | None = None) -> FlowMark | None:
        said: dict[str, tuple[str, ...]] = {}
        for each in decorators:
            is_call = isinstance(each, ast.Call)
            name = self._name(each.func if isinstance(each, ast.Call) else each)
            if not name:
                continue
            words = [_text(a) for a in each.args] if isinstance(each, ast.Call) else []
            if is_call and name == "pure":
                self._tell(each.lineno, ("pure takes no words",))
            elif not is_call and name in _NEEDING_WORDS:
                self._tell(each.lineno, (f"{name} needs words: @{name}(…)",))
            elif name == "changes" and not words:
                self._tell(each.lineno, ("changes names no parameter",))
            else:
                self._tell(each.lineno, wrong(name, words, parameters))
            said[name] = (*said.get(name, ()), *(w for w in words if w is not None))
        if "pure" in said and "changes" in said:
            line = next(iter(decorators)).lineno
            self._tell(line, ("pure and changes exclude each other",))
        return mark_of(said)

    def _name(self, node: ast.expr) -> str:
        """The mark that an expression means; '' where it means none."""
        return self._names.get(node.id, "") if isinstance(node, ast.Name) else ""

    def _tell(self, line: int, messages: Iterable[str]) -> None:
        self._complaints += [Wrong(line, message) for message in messages]


def _both(first: FlowMark, second: FlowMark) -> FlowMark:
    return FlowMark(
        first.sinks + second.sinks,
        first.sources + second.sources,
        first.pure or second.pure,
        first.releases or second.releases,
    )


def _imported(tree: ast.Module) -> Iterator[tuple[str, str]]:
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.module == _NOTATION:
            for alias in node.names:
                if alias.name in MARKS:
                    yield alias.asname or alias.name, alias.name


def _text(node: ast.expr) -> str | None:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _class_name(node: ast.expr | None) -> str:
    text = _text(node) if node is not None else None
    if text is not None:
        return text
    return node.id if isinstance(node, ast.Name) else ""


def _writes_to_self(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Whether the body of a method stores into its object, or calls a method of it, or of what is in it, that may."""
    first = function.args.args[0].arg if function.args.args else ""
    if first != "self":
        return False
    for node in ast.walk(function):
        if isinstance(node, (ast.Attribute, ast.Subscript)) and not isinstance(node.ctx, ast.Load):
            if _begins_with(node, first):
                return True
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and _begins_with(node.func, first):
            return True
    return False


def _is_property(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return any(isinstance(each, ast.Name) and each.id == "property" for each in function.decorator_list)


def _begins_with(node: ast.expr, name: str) -> bool:
    while isinstance(node, (ast.Attribute, ast.Subscript)):
        node = node.value
    return isinstance(node, ast.Name) and node.id == name


def imports_of(tree: ast.Module) -> Mapping[str, int]:
    """What a stub imports of the notation of stubs, with the lines."""
    return {
        alias.name: node.lineno
        for node in tree.body
        if isinstance(node, ast.ImportFrom) and node.module == _NOTATION
        for alias in node.names
    }
