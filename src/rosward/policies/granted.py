# SPDX-License-Identifier: Apache-2.0
"""Under which name is an entity granted, and which entities are not?

publisher /chatter                         ->  /chatter
publisher of an unknown name, "wildcard"   ->  /*
publisher /a[b], which ROS cannot hold     ->  not granted: "not a valid name in ROS"
"""

from __future__ import annotations

import re
from typing import Final

from rosward.network.checks import UnknownNames
from rosward.ros.entities import Entity, Resolution

__all__ = ["OUTSIDE", "is_name_of_ros", "name_to_grant", "why_not"]

OUTSIDE: Final = "outside the ROS namespace, which policy.xml cannot express"
"""The one reason that holds for a policy only: DDS permissions have a name for it."""

_NAME: Final = re.compile(r"(/[A-Za-z_*][A-Za-z0-9_*]*)+")


def why_not(entity: Entity, unknown: UnknownNames) -> str | None:
    """Why a policy has no rule for an entity; None where it has one."""
    if entity.resolution is Resolution.UNKNOWN and unknown == "deny":
        return "unknown name"
    if not is_name_of_ros(entity.name):
        return "not a valid name in ROS"
    return None if entity.ros_prefix else OUTSIDE


def is_name_of_ros(name: str) -> bool:
    """Whether ROS can hold a full name, or one that a pattern stands for."""
    return _NAME.fullmatch(name) is not None


def name_to_grant(entity: Entity) -> str:
    """An unknown name may also turn out to be an absolute one, so that nothing less than `/*` is sure to hold it."""
    wholly_unknown = entity.resolution is Resolution.UNKNOWN and entity.name.endswith("/*")
    return "/*" if wholly_unknown else entity.name
