# SPDX-License-Identifier: Apache-2.0
"""Where all callbacks together take too many steps, that is told, and those that have not run yet run once all the same."""

from __future__ import annotations

from pathlib import Path

import pytest

import rosward
from rosward.engine.budget import Budget
from rosward.engine.callbacks import schedule

PROGRAM = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Count:
    def __init__(self, step):
        self.total = 0
        for turn in range(90):
            self.total = self.total + step * turn + len(f"{step}{turn}")


class Busy(Node):
    def __init__(self):
        super().__init__("busy")
        for n in range(4):
            self.create_timer(1.0, lambda n=n: Count(n))
        self.create_subscription(String, "late", self.on_late, 1)

    def on_late(self, message):
        self.create_publisher(String, "made_late", 1)


rclpy.init()
rclpy.spin(Busy())
"""


def test_what_runs_for_the_first_time_has_steps_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(schedule, "_STEPS_OF_EACH", 0)
    (tmp_path / "main.py").write_text(PROGRAM, encoding="utf-8")
    budget = Budget(entry_steps=300, entry_hasty=300, entry_coarse=5_000, callback_steps=350)
    network = rosward.extract(tmp_path, budget=budget).network
    told = [f.message for f in network.findings if f.code == "RW201"]
    assert any("in what a timer starts" in each for each in told)  # that one took too many does not hide
    assert any("in all callbacks" in each for each in told)  # that all did
    assert "/made_late" in {e.name for node in network.nodes for e in node.entities}


THREAD = """
import threading
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("busy")


def work():
    total = 0
    for turn in range(90):
        total = total + turn + len(f"{total}{turn}")
    node.create_publisher(String, "behind", 1)


threading.Thread(target=work).start()
rclpy.spin(node)
"""


def test_a_thread_that_takes_too_many_steps_at_once_is_told(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text(THREAD, encoding="utf-8")
    network = rosward.extract(tmp_path, budget=Budget(entry_steps=100, entry_hasty=100, entry_coarse=5_000)).network
    told = [f.message for f in network.findings if f.code == "RW201"]
    assert any("in what a thread starts" in each for each in told)
