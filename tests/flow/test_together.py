# SPDX-License-Identifier: Apache-2.0
"""Promise: where calls and objects are no longer told apart, as in large processes, more is said and nothing is lost.

The sixty programs once more: calls of one body as one from the beginning, and every two objects that one value may be are merged. So are the ways
of `python_ways.txt`, with all else that large processes do.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import pytest
from sampling import sample

from rosward.engine.watching import watch
from rosward.flow import bound, library, walker
from rosward.flow.stored import beside, shape, standing, tracker

from .reported import reported, said_by, said_of
from .robots import SEND, write
from .test_programs import PROGRAMS, _differences, _lacking, _told
from .test_python_ways import WAYS, Way

_LIMITS: Final[dict[tuple[Any, str], object]] = {
    (walker, "CALM"): 0,
    (walker, "_FEW"): 0,
    (watch, "_LARGE"): -1,
    (shape, "_FEW"): ((float("inf"), 1),),
    (library, "_FEW"): 0,
    (bound, "_FEW"): 0,
    (standing, "_DEPTH"): 1,
    (beside, "_MOST_STATES"): 1,
    (tracker, "_MOST_SENT"): 1,
}
"""From where on something is no longer told apart."""


@pytest.mark.parametrize("few", [1, 1_000_000], ids=["objects and calls", "calls"])
@pytest.mark.parametrize("program", sample(PROGRAMS, 2))
def test_nothing_is_missing(program: str, few: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watch, "_LARGE", -1)
    monkeypatch.setattr(shape, "_FEW", ((float("inf"), few),))
    assert _told(_differences(program, _lacking)) == ""


@pytest.mark.parametrize("way", sample([way for way in WAYS if way.way != "clean"], 12), ids=lambda w: w.name)
def test_no_way_is_lost(way: Way, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for (module, name), value in _LIMITS.items():
        monkeypatch.setattr(module, name, value)
    parts = way.parts
    program = tmp_path / "robot.py"
    write(program, parts.get("keeps", ""), parts["does"], SEND.format(parts["sends"]), parts.get("top", ""))
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    assert "topic:/in" in (said.data | said.control if way.way == "control" else said.data), said


def test_what_arrives_at_any_of_many(tmp_path: Path) -> None:
    names = [f"/ask_{number}" for number in range(10)]
    said = said_by(
        tmp_path,
        f"""
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool
from std_srvs.srv import Trigger


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(Bool, '/out', 10)
        self.several = {{n: self.create_client(Trigger, n) for n in {names}}}
        self.create_timer(1.0, self.tick)

    def tick(self):
        for client in self.several.values():
            self.out.publish(Bool(data=client.call(Trigger.Request()).success))


rclpy.init()
rclpy.spin(Robot())
""",
        "topic:/out",
    )
    assert said.data == {f"response:{name}" for name in names}
