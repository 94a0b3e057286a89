# SPDX-License-Identifier: Apache-2.0
"""A stub of the standard library accepts every call that the real module accepts."""

from __future__ import annotations

import ast
import functools
import importlib
import inspect
import warnings
from pathlib import Path
from typing import Final

import pytest
from sampling import sample

import rosward.domain

STUBS: Final = Path(rosward.domain.__file__).parent.parent / "models" / "stubs"
_MODULES: Final = """abc argparse asyncio atexit collections concurrent.futures configparser contextlib csv curses functools gc
    getopt inspect itertools json logging math multiprocessing operator optparse os pathlib pickle pprint queue re sched
    signal string subprocess sys termios threading traceback tty types typing warnings weakref yaml"""


def stub_path(module: str) -> Path:
    inner = module.replace(".", "/")
    return next(p for p in (STUBS / f"{inner}.pyi", STUBS / inner / "__init__.pyi") if p.is_file())


class Stub:
    """What one function of a stub accepts."""

    def __init__(self, node: ast.FunctionDef | ast.AsyncFunctionDef, bound: bool) -> None:
        args = node.args
        positional = [*args.posonlyargs, *args.args][1 if bound else 0 :]
        self.positional = [a.arg for a in positional]
        self.by_name = {a.arg for a in [*args.args, *args.kwonlyargs]}
        self.keywords = {a.arg for a in args.kwonlyargs}
        self.vararg = args.vararg is not None
        self.kwarg = args.kwarg is not None
        needed = len(self.positional) - len(args.defaults)
        self.required = set(self.positional[: max(0, needed)])
        self.required |= {a.arg for a, d in zip(args.kwonlyargs, args.kw_defaults, strict=True) if d is None}


def refusals(stub: Stub, real: inspect.Signature, bound: bool) -> list[str]:
    """The calls of the real function that the stub refuses."""
    parameters = list(real.parameters.values())[1 if bound else 0 :]
    positional = [p for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    found: list[str] = []
    if len(positional) > len(stub.positional) and not stub.vararg:
        found.append(f"takes {len(stub.positional)} positional arguments, not {len(positional)}")
    if any(p.kind is p.VAR_POSITIONAL for p in parameters) and not stub.vararg:
        found.append("no *args")
    if any(p.kind is p.VAR_KEYWORD for p in parameters) and not stub.kwarg:
        found.append("no **kwargs")
    names = {p.name for p in parameters if p.kind in (p.POSITIONAL_OR_KEYWORD, p.KEYWORD_ONLY)}
    if not stub.kwarg:
        found.extend(f"no argument {n}" for n in sorted(names - stub.by_name))
    optional = {p.name for p in parameters if p.default is not p.empty}
    for index, name in enumerate(stub.positional):
        if name in stub.required and (
            name in optional or (index < len(positional) and positional[index].default is not inspect.Parameter.empty)
        ):
            found.append(f"{name} is optional")
    return found


def cases() -> list[tuple[str, str]]:
    found: list[tuple[str, str]] = []
    for module in _MODULES.split():
        for node in ast.parse(stub_path(module).read_text(encoding="utf-8")).body:
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and not node.name.startswith("_"):
                found.append((module, node.name))
            elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                found.extend(
                    (module, f"{node.name}.{f.name}")
                    for f in node.body
                    if isinstance(f, (ast.FunctionDef, ast.AsyncFunctionDef))
                    and (not f.name.startswith("_") or f.name == "__init__")
                )
    return found


def real_function(module: str, path: str) -> object | None:
    found: object = importlib.import_module(module)
    for name in path.split("."):
        found = getattr(found, name, None)
    return found


@pytest.mark.parametrize(("module", "path"), sample(cases(), 4))
def test_a_stub_accepts_what_the_real_one_accepts(module: str, path: str) -> None:
    made = path.endswith(".__init__")  # a class is called; its own `__init__` may say no more than *args
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        real = real_function(module, path)
    if real is None or isinstance(real, property):
        pytest.skip("of another version of Python")
    if isinstance(real, functools.partial):
        pytest.skip("pytest has put a hook of its own in its place")
    try:
        signature = inspect.signature(real_function(module, path.rpartition(".")[0]) if made else real)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        pytest.skip("the real one has no signature")
    tree: ast.AST = ast.parse(stub_path(module).read_text(encoding="utf-8"))
    for name in path.split("."):
        tree = next(n for n in ast.iter_child_nodes(tree) if getattr(n, "name", "") == name)
    assert isinstance(tree, (ast.FunctionDef, ast.AsyncFunctionDef))
    decorated = {d.id for d in tree.decorator_list if isinstance(d, ast.Name)}
    method = "." in path and "staticmethod" not in decorated
    bound = method and "classmethod" not in decorated and not made
    assert refusals(Stub(tree, method), signature, bound) == []
