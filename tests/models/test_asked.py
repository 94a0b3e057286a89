# SPDX-License-Identifier: Apache-2.0
"""Promise: what the real rclpy calls on its own objects, and a program may override, the models call too.

rclpy/parameter_service.py    node.create_service(…)      rclpy/parameter_service.pyi    node.create_service(…) or ask(node, "create_service", …)
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest

from rosward.engine.libraries.stub_files import STUBS

rclpy = pytest.importorskip("rclpy")
REAL: Final = Path(rclpy.__file__).parent

READ_ONLY: Final = {"handle", "context", "default_callback_group", "executor"}
"""Properties that rclpy reads: a program that overrides one of them has nothing to do there."""

ELSEWHERE: Final = {
    "rclpy/executors.py Executor._wait_for_ready_callbacks": "reads what a node holds: properties",
    "rclpy/node.py Node.__init__ get_parameters": "of the C object, not of the node",
    "rclpy/node.py Node._set_parameters_atomically_common": "Node._set",
    "rclpy/node.py Node._apply_descriptor": "Node._set",
    "rclpy/node.py Node.undeclare_parameter": "in code; has_parameter of a program changes nothing that is undeclared",
    "rclpy/node.py Node._validate_topic_or_service_name": "names for a message of an error",
    "rclpy/node.py Node._count_publishers_or_subscribers": "names for a question to the running system",
    "rclpy/node.py Node._count_clients_or_servers": "names for a question to the running system",
    "rclpy/node.py Node._get_info_by_topic": "names for a question to the running system",
    "rclpy/node.py Node.set_descriptor get_parameter": "get_parameter of the same call",
    "rclpy/parameter_event_handler.py ParameterEventHandler._resolve_path": "names for a comparison",
    "rclpy/time_source.py TimeSource._subscribe_to_clock_topic": "TimeSource.ros_time_is_active",
    "rclpy/time_source.py TimeSource._on_parameter_event": "says that a parameter is refused",
    "rclpy/time_source.py TimeSource.__init__": "TimeSource.attach_node",
    "rclpy/action/server.py ActionServer._execute_goal_request": "the time of a goal",
    "rclpy/executors.py Executor._wait_for_ready_callbacks get_nodes": "Executor.spin",
}
"""What a model calls in another function than rclpy, or not at all; and why."""


def _public(tree: ast.Module, cls: str) -> set[str]:
    found = next(n for n in tree.body if isinstance(n, ast.ClassDef) and n.name == cls)
    return {f.name for f in found.body if isinstance(f, ast.FunctionDef) and not f.name.startswith("_")}


def _asked(path: Path, names: set[str]) -> dict[str, set[str]]:
    """The methods that are called on a node, by the function that calls them."""
    found: dict[str, set[str]] = {}
    for where, function in _functions(ast.parse(path.read_text(encoding="utf-8"))):
        own = where.partition(".")[0] in ("Node", "LifecycleNodeMixin", "LifecycleNode")
        for node in ast.walk(function):
            if isinstance(node, ast.Attribute) and node.attr in names and _is_node(ast.unparse(node.value), own=own):
                found.setdefault(where, set()).add(node.attr)
            elif isinstance(node, ast.Call) and ast.unparse(node.func) in ("ask", "overridden"):
                texts = {a.value for a in node.args if isinstance(a, ast.Constant) and isinstance(a.value, str)}
                found.setdefault(where, set()).update(texts)
    return found


def _is_node(text: str, *, own: bool) -> bool:
    return text in ("node", "self._node", "self.node") or (own and text in ("self", "Node"))


def _functions(tree: ast.Module) -> Iterator[tuple[str, ast.FunctionDef]]:
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, node
        elif isinstance(node, ast.ClassDef):
            yield from ((f"{node.name}.{f.name}", f) for f in node.body if isinstance(f, ast.FunctionDef))


def _missing() -> Iterator[str]:
    names = _public(ast.parse((REAL / "node.py").read_text(encoding="utf-8")), "Node") - READ_ONLY
    for real in sorted(REAL.rglob("*.py")):
        model = STUBS / real.relative_to(REAL.parent).with_suffix(".pyi")
        if not model.is_file():
            continue
        known = _asked(model, names)
        for where, asked in sorted(_asked(real, names).items()):
            said = known.get(where, set())
            place = f"{real.relative_to(REAL.parent).as_posix()} {where}"
            if place not in ELSEWHERE:
                yield from (f"{place} {name}" for name in sorted(asked - said) if f"{place} {name}" not in ELSEWHERE)


def test_models_ask_what_rclpy_asks() -> None:
    """No call of the real library on its node is missing in the model of the same function."""
    assert list(_missing()) == []
