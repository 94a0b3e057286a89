# SPDX-License-Identifier: Apache-2.0
"""Summaries of recursions come to rest: nothing is reported that is not so."""

from __future__ import annotations

from pathlib import Path

import pytest

import rosward
from rosward.engine.budget import Budget

COARSE = Budget(coarse=0.0, entry_coarse=0)

MUTUAL = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.seen = 0
        self.create_subscription(String, 'tree', self.on_tree, 10)

    def on_tree(self, msg):
        self.walk(msg.data)
        if self.seen:
            self.create_publisher(String, self.last, 10)

    def walk(self, text):
        for part in text.split():
            self.step(part)

    def step(self, part):
        self.last = 'found'
        if part:
            self.walk(part[1:])
        self.seen = self.seen + 1

def main():
    rclpy.init()
    rclpy.spin(Walker())

if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize("large", [-1, 10, 50])
def test_a_function_inside_a_recursion_gives_what_it_gave(large: int, tmp_path: Path) -> None:
    """`step` has a summary of its own, which is made anew in each turn of `walk`: where nothing is new, it is no other one."""
    (tmp_path / "walker.py").write_text(MUTUAL, encoding="utf-8")
    network = rosward.extract(tmp_path, budget=COARSE._replace(large=large)).network
    assert [f.message for f in network.findings if f.code == "RW201"] == []
    assert "/found" in {entity.name for node in network.nodes for entity in node.entities}
