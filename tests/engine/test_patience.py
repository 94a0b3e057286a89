# SPDX-License-Identifier: Apache-2.0
"""A callback that takes many steps before it creates anything is followed with less precision at first, and once more where it creates something."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

import rosward
from rosward.engine.precision import Precision

_HEAVY: Final = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

NAMES = [f"joint_{i}/state" for i in range(20)]

class Arm(Node):
    def __init__(self):
        super().__init__("arm")
        self.create_timer(0.1, self.set_up)

    def set_up(self):
        total = 0
        for i in range(100):
            for j in range(5):
                total = total + i * j + len(str(total)) - abs(i - j) + max(i, j) - min(i, j)
                total += hash(total) % 7 + round(total) - int(total) + sum([i, j, total])
        for name in NAMES:
            self.create_publisher(String, name, 10)
        self.declare_parameter("rate", 10)

rclpy.init()
rclpy.spin(Arm())
"""


def _started(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Each beginning of a callback from now on: whether it is followed with patience."""
    found: list[bool] = []
    begin = Precision.begin_callback

    def noting(self: Precision, *, coarse: bool, patient: bool) -> int:
        found.append(patient)
        return begin(self, coarse=coarse, patient=patient)

    monkeypatch.setattr(Precision, "begin_callback", noting)
    return found


def test_what_it_creates_is_known_exactly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_HEAVY, encoding="utf-8")
    started = _started(monkeypatch)
    node = rosward.extract(tmp_path).network.nodes[0]
    names = {str(each.name) for each in node.entities if "joint" in str(each.name)}
    assert names == {f"/joint_{i}/state" for i in range(20)}
    assert [p.name for p in node.parameters if p.name == "rate"] == ["rate"]
    assert started[:2] == [False, True], "it was followed once more"


def test_what_creates_nothing_is_not_followed_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_HEAVY.replace("self.create_publisher", "print"), encoding="utf-8")
    program = (
        (tmp_path / "main.py").read_text(encoding="utf-8").replace('        self.declare_parameter("rate", 10)\n', "")
    )
    (tmp_path / "main.py").write_text(program, encoding="utf-8")
    started = _started(monkeypatch)
    rosward.extract(tmp_path)
    assert started
    assert not any(started)
