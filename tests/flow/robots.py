# SPDX-License-Identifier: Apache-2.0
"""A node of which a case says what it keeps, what it does when a message arrives, and what its timer sends then."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import Final, NamedTuple

from rosward.ros.flows import STRENGTHS

from .reported import Said, reported, said_of

_PROGRAM: Final = """
import asyncio
import contextlib
import functools
import itertools
import multiprocessing
import operator
import random
import sys
import threading
import time
import traceback
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
import rclpy
from rclpy.node import Node
from rcl_interfaces.msg import SetParametersResult
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


class Swallows:
    def __init__(self, robot):
        self.robot = robot

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        self.robot.value = error.args[0]
        return True


class Switch:
    on = False

    def __bool__(self):
        return self.on


class Index:
    at = 0

    def __index__(self):
        return self.at


LEVEL = 0.0


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

    def judge(self, parameters):
        return SetParametersResult(successful=self.value)

    def take(self, parameters):
        self.value = parameters[0].value

    def errors(self):
        last = 0.0
        while True:
            try:
                yield last
            except ValueError as error:
                last = error.args[0]

    def inner(self, value):
        yield 1.0
        return value

    def outer(self, value):
        self.value = yield from self.inner(value)

    @contextlib.contextmanager
    def for_a_while(self, value):
        before, self.value = self.value, value
        try:
            yield
        finally:
            self.value = before

    def twice(self, value):
        self.value = value
        yield 0.0
        self.value = 0.0

    @contextlib.contextmanager
    def caught(self):
        try:
            yield
        except ValueError as error:
            self.value = error.args[0]

    def more(self, msg):
        for _ in getattr(self, 'items', ()):
            if msg.data > 1.0:
                break
        else:
            self.value = 1.0

    async def half(self, value):
        await asyncio.sleep(0)
        return value / 2.0

    async def gathered(self, value):
        one, other = await asyncio.gather(self.half(value), self.half(1.0))
        self.value = one + other

    def on_in(self, msg):
{does}

    def tick(self):
{then}


rclpy.init()
rclpy.spin(Robot())
"""
SEND: Final = "self.out.publish(Float64(data={}))"


class Case(NamedTuple):
    """What is kept, done, and sent then; how strongly that depends on the message, at least."""

    keeps: str
    does: str
    sends: str
    strength: str = "data"


def write(program: Path, keeps: str, does: str, then: str, top: str = "") -> None:
    """The node, as a program; `top`: what stands in front of its class."""
    indented = (textwrap.indent(part, " " * 8) for part in (keeps or "pass", does, then))
    text = _PROGRAM.format(**dict(zip(("keeps", "does", "then"), indented, strict=True)))
    program.write_text(text.replace("class Robot(Node):", f"{top}\n\n\nclass Robot(Node):"))


def said_strongly(case: Case, folder: Path) -> tuple[frozenset[str], Said]:
    """The sources of `/out` that are at least as strong as the case says, and all that is said of it."""
    program = folder / "robot.py"
    write(program, case.keeps, case.does, SEND.format(case.sends))
    said = said_of(reported(program), "topic:/out")
    assert said is not None
    strong_enough = STRENGTHS[: STRENGTHS.index(case.strength) + 1]
    return frozenset().union(*(getattr(said, s) for s in strong_enough)), said
