# SPDX-License-Identifier: Apache-2.0
"""Copies of copies are finitely many: a program that keeps what it was, and goes back to it, comes to rest."""

from __future__ import annotations

from pathlib import Path

import pytest

import rosward
from rosward.engine import interpreter
from rosward.engine.interpreter import Interpreter

EDITOR = """
from copy import COPY

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Part:
    def __init__(self, name):
        self.name = name


class State:
    def __init__(self, name):
        self.name = name
        self.parts = [Part('arm'), Part('leg')]


class Editor(Node):
    def __init__(self):
        super().__init__('editor')
        self.state = State('start')
        self.steps = []
        self.undone = []
        for name in ('add', 'move', 'undo', 'redo'):
            self.create_subscription(String, name, getattr(self, 'on_' + name), 10)

    def save(self):
        self.steps.append((COPY(self.state), 'step'))

    def on_add(self, msg):
        self.save()
        self.state.parts.append(Part('hand'))

    def on_move(self, msg):
        self.save()
        self.state.name = 'moved'

    def on_undo(self, msg):
        state, _ = self.steps.pop()
        self.undone.append(COPY(self.state))
        self.state = state

    def on_redo(self, msg):
        self.save()
        self.state = self.undone.pop()
        for part in self.state.parts:
            self.create_publisher(String, self.state.name + '_' + part.name, 10)


def main():
    rclpy.init()
    rclpy.spin(Editor())


if __name__ == '__main__':
    main()
"""
TWO = """
from copy import deepcopy

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Part:
    def __init__(self, name):
        self.name = name


class Pair(Node):
    def __init__(self):
        super().__init__('pair')
        first = Part('first')
        second = deepcopy(first)
        second.name = 'second'
        one, other = deepcopy([first, second])
        one.name = 'left'
        self.create_publisher(String, one.name, 10)
        self.create_publisher(String, other.name, 10)


def main():
    rclpy.init()
    rclpy.spin(Pair())


if __name__ == '__main__':
    main()
"""

IN_TURN = """
from copy import copy

import rclpy
from std_msgs.msg import String
from numpy import vstack

found = []


def on_point(msg):
    global found
    found = vstack((found, [msg.data])) if found else [[msg.data]]


def main():
    global found
    rclpy.init()
    node = rclpy.create_node('filter')
    node.create_subscription(String, 'points', on_point, 10)
    while len(found) < 1:
        rclpy.spin_once(node)
    while rclpy.ok():
        kept = []
        front = copy(found)
        if len(front) > 1:
            kept = fitted(front)
        if len(front) == 1:
            kept = front
        found = copy(kept)
        rclpy.spin_once(node)
    node.create_publisher(String, 'last', 10)


if __name__ == '__main__':
    main()
"""


def published(folder: Path, source: str) -> set[str]:
    """What a program publishes of its own."""
    (folder / "editor.py").write_text(source, encoding="utf-8")
    network = rosward.extract(folder).network
    assert [f.code for f in network.findings if f.code == "RW201"] == []
    return {entity.name for node in network.nodes for entity in node.entities if entity.type == "std_msgs/msg/String"}


@pytest.mark.parametrize(("function", "most"), [("deepcopy", 600), ("copy", 600)])
def test_a_history_comes_to_rest(function: str, most: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each callback copies what another one copied: the objects are as many as the places that copy, not as the ways from one to another."""
    machines: list[Interpreter] = []
    note = interpreter.Interpreter.note_creation

    def noted(machine: Interpreter, *, new: bool, exact: bool, key: object = None) -> None:
        machines.append(machine)
        note(machine, new=new, exact=exact, key=key)

    monkeypatch.setattr(interpreter.Interpreter, "note_creation", noted)
    found = published(tmp_path, EDITOR.replace("COPY", function))
    assert {"/start_arm", "/start_hand", "/moved_leg"} <= found
    assert sum(1 for _ in machines[-1].state.heap.items()) < most


def test_two_copies_of_one_object_in_one_call_are_told_apart(tmp_path: Path) -> None:
    """An object, and a copy of it, are copied together."""
    assert published(tmp_path, TWO) == {"/left", "/second"}


def test_copies_that_a_loop_makes_of_one_another_come_to_rest(tmp_path: Path) -> None:
    """A copy may be of any of several lists, some of which are copies."""
    assert published(tmp_path, IN_TURN) == {"/points", "/last"}
