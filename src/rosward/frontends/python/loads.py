# SPDX-License-Identifier: Apache-2.0
"""Which modules may a file load by name, besides those that it imports?

importlib.import_module('plugs.nav')        plugs.nav
importlib.import_module(f'plugs.{kind}')    plugs.*, a module in that package
importlib.import_module(f'{kind}.msg')      *.msg
importlib.import_module(f'.{kind}', __name__), f'{__name__}.{kind}'    .*, one beside this file
pkgutil.iter_modules(plugs.__path__)        plugs.*, where the file loads something by name; .* for the `__path__` of the file itself
__all__ = ['nav']                           .nav, where the file has no `nav`: `import *` loads it; .* where `__all__` is computed
importlib.import_module(name)               *, any; but what `name` is given in this file, where it is given nothing else
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import Final

ANY: Final = "*"

_BY_NAME: Final = frozenset({"import_module", "__import__", "find_spec"})
_OTHERWISE: Final = {
    **dict.fromkeys(("spec_from_file_location", "SourceFileLoader", "load_module", "exec_module"), ""),
    "entry_points": "metadata",
    "iter_entry_points": "pkg_resources",
}
"""What else is followed that loads modules, or told (RW203), and the word without which nothing in a file means it."""

_WORDS: Final = re.compile(rf"\b(?:{'|'.join(sorted({*_BY_NAME, *_OTHERWISE}))})\b")
_FIELD: Final = re.compile(r"%(?:\(\w*\))?[a-z]|\{[^{}]*\}")
_CHANGES: Final = frozenset({"update", "setdefault", "__setitem__"})
_ADDS: Final = frozenset({"append", "extend", "insert"})
_NAMED: Final = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.ExceptHandler, ast.MatchAs, ast.MatchStar)
_OWN: Final = ("__name__", "__package__")
_LONGEST: Final = 300  # characters
_MOST: Final = 100
"""So many names of one file are told apart."""
_MOST_HOLES: Final = 2
"""Of so many unknown parts a name is more than a beginning and an end: each costs who looks for files with such a name."""


def loads(tree: ast.Module, text: str) -> list[str]:
    """The names of modules, as this page's head shows them. `import_module` under another name may load any, as may too many names."""
    found: dict[str, None] = dict.fromkeys(_listed(tree) if "__all__" in text else ())
    for name in _loads(tree, text):
        found[_short(name)] = None
        if len(found) > _MOST:
            return [ANY]
    return list(found)


def _short(name: str) -> str:
    """The same, or what takes less to look for and means that, too."""
    first, *rest = name.split(ANY)
    if len(name) > _LONGEST:
        return ANY
    return f"{first}{ANY}{rest[-1]}" if len(rest) > _MOST_HOLES else name


def _loads(tree: ast.Module, text: str) -> Iterator[str]:
    words = set(_WORDS.findall(text))
    others = {w for w in words if (of := _OTHERWISE.get(w)) is not None and re.search(rf"\b{of}", text)}
    if words.isdisjoint(_BY_NAME) and not others:
        return
    reader = _Reader(tree)
    called: set[ast.expr] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _word(node.func) in _BY_NAME:
            called.add(node.func)
            yield from reader.loaded(node)
        elif isinstance(node, ast.Attribute) and node.attr == "__path__":  # what is in a package that is at hand
            yield f"{ast.unparse(node.value)}.{ANY}" if _is_dotted(node.value) else ANY
        elif isinstance(node, ast.Name) and node.id == "__path__":
            yield f".{ANY}"
        elif (isinstance(node, ast.alias) and node.asname and node.name in _BY_NAME) or (
            isinstance(node, ast.expr) and node not in called and _word(node) in _BY_NAME | others
        ):
            yield ANY


def _listed(tree: ast.Module) -> Iterator[str]:
    """What `import *` of this file may load: modules in its package that stand in `__all__`."""
    given: list[ast.expr] = []
    bound: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, (ast.Assign, ast.AnnAssign, ast.AugAssign)) and node.value is not None:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            given += [node.value for target in targets if _word(target) == "__all__"]
        elif (
            isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and _word(node.func.value) == "__all__"
        ):
            given += node.args if node.func.attr in _ADDS else []
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            bound.add(node.name)
        elif isinstance(node, ast.alias):
            bound.add((node.asname or node.name).partition(".")[0])
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            bound.add(node.id)
    names = [n for value in given for n in _names_in(value)]
    if ANY in names or len(names) > _MOST:
        yield f".{ANY}"
    else:
        yield from (f".{name}" for name in names if name not in bound)


def _names_in(node: ast.expr) -> Iterator[str]:
    """The names that stand in a value of `__all__`, `*` where it is computed; what another module lists is that one's."""
    if isinstance(node, (ast.List, ast.Tuple, ast.Set)):
        for element in node.elts:
            yield from _names_in(element)
    elif isinstance(node, ast.BinOp):
        yield from _names_in(node.left)
        yield from _names_in(node.right)
    elif isinstance(node, ast.Starred):
        yield from _names_in(node.value)
    elif isinstance(node, ast.Constant):
        yield from [node.value] if isinstance(node.value, str) and node.value.isidentifier() else []
    elif _word(node) not in ("__all__", "__name__"):  # `Node.__name__` is something that the file has
        yield ANY


