# SPDX-License-Identifier: Apache-2.0
"""What must be known of client libraries before any of their models is run? The marks of stubs say it; this is what they come to.

@node_class                              class Node: …                    its objects are nodes
@creates("publisher", …)                 def create_publisher(…): …       a method that creates an entity, of a node class
@node_method                             def create_timer(…): …           any other method by which a node is known
@creator                                 class TransformListener: …       a call of it creates entities
@plugin_class("rqt_gui.main._open")      class Plugin: …                  that function loads what derives from it
raises_nothing(__name__)                                                  functions of this module raise nothing
asks_all(__name__)                                                        of this package: what it calls of a program, stubs `ask` for
before_sources(__name__)                                                  of this package: its model goes before its own sources
precise("create_", …)                                                     methods of such names are never summarised
exact_calls("rclpy.", …)                                                  in modules of such names, a call that a signature refuses fails
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Final

from rosward.findings import Finding
from rosward.records import NamedTuple
from rosward.source import disk, limits
from rosward.source.text import read_bytes

_MOST_FILES: Final = 10_000
_DECORATORS: Final = ("node_class", "node_method", "creates", "creator", "plugin_class")
_STATEMENTS: Final = ("raises_nothing", "asks_all", "before_sources", "precise", "exact_calls")
_WORDS: Final = tuple(word.encode() for word in (*_DECORATORS, *_STATEMENTS))


class LibraryFacts(NamedTuple):
    """What marks say of all libraries together."""

    node_classes: frozenset[str] = frozenset()
    """Dotted names of the classes of nodes."""
    node_methods: frozenset[str] = frozenset()
    """Names of methods that nodes alone have: what has one is taken for a node."""
    creating: frozenset[str] = frozenset()
    """Names of methods that create entities."""
    creators: frozenset[tuple[str, str]] = frozenset()
    """Classes and functions that create entities when they are called, each with the top-level package that it is known by."""
    precise: tuple[str, ...] = ()
    """How the names of methods begin that are never summarised: what they are given decides what there is."""
    exact: tuple[str, ...] = ()
    """How the names of modules begin whose signatures are exact: what they do not take is an error of the program."""
    raising_nothing: frozenset[str] = frozenset()
    """Modules whose functions raise nothing, for what programs give them."""
    asking: frozenset[str] = frozenset()
    """Top-level packages whose stubs say which methods of a program's classes the library calls."""
    before_sources: frozenset[str] = frozenset()
    """Top-level packages whose models go before sources of that name."""
    plugin_classes: tuple[tuple[str, str], ...] = ()
    """Dotted names of classes, each with that of the function of a model that loads what derives from it, where the program does not."""

    def creators_of(self, packages: Iterable[str]) -> frozenset[str]:
        """The names of what creates entities when it is called, in a module that imports these top-level packages."""
        wanted = frozenset(packages)
        return frozenset(name for name, package in self.creators if package in wanted)

    def joined(self, other: LibraryFacts) -> LibraryFacts:
        """What both say."""
        return LibraryFacts(
            self.node_classes | other.node_classes,
            self.node_methods | other.node_methods,
            self.creating | other.creating,
            self.creators | other.creators,
            tuple(dict.fromkeys((*self.precise, *other.precise))),
            tuple(dict.fromkeys((*self.exact, *other.exact))),
            self.raising_nothing | other.raising_nothing,
            self.asking | other.asking,
            self.before_sources | other.before_sources,
            tuple(dict.fromkeys((*self.plugin_classes, *other.plugin_classes))),
        )


def marked(folder: Path) -> LibraryFacts:
    """What the marks of the stubs in a folder say; what cannot be read says nothing here, and is told where it is imported."""
    found = LibraryFacts()
    for file in stub_names(folder):
        data = read_bytes(folder / file, file, limits.STUB_FILE)
        if not isinstance(data, Finding) and any(word in data for word in _WORDS):
            try:
                tree = ast.parse(data)
            except (SyntaxError, ValueError, RecursionError, MemoryError):
                continue
            found = found.joined(
                _of_module(tree, file.removesuffix(".pyi").removesuffix("/__init__").replace("/", "."))
            )
    return found


def stub_names(folder: Path) -> Iterator[str]:
    """The stubs in a folder, in a fixed order."""
    count = 0
    for above, inner, names in disk.walk(folder):
        inner.sort()
        for name in sorted(names):
            if name.endswith(".pyi") and count < _MOST_FILES:
                count += 1
                yield Path(above, name).relative_to(folder).as_posix()


def _of_module(tree: ast.Module, name: str) -> LibraryFacts:
    top = frozenset({name.partition(".")[0]})
    facts = LibraryFacts()
    for node in tree.body:
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            facts = facts.joined(_of_statement(node.value, name, top))
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and _marks(node) & {"creator", "creates"}:
            facts = facts.joined(LibraryFacts(creators=frozenset((node.name, package) for package in top)))
        elif isinstance(node, ast.ClassDef):
            facts = facts.joined(_of_class(node, name, top))
    return facts


def _of_statement(call: ast.Call, name: str, top: frozenset[str]) -> LibraryFacts:
    mark = ast.unparse(call.func)
    words = tuple(a.value for a in call.args if isinstance(a, ast.Constant) and isinstance(a.value, str))
    if mark == "precise":
        return LibraryFacts(precise=words)
    if mark == "exact_calls":
        return LibraryFacts(exact=words)
    if mark == "raises_nothing":
        return LibraryFacts(raising_nothing=frozenset({name}))
    if mark == "asks_all":
        return LibraryFacts(asking=top)
    return LibraryFacts(before_sources=top) if mark == "before_sources" else LibraryFacts()


def _of_class(node: ast.ClassDef, module: str, top: frozenset[str]) -> LibraryFacts:
    marks = _marks(node)
    of_nodes = "node_class" in marks
    methods = {m.name: _marks(m) for m in node.body if isinstance(m, ast.FunctionDef | ast.AsyncFunctionDef)}
    creating = frozenset(n for n, m in methods.items() if m & {"creates", "creator"} and n != "__init__")
    known_by = frozenset(n for n, m in methods.items() if of_nodes and m & {"creates", "node_method"})
    called = "creator" in marks or "creates" in methods.get("__init__", ())
    return LibraryFacts(
        node_classes=frozenset({f"{module}.{node.name}"} if of_nodes else ()),
        node_methods=known_by,
        creating=creating,
        creators=frozenset((node.name, package) for package in top if called),
        plugin_classes=tuple((f"{module}.{node.name}", loader) for loader in _loaders(node)),
    )


def _loaders(node: ast.ClassDef) -> Iterator[str]:
    """The functions that load what derives from a class."""
    for mark in node.decorator_list:
        if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "plugin_class":
            yield from (a.value for a in mark.args if isinstance(a, ast.Constant) and isinstance(a.value, str))


def _marks(node: ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef) -> set[str]:
    """The marks among the decorators of a definition."""
    return {ast.unparse(d.func if isinstance(d, ast.Call) else d) for d in node.decorator_list} & set(_DECORATORS)
