# SPDX-License-Identifier: Apache-2.0
"""What models of ROS need beyond the protocol of natives: the interpreter behind a call, constants that a value surely is."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from rosward.domain.values import Const, Value

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter
    from rosward.models.native import Machine


def host(machine: Machine) -> Interpreter:
    """The interpreter behind a call: effects need its log and its frames."""
    return cast("Interpreter", machine)


def text_of(value: Value | None, default: str = "") -> str:
    """The str that a value surely is."""
    return value.value if isinstance(value, Const) and isinstance(value.value, str) else default


def is_true(value: Value | None) -> bool:
    """Whether a value is the constant True."""
    return isinstance(value, Const) and value.value is True
