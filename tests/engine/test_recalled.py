# SPDX-License-Identifier: Apache-2.0
"""Calls and loops that are not followed again: whatever they do, the result is that of following them."""

from __future__ import annotations

from pathlib import Path
from random import Random
from typing import Final

import pytest
from compiled import interpreted
from sampling import sample

import rosward
from rosward.engine.budget import Budget
from rosward.engine.calls import recalled
from rosward.outputs.documents.network_json import network_json

from .recalling import noted_recalls

_HEAD = """
import random
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Refused(Exception):
    pass

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
_RAISING = (
    "if random.random() > 0.5:\n    raise ValueError({value})",
    "if random.random() > 0.5:\n    raise Refused({value})",
    "assert random.random() > 0.5, {value}",
    "self.msg = String(); self.msg.data = {value}",
    "try:\n{inner}\nexcept Refused as e:\n    self.a = e.args[0]",
    "try:\n{inner}\nexcept Exception as e:\n    self.make(str(e))",
    "try:\n{inner}\nexcept Refused:\n    self.make(self.a)\n    raise",
    "try:\n{inner}\nfinally:\n    self.make(self.a)",
    "with open('x') as f:\n{inner}",
)
_PLAIN = 8
"""So many statements, the first of them, have no others in them; of those that have to do with exceptions four."""


def _block(random: Random, functions: int, depth: int, *, raising: bool) -> str:
    return "\n".join(_statement(random, functions, depth, raising=raising) for _ in range(random.randint(1, 3)))


def _statement(random: Random, functions: int, depth: int, *, raising: bool) -> str:
    plain, others = _STATEMENTS[:_PLAIN], _STATEMENTS[_PLAIN:]
    if raising:
        plain, others = plain + _RAISING[:4], others + _RAISING[4:]
    chosen = random.choice(plain + others if depth else plain)
    inner = _indented(_block(random, functions, depth - 1, raising=raising), 1) if "{inner}" in chosen else ""

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


def _program(seed: int, *, raising: bool = False) -> str:
    """A node whose callbacks call functions that read and write what it has; a function calls only those before it."""
    random = Random(seed)
    parts = [_HEAD]
    for number in range(3):
        parts.append(
            f"    def f{number}(self, v):\n{_indented(_block(random, number, 2, raising=raising), 2)}\n        return v\n"
        )
    parts += [
        f"    def {name}(self, v='t'):\n{_indented(start + _block(random, 3, 2, raising=raising), 2)}\n"
        for name, start in (("tick", ""), ("hear", "v = v.data\n"))
    ]
    return "\n".join(parts) + _TAIL


def _told(folder: Path, budget: Budget | None = None) -> str:
    result = rosward.extract(folder, budget=budget)
    return network_json(result.network)


@pytest.mark.parametrize("seed", sample(range(24), 8))
def test_the_result_is_that_of_following_all(seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_program(seed), encoding="utf-8")
    found = _told(tmp_path)
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    assert found == _told(tmp_path)


_LITTLE: Final = Budget(steps=30_000, entry_steps=30_000, callback_steps=60_000, entry_coarse=150, loop_steps=150)
"""With it, precision is given up soon."""


@pytest.mark.parametrize("budget", [Budget(), _LITTLE], ids=["usual", "little"])
@pytest.mark.parametrize("seed", sample(range(16), 4))
def test_exceptions_are_those_of_following_all(
    seed: int, budget: Budget, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "main.py").write_text(_program(seed, raising=True), encoding="utf-8")
    found = _told(tmp_path, budget)
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    assert found == _told(tmp_path, budget)


_TRIED = (
    _HEAD
    + """
    def keep(self, name):
        self.a = name
        if random.random() > 0.5:
            raise Refused(name)
        self.a = name + "_done"
        self.b[0]

    def tick(self):
        for name in ["p", "q"] * random.randint(0, 9):
            for number in range(random.randint(0, 9)):
                self.c = self.c + 1
                try:
                    self.keep("left")
                except Refused as e:
                    self.make(e.args[0] + "/refused")
                except IndexError:
                    self.make(self.a)

    def hear(self, msg):
        pass
"""
    + _TAIL
)


@interpreted
def test_a_handler_sees_what_a_recalled_call_wrote(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_TRIED, encoding="utf-8")
    recalls = noted_recalls(monkeypatch)
    found = _told(tmp_path)
    assert any(call.told and call.left_in.written and call.raised for call in recalls)
    assert all(f'"/{name}"' in found for name in ("left_done", "left/refused"))
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


@interpreted
def test_a_call_that_would_do_the_same_is_not_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_REPEATS, encoding="utf-8")
    recalls = noted_recalls(monkeypatch)
    found = _told(tmp_path)
    assert sum(call.effort.steps for call in recalls) > 100
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
