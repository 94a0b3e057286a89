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
from rosward.models.python.std.support import is_since
from rosward.ros.distro import Distro


def _since(call: NativeCall) -> Value:
    known = is_since(call.machine, Distro(text_of(call.args[0])))
    return call.machine.unknown(Cause.ENVIRONMENT, "ROS_DISTRO", "bool") if known is None else Const(known)


NATIVES: Final[dict[str, NativeFunction]] = dict.fromkeys(
    ("enum._since", "nav2_simple_commander.robot_navigator._since", "ros2param.api._since"), _since
)
