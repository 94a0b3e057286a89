# SPDX-License-Identifier: Apache-2.0
"""Promise: a snapshot of real processes has no difference from their source; a node more, and an entity less, are just what is told.

The programs run as a person runs them, each in a process of its own, on this machine alone; the snapshot is taken by the plain script, as
on a robot where rosward is not installed.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

import pytest

pytest.importorskip("rclpy")

from rosward.audit import snapshot
from rosward.audit.accepted import Accepted
from rosward.audit.compare import audit
from rosward.audit.document import read_snapshot
from rosward.audit.result import Audit
from rosward.pipeline import extract
from rosward.rules import Severity

SCRIPT: Final = Path(snapshot.__file__)
PATIENCE: Final = 300.0

ROBOT: Final = """\
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.qos import QoSDurabilityPolicy, QoSProfile
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci

rclpy.init()
base = rclpy.create_node("base", namespace="robot")
base.create_publisher(String, "map", QoSProfile(depth=1, durability=QoSDurabilityPolicy.TRANSIENT_LOCAL))
base.create_publisher(String, "outside", QoSProfile(depth=1, avoid_ros_namespace_conventions=True))
base.create_subscription(String, "cmd", print, 10)
base.create_service(Trigger, "~/stop", print)
ActionServer(base, Fibonacci, "drive", print)
pilot = rclpy.create_node("pilot", use_global_arguments=False)
ActionClient(pilot, Fibonacci, "/robot/drive")
pilot.create_client(Trigger, "/robot/base/stop")
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(base)
executor.add_node(pilot)
print("ready", flush=True)
executor.spin()
"""
ROGUE: Final = """\
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("rogue")
node.create_subscription(String, "/robot/cmd", print, 10)
print("ready", flush=True)
rclpy.spin(node)
"""


@contextmanager
def running(folder: Path, **programs: str) -> Iterator[dict[str, str]]:
    """The programs, all of which have come so far as to say that they are ready; the environment in which they run."""
    environment = {
        **os.environ,
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_DOMAIN_ID": str(os.getpid() % 100 + 1),
        "ROS_LOG_DIR": str(folder / "log"),
        "ROS_DISTRO": "kilted",
    }
    processes: list[subprocess.Popen[str]] = []
    try:
        for name, text in programs.items():
            file = folder / f"{name}.py"
            file.write_text(text, encoding="utf-8")
            processes.append(
                subprocess.Popen([sys.executable, str(file)], env=environment, stdout=subprocess.PIPE, text=True)
            )
        for process in processes:
            assert process.stdout is not None
            assert process.stdout.readline() == "ready\n"
        yield environment
    finally:
        for process in processes:
            process.send_signal(signal.SIGKILL)
            process.wait()
            if process.stdout is not None:
                process.stdout.close()


def snapshot_of(folder: Path, environment: dict[str, str], nodes: int) -> Path:
    """A snapshot in which all nodes were seen in several looks: how long discovery takes depends on the machine."""
    file = folder / "robot.json"
    end = time.monotonic() + PATIENCE
    while True:
        subprocess.run(
            [sys.executable, "-I", str(SCRIPT), "-o", str(file), "--seconds", "4"], env=environment, check=True
        )
        seen = [node for node in read_snapshot(str(file)).nodes if node.seen > 2]
        if len(seen) >= nodes or time.monotonic() > end:
            return file


def compared(source: Path, seen: Path) -> Audit:
    result = extract(source, distro="kilted")
    errors = {f.code for f in result.findings if f.rule.severity is Severity.ERROR}
    assert errors <= {"RW305"}, result.findings  # a topic for which no policy has words
    return audit(result.network.nodes, result.findings, read_snapshot(str(seen)), Accepted())


def test_real_processes_do_what_their_source_says(tmp_path: Path) -> None:
    with running(tmp_path, robot=ROBOT) as environment:
        seen = snapshot_of(tmp_path, environment, 2)
    found = compared(tmp_path / "robot.py", seen)
    assert [d.finding.message for d in found.differences] == []
    assert found.clean
    assert found.nodes == (2, 2, 0)
    assert read_snapshot(str(seen)).distro == "kilted"


def test_a_rogue_node_and_a_lost_entity_are_just_what_is_told(tmp_path: Path) -> None:
    lost = ROBOT.replace('base.create_subscription(String, "cmd", print, 10)\n', "")
    with running(tmp_path, robot=lost, rogue=ROGUE) as environment:
        seen = snapshot_of(tmp_path, environment, 3)
    (tmp_path / "robot.py").write_text(ROBOT, encoding="utf-8")
    found = compared(tmp_path / "robot.py", seen)
    assert [(d.finding.code, d.node, d.entity) for d in found.differences] == [
        ("RW503", "/robot/base", "subscription /robot/cmd"),
        ("RW501", "/rogue", ""),
    ]
    assert str(found.differences[0].finding.place) == "robot.py:12"
    assert "it has subscription /robot/cmd, " in found.differences[1].finding.message


def test_a_second_node_under_a_known_name_does_not_hide(tmp_path: Path) -> None:
    """It is counted, and what it has is seen, though rclpy tells by name of one of them only."""
    twin = ROGUE.replace('"rogue"', '"base", namespace="robot"').replace("/robot/cmd", "/secret")
    with running(tmp_path, robot=ROBOT, twin=twin) as environment:
        seen = snapshot_of(tmp_path, environment, 2)
    found = compared(tmp_path / "robot.py", seen)
    assert [(d.finding.code, d.node, d.entity) for d in found.differences] == [
        ("RW501", "/robot/base", ""),
        ("RW502", "/robot/base", "subscription /secret"),
    ]


def test_another_qos_is_told(tmp_path: Path) -> None:
    other = ROBOT.replace("TRANSIENT_LOCAL", "VOLATILE")
    with running(tmp_path, robot=other) as environment:
        seen = snapshot_of(tmp_path, environment, 2)
    (tmp_path / "robot.py").write_text(ROBOT, encoding="utf-8")
    (difference,) = compared(tmp_path / "robot.py", seen).differences
    assert difference.finding.message == (
        "publisher /robot/map of /robot/base has durability volatile, but the source says transient_local"
    )


def test_the_command_looks_at_the_graph_by_itself(tmp_path: Path) -> None:
    with running(tmp_path, robot=ROBOT) as environment:
        snapshot_of(tmp_path, environment, 2)
        command = [sys.executable, "-m", "rosward", "audit", "robot.py", "--seconds", "8"]
        paths = os.pathsep.join(p for p in sys.path if p)
        run = subprocess.run(
            command, cwd=tmp_path, env={**environment, "PYTHONPATH": paths}, capture_output=True, text=True, check=False
        )
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.endswith("The source explains everything that runs, and everything it expects is running.\n")
