# SPDX-License-Identifier: Apache-2.0
"""Promise: the names of interfaces are known for the workspace and for common packages, and unknown is not none."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.source.interfaces import InterfaceIndex
from source.trees import manifest, read


@pytest.mark.parametrize(
    ("package", "kind", "name"),
    [
        ("std_msgs", "msg", "String"),
        ("geometry_msgs", "msg", "TwistStamped"),
        ("sensor_msgs", "srv", "SetCameraInfo"),
        ("std_srvs", "srv", "Trigger"),
        ("nav2_msgs", "action", "NavigateToPose"),
        ("example_interfaces", "action", "Fibonacci"),
        ("action_tutorials_interfaces", "action", "Fibonacci"),
        ("builtin_interfaces", "msg", "Time"),
        ("px4_msgs", "msg", "VehicleCommand"),
        ("turtlesim", "srv", "Spawn"),
        ("rcl_interfaces", "msg", "ParameterEvent"),
        ("tf2_msgs", "msg", "TFMessage"),
        ("control_msgs", "action", "FollowJointTrajectory"),
        ("moveit_msgs", "srv", "GetPositionIK"),
    ],
)
def test_common_packages_are_known(package: str, kind: str, name: str) -> None:
    index = InterfaceIndex()
    assert index.has(f"{package}.{kind}", name) is True
    assert index.has(f"{package}.{kind}", "Nonsense") is False


def test_nothing_is_known_of_other_packages() -> None:
    assert InterfaceIndex().has("my_msgs.msg", "Foo") is None
    assert InterfaceIndex().names("std_msgs", "nonsense") is None
    assert InterfaceIndex().has("std_msgs", "msg") is None


def test_a_known_package_without_services_has_none() -> None:
    assert InterfaceIndex().names("std_msgs", "srv") == frozenset()


def test_the_workspace_goes_first(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        {
            "mine/package.xml": manifest("mine", "ament_cmake"),
            "mine/msg/Foo.msg": "",
            "mine/msg/Bar.idl": "",
            "mine/srv/Do.srv": "",
            "mine/action/deep/Go.action": "",
            "std_msgs/package.xml": manifest("std_msgs", "ament_cmake"),
            "std_msgs/msg/Own.msg": "",
        },
    )
    index = InterfaceIndex(found)
    assert index.names("mine", "msg") == frozenset({"Foo", "Bar"})
    assert index.names("mine", "srv") == frozenset({"Do"})
    assert index.names("mine", "action") == frozenset({"Go"})
    assert index.names("std_msgs", "msg") == frozenset({"Own"})
