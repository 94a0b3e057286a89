# SPDX-License-Identifier: Apache-2.0
"""For which distribution is the analysis?

_since(NAME)         in a stub: True for the distribution of that name and what came later; False for those before it
"""

from __future__ import annotations

from typing import Final

from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import text_of
from rosward.ros.distro import DISTROS, Distro


def _since(call: NativeCall) -> Value:
    """Whether the analysis is for a distribution, or for a later one."""
    known = call.machine.environment.get("ROS_DISTRO")
    name = None if known is None else text_of(known)
    if name not in DISTROS:
        return call.machine.unknown(Cause.ENVIRONMENT, "ROS_DISTRO", "bool")
    return Const(Distro(name).has(Distro(text_of(call.args[0]))))


NATIVES: Final[dict[str, NativeFunction]] = dict.fromkeys(
    ("enum._since", "nav2_simple_commander.robot_navigator._since", "ros2param.api._since"), _since
)
