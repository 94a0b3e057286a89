# SPDX-License-Identifier: Apache-2.0
"""A function that waits and calls itself again: its callbacks run at each wait, so only its first call is followed apart."""

from __future__ import annotations

from pathlib import Path

import rosward
from rosward.engine.budget import Budget

_PROGRAM = """
import time
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Runner(Node):
    def __init__(self):
        super().__init__("runner")
        self.odometry, self.model, self.seen, self.answers = None, None, [], {}
        self.create_subscription(String, "odometry", self.on_odometry, 10)
        self.create_timer(0.1, self.tick)
        self.request()

    def on_odometry(self, message):
        self.odometry = message.data
        self.seen.append(message.data)

    def tick(self):
        if self.odometry and self.model:
            for each in self.seen:
                self.answers[each] = [self.model, each, len(self.seen)]
            if len(self.answers) > 10:
                self.create_publisher(String, "many", 10)
                self.end()

    def end(self):
        self.seen = []
        self.request()

    def request(self):
        try:
            answer = input()
            if answer:
                self.model = answer
                if self.model == "good":
                    self.begin()
                else:
                    self.create_publisher(String, "bad", 10)
                    time.sleep(5.0)
                    self.request()
            else:
                self.request()
        except Exception:
            self.create_publisher(String, "failed", 10)
            self.request()

    def begin(self):
        while self.odometry is None:
            rclpy.spin_once(self, timeout_sec=0.1)
        self.create_publisher(String, "begun", 10)
        self.seen = []
        while len(self.seen) < 10:
            rclpy.spin_once(self, timeout_sec=0.1)
        self.answers.clear()

def main():
    rclpy.init()
    rclpy.spin(Runner())

main()
"""


def test_callbacks_do_not_run_at_each_depth_of_a_recursion(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text(_PROGRAM, encoding="utf-8")
    network = rosward.extract(tmp_path, budget=Budget(callback_steps=20_000)).network
    assert "RW201" not in {each.code for each in network.findings}
    assert {"/odometry", "/many", "/bad", "/failed", "/begun"} <= {str(topic.name) for topic in network.topics}
