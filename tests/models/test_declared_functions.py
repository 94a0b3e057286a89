# SPDX-License-Identifier: Apache-2.0
"""Each function of each stub says what it changes, or says that it changes nothing.

A body says it, an effect decorator, or the mark `reads_only`: on the function, on its class, or for the whole module.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

from rosward.engine.libraries.stub_files import STUBS

EFFECTS = {"native", "creates", "calls", "spins", "pure", "changes"}
MARK = "reads_only"


def decorators(node: ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef) -> set[str]:
    return {ast.unparse(d).partition("(")[0] for d in node.decorator_list}


def says_nothing(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Whether a body is a docstring, `pass` and `...` alone."""
    return all(
        isinstance(s, ast.Pass) or (isinstance(s, ast.Expr) and isinstance(s.value, ast.Constant))
        for s in function.body
    )


def silent(node: ast.AST, owner: str = "") -> Iterator[str]:
    """The functions that do not say what they change."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.ClassDef):
            if MARK not in decorators(child):
                yield from silent(child, f"{owner}{child.name}.")
        elif isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef):
            if says_nothing(child) and not decorators(child) & {*EFFECTS, MARK}:
                yield f"{owner}{child.name}"
            yield from silent(child, f"{owner}{child.name}.")
        else:
            yield from silent(child, owner)


def is_marked(module: ast.Module) -> bool:
    return any(isinstance(s, ast.Expr) and ast.unparse(s.value) == f"{MARK}(__name__)" for s in module.body)


@pytest.mark.parametrize("file", sorted(STUBS.rglob("*.pyi")), ids=lambda f: f.relative_to(STUBS).as_posix())
def test_each_function_says_what_it_changes(file: object) -> None:
    module = ast.parse(file.read_text(encoding="utf-8"))  # type: ignore[attr-defined]
    found = list(silent(module))
    if is_marked(module):
        assert found, "the mark of this module says nothing"
    else:
        assert found == []


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("def f(): ...", ["f"]),
        ("def f():\n    'Only words.'", ["f"]),
        ("class C:\n    def f(self):\n        pass", ["C.f"]),
        ("if X:\n    class C:\n        class D:\n            async def f(self): ...", ["C.D.f"]),
        ("def g():\n    def f(): ...\n    return f", ["g.f"]),
        ("@property\ndef f(): ...", ["f"]),
        ("@reads_only\ndef f(): ...", []),
        ("@reads_only\nclass C:\n    def f(self): ...", []),
        ("@changes('x')\ndef f(x): ...", []),
        ("def f(x):\n    x.clear()", []),
    ],
)
def test_what_says_nothing_is_seen(source: str, expected: list[str]) -> None:
    assert list(silent(ast.parse(source))) == expected


def test_what_changes_is_a_parameter() -> None:
    for file in STUBS.rglob("*.pyi"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                names = {a.arg for a in ast.walk(node.args) if isinstance(a, ast.arg)}
                for decorator in node.decorator_list:
                    if isinstance(decorator, ast.Call) and ast.unparse(decorator.func) == "changes":
                        assert {ast.literal_eval(a) for a in decorator.args} <= names, f"{file}: {node.name}"
