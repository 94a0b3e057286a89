# SPDX-License-Identifier: Apache-2.0
"""Questions for attributes: numbers that tell an address and a name, and when two records answer them alike."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import rosward
from rosward.domain.heap import KIND, Obj
from rosward.domain.values import NONE, Const
from rosward.engine.callbacks import schedule
from rosward.engine.machine import Engine
from rosward.engine.running.attributes_asked import FIRST, AttributeNames, records_of, says_the_same
from rosward.engine.running.scheduled import Scheduled

ADDRESSES = st.integers(0, 1 << 34)
NAMES = st.text(max_size=4)


@given(st.lists(st.tuples(ADDRESSES, NAMES)))
def test_a_question_tells_what_it_asks_for(asked: list[tuple[int, str]]) -> None:
    names = AttributeNames()
    questions = [names.question(address, name) for address, name in asked]
    assert [names.asked(question) for question in questions] == asked
    assert list(records_of(questions)) == [address for address, _ in asked]
    assert all(question <= FIRST for question in questions)


def test_of_a_function_the_whole_record_is_asked_for() -> None:
    """Its address is below zero."""
    assert AttributeNames().question(-3, "topic") == -3
    assert list(records_of([-3, 7])) == [-3, 7]


def test_what_another_attribute_holds_is_not_asked() -> None:
    before = Obj("instance", NONE, {"kept": Const(1), "other": Const(2)})
    after = before.with_attr("other", Const(3))
    assert says_the_same(before, after, "kept")
    assert says_the_same(before, after, KIND)
    assert not says_the_same(before, after, "other")
    assert not says_the_same(before, after.replace(many=True), "kept")
    assert not says_the_same(None, after, "kept")


_PROGRAM = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class N(Node):
    def __init__(self):
        super().__init__("n")
        self.out = self.create_publisher(String, "out", 1)
        self.last = None
        self.create_subscription(String, "in", self.keep, 1)
        self.create_timer(1.0, self.send)
        self.create_timer(1.0, self.look)

    def keep(self, msg):
        self.last = msg

    def send(self):
        text = String()
        text.data = "tick"
        self.out.publish(text)

    def look(self):
        self.get_logger().info(str(self.last))

rclpy.init()
rclpy.spin(N())
"""


def test_callbacks_run_again_for_what_they_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Who keeps a message makes those run again that look at it, and no others."""
    runs: dict[str, int] = {}
    run = schedule._run_once

    def noted(machine: Engine, entry: Scheduled, *, short: bool) -> None:
        for name in ("keep", "send", "look"):
            runs[name] = runs.get(name, 0) + (f"N.{name})" in repr(entry.callback))
        run(machine, entry, short=short)

    monkeypatch.setattr(schedule, "_run_once", noted)
    (tmp_path / "main.py").write_text(_PROGRAM, encoding="utf-8")
    rosward.extract(tmp_path)
    assert runs["send"] == 1
    assert runs["keep"] <= 2
    assert runs["look"] >= 1
