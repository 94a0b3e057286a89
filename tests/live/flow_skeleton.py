# SPDX-License-Identifier: Apache-2.0
"""What random programs are written into: functions, a helper class and a node, with places for what is written anew each time.

What a program does not use is taken out of it.
"""

from __future__ import annotations

from typing import Final

HEAD: Final = """import bisect
import collections
import contextlib
import copy
import dataclasses
import enum
import functools
import hashlib
import heapq
import io
import itertools
import json
import math
import operator
import queue
import statistics
import threading
import typing
from collections import deque

import rclpy
from geometry_msgs.msg import PointStamped, Twist, Vector3
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import Bool, Float64, Float64MultiArray, Int32, String
from std_srvs.srv import SetBool, Trigger

STATE = {'a': 1.0, 'b': 2.0, 'c': 3.0}


class Shared:
    total = 0.0


class Refused(Exception):
    def __init__(self, value):
        super().__init__('refused')
        self.value = value


def free(p, q):
    return p + q * 0.5


free.last = 0.0


class Special:
    def __init__(self, value):
        self.value = value

    def __float__(self):
        return self.value * 2.0

    def __int__(self):
        return int(self.value)

    def __index__(self):
        return int(self.value > 1.0)

    def __divmod__(self, other):
        return self.value, other

    def __iter__(self):
        return iter([self.value, 1.0])

    def __reversed__(self):
        return iter([1.0, self.value])

    def __hash__(self):
        return int(self.value) % 7

    def __eq__(self, other):
        return self.value == other.value


def digested(text):
    digest = hashlib.md5()
    digest.update(text.encode())
    return float(digest.digest()[0])


def through_text(value):
    text = io.StringIO()
    json.dump({'value': value}, text)
    return json.loads(text.getvalue())['value']


def remember(p, kept=[]):
    kept.append(p)
    return sum(kept[-2:])


def parsed(text, otherwise):
    try:
        return float(text)
    except ValueError:
        return otherwise


def put(where, what):
    where.append(what)


def cell(p):
    value = p

    def read():
        return value

    def change(q):
        nonlocal value
        value = q

    return read, change


class Point(typing.NamedTuple):
    x: float
    y: float


@dataclasses.dataclass
class Kept:
    value: float
    other: float = 0.0

    def doubled(self):
        return self.value * 2.0 + self.other


class Mode(enum.Enum):
    SLOW = 1.0
    FAST = 2.0


class Delegate:
    def __init__(self, owner):
        self.owner = owner

    def read(self):
        return self.owner.n1

    def write(self, p):
        self.owner.n1 = p


COUNT = 0.0


def count(p):
    global COUNT
    COUNT = p


TABLE = [lambda v: v + 1.0, lambda v: v * 2.0]
"""

HELPER: Final = """
class Helper:
    made = 0

    def __init__(self, value=0.0):
        self.value = value
        self.other = 1.0
        self.items = [value]
        self.by_key = {{'a': value, 'b': 0.0, 'c': 0.0}}
        self.name = 'a'

    def step(self, p):
{step}

    def keep(self, p):
        self.items.append(p)
{keep}

    @property
    def level(self):
        return {level}

    @level.setter
    def level(self, p):
        self.other = p

    def itself(self):
        return self

    @classmethod
    def make(cls, p):
        return cls(p)

    def __call__(self, p):
{call}

    def __add__(self, other):
        return Helper(self.value + other.other)

    def __eq__(self, other):
        return self.value == other.value

    def __hash__(self):
        return 1

    def __len__(self):
        return len(self.items)

    def __bool__(self):
        return True

    def __iter__(self):
        return iter(self.items)

    def __getitem__(self, key):
        return self.by_key[key]

    def __setitem__(self, key, p):
        self.by_key[key] = p

    def __enter__(self):
        self.other = self.value
        return self

    def __exit__(self, *_):
        self.value = self.other


class Further(Helper):
    def step(self, p):
        self.other = super().step(p)
        return {further}
"""

