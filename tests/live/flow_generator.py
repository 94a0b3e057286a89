# SPDX-License-Identifier: Apache-2.0
"""Random small nodes through which information flows in the ways of `flow_ways.py`: `write(Seeded(7))` gives the text of one.

Nothing raises, and every loop ends: what comes out of the holes is of the right type, lists may be empty where they are read.
"""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass, field, replace
from typing import Final

from .draft import Chooser
from .flow_ways import BLOCKS, CONDITIONS, NUMBERS, PLAIN, SENDING, TEXTS

_HEAD: Final = '''import contextlib
import copy
import functools
import json
import math
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


TABLE = [lambda v: v + 1.0, lambda v: v * 2.0]
'''

_HELPER: Final = '''
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
'''

_NODE: Final = '''
class Robot(Node):
    shared = {{'a': 0.0, 'b': 0.0, 'c': 0.0}}
    bias = 0.5

    def __init__(self):
        super().__init__('robot')
        self.n0, self.n1, self.n2 = 0.0, 1.0, 2.0
        self.text, self.flag, self.last, self.pair = 'a', False, None, (0.0, 1.0)
        self.l0, self.l1 = [], [1.0]
        self.d0, self.d1 = ({{'a': 0.0, 'b': 1.0, 'c': 2.0}} for _ in range(2))
        self.rows = [[], [0.0]]
        self.seen, self.hooks = {{}}, []
        self.table = dict.fromkeys('abc', abs)
        self.queue, self.recent = deque([0.0], maxlen=3), deque([Twist()], maxlen=2)
        self.o0, self.o1 = Helper(), Further(1.0)
        self.helpers = {{'a': self.o0, 'b': self.o1, 'c': Helper(2.0)}}
        self.m0 = Twist()
        self._sum = 0.0
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
'''

_MESSAGES: Final[dict[str, dict[str, list[str]]]] = {
    "Float64": {"n": ["msg.data"]},
    "Int32": {"n": ["float(msg.data)"]},
    "Bool": {"c": ["msg.data"]},
    "String": {"t": ["msg.data"]},
    "Twist": {"n": ["msg.linear.x", "msg.angular.z"], "m": ["msg"]},
    "PointStamped": {"n": ["msg.point.x", "float(msg.header.stamp.sec)"], "t": ["msg.header.frame_id"]},
    "Float64MultiArray": {"n": ["msg.data[0]"], "l": ["data"]},
}
_PLACES: Final = {
    "l": ["self.l0", "self.l1", "self.rows[0]", "self.o0.items"],
    "d": ["self.d0", "self.d1", "self.o1.by_key"],
    "o": ["self.o0", "self.o1", "self.helpers['c']"],
    "m": ["self.m0", "self.recent[-1]"],
}
_HOLE: Final = re.compile(r"\{\{|\}\}|\{(w[ldom]?|[a-z])(\d?)\}")


@dataclass
class _Scope:
    """Where something stands. `own`: in a method of the node; `known`: what holds a number, list …; `names`: local variables."""

    own: bool = True
    known: dict[str, list[str]] = field(default_factory=dict)
    names: list[str] = field(default_factory=list)
    result: bool = False
    helpers: int = 0  # which helper methods may be called: those of higher numbers
    inner: bool = False

    def inside(self) -> _Scope:
        """A block in it."""
        return replace(self, known={k: list(v) for k, v in self.known.items()}, names=list(self.names))


