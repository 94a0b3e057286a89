# SPDX-License-Identifier: Apache-2.0
"""Promise: what flows through the containers, classes and calls of a program is not lost on the way.

Each row is what a node keeps, what it does when a message arrives, and what its timer does then: the message must be named for `/out`, at
least as strongly as said. Random programs that were run (`tests/live`) have shown each of these to be lost once.
"""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import Final, NamedTuple

import pytest

from rosward.ros.flows import STRENGTHS

from .reported import reported, said_of

_PROGRAM: Final = """
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import Float64


class Shared:
    total = 0.0


class Point(NamedTuple):
    x: float
    y: float


@dataclass
class Size:
    width: float
    height: float = 0.0


def remembered(value, kept=[]):
    kept.append(value)
    return sum(kept)


def masked(limit):
    values = np.array([1.0, 2.0])
    values = values * 2.0
    values[values <= limit] = 0.0
    return values.sum()


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.out = self.create_publisher(Float64, '/out', 10)
        self.create_subscription(Float64, '/in', self.on_in, 10)
        self.create_timer(0.1, self.tick)
{keeps}

    def last(self, *values, **named):
        return sum(values[-1:])

    def all_but_a(self, **named):
        return sum(v for k, v in named.items() if k != 'a')

    def say(self, value=0.0, arrived=None, late=0.0):
        self.out.publish(Float64(data=late if isinstance(value, Float64) else value))

    def say2(self, value, other, arrived):
        self.out.publish(Float64(data=value + other))

    def on_in(self, msg):
{does}

    def tick(self):
{then}


rclpy.init()
rclpy.spin(Robot())
"""
_SEND: Final = "self.out.publish(Float64(data={}))"


class Case(NamedTuple):
    """What is kept, done, and sent then."""

    keeps: str
    does: str
    sends: str
    strength: str = "data"


