# SPDX-License-Identifier: Apache-2.0
"""Calls and loops that are not followed again: whatever they do, the result is that of following them."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest

import rosward
from rosward.domain.values import Value
from rosward.engine import recalled
from rosward.engine.machine import Engine
from rosward.engine.summaries import Call
from rosward.outputs.documents.network_json import network_json

_HEAD = """
import random
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class N(Node):
    def __init__(self):
        super().__init__("n")
        self.a, self.b, self.c, self.d = "a", ["x", "y"], 0, {"k": "v"}
        self.create_timer(1.0, self.tick)
        self.create_subscription(String, "in", self.hear, 10)

    def make(self, name):
        self.create_publisher(String, name, 10)
        return name
"""
_TAIL = """
rclpy.init()
rclpy.spin(N())
"""
_VALUES = ("self.a", "'k'", "self.b[0]", "self.d['k']", "v", "v + 'z'", "str(self.c)", "self.f{n}(v)", "self.make(v)")
_STATEMENTS = (
    "self.a = {value}",
    "self.c += 1",
    "self.c = len(self.b)",
    "self.b.append({value})",
    "self.b = [{value}]",
    "self.d[{value}] = {value}",
    "v = {value}",
    "self.make({value})",
    "if random.random() > 0.5:\n{inner}",
    "for v in self.b:\n{inner}",
    "for i in range(random.randint(0, 9)):\n{inner}",
    "while random.random() > 0.5:\n{inner}",
    "try:\n{inner}\nexcept ValueError:\n    self.a = {value}",
    "for w in (self.f{n}(u) for u in self.b):\n    v = w\n{inner}",
)


def _block(random: Random, functions: int, depth: int) -> str:
    return "\n".join(_statement(random, functions, depth) for _ in range(random.randint(1, 3)))


def _statement(random: Random, functions: int, depth: int) -> str:
    chosen = random.choice(_STATEMENTS if depth else _STATEMENTS[:8])
    inner = _indented(_block(random, functions, depth - 1), 1) if "{inner}" in chosen else ""

    def value() -> str:
        known = _VALUES if functions else [v for v in _VALUES if "{n}" not in v]
        return random.choice(known).format(n=random.randrange(max(functions, 1)))

    if "{n}" in chosen and not functions:
        return "self.c += 1"
    for _ in range(chosen.count("{value}")):
        chosen = chosen.replace("{value}", value(), 1)
    return chosen.replace("{inner}", inner).replace("{n}", str(random.randrange(max(functions, 1))))


def _indented(text: str, depth: int) -> str:
    return "\n".join("    " * depth + line for line in text.splitlines())


def _program(seed: int) -> str:
    """A node whose callbacks call functions that read and write what it has; a function calls only those before it."""
    random = Random(seed)
    parts = [_HEAD]
    for number in range(3):
        parts.append(f"    def f{number}(self, v):\n{_indented(_block(random, number, 2), 2)}\n        return v\n")
    parts += [
        f"    def {name}(self, v='t'):\n{_indented(start + _block(random, 3, 2), 2)}\n"
        for name, start in (("tick", ""), ("hear", "v = v.data\n"))
    ]
    return "\n".join(parts) + _TAIL


def _told(folder: Path) -> str:
    result = rosward.extract(folder)
    return network_json(result.network)


@pytest.mark.parametrize("seed", range(24))
def test_the_result_is_that_of_following_all(seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_program(seed), encoding="utf-8")
    found = _told(tmp_path)
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    assert found == _told(tmp_path)


_REPEATS = (
    _HEAD
    + """
    def size(self, box):
        total = 0
        for side in box:
            total = total + side * self.c
        self.make(self.a)
        return total

    def tick(self):
        for box in [[1, 2], [3]] * random.randint(0, 9):
            for side in box:
                self.c = self.c + self.size(box)

    def hear(self, msg):
        for box in [[1, 2], [3]] * random.randint(0, 9):
            self.size(box)
"""
    + _TAIL
)


def test_a_call_that_would_do_the_same_is_not_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_REPEATS, encoding="utf-8")
    steps: list[int] = []
    repeated = recalled.repeated

    def counting(machine: Engine, key: str, call: Call) -> Value:
        steps.append(call.effort.steps)
        return repeated(machine, key, call)

    monkeypatch.setattr(recalled, "repeated", counting)
    found = _told(tmp_path)
    assert sum(steps) > 100
    assert '"/a"' in found


_LOCALS = (
    _HEAD
    + """
    def tick(self):
        name = "a"
        for _ in range(random.randint(0, 9)):
            for _ in range(random.randint(0, 9)):
                self.a = locals()["name"]
            self.make(self.a)
            name = "b" if name == "a" else "c"

    def hear(self, msg):
        pass
"""
    + _TAIL
)


def test_a_loop_that_looks_at_all_variables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_LOCALS, encoding="utf-8")
    found = _told(tmp_path)
    assert all(f'"/{name}"' in found for name in "abc")
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    assert found == _told(tmp_path)
