# SPDX-License-Identifier: Apache-2.0
"""The promise of the library models: what the real library accepts, its stub accepts.

Every function, class and method of a stub whose real module can be imported is compared with `inspect.signature` of the
real one; so is what the real module has and the stub lacks. Run with an interpreter that has rclpy and its relatives
(`python -m pytest tests/models` with an interpreter that has it); what is not installed is skipped.
"""

from __future__ import annotations

import ast
import importlib
import inspect
from pathlib import Path
from typing import Any

import pytest

STUBS = Path(__file__).parents[2] / "src" / "rosward" / "models" / "stubs"

# The packages of ROS that have stubs. (Stubs of Python itself and of numpy and the like are not exact signatures.)
ROS = frozenset(
    {
        "ament_index_python",
        "cv_bridge",
        "diagnostic_updater",
        "image_transport_py",
        "interactive_markers",
        "message_filters",
        "nav2_simple_commander",
        "py_trees",
        "py_trees_ros",
        "rclpy",
        "ros2_numpy",
        "rosidl_runtime_py",
        "sensor_msgs_py",
        "tf2_geometry_msgs",
        "tf2_py",
        "tf2_ros",
        "tf_transformations",
        "webots_ros2_core",
    }
)

# What a stub says differently on purpose: dotted name -> why.
EXCEPTIONS = {
    "rclpy.wait_for_message.wait_for_message": "time_to_wait is positional up to iron, by keyword later: both do",
    "message_filters.Subscriber": "the real one takes *args, of which it needs three",
}

# What a real module has and its stub may lack: dotted name -> why.
LACKING = {
    "rclpy.type_support": "typing protocols, which no program calls",
    "rclpy.impl.rcutils_logger": "filters of the logger, which no program calls",
    "rclpy.impl.implementation_singleton": "the loader of the compiled part",
    "rclpy.parameter_event_handler.ParameterEventHandler.Callbacks": "its inner book-keeping",
    "rclpy.clock.TimeJumpDictionary": "typing only",
    "rclpy.type_hash.TypeHashDictionary": "typing only",
    "rclpy.action.client.ClientGoalHandleDict": "typing only",
    "rclpy.action.client.SendGoalKWargs": "typing only",
    "rclpy.action.server.ServerGoalHandleDict": "typing only",
    "rclpy.lifecycle.node.CreateLifecyclePublisherArgs": "typing only",
    "rclpy.lifecycle.node.LifecycleNodeArgs": "typing only",
    "rclpy.lifecycle.publisher.LifecyclePublisherKWArgs": "typing only",
    "rclpy.task.FutureState": "kilted's private states of a future",
    "py_trees": "only what holds behaviours and calls them is modelled; the rest reads as unknown",
    "py_trees_ros": "as py_trees",
}


def _modules() -> list[str]:
    names = []
    for path in sorted(STUBS.rglob("*.pyi")):
        parts = path.relative_to(STUBS).with_suffix("").parts
        names.append(".".join(parts[:-1] if parts[-1] == "__init__" else parts))
    return names


def _stub(module: str) -> ast.Module:
    path = STUBS.joinpath(*module.split("."))
    file = path / "__init__.pyi" if path.is_dir() else path.with_suffix(".pyi")
    return ast.parse(file.read_text(encoding="utf-8"))


def _real(module: str) -> Any:
    try:
        return importlib.import_module(module)
    except ImportError:
        pytest.skip(f"{module} is not installed")


def _is_ros(module: str) -> bool:
    return module.partition(".")[0] in ROS


class _Parameters:
    """The parameters of a stub function, without `self` where it is bound."""

    def __init__(self, function: ast.FunctionDef | ast.AsyncFunctionDef, *, bound: bool) -> None:
        args = function.args
        self.positional = [a.arg for a in (*args.posonlyargs, *args.args)]
        first_default = len(self.positional) - len(args.defaults)
        self.optional = set(self.positional[first_default:])
        if bound:
            self.positional = self.positional[1:]
        self.keyword_only = [a.arg for a in args.kwonlyargs]
        self.optional |= {a.arg for a, d in zip(args.kwonlyargs, args.kw_defaults, strict=True) if d is not None}
        self.star, self.double_star = args.vararg is not None, args.kwarg is not None


def _differences(stub: _Parameters, real: inspect.Signature) -> list[str]:
    """Each way in which a call that the real function accepts is refused by the stub."""
    found, named, position = [], set[str](), 0
    for parameter in real.parameters.values():
        name, kind = parameter.name, parameter.kind
        if kind is inspect.Parameter.VAR_POSITIONAL:
            if not stub.star:
                found.append(f"*{name} is missing")
            continue
        if kind is inspect.Parameter.VAR_KEYWORD:
            if not stub.double_star:
                found.append(f"**{name} is missing")
            continue
        named.add(name)
        has_default = parameter.default is not inspect.Parameter.empty
        if kind in (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD):
            at = stub.positional[position] if position < len(stub.positional) else None
            position += 1
            if at is None and not stub.star:
                found.append(f"positional {name} is missing")
            elif at is not None and at != name and kind is inspect.Parameter.POSITIONAL_OR_KEYWORD:
                found.append(f"positional {name} is called {at}")
        elif name not in stub.positional and name not in stub.keyword_only and not stub.double_star:
            found.append(f"keyword {name} is missing")
        if has_default and name in (*stub.positional, *stub.keyword_only) and name not in stub.optional:
            found.append(f"{name} has no default")
    required = [n for n in (*stub.positional, *stub.keyword_only) if n not in named and n not in stub.optional]
    return found + [f"{name} is required, but no parameter of the real one" for name in required]


