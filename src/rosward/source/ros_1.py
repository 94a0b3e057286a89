# SPDX-License-Identifier: Apache-2.0
"""Which packages are for ROS 1, by what their `package.xml` says?

<buildtool_depend>catkin</buildtool_depend> <depend>roscpp</depend>                        ROS 1
<depend condition="$ROS_VERSION == 2">rclcpp</depend> <depend condition="…1">roscpp</depend>  ROS 2
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.source.left_out import named_few
from rosward.source.workspace import Package

_ONLY_ROS_1: Final = frozenset(
    {"roscpp", "rospy", "nodelet", "message_generation", "message_runtime", "dynamic_reconfigure", "roslaunch"}
)
_ONLY_ROS_2: Final = frozenset(
    {"rclcpp", "rclpy", "rclcpp_components", "rclcpp_lifecycle", "rosidl_default_generators"}
)


def is_for_ros_1(package: Package) -> bool:
    """Whether a package depends on what only ROS 1 has, and on nothing that only ROS 2 has."""
    return (
        package.build_type == "catkin"
        and not _ONLY_ROS_1.isdisjoint(package.depends)
        and _ONLY_ROS_2.isdisjoint(package.depends)
    )


def of_ros_1(packages: Iterable[Package]) -> list[Finding]:
    """RW020, once for all packages that are for ROS 1."""
    found = [package for package in packages if is_for_ros_1(package)]
    if not found:
        return []
    names = sorted({package.name for package in found})
    what = f"The package {names[0]} is" if len(names) == 1 else f"{len(names)} packages are"
    listed = "" if len(names) == 1 else f": {named_few(names)}"
    where = min(package.relative for package in found)
    return [Finding("RW020", f"{what} for ROS 1{listed}.", Place(f"{where}/package.xml" if where else "package.xml"))]
