# SPDX-License-Identifier: Apache-2.0
"""Callbacks that have nothing new to read are not run again, whatever else the program makes in the meantime."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Final

import pytest
from compiled import interpreted

import rosward
from rosward.engine.callbacks import schedule
from rosward.engine.machine import Engine
from rosward.engine.running.scheduled import Scheduled
from rosward.outputs.documents.network_json import network_json

_THREADS: Final = """
import threading
import rclpy
from rclpy.node import Node

def work(name):
    print(name)

def main():
    rclpy.init()
    for number in range(30):
        threading.Thread(target=work, args=(f"thread {number}",)).start()
        node = Node(f"node_{number}")
        rclpy.spin_once(node)

main()
"""
_ASKING: Final = """
import rclpy
from rclpy.node import Node

rclpy.init()
node = Node("first")
def tick():
    node.create_publisher(String, node.get_name() + "/state", 1)
from std_msgs.msg import String
node.create_timer(1.0, tick)
for number in range(3):
    rclpy.spin_once(node)
    node = Node(f"node_{number}")
rclpy.spin(node)
"""


@interpreted
def test_a_new_node_makes_no_callback_run_again_that_asks_for_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    runs: list[str] = []
    call = schedule._call

    def noted(machine: Engine, entry: Scheduled) -> None:
        runs.append(entry.event)
        call(machine, entry)

    monkeypatch.setattr(schedule, "_call", noted)
    (tmp_path / "main.py").write_text(_THREADS, encoding="utf-8")
    found = rosward.extract(tmp_path).network
    assert len(found.nodes) == 30
    assert runs.count("thread") <= 30 * 4


def test_one_that_asks_for_a_node_runs_again_where_that_is_another_one(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text(_ASKING, encoding="utf-8")
    found = rosward.extract(tmp_path).network
    names = {topic["name"] for topic in json.loads(network_json(found))["topics"]}
    assert {"/first/state", "/node_0/state", "/node_1/state", "/node_2/state"} <= names
