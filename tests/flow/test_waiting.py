# SPDX-License-Identifier: Apache-2.0
"""Promise: what a callback takes back behind a wait flows to who may run meanwhile."""

from __future__ import annotations

from pathlib import Path

import pytest

from .reported import reported, said_of

_PROGRAM = """
import threading
import time
import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.last = ""
        self.create_subscription(String, "/in", self.hear, 1)
        self.out = self.create_publisher(String, "/out", 1)
        {begin}
    def hear(self, message):
        self.last = message.data
        {wait}
        self.last = ""
    def say(self):
        self.out.publish(String(data=self.last))
rclpy.init()
rclpy.spin(Robot(){executor})
"""
_TIMER = "self.create_timer(1, self.say)"


@pytest.mark.parametrize(
    ("begin", "wait", "executor"),
    [
        (_TIMER, "time.sleep(1)", ", MultiThreadedExecutor()"),
        (_TIMER, "self.executor.spin_once()", ""),
        ("threading.Thread(target=self.say).start()", "time.sleep(1)", ""),
    ],
)
def test_what_is_taken_back(tmp_path: Path, begin: str, wait: str, executor: str) -> None:
    """The other one sends what the message held."""
    program = tmp_path / "program.py"
    program.write_text(_PROGRAM.format(begin=begin, wait=wait, executor=executor))
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    assert "topic:/in" in said.data
