# SPDX-License-Identifier: Apache-2.0
"""Promise: the models of rclpy have the signatures of the real rclpy, parameter by parameter.

    stub    def create_timer(self, timer_period_sec, callback, callback_group=None, clock=None, autostart=True)
    real    the same names, in the same order, of the same kinds, with defaults in the same places

A release of rclpy that adds, renames or moves a parameter fails here. (That the models accept what every supported distribution
accepts, and lack nothing, is what tests/models/test_signatures.py says.)
"""

from __future__ import annotations

import ast
import importlib
import inspect
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final, NamedTuple

import pytest

pytest.importorskip("rclpy")

import rosward.models

STUBS: Final = Path(rosward.models.__file__).parent / "stubs"

DIFFERENT: Final = {
    "rclpy.exceptions": "the models take *args, too: a class of the program that derives from one passes what it likes",
    "rclpy.qos.InvalidQoSProfileException": "as rclpy.exceptions",
    "rclpy.wait_for_message.wait_for_message": "time_to_wait is positional up to iron, by keyword later: the model takes both",
}
"""Signatures that differ on purpose: dotted name, or what it begins with -> why."""


class Parameter(NamedTuple):
    """What a call sees of a parameter."""

    name: str
    kind: str
    optional: bool


Function = ast.FunctionDef | ast.AsyncFunctionDef


def modules() -> list[str]:
    """The modules of rclpy that have a model."""
    paths = [p.relative_to(STUBS).with_suffix("") for p in (STUBS / "rclpy").rglob("*.pyi")]
    return sorted(".".join(p.parts[:-1] if p.name == "__init__" else p.parts) for p in paths)


def declared(function: Function) -> list[Parameter]:
    """The parameters of a function of a model."""
    args = function.args
    positional = [
        *((a, "POSITIONAL_ONLY") for a in args.posonlyargs),
        *((a, "POSITIONAL_OR_KEYWORD") for a in args.args),
    ]
    first = len(positional) - len(args.defaults)
    found = [Parameter(a.arg, kind, number >= first) for number, (a, kind) in enumerate(positional)]
    if args.vararg:
        found.append(Parameter(args.vararg.arg, "VAR_POSITIONAL", True))
    found += [
        Parameter(a.arg, "KEYWORD_ONLY", d is not None) for a, d in zip(args.kwonlyargs, args.kw_defaults, strict=True)
    ]
    if args.kwarg:
        found.append(Parameter(args.kwarg.arg, "VAR_KEYWORD", True))
    return found


def real(function: Any) -> list[Parameter] | None:
    """The parameters of a function of rclpy; None where it does not tell."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return None
    found = []
    for parameter in signature.parameters.values():
        variable = parameter.kind in {parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD}
        found.append(
            Parameter(parameter.name, parameter.kind.name, variable or parameter.default is not parameter.empty)
        )
    return found


def functions(tree: ast.Module | ast.ClassDef, dotted: str, there: Any) -> Iterator[tuple[str, Function, Any]]:
    """Each function and method of a model that the real module has, with the real one, both as they are written."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and inspect.isclass(getattr(there, node.name, None)):
            yield from functions(node, f"{dotted}.{node.name}", getattr(there, node.name))
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            found = inspect.getattr_static(there, node.name, None)
            found = getattr(found, "__func__", found)  # of a class method or static method
            if inspect.isfunction(found):
                yield f"{dotted}.{node.name}", node, found


@pytest.mark.parametrize("module", modules())
def test_signatures(module: str) -> None:
    """Each function of the model has the parameters of the real one."""
    path = STUBS.joinpath(*module.split("."))
    tree = ast.parse((path / "__init__.pyi" if path.is_dir() else path.with_suffix(".pyi")).read_text(encoding="utf-8"))
    try:
        there = importlib.import_module(module)
    except ImportError:
        pytest.skip(f"{module} is not in this release of rclpy")
    different = {}
    for dotted, node, function in functions(tree, module, there):
        ours, theirs = declared(node), real(function)
        if theirs is not None and ours != theirs:
            different[dotted] = f"{[*map(_told, ours)]} is {[*map(_told, theirs)]}"
    allowed = {name for name in different if any(f"{name}.".startswith(f"{known}.") for known in DIFFERENT)}
    assert {name: text for name, text in different.items() if name not in allowed} == {}


def test_what_is_allowed_to_differ_exists() -> None:
    """Each line of the table speaks of a module of rclpy."""
    assert all(any(known.startswith(module) for module in modules() if module != "rclpy") for known in DIFFERENT)


def _told(parameter: Parameter) -> str:
    mark = {"VAR_POSITIONAL": "*", "VAR_KEYWORD": "**", "KEYWORD_ONLY": "keyword ", "POSITIONAL_ONLY": "positional "}
    return (
        mark.get(parameter.kind, "")
        + parameter.name
        + ("=" if parameter.optional and "VAR" not in parameter.kind else "")
    )
