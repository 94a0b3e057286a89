# SPDX-License-Identifier: Apache-2.0
"""Steps of generators that are not followed again, and generators inside one another without end: the result is that of following them."""

from __future__ import annotations

from pathlib import Path
from random import Random
from typing import Final

import pytest
from sampling import sample

import rosward
from rosward.engine.budget import Budget
from rosward.engine.calls import recalled
from rosward.outputs.documents.network_json import network_json

_HEAD: Final = """
import itertools
import random
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class N(Node):
    def __init__(self):
        super().__init__("n")
        self.a, self.b, self.c = "a", ["x", "y"], 0
        self.kept = self.g0("k")
        self.create_timer(1.0, self.tick)
        self.create_subscription(String, "in", self.hear, 10)

    def make(self, name):
        self.create_publisher(String, name, 10)
        return name
"""
_TAIL: Final = """
rclpy.init()
rclpy.spin(N())
"""
_VALUES: Final = ("self.a", "self.b[0]", "v", "v + 'z'", "self.make(v)", "next(self.kept, 'over')")
_PLAIN: Final = (
    "self.a = {value}",
    "self.c += 1",
    "self.b = [{value}]",
    "v = {value}",
    "self.make({value})",
)
_AROUND: Final = (
    "if random.random() > 0.5:\n{inner}",
    "for v in self.b:\n{inner}",
    "for v in self.g{n}(v):\n{inner}",
    "for v in itertools.chain(self.b, self.g{n}(v)):\n{inner}",
    "self.kept = self.g{n}({value})\nfor v in self.kept:\n{inner}",
    "try:\n{inner}\nfinally:\n    self.make(self.a)",
)
_YIELDING: Final = (
    "yield {value}",
    "yield from self.g{n}({value})",
    "if random.random() > 0.5:\n    return {value}",
    "v = yield {value}",
)


def _block(random: Random, known: range, depth: int, plain: tuple[str, ...]) -> str:
    return "\n".join(_statement(random, known, depth, plain) for _ in range(random.randint(1, 3)))


def _statement(random: Random, known: range, depth: int, plain: tuple[str, ...]) -> str:
    chosen = random.choice(plain + _AROUND if depth else plain)
    if "{n}" in chosen and not known:
        return "self.c += 1"
    if "{inner}" in chosen:
        chosen = chosen.replace("{inner}", _indented(_block(random, known, depth - 1, plain), 1))
    for _ in range(chosen.count("{value}")):
        chosen = chosen.replace("{value}", random.choice(_VALUES), 1)
    return chosen.replace("{n}", str(random.choice(known))) if known else chosen


def _indented(text: str, depth: int) -> str:
    return "\n".join("    " * depth + line for line in text.splitlines())


def _program(seed: int) -> str:
    """A node whose callbacks advance generators, which advance those before them."""
    random = Random(seed)
    parts = [_HEAD]
    for number in range(3):
        body = f"{_block(random, range(number), 1, _PLAIN + _YIELDING)}\nyield {random.choice(_VALUES)}"
        parts.append(f"    def g{number}(self, v):\n{_indented(body, 2)}\n")
    for name, start in (("tick", ""), ("hear", "v = v.data\n")):
        parts.append(f"    def {name}(self, v='t'):\n{_indented(start + _block(random, range(3), 2, _PLAIN), 2)}\n")
    return "\n".join(parts) + _TAIL


def _told(folder: Path) -> str:
    return network_json(rosward.extract(folder).network)


@pytest.mark.parametrize("seed", sample(range(24), 4))
def test_the_result_is_that_of_following_all(seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "main.py").write_text(_program(seed), encoding="utf-8")
    found = _told(tmp_path)
    assert "RW201" not in found
    monkeypatch.setattr(recalled, "place_of", lambda *_: None)
    assert found == _told(tmp_path)


_TREE: Final = (
    """
import itertools
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Symbol:
    def __init__(self, name):
        self.name = name

    def __iter__(self):
        for each in [self]:
            yield each

class Pair:
    def __init__(self, left, right):
        self.left, self.right = left, right

    def __iter__(self):
        for each in {around}:
            yield each

def parse(tokens):
    token = tokens.pop()
    if token == "(":
        return Pair(parse(tokens), parse(tokens))
    return Symbol(token)

class N(Node):
    def __init__(self):
        super().__init__("n")
        for each in parse(input().split()):
            if isinstance(each, Symbol):
                self.create_publisher(String, "of/" + each.name, 10)
            else:
                self.create_service_of(each)

    def create_service_of(self, pair):
        self.create_subscription(String, "pair", print, 10)
"""
    + _TAIL
)


@pytest.mark.slow
@pytest.mark.parametrize(
    "around",
    ["itertools.chain([self], self.left, self.right)", "[self, *self.left, *self.right]"],
    ids=["chain", "list"],
)
def test_a_tree_that_iterates_over_itself_is_found_whole(around: str, tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text(_TREE.replace("{around}", around), encoding="utf-8")
    network = rosward.extract(tmp_path, budget=Budget(steps=60_000)).network
    assert "RW201" not in {each.code for each in network.findings}
    assert {"/of/*", "/pair"} <= {str(topic.name) for topic in network.topics}
