# SPDX-License-Identifier: Apache-2.0
"""Which running nodes are tools that people look at a robot with, and no part of it?

    /_ros2cli_daemon_0_3f2a…  ->  ros2 command line        /rviz2  ->  RViz

By their names alone, so a node that calls itself so passes for a tool: tools are told, with all that they have, never left out. A name that
the source explains is no tool. The names are those of ros2cli (node/__init__.py), ros2doctor (hello.py), launch_ros (ros_adapters.py),
rqt (ros_py_plugin_provider.py, roscpp_plugin_provider.cpp), rviz2, rosbag2 (record.py, play_options) and of rosward itself.
"""

from __future__ import annotations

import re
from typing import Final

__all__ = ["tool_of"]

_TOOLS: Final = (
    (re.compile(r"_ros2cli(_\w+)?"), "ros2 command line"),
    (re.compile(r"ros2doctor_\w+"), "ros2 doctor"),
    (re.compile(r"launch_ros_\d+"), "ros2 launch"),
    (re.compile(r"rqt_gui_(py|cpp)_node_\d+"), "rqt"),
    (re.compile(r"rviz2?"), "RViz"),
    (re.compile(r"rosbag2_(recorder|player)"), "ros2 bag"),
    (re.compile(r"_rosward_snapshot_[0-9a-f]+"), "rosward"),
)


def tool_of(node: str) -> str | None:
    """The tool that a node of this full name belongs to."""
    name = node.rpartition("/")[2]
    return next((tool for pattern, tool in _TOOLS if pattern.fullmatch(name)), None)