NODE: Final = """
class Robot(Node):
    shared = {{'a': 0.0, 'b': 0.0, 'c': 0.0}}
    bias = 0.5

    def __init__(self):
        super().__init__('robot')
        self.n0, self.n1, self.n2 = 0.0, 1.0, 2.0
        self.text = 'a'
        self.flag = False
        self.last = None
        self.pair = (0.0, 1.0)
        self.l0 = []
        self.l1 = [1.0]
        self.d0 = {{'a': 0.0, 'b': 1.0, 'c': 2.0}}
        self.d1 = {{'a': 0.0, 'b': 1.0, 'c': 2.0}}
        self.rows = [[], [0.0]]
        self.seen = {{}}
        self.hooks = []
        self.table = dict.fromkeys('abc', abs)
        self.queue = deque([0.0], maxlen=3)
        self.recent = deque([Twist()], maxlen=2)
        self.o0 = Helper()
        self.o1 = Further(1.0)
        self.helpers = {{'a': self.o0, 'b': self.o1, 'c': Helper(2.0)}}
        self.m0 = Twist()
        self._sum = 0.0
        self.point = Point(0.0, 1.0)
        self.kept = Kept(0.0)
        self.mode = Mode.SLOW
        self.delegate = Delegate(self)
        self.hidden = 0.0
        self.cell, self.change_cell = cell(0.0)
        self.jobs = queue.Queue()
        self.steps = iter([1.0, 2.0])
        self.declare_parameter('gain', 2.0)
        self.declare_parameter('mode', False)
        self.f0 = self.create_publisher(Float64, '/f0', 10)
        self.f1 = self.create_publisher(Float64, '/f1', 10)
        self.words = self.create_publisher(String, '/words', 10)
        self.moves = self.create_publisher(Twist, '/moves', 10)
        self.many = self.create_publisher(Float64MultiArray, '/many', 10)
        self.outs = [self.create_publisher(Float64, f'/out{{i}}', 10) for i in range(2)]
        self.by_name = {{c: self.create_publisher(Float64, f'/by/{{c}}', 10) for c in 'abc'}}
        self.client = self.create_client(Trigger, '/query')
        self.timer = self.create_timer(0.1, self.tick)
{init}

    @property
    def average(self):
        return self._sum / 2.0

    @average.setter
    def average(self, p):
        self._sum += p

    def set_n0(self, p):
        self.n0 = p

    def set_n1(self, p):
        self.n1 = p

    def set_n2(self, p):
        self.n2 = p

    def send(self, name, p):
        self.by_name[name].publish(Float64(data=float(p)))

    def chosen(self, p):
        return 0 if p < 1.0 else 1

    def work(self, p):
        self.n2 = p
        self.f1.publish(Float64(data=float(self.n1)))

    def guess(self, p):
        try:
            if p > 2.0:
                raise KeyError(p)
            return self.n0
        except KeyError as error:
            return error.args[0] * 2.0
        finally:
            self.n1 = 0.5

    def both(self, p, q):
        return p, q

    def spread(self, *values, **named):
        return sum(values[-1:]) + sum(v for k, v in named.items() if k != 'a')

    def change(self, where):
        where.append(self.n2)

    def fill(self, where, p):
        where['b'] = p

    def pour(self, message, p):
        message.linear.x = float(p)

    def counting(self, p):
        yield p
{counting}
        yield self.n1

    @contextlib.contextmanager
    def changed(self, p):
        before, self.n2 = self.n2, p
        try:
            yield self.n2
        finally:
            self.n2 = before

    @contextlib.contextmanager
    def caught(self, name):
        try:
            yield
        except Refused as refused:
            setattr(self, name, refused.value)

    def keeping(self):
        try:
            yield 0.0
        except Refused as refused:
            self.n1 = refused.value
            yield 1.0

    def halved(self, p):
        yield p
        return p * 0.5

    def passing(self, p):
        self.n0 = yield from self.halved(p)

    def risky(self, p):
        if p > 1.0:
            raise Refused(p)
        return p

    def ask(self, flag):
        if flag:
            self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)

    def on_answer(self, future):
        answer = future.result()
{answer}
{methods}

def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
"""