class _Writer:
    def __init__(self, chooser: Chooser) -> None:
        self.chooser = chooser
        self.number = 0
        self.helpers = chooser.number(1, 2)

    def fresh(self, kind: str) -> str:
        self.number += 1
        return f"{kind or 'v'}{self.number}"

    # Expressions

    def expression(self, kind: str, scope: _Scope, depth: int) -> str:
        known = scope.known.get(kind, [])
        if known and self.chooser.chance(50 if depth > 0 else 75):
            return self.chooser.pick(known)
        ways = {"n": NUMBERS, "c": CONDITIONS, "t": TEXTS}[kind]
        if depth <= 0:
            ways = tuple(w for w in ways if not re.search(r"\{[nct]\}", w)) if kind != "c" else ("{n} > 1.0", "self.flag")
        return self.filled(self.chooser.pick(self.usable(ways, scope)), scope, depth)

    def usable(self, ways: tuple[str, ...], scope: _Scope) -> list[str]:
        found = []
        for way in ways:
            if "{h}" in way and scope.helpers >= self.helpers:
                continue
            if ("{x}" in way or "{y}" in way) and not scope.names:
                continue
            if "hook()" in way and (scope.inner or scope.helpers):
                continue
            if "{y}" in way and scope.inner:
                continue
            if not scope.own and ("self." in way or "{a}" in way or any("{" + k in way for k in "ldom")):
                continue
            found.append(way)
        return found

    def filled(self, way: str, scope: _Scope, depth: int) -> str:
        held: dict[str, str] = {}
        new: list[tuple[int, str, str]] = []
        inner = scope.inside()
        bound = way.startswith(("{w", "def inner", "steps", "value"))

        def hole(match: re.Match[str]) -> str:
            if match[0] in ("{{", "}}"):
                return match[0][0]
            kind, key = match[1], match[1] + match[2]
            line = way.count("\n", 0, match.start())
            while new and new[0][0] < line:
                _, what, name = new.pop(0)
                _know(inner, what, name)
                if bound:
                    _know(scope, what, name)
            if kind in "nct":
                return self.expression(kind, inner, depth - 1)
            if kind == "b":
                lines = self.block(inner.inside(), depth - 1)
                return textwrap.indent(lines, "    ") if not match[2] else lines.replace("\n", "\n        ")
            if kind == "f":
                return textwrap.indent(self.block(replace(inner.inside(), names=[], result=False, inner=True), depth - 1), "    ")
            if kind == "r":
                return f"return {self.expression('n', inner, 1)}" if scope.result else "return"
            if key not in held:
                held[key] = self.place(kind, scope, held)
                if kind.startswith("w"):
                    new.append((line, kind[1:], held[key]))
            return held[key]

        text = _HOLE.sub(hole, way)
        if bound:
            for _, kind, name in new:
                _know(scope, kind, name)
        return text

    def place(self, kind: str, scope: _Scope, held: dict[str, str]) -> str:
        pick = self.chooser.pick
        if kind.startswith(("w", "z")):
            return self.fresh(kind[1:])
        if kind in "xy":
            return pick(scope.names)
        if kind == "a":
            return pick(["n0", "n1", "n2"])
        if kind == "k":
            return pick(["a", "b", "c"])
        if kind == "h":
            return f"helper{self.chooser.number(scope.helpers, self.helpers - 1)}"
        places = _PLACES[kind] + 2 * scope.known.get(kind, [])
        others = [p for p in places if p not in held.values()]
        return pick(others or places)

    # Statements

    def block(self, scope: _Scope, depth: int, most: int = 3) -> str:
        lines = []
        for _ in range(self.chooser.number(1, most)):
            lines.append(self.statement(scope, depth))
        return "\n".join(lines)

    def statement(self, scope: _Scope, depth: int) -> str:
        kind = self.chooser.number(0, 9)
        ways = BLOCKS if kind < 4 and depth > 0 else SENDING if kind == 9 and scope.own else PLAIN
        usable = self.usable(ways, scope)
        return self.filled(self.chooser.pick(usable), scope, self.chooser.number(1, 2) if ways is not BLOCKS else depth)

    # The program

    def method(self, head: str, scope: _Scope, first: str = "", *, sends: bool = False) -> str:
        body = [first] if first else []
        body.append(self.block(scope, self.chooser.number(0, 2), self.chooser.number(1, 3)))
        if sends:
            body.append(self.filled(self.chooser.pick(self.usable(SENDING, scope)), scope, self.chooser.number(1, 2)))
        if scope.result:
            body.append(f"return {self.expression('n', scope, 2)}")
        return f"\n    def {head}:\n" + textwrap.indent("\n".join(body), " " * 8) + "\n"

    def program(self) -> str:
        pick = self.chooser.pick
        methods, init = [], []
        for name in "abc"[: self.chooser.number(2, 3)]:
            kind = pick(list(_MESSAGES))
            init.append(f"self.create_subscription({kind}, '/{name}', self.on_{name}, 10)")
            known = {k: 2 * v for k, v in _MESSAGES[kind].items()}
            first = "data = list(msg.data)" if "l" in known else ""
            methods.append(self.method(f"on_{name}(self, msg)", _Scope(known=known), first, sends=self.chooser.chance(60)))
        methods.append(self.method("tick(self)", _Scope(), sends=True))
        if self.chooser.chance(40):
            init.append("self.create_service(SetBool, '/set', self.on_set)")
            body = self.method("on_set(self, request, response)", _Scope(known={"c": ["request.data"]}))
            body = re.sub(r"\breturn$", "return response", body, flags=re.M)
            methods.append(f"{body}        response.message = {self.expression('t', _Scope(), 1)}\n        return response\n")
        for number in range(self.helpers):
            scope = _Scope(known={"n": ["p", "other"]}, names=["p"], result=True, helpers=number + 1)
            methods.append(self.method(f"helper{number}(self, p, other={pick(['0.0', '3.0'])})", scope))
        of_generator = self.block(_Scope(known={"n": ["p"]}, names=["p"], helpers=9), 0, 2)
        answer = _Scope(known={"t": ["answer.message"], "c": ["answer.success"]})
        node = _NODE.format(
            init=textwrap.indent("\n".join([*init, self.statement(_Scope(helpers=9), 0)]), " " * 8),
            counting=textwrap.indent(of_generator.replace("self.counting", "(lambda v: iter([v, v]))"), " " * 8),
            answer=textwrap.indent(self.block(answer, 1).replace("self.ask", "bool"), " " * 8),
            methods="".join(methods),
        )
        return _HEAD + self.helper() + node

    def helper(self) -> str:
        pick = self.chooser.pick
        fields = ["self.value", "self.other", "sum(self.items)", "self.by_key['a']"]
        names = [*fields, "p", "p"]

        def number() -> str:
            return pick([*names, f"({pick(names)} + {pick(names)})", f"({pick(names)} if {pick(names)} > 1.0 else {pick(names)})"])

        def write() -> str:
            place = pick(["self.value", "self.other", "self.by_key['a']", "self.by_key['b']", "self.value"])
            return pick(
                [
                    f"{place} = {number()}",
                    f"{place} += {number()}",
                    f"if {number()} > 1.0:\n    {place} = {number()}",
                    f"if {number()} > {number()}:\n    return {number()}",
                    f"self.items.append({number()})",
                    f"self.items = [{number()}]",
                    f"self.items = self.items[-2:]\n{place} = len(self.items)",
                    f"self.name = str({number()})",
                    f"for v in self.items[:2]:\n    {place} += v",
                ]
            )

        def body() -> str:
            return textwrap.indent("\n".join([write(), write(), f"return {number()}"]), " " * 8)

        keep = textwrap.indent(write(), " " * 8)
        return _HELPER.format(step=body(), keep=keep, level=pick(fields), call=body(), further=number())


def _know(scope: _Scope, kind: str, name: str) -> None:
    if kind:
        scope.known.setdefault(kind, []).append(name)
    else:
        scope.known.setdefault("n", []).append(name)
        scope.names.append(name)


def write(chooser: Chooser) -> str:
    """A program."""
    return _Writer(chooser).program()
