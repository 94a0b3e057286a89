# SPDX-License-Identifier: Apache-2.0
"""What a call, a loop or a callback may read, and what changes it behind its back: each is followed again where it does something else then."""

from __future__ import annotations

from pathlib import Path
from textwrap import indent
from typing import Final

import pytest
from sampling import sample

import rosward
from rosward.engine.callbacks import schedule
from rosward.engine.calls import recalled
from rosward.outputs.documents.network_json import network_json

_HEAD: Final = """
import contextlib, copy, dataclasses, functools, os, random, sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
R = random.randint
"""
_NODE: Final = """
class N(Node):
    def __init__(self):
        super().__init__("n")
        self.a = "a"
        self.init()
        self.create_timer(1.0, self.tick)
        self.create_subscription(String, "in", self.hear, 10)
    def init(self): pass
    def tick(self): pass
    def hear(self, msg): pass
    def make(self, name):
        return self.create_publisher(String, name, 10)
    def pad(self):
        t = 0
        for i in (1, 2, 3, 4, 5, 6, 7, 8, 9): t = t + i
        return t
"""
_TAIL: Final = """
rclpy.init()
rclpy.spin(N())
"""


def _programs() -> dict[str, tuple[frozenset[str], str, str]]:
    """By name: the topics that a program makes, what stands before the node, and what stands in it."""
    found = {}
    for part in Path(__file__).with_name("recalled_reads.txt").read_text(encoding="utf-8").split("\n== ")[1:]:
        first, _, rest = part.partition("\n")
        name, _, made = first.partition(": ")
        before, _, inside = rest.partition("-- node\n")
        found[name] = (frozenset(f"/{each}" for each in made.split()), before, indent(inside, "    "))
    return found


_PROGRAMS: Final = _programs()


def _told(folder: Path) -> tuple[str, set[str]]:
    network = rosward.extract(folder).network
    return network_json(network), {topic.name for topic in network.topics}


@pytest.mark.parametrize("name", sample(_PROGRAMS, 4))
def test_what_is_read_counts(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made, before, inside = _PROGRAMS[name]
    (tmp_path / "main.py").write_text(f"{_HEAD}{before}{_NODE}{inside}{_TAIL}", encoding="utf-8")
    found, topics = _told(tmp_path)
    if not any("*" in topic for topic in topics):
        assert topics >= made
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    assert found == _told(tmp_path)[0]
    monkeypatch.setattr(schedule, "is_unchanged", lambda *_: False)
    assert found == _told(tmp_path)[0]
