# SPDX-License-Identifier: Apache-2.0
"""Small repositories, and a survey of them: analysing takes most of the time of these tests, so several look at one."""

from __future__ import annotations

from pathlib import Path
from typing import Final, NamedTuple

import rosward

TALKER: Final = """\
import sys
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, "chatter", QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT))
node.create_publisher(String, sys.argv[1], 10)
rclpy.spin(node)
"""
LISTENER: Final = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("listener")
node.create_subscription(String, "chatter", print, 10)
rclpy.spin(node)
"""
LAUNCH: Final = """\
<launch><node pkg="demo_nodes_cpp" exec="talker" name="other"><remap from="chatter" to="/said"/></node></launch>
"""
RESULTS: Final = ("repositories", "nodes", "entities", "findings", "systems")
"""The tables that are the same however a survey ran."""
NAMES: Final = ("both", "empty", "launched", "new\nline \udcff<b>")


class Surveyed(NamedTuple):
    """A folder of repositories, where the tables of its survey are, and what the survey said."""

    folder: Path
    output: Path
    survey: rosward.Survey

    @classmethod
    def of(cls, place: Path) -> Surveyed:
        """Four repositories, one of them without a program, one with a name that nobody would choose."""
        folder = place / "checkouts"
        both, empty, launched, odd = (folder / name for name in NAMES)
        put(both / "talker.py", TALKER)
        put(both / "listener.py", LISTENER)
        put(empty / "README", "nothing")
        put(launched / "start.launch.xml", LAUNCH)
        put(odd / "talker.py", TALKER.replace("sys.argv[1]", "'b'"))
        survey = rosward.survey(folder, place / "out", jobs=2, all_launch=True)
        return cls(folder, place / "out", survey)


def put(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def tables(output: Path) -> dict[str, bytes]:
    """The bytes of the result tables."""
    return {name: (output / f"{name}.parquet").read_bytes() for name in RESULTS}
