# SPDX-License-Identifier: Apache-2.0
"""Programs whose interface stands in their arguments or in a file: the bridge to Gazebo, rviz2."""

from __future__ import annotations

import pytest

from rosward.deployment.declared.found import ReadFile
from rosward.domain.certain import text_of
from rosward.domain.text import concat
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.ros.entities import Qos

from .declared_nodes import HERE, codes, lines, nodes, start


def always(text: str) -> ReadFile:
    """Every file has this text."""
    return lambda _: text


# ros_gz_bridge


@pytest.mark.parametrize(
    ("argument", "expected"),
    [
        ("/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan", ["pub /scan LaserScan"]),
        ("/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist", ["sub /cmd_vel Twist"]),
        ("/chatter@std_msgs/msg/String@gz.msgs.StringMsg", ["pub /chatter String", "sub /chatter String"]),
        ("chatter@std_msgs/String[gz.msgs.StringMsg", ["pub chatter String"]),
        ("/world/w/control@ros_gz_interfaces/srv/ControlWorld", ["srv /world/w/control ControlWorld"]),
        ("/s@ros_gz_interfaces/srv/ControlWorld@gz.msgs.A@gz.msgs.B", ["srv /s ControlWorld"]),
    ],
)
def test_each_argument_is_a_bridge(argument: str, expected: list[str]) -> None:
    log = start("ros_gz_bridge", "parameter_bridge", [argument, "--ros-args", "-r", "__node:=bridge"])
    assert (nodes(log), lines(log), codes(log)) == (["/bridge"], expected, [])


def test_an_argument_that_is_partly_known() -> None:
    world = Unknown((Reason(Cause.ENVIRONMENT, "WORLD", HERE),), "str")
    word: Value = concat((Const("/world/"), world, Const("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock")))
    assert lines(start("ros_gz_bridge", "parameter_bridge", [word])) == ["pub /world/*/clock Clock"]
    log = start("ros_gz_bridge", "parameter_bridge", [world])
    assert codes(log) == ["RW314"]
    assert "environment variable: WORLD" in next(iter(log.findings)).message


BRIDGES = """
- ros_topic_name: scan
  gz_topic_name: /lidar
  ros_type_name: sensor_msgs/msg/LaserScan
  gz_type_name: gz.msgs.LaserScan
  direction: GZ_TO_ROS
  publisher_queue: 3
- {topic_name: cmd_vel, ros_type_name: geometry_msgs/msg/Twist, gz_type_name: gz.msgs.Twist, direction: ROS_TO_GZ}
- {topic_name: both, ros_type_name: std_msgs/msg/Bool, gz_type_name: gz.msgs.Boolean}
- {topic_name: no_type}
"""


def test_the_file_of_a_bridge() -> None:
    words = ["--ros-args", "-p", "config_file:=/bridges.yaml"]
    log = start(
        "ros_gz_bridge",
        "parameter_bridge",
        words,
        read_file=lambda path: BRIDGES if text_of(path) == "/bridges.yaml" else None,
    )
    assert lines(log) == ["pub both Bool", "pub scan LaserScan", "sub both Bool", "sub cmd_vel Twist"]
    assert next(e.qos for e in log.entities if e.name == Const("scan")) == Qos("reliable", "volatile", "keep_last", 3)
    assert codes(start("ros_gz_bridge", "parameter_bridge", words)) == ["RW314"]
    for text in ("", "{}", "- 1", "[", "- [a]"):
        assert codes(start("ros_gz_bridge", "parameter_bridge", words, read_file=always(text))) == ["RW314"], text


def test_an_image_bridge_publishes_by_image_transport() -> None:
    words = ["/camera", "--ros-args", "-r", "/camera:=/left/camera"]
    assert "pub /left/camera Image" in lines(start("ros_gz_image", "image_bridge", words))


# rviz2

