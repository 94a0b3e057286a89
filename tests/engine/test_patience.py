# SPDX-License-Identifier: Apache-2.0
"""A callback that takes many steps before it creates anything is followed with less precision at first, and once more where it creates something."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

import rosward
from rosward.engine.budget import Budget
from rosward.engine.running.precision import Precision

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


def _followed(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Each time that a process is followed from now on: whether in haste."""
    found: list[bool] = []
    begin = Precision.__init__

    def noting(self: Precision, budget: Budget, careful: frozenset[str] | None = None) -> None:
        found.append(careful is not None)
        begin(self, budget, careful)

    monkeypatch.setattr(Precision, "__init__", noting)
    return found


def test_what_it_creates_is_known_exactly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_HEAVY, encoding="utf-8")
    followed = _followed(monkeypatch)
    node = rosward.extract(tmp_path).network.nodes[0]
    names = {str(each.name) for each in node.entities if "joint" in str(each.name)}
    assert names == {f"/joint_{i}/state" for i in range(20)}
    assert [p.name for p in node.parameters if p.name == "rate"] == ["rate"]
    assert followed[-2:] == [True, True], "it was followed anew, the callback without haste"


def test_what_creates_nothing_is_not_followed_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_HEAVY.replace("self.create_publisher", "print"), encoding="utf-8")
    program = (
        (tmp_path / "main.py").read_text(encoding="utf-8").replace('        self.declare_parameter("rate", 10)\n', "")
    )
    (tmp_path / "main.py").write_text(program, encoding="utf-8")
    followed = _followed(monkeypatch)
    rosward.extract(tmp_path)
    assert followed[-1:] == [True]


_TABLE: Final = """
import threading
from functools import partial
import rclpy
import unknown_library
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import String
from std_srvs.srv import Trigger

TABLE = "\\n".join(f"joint_{i};{i};state_{i}" for i in range(%d))

def weighed(a, b):
    %s
    return a * b

class Arm(LifecycleNode):
    def __init__(self):
        super().__init__("arm")
        self.names = []
        self.client = self.create_client(Trigger, "go")
        %s

    def read(self):
        names, last = [], None
        for line in TABLE.split("\\n"):
            name, value, topic = line.strip().split(";")
            if weighed(int(value), 2) < 0:
                continue
            last = name
            names.append(name + "/" + topic)
        if last is None or not last.startswith("joint"):
            unknown_library.register(self)
        return names

    def make(self, name, *_):
        self.create_publisher(String, name, 10)

    %s

rclpy.init()
rclpy.spin(Arm())
"""
_ROWS: Final = 40
_TERM: Final = "c = c + a * b + a - b + a * a - b * b + len(str(a)) + max(a, b) + min(a, b)"
_LIGHT: Final = "; ".join(["c = 0", *[_TERM] * 3])
_HEAVY_TURN: Final = "; ".join(["c = 0", *[_TERM] * 30])

_LATER: Final = {
    "in another callback": (
        _LIGHT,
        "",
        """
    def on_configure(self, state):
        self.names = self.read()

    def on_activate(self, state):
        for name in self.names:
            self.make(name)
""",
    ),
    "in threads": (
        _LIGHT,
        "self.create_timer(1.0, self.tick)",
        """
    def tick(self):
        for name in self.read():
            threading.Thread(target=self.make, args=(name,)).start()
""",
    ),
    "in what is called with answers, and behind": (
        _LIGHT,
        "self.create_timer(1.0, self.tick)",
        """
    def tick(self):
        for name in self.read():
            self.client.call_async(Trigger.Request()).add_done_callback(partial(self.make, name))
        self.make("late")
""",
    ),
    "of what the main body computed": (
        _HEAVY_TURN,
        "self.names = self.read(); self.create_timer(1.0, self.tick)",
        """
    def tick(self):
        for name in self.names:
            self.make(name)
""",
    ),
    "in the main body": (
        _HEAVY_TURN,
        "for name in self.read(): self.make(name)",
        "",
    ),
}


@pytest.mark.parametrize("where", _LATER)
def test_what_is_created_later_is_known_exactly(tmp_path: Path, where: str) -> None:
    (tmp_path / "main.py").write_text(_TABLE % (_ROWS, *_LATER[where]), encoding="utf-8")
    result = rosward.extract(tmp_path)
    names = {str(each.name) for each in result.network.nodes[0].entities if str(each.type) == "std_msgs/msg/String"}
    assert names - {"/late"} == {f"/joint_{i}/state_{i}" for i in range(_ROWS)}
    assert not [finding for finding in result.findings if finding.code in ("RW102", "RW202")]
