# SPDX-License-Identifier: Apache-2.0
"""Which modules may a file load by name, besides those that it imports?

importlib.import_module('plugs.nav')        plugs.nav
importlib.import_module(f'plugs.{kind}')    plugs.*, a module in that package
importlib.import_module(name)               *, any
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import Final

ANY: Final = "*"

_BY_NAME: Final = frozenset({"import_module", "__import__"})
_OTHERWISE: Final = frozenset(
    {
        *("spec_from_file_location", "SourceFileLoader", "load_module", "load_source", "find_spec", "exec_module"),
        *("run_path", "run_module", "entry_points", "iter_entry_points", "import_string", "locate"),
    }
)
_WORDS: Final = re.compile(rf"\b(?:{'|'.join(sorted(_BY_NAME | _OTHERWISE))})\b")


def loads(tree: ast.Module, text: str) -> Iterator[str]:
    """The names of modules, as this page's head shows them. `import_module` under another name may load any."""
    if not _WORDS.search(text):
        return
    called: set[ast.expr] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _word(node.func) in _BY_NAME:
            called.add(node.func)
            yield _loaded(node)
        elif (isinstance(node, ast.alias) and node.asname and node.name in _BY_NAME) or (
            isinstance(node, ast.expr) and node not in called and _word(node) in _BY_NAME | _OTHERWISE
        ):
            yield ANY


def _word(node: ast.expr) -> str:
    """The last word of a dotted name."""
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def _loaded(call: ast.Call) -> str:
    start, whole = _beginning(call.args[0] if call.args else _given(call, "name"))
    if start.startswith("."):
        before, known = _beginning(call.args[1] if len(call.args) > 1 else _given(call, "package"))
        start = before + start if known else start
    if whole:
        return start
    around = start.rpartition(".")[0]
    return f"{around}.{ANY}" if around.strip(".") else ANY


def _given(call: ast.Call, name: str) -> ast.expr | None:
    return next((each.value for each in call.keywords if each.arg == name), None)


def _beginning(node: ast.expr | None) -> tuple[str, bool]:
    """The text with which something begins, and whether it is all of it."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value, True
    if isinstance(node, ast.JoinedStr):
        first = node.values[0] if node.values else None
        return (_beginning(first)[0], False) if isinstance(first, ast.Constant) else ("", False)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return _beginning(node.left)[0], False
    return "", False