VIEW = """
Panels:
  - {Class: rviz_common/Displays}
  - {Class: rviz_common/Views}
Visualization Manager:
  Class: ""
  Displays:
    - {Class: rviz_default_plugins/Grid, Enabled: true}
    - Class: rviz_default_plugins/LaserScan
      Enabled: true
      Topic: {Depth: 7, Durability Policy: Volatile, History Policy: Keep Last, Reliability Policy: Best Effort, Value: /scan}
    - {Class: rviz_default_plugins/Map, Enabled: true, Topic: {Value: /map}, Update Topic: {Value: /map_updates}}
    - {Class: rviz_default_plugins/RobotModel, Enabled: true, Description Source: Topic, Description Topic: {Value: /robot_description}}
    - {Class: rviz_default_plugins/RobotModel, Enabled: true, Description Source: File, Description Topic: {Value: /never}}
    - {Class: rviz_default_plugins/Image, Enabled: true, Topic: {Value: /camera/compressed}}
    - {Class: rviz_default_plugins/Camera, Enabled: true, Topic: {Value: /camera/image}}
    - {Class: rviz_default_plugins/Marker, Enabled: true, Topic: {Value: /marks}}
    - {Class: rviz_default_plugins/InteractiveMarkers, Enabled: true, Interactive Markers Namespace: /tool}
    - {Class: rviz_default_plugins/Path, Enabled: true, Topic: {Value: ""}}
    - {Class: nav2_rviz_plugins/ParticleCloud, Enabled: true, Topic: {Value: /particles}}
    - {Class: nav2_rviz_plugins/ParticleCloud, Enabled: true, Topic: {Value: ""}}
    - Class: rviz_common/Group
      Enabled: false
      Displays:
        - {Class: rviz_default_plugins/Path, Enabled: true, Topic: {Value: /plan}}
  Tools:
    - {Class: rviz_default_plugins/MoveCamera}
    - {Class: rviz_default_plugins/SetGoal, Topic: {Value: /goal}}
    - {Class: rviz_default_plugins/SetInitialPose}
"""


def test_rviz_takes_the_last_of_two_keys() -> None:
    view = VIEW.replace("Topic: {Value: /marks}", "Topic: {Value: /first, Value: /marks}")
    log = start("rviz2", "rviz2", ["-d", "/v.rviz", "--ros-args", "-r", "__node:=rviz2"], read_file=lambda _: view)
    assert "sub /marks Marker" in lines(log)
    assert not any("/first" in line for line in lines(log))


def test_rviz_subscribes_to_what_its_displays_show() -> None:
    log = start("rviz2", "rviz2", ["-d", "/v.rviz", "--ros-args", "-r", "__node:=rviz2"], read_file=lambda _: VIEW)
    assert nodes(log) == ["/rviz2", "/transform_listener_impl_*"]
    assert lines(log) == [
        "?sub /plan Path",
        "cli /tool/get_interactive_markers GetInteractiveMarkers",
        "pub /goal PoseStamped",
        "pub /tool/feedback InteractiveMarkerFeedback",
        "pub initialpose PoseWithCovarianceStamped",
        "srv ~/reset_time Empty",
        "sub /camera/camera_info CameraInfo",
        "sub /camera/compressed CompressedImage",
        "sub /camera/image Image",
        "sub /map OccupancyGrid",
        "sub /map_updates OccupancyGridUpdate",
        "sub /marks Marker",
        "sub /marks_array MarkerArray",
        "sub /particles ParticleCloud",
        "sub /robot_description String",
        "sub /scan LaserScan",
        "sub /tool/update InteractiveMarkerUpdate",
    ]
    assert codes(log) == []
    assert next(e.qos for e in log.entities if e.name == Const("/scan")) == Qos(
        "best_effort", "volatile", "keep_last", 7
    )


def test_a_display_panel_or_tool_of_another_library_is_told() -> None:
    view = """
Panels: [{Class: nav2_rviz_plugins/Navigation 2}]
Visualization Manager:
  Displays: [{Class: moveit_rviz_plugin/MotionPlanning, Enabled: true}]
  Tools: [{Class: acme/Poke}, {Class: nav2_rviz_plugins/GoalTool}]
"""
    log = start("rviz2", "rviz2", ["-d", "/v.rviz"], read_file=lambda _: view)
    assert [f.message.rpartition(": ")[2] for f in log.findings] == [
        "its display moveit_rviz_plugin/MotionPlanning is unknown.",
        "its tool acme/Poke is unknown.",
        "its panel nav2_rviz_plugins/Navigation 2 is unknown.",
    ]


def test_rviz_without_a_file_that_is_known() -> None:
    assert codes(start("rviz2", "rviz2")) == ["RW314"]
    assert "pub goal_pose PoseStamped" in lines(start("rviz2", "rviz2"))
    assert codes(start("rviz2", "rviz2", ["-d", "/elsewhere.rviz"])) == ["RW314"]
    for text in ("", "- 1", "Visualization Manager: 1", "[", "Panels: {a: b}\nVisualization Manager: {Displays: {}}"):
        log = start("rviz2", "rviz2", ["-d", "/v.rviz"], read_file=always(text))
        assert set(codes(log)) <= {"RW314"}, text
