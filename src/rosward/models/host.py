# SPDX-License-Identifier: Apache-2.0
"""What models of ROS need beyond the protocol of natives: the interpreter behind a call."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    from rosward.engine.interpreter import Interpreter
    from rosward.models.native import Machine


def host(machine: Machine) -> Interpreter:
    """The interpreter behind a call: effects need its log and its frames."""
    return cast("Interpreter", machine)
