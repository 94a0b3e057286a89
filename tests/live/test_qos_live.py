# SPDX-License-Identifier: Apache-2.0
"""Promise: RW309 is told of exactly those publishers and subscriptions between which, under the real rclpy, no message passes because of QoS.

Two nodes talk over one topic, with every pair of reliability and durability. The program below is read by rosward and run by rclpy.
"""

from __future__ import annotations

import itertools
import os
import time
from pathlib import Path
from typing import Any

import pytest

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
rclpy = pytest.importorskip("rclpy")
SingleThreadedExecutor = pytest.importorskip("rclpy.executors").SingleThreadedExecutor
Empty = pytest.importorskip("std_msgs.msg").Empty

import rosward  # noqa: E402

PROGRAM = """\
import rclpy
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Empty


def main(heard=None, clashed=None, context=None):
    rclpy.init(context=context)
    talker, listener = Node("talker", context=context), Node("listener", context=context)
    offered = QoSProfile(depth=5, reliability=ReliabilityPolicy.{}, durability=DurabilityPolicy.{})
    requested = QoSProfile(depth=5, reliability=ReliabilityPolicy.{}, durability=DurabilityPolicy.{})
    events = SubscriptionEventCallbacks(incompatible_qos=clashed)
    publisher = talker.create_publisher(Empty, "/rosward_qos", offered)
    listener.create_subscription(Empty, "/rosward_qos", heard, requested, event_callbacks=events)
    return talker, listener, publisher


if __name__ == "__main__":
    main()
"""
POLICIES = list(itertools.product(("BEST_EFFORT", "RELIABLE"), ("VOLATILE", "TRANSIENT_LOCAL")))
PATIENCE = 300.0


def told(folder: Path, program: str) -> bool:
    (folder / "program.py").write_text(program, encoding="utf-8")
    network = rosward.extract(folder, distro="kilted").network
    assert [topic.name for topic in network.topics if not topic.system] == ["/rosward_qos"]
    return "RW309" in {finding.code for finding in network.findings}


def happens(program: str) -> set[str]:
    """What comes first: a message, or the event that the two are not compatible."""
    seen: set[str] = set()
    names: dict[str, Any] = {"__name__": "program"}
    exec(compile(program, "program.py", "exec"), names)
    context = rclpy.Context()
    *nodes, publisher = names["main"](lambda _: seen.add("message"), lambda _: seen.add("incompatible"), context)
    try:
        executor = SingleThreadedExecutor(context=context)
        for node in nodes:
            executor.add_node(node)
        end = time.monotonic() + PATIENCE
        while not seen and time.monotonic() < end:
            publisher.publish(Empty())
            executor.spin_once(timeout_sec=0.05)
    finally:
        for node in nodes:
            node.destroy_node()
        context.try_shutdown()
    return seen


@pytest.mark.parametrize(("offered", "requested"), list(itertools.product(POLICIES, POLICIES)), ids=str)
def test_what_never_talks_is_told(offered: tuple[str, str], requested: tuple[str, str], tmp_path: Path) -> None:
    program = PROGRAM.format(*offered, *requested)
    assert happens(program) == ({"incompatible"} if told(tmp_path, program) else {"message"})