CASES: Final = {
    "a loop that finds no element": Case(
        "self.items = []",
        "v = msg.data\nfor v in self.items:\n    pass\n" + _SEND.format("v"),
        "0.0",
    ),
    "an element is deleted": Case(
        "self.items = [1.0, 2.0, 3.0]", "if msg.data > 1.0:\n    del self.items[:1]", "self.items[0]", "control"
    ),
    "an element is deleted when something arrives": Case(
        "self.items = [1.0, 2.0, 3.0]", "del self.items[0]", "self.items[0]", "trigger"
    ),
    "an element is taken out": Case(
        "self.items = [1.0, 2.0, 3.0]", "if msg.data > 1.0:\n    self.items.pop(0)", "self.items[0]", "control"
    ),
    "which one is removed": Case("self.items = [1.0, 2.0]", "self.items.remove(msg.data)", "sum(self.items)"),
    "one is discarded": Case("self.items = {1.0, 2.0}", "self.items.discard(msg.data)", "float(len(self.items))"),
    "a dict is cleared": Case(
        "self.table = {'a': 1.0}", "if msg.data > 1.0:\n    self.table.clear()", "self.table.get('a', 5.0)", "control"
    ),
    "a slice is written": Case("self.items = [1.0]", "self.items[:] = [msg.data]", "sum(self.items[1:])"),
    "how many arguments a list gives": Case(
        "self.items = [0.0]", "self.items.insert(0, 1.0)", "self.last(*self.items)", "trigger"
    ),
    "arguments of a list beside those of a dict": Case(
        "self.rows, self.table = [[], [0.0]], {'a': 0.0}",
        "for row in self.rows:\n    row.append(msg.data)",
        "self.last(*self.rows[0], **self.table)",
    ),
    "named arguments of a dict": Case(
        "self.table = {'a': 0.0, 'b': 1.0}",
        "self.table.pop('b')\nself.table['b'] = msg.data",
        "self.all_but_a(**self.table)",
    ),
    "a default that is kept": Case("self.value = 0.0", "self.value = msg.data", "remembered(self.value)"),
    "an attribute of a class": Case("", "Shared.total += msg.data", "Shared.total"),
    "an attribute of one's own class": Case("Robot.bias = 0.0", "type(self).bias = msg.data", "Robot.bias"),
    "the dictionary of an object": Case("self.value = 0.0", "self.__dict__['value'] = msg.data", "self.value"),
    "a named tuple": Case("self.value = Point(0.0, 0.0)", "self.value = Point(msg.data, y=2.0)", "self.value.x"),
    "a data class": Case("self.value = Size(0.0)", "self.value = Size(msg.data, height=2.0)", "self.value.width"),
    "a dict made of words": Case("self.value = 0.0", "self.value = msg.data", "dict(a=0.0, b=self.value)['b']"),
    "a parameter that is a list": Case(
        "self.declare_parameter('scale', [1.0])\nself.scale = self.get_parameter('scale').value",
        "self.scale = [msg.data * s for s in self.scale]",
        "self.scale[0]",
    ),
    "a parameter that the node sets": Case(
        "self.declare_parameter('gain', 1.0)",
        "self.set_parameters([Parameter('gain', value=msg.data)])",
        "self.get_parameter('gain').value",
    ),
    "a parameter that the node sets at times": Case(
        "self.declare_parameter('gain', 1.0)",
        "if msg.data > 1.0:\n    self.set_parameters_atomically([Parameter('gain', value=2.0)])",
        "self.get_parameter('gain').value",
        "control",
    ),
    "the default of a parameter": Case(
        "self.value = 0.0",
        "if not self.has_parameter('gain'):\n    self.declare_parameter('gain', msg.data)",
        "self.get_parameter_or('gain', Parameter('gain', value=2.0)).value",
    ),
    "whether a parameter is there": Case(
        "self.declare_parameter('gain', 1.0)",
        "if msg.data > 1.0:\n    self.undeclare_parameter('gain')",
        "float(self.has_parameter('gain'))",
        "control",
    ),
    "an array is written where a mask says so": Case(
        "self.limit = 0.0",
        "self.limit = msg.data",
        "float(masked(self.limit))",
    ),
    "how much there is in lists of a list": Case(
        "self.rows = [[], [0.0]]",
        "if msg.data > 1.0:\n    self.rows[0].append(1.0)",
        "float(len([v for row in self.rows for v in row]))",
        "control",
    ),
    "the elements of objects of a list": Case(
        "self.points = [Size(0.0), Size(1.0)]",
        "self.points[0].width = msg.data",
        "sum(p.width for p in self.points)",
    ),
    "what a partial function gives to a callback": Case(
        "", "self.create_subscription(Float64, '/more', partial(self.say, msg.data), 10)", "0.0"
    ),
    "what a partial function gives by name": Case(
        "", "self.create_subscription(Float64, '/more', partial(self.say, late=msg.data), 10)", "0.0"
    ),
    "what a partial function gives to a timer": Case(
        "", "self.create_timer(1.0, partial(self.say, [msg.data][0], None))", "0.0"
    ),
    "what partial functions in each other give": Case(
        "", "self.create_subscription(Float64, '/more', partial(partial(self.say2, msg.data), 1.0), 10)", "0.0"
    ),
    "the default of a callback": Case(
        "", "self.create_subscription(Float64, '/more', lambda m, v=msg.data: self.say(v, m), 10)", "0.0"
    ),
    "an exception that a context swallows": Case(
        "self.value = 0.0",
        "with suppress(ValueError):\n    float(msg.data)\n    self.value = 1.0",
        "self.value",
        "control",
    ),
    "which of several lists": Case(
        "self.rows = [[], [0.0]]", "self.rows[0 if msg.data > 1.0 else 1].append(1.0)", "sum(self.rows[0])", "control"
    ),
    "which of several dicts": Case(
        "self.tables = [{'a': 0.0}, {'a': 1.0}]",
        "self.tables[0 if msg.data > 1.0 else 1]['a'] = 5.0",
        "self.tables[0]['a']",
        "control",
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=list(CASES))
def test_nothing_is_lost(case: Case, tmp_path: Path) -> None:
    program = tmp_path / "robot.py"
    parts = (case.keeps or "pass", case.does, _SEND.format(case.sends))
    keeps, does, then = (textwrap.indent(part, " " * 8) for part in parts)
    program.write_text(_PROGRAM.format(keeps=keeps, does=does, then=then))
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    strong_enough = STRENGTHS[: STRENGTHS.index(case.strength) + 1]
    assert "topic:/in" in frozenset().union(*(getattr(said, s) for s in strong_enough)), said


@pytest.mark.xfail(strict=True, reason="an index that a parameter gives is taken for the one that its default gives")
def test_a_parameter_chooses_the_publisher(tmp_path: Path) -> None:
    program = tmp_path / "robot.py"
    keeps = (
        "self.declare_parameter('which', 0)\n"
        "self.outs = [self.create_publisher(Float64, f'/out{i}', 10) for i in range(2)]"
    )
    then = "self.outs[self.get_parameter('which').value].publish(Float64())"
    indented = (textwrap.indent(part, " " * 8) for part in (keeps, "pass", then))
    program.write_text(_PROGRAM.format(**dict(zip(("keeps", "does", "then"), indented, strict=True))))
    said = said_of(reported(program), "topic:/out1")
    assert said is not None
    assert "parameter:which" in said.data | said.control