def _word(node: ast.expr) -> str:
    """The last word of a dotted name."""
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def _is_dotted(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) or (isinstance(node, ast.Attribute) and _is_dotted(node.value))


class _Reader:
    """Reads texts of one file; `*` is what is not known of one."""

    def __init__(self, tree: ast.Module) -> None:
        self._tree = tree
        self._given: dict[str, list[ast.expr]] | None = None
        self._changed: set[str] = set()  # tables that get something
        self._of_name: dict[str, list[str]] = {}

    def loaded(self, call: ast.Call) -> Iterator[str]:
        first = call.args[0] if call.args else _keyword(call, "name")
        package = call.args[1] if len(call.args) > 1 else _keyword(call, "package")
        for name in self._texts(first):
            if name.startswith("\0"):
                yield name[1:]
            elif not name.startswith(".") or (isinstance(package, ast.Name) and package.id in _OWN):
                yield name
            elif name.startswith("..") or _word(call.func) == "__import__":
                yield ANY
            else:
                yield from (ANY if ANY in around else (around + name).lstrip("\0") for around in self._texts(package))

    def _texts(self, node: ast.expr | None) -> Iterator[str]:
        """What a text may be; one that begins with the name of this module is marked."""
        for each in self._alternatives(node):
            text = re.sub(r"\*+", ANY, each)
            if text.startswith("\0."):
                yield text[0] + text[1:].replace("\0", ANY)
            else:
                yield ANY if text.startswith("\0") else text.replace("\0", ANY)

    def _alternatives(self, node: ast.expr | None) -> list[str]:
        if isinstance(node, ast.IfExp):
            return [*self._alternatives(node.body), *self._alternatives(node.orelse)]
        if not isinstance(node, ast.Name) or node.id in _OWN:
            return self._of_table(node) or [self._text(node)]
        if node.id not in self._of_name:
            self._of_name[node.id] = [ANY]  # of a name that is given something of itself
            found = dict.fromkeys(text for each in self._all_given(node.id) for text in self._alternatives(each))
            self._of_name[node.id] = list(found) if 0 < len(found) <= _MOST else [ANY]
        return self._of_name[node.id]

    def _of_table(self, node: ast.expr | None) -> list[str]:
        """What a table of this module alone (`_LAZY[name]`, `_LAZY.get(name)`) has, which nothing changes."""
        table = node.value if isinstance(node, ast.Subscript) else None
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "get":
            table = node.func.value if len(node.args) == 1 else None
        if not isinstance(table, ast.Name) or not table.id.startswith("_"):
            return []
        given = self._all_given(table.id)
        if len(given) != 1 or not isinstance(given[0], ast.Dict) or table.id in self._changed:
            return []
        return [self._text(value) for value in given[0].values] if len(given[0].values) <= _MOST else []

    def _text(self, node: ast.expr | None) -> str:
        found = self._read(node)
        return found if len(found) <= _LONGEST else ANY

    def _read(self, node: ast.expr | None) -> str:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            return node.value.replace(ANY, "")
        if isinstance(node, ast.JoinedStr):
            return "".join(self._text(part) for part in node.values)
        if isinstance(node, ast.FormattedValue) and isinstance(node.value, ast.Name):
            return self._text(node.value)
        if isinstance(node, ast.Name):
            found = ["\0"] if node.id in _OWN else self._alternatives(node)
            return found[0] if len(found) == 1 else ANY
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            return self._text(node.left) + self._text(node.right)
        pattern = None
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod):
            pattern = node.left
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "format":
            pattern = node.func.value
        if isinstance(pattern, ast.Constant) and isinstance(pattern.value, str):
            return _FIELD.sub(ANY, pattern.value.replace(ANY, ""))
        return ANY

    def _all_given(self, name: str) -> list[ast.expr]:
        """What a name is given, if it is only ever given something by plain assignments."""
        if self._given is None:
            given: dict[str, list[ast.expr]] = {}
            plain: set[ast.expr] = set()
            otherwise: set[str] = set()
            for node in ast.walk(self._tree):
                if isinstance(node, (ast.Assign, ast.AnnAssign)) and node.value is not None:
                    for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
                        if isinstance(target, ast.Name):
                            plain.add(target)
                            given.setdefault(target.id, []).append(node.value)
                elif (isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store)) or (
                    isinstance(node, ast.Attribute) and node.attr in _CHANGES
                ):
                    self._changed.add(_word(node.value))
                elif isinstance(node, ast.arg):
                    otherwise.add(node.arg)
                elif isinstance(node, ast.alias):
                    otherwise.add(node.asname or node.name)
                elif isinstance(node, _NAMED):
                    otherwise.add(node.name or "")
                elif isinstance(node, ast.MatchMapping):
                    otherwise.add(node.rest or "")
                elif isinstance(node, ast.Global):
                    otherwise.update(node.names)
                elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and node not in plain:
                    otherwise.add(node.id)
            self._given = {name: values for name, values in given.items() if name not in otherwise}
        return self._given.get(name, [])


def _keyword(call: ast.Call, name: str) -> ast.expr | None:
    return next((each.value for each in call.keywords if each.arg == name), None)
