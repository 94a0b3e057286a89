# SPDX-License-Identifier: Apache-2.0
"""Which distributions of ROS 2 are there, and what is so in each?

    Distro("jazzy").facts.actions_are_remapped          True
    Distro.HUMBLE.facts.type_description                False: /talker/get_type_description came with iron
    Distro.KILTED.has(Distro.IRON)                      True: it is a later one

The one place for it. A new distribution is a member of `Distro` and a row of `_FACTS`; what is new in it is a field of
`DistroFacts`. Read from rclpy, rcl, rclcpp, launch and launch_ros, branches humble, iron, jazzy and rolling (December 2024), from
rclpy 9.1.2 and rcl 10.1.3 as released for kilted, and for lyrical from what was released by July 2026: rclpy 10.0.10, rcl,
rcl_action and rcl_lifecycle 10.4.4, rclcpp and rclcpp_lifecycle 32.0.1. Between kilted and lyrical no endpoint came, went, or
changed its name, type or QoS.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping
from typing import Final

from rosward.records import NamedTuple

__all__ = ["DEFAULT_DISTRO", "DISTROS", "Distro", "DistroFacts"]


class DistroFacts(NamedTuple):
    """What is so in a distribution."""

    environment: Mapping[str, str]
    """The variables that its setup files set where nobody has set them before (ros_environment)."""

    rclcpp: tuple[int, int, int]
    """The version of rclcpp, for `RCLCPP_VERSION_GTE`."""

    type_description: bool = False
    """A node serves `~/get_type_description`."""

    logger_services: bool = False
    """A node serves `~/get_logger_levels` and `~/set_logger_levels` where it is asked to."""

    service_events: bool = False
    """`configure_introspection` of services and their clients publishes `…/_service_event`."""

    action_service_events: bool = False
    """Those of the services of actions, too."""

    actions_are_remapped: bool = False
    """A plain rule (`fibonacci:=sequence`) renames an action as if it were a topic; else only rules for its five hidden names do.

    It came with rcl_action 9.2.8 of jazzy (October 2025, ros2/rcl#1170 and #1220).
    """

    components_have_conditions: bool = False
    """A component of which `condition` is false is not loaded; humble loads each."""

    logical_substitutions: bool = False
    """launch has `any`, `all`, `equals`, `not-equals`, `if`, `file-content` and `launch-log-dir`."""


class Distro(enum.Enum):
    """A distribution of ROS 2 that is understood, oldest first."""

    HUMBLE = "humble"
    IRON = "iron"
    JAZZY = "jazzy"
    KILTED = "kilted"
    LYRICAL = "lyrical"
    ROLLING = "rolling"

    def has(self, since: Distro) -> bool:
        """Whether this distribution is `since` or a later one."""
        order = list(Distro)
        return order.index(self) >= order.index(since)

    @property
    def facts(self) -> DistroFacts:
        """What is so in it."""
        return _FACTS[self]


_HUMBLE: Final = DistroFacts(environment={"ROS_LOCALHOST_ONLY": "0"}, rclcpp=(16, 0, 11))
_IRON: Final = DistroFacts(
    environment={"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET"},
    rclcpp=(21, 0, 7),
    type_description=True,
    logger_services=True,
    service_events=True,
    components_have_conditions=True,
    logical_substitutions=True,
)
_JAZZY: Final = _IRON._replace(rclcpp=(28, 1, 6), actions_are_remapped=True)
_KILTED: Final = _JAZZY._replace(rclcpp=(29, 5, 0), action_service_events=True)
_LYRICAL: Final = _KILTED._replace(rclcpp=(32, 0, 1))

_FACTS: Final[Mapping[Distro, DistroFacts]] = {
    Distro.HUMBLE: _HUMBLE,
    Distro.IRON: _IRON,
    Distro.JAZZY: _JAZZY,
    Distro.KILTED: _KILTED,
    Distro.LYRICAL: _LYRICAL,
    Distro.ROLLING: _LYRICAL,
}

DISTROS: Final[tuple[str, ...]] = tuple(distro.value for distro in Distro)
DEFAULT_DISTRO: Final[str] = Distro.JAZZY.value