def _signature(real: object) -> inspect.Signature | None:
    try:
        return inspect.signature(real)  # type: ignore[arg-type]  # checked by the except below
    except (ValueError, TypeError):
        return None


def _kinds(function: ast.FunctionDef | ast.AsyncFunctionDef) -> set[str]:
    return {ast.unparse(d) for d in function.decorator_list}


def _check_function(
    dotted: str, function: ast.FunctionDef | ast.AsyncFunctionDef, real: Any, *, method: bool
) -> list[str]:
    kinds = _kinds(function)
    if dotted in EXCEPTIONS or any(k == "property" or k.endswith(".setter") for k in kinds):
        return []
    if isinstance(real, property) or not callable(real) or (signature := _signature(real)) is None:
        return []
    if method and not kinds & {"staticmethod", "classmethod"}:
        signature = signature.replace(parameters=list(signature.parameters.values())[1:])
    bound = method and "staticmethod" not in kinds
    return [f"{dotted}: {d}" for d in _differences(_Parameters(function, bound=bound), signature)]


def _check_class(dotted: str, cls: ast.ClassDef, real: Any) -> list[str]:
    found, own = [], {}
    for node in cls.body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            own[node.name] = node
    for name, node in own.items():
        if name == "__init__":
            signature = None if dotted in EXCEPTIONS else _signature(real)
            if signature is not None:
                found += [f"{dotted}: {d}" for d in _differences(_Parameters(node, bound=True), signature)]
        elif hasattr(real, name):
            found += _check_function(f"{dotted}.{name}", node, getattr(real, name), method=True)
    for node in cls.body:
        if isinstance(node, ast.ClassDef) and inspect.isclass(getattr(real, node.name, None)):
            found += _check_class(f"{dotted}.{node.name}", node, getattr(real, node.name))
    return found


MODULES = _modules()


@pytest.mark.parametrize("module", MODULES)
def test_a_stub_is_python(module: str) -> None:
    tree = _stub(module)
    assert ast.get_docstring(tree), "the docstring says which version the stub was read from"


@pytest.mark.parametrize("module", [m for m in MODULES if _is_ros(m)])
def test_a_stub_accepts_what_the_real_library_accepts(module: str) -> None:
    real, found = _real(module), list[str]()
    for node in _stub(module).body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and hasattr(real, node.name):
            found += _check_function(f"{module}.{node.name}", node, getattr(real, node.name), method=False)
        elif isinstance(node, ast.ClassDef) and inspect.isclass(getattr(real, node.name, None)):
            found += _check_class(f"{module}.{node.name}", node, getattr(real, node.name))
    assert found == []


def _stub_names(module: str) -> set[str]:
    names = set[str]()
    for node in _stub(module).body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            names.add(node.name)
        elif isinstance(node, ast.Assign):
            names |= {t.id for t in node.targets if isinstance(t, ast.Name)}
        elif isinstance(node, ast.ImportFrom) and node.module:
            if any(a.name == "*" for a in node.names):
                names |= _stub_names(node.module)
            names |= {a.asname or a.name for a in node.names}
    return names


def _members(tree: ast.Module, cls: ast.ClassDef) -> set[str]:
    """The names that a stub class has by itself or from its bases in the same stub, and what its methods set."""
    names = set[str]()
    bases = {base.id for base in cls.bases if isinstance(base, ast.Name)}
    for base in tree.body:
        if isinstance(base, ast.ClassDef) and base.name in bases:
            names |= _members(tree, base)
    for node in ast.walk(cls):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            names.add(node.name)
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            names.add(node.attr)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            names.add(node.id)
    return names


@pytest.mark.parametrize("module", [m for m in MODULES if _is_ros(m)])
def test_a_stub_lacks_nothing_that_the_real_library_defines(module: str) -> None:
    real, lacking = _real(module), list[str]()
    names = _stub_names(module)
    for name, value in vars(real).items():
        defined_here = getattr(value, "__module__", None) == module and (
            inspect.isclass(value) or inspect.isfunction(value)
        )
        if defined_here and not name.startswith("_") and name not in names:
            lacking.append(f"{module}.{name}")
    tree = _stub(module)
    for node in tree.body:
        cls = getattr(real, node.name, None) if isinstance(node, ast.ClassDef) else None
        if not isinstance(node, ast.ClassDef) or not inspect.isclass(cls) or cls.__module__ != module:
            continue
        has = _members(tree, node)
        for name, value in vars(cls).items():
            routine = inspect.isroutine(value) or isinstance(value, (property, classmethod, staticmethod))
            if routine and not name.startswith(("_", "RMW_")) and name not in has:
                lacking.append(f"{module}.{node.name}.{name}")
    assert [x for x in lacking if not any(x == known or x.startswith(f"{known}.") for known in LACKING)] == []
