# SPDX-License-Identifier: Apache-2.0
"""What the marks of stubs say: of rosward's own, and of a client library that only the user describes."""

from __future__ import annotations

from pathlib import Path

import pytest

import rosward
from rosward.engine.libraries.stub_files import STUBS
from rosward.findings import Finding
from rosward.models.facts import LibraryFacts, marked
from rosward.models.ros.facts import OWN

MINI_ROS = """
from _rosward import asks_all, before_sources, create, create_node, creates, creator, node_class, node_method, precise, raises_nothing, schedule

asks_all(__name__)
before_sources(__name__)
raises_nothing(__name__)
precise("announce")


@node_class
class Component:
    def __init__(self, name):
        create_node(self, name)

    @creates("publisher", name="topic", type="msg_type")
    def advertise(self, msg_type, topic): ...

    @node_method
    def every(self, seconds, callback):
        schedule(callback, event="timer")


@creator
class Mirror:
    def __init__(self, component, topic):
        create("subscription", component, topic, None)


def run(component): ...
"""
ROBOT = """
from std_msgs.msg import String
from mini_ros import Component, Mirror


class Robot(Component):
    def __init__(self):
        super().__init__('robot')
        self.advertise(String, 'state')

    def later(self):
        self.advertise(String, 'never')

    def mirrored(self):
        return Mirror(self, 'copy')


class Alone(Component):
    def __init__(self):
        super().__init__('alone')
        self.every(1.0, self.tick)

    def tick(self):
        self.advertise(String, 'ticks')


if __name__ == '__main__':
    Robot()
"""
ON_UNKNOWN_BASE = """
from std_msgs.msg import String
from not_there import Base


class Driver(Base):
    def __init__(self):
        super().__init__()
        self.advertise(String, 'driven')


Driver()
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    for name, text in (
        ("models/mini_ros/__init__.pyi", MINI_ROS),
        ("src/robot.py", ROBOT),
        ("src/driver.py", ON_UNKNOWN_BASE),
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def made(result: rosward.Result) -> set[tuple[str, str]]:
    return {(node.fqn, e.name) for node in result.network.nodes for e in node.entities}


def told(result: rosward.Result, code: str) -> list[tuple[str, int]]:
    return [(Path(f.place.file).name, f.place.line) for f in result.network.findings if f.code == code]


def test_what_is_written_down_is_what_the_marks_of_the_stubs_say() -> None:
    assert marked(STUBS) == OWN


def test_what_marks_say(project: Path) -> None:
    assert marked(project / "models") == LibraryFacts(
        node_classes=frozenset({"mini_ros.Component"}),
        node_methods=frozenset({"advertise", "every"}),
        creating=frozenset({"advertise"}),
        creators=frozenset({("Mirror", "mini_ros")}),
        precise=("announce",),
        raising_nothing=frozenset({"mini_ros"}),
        asking=frozenset({"mini_ros"}),
        before_sources=frozenset({"mini_ros"}),
    )


def test_nodes_of_another_client_library(project: Path) -> None:
    """`Robot` is made by the program; nothing makes `Alone`, which is assumed to be started, as a node class of rclpy is."""
    result = rosward.extract(project / "src", models=[project / "models"])
    assert {("/robot", "/state"), ("/alone", "/ticks")} <= made(result)
    assert not {("/robot", "/never"), ("/robot", "/copy")} & made(result)


def test_what_no_process_reaches_is_told(project: Path) -> None:
    result = rosward.extract(project / "src", models=[project / "models"])
    assert told(result, "RW205") == [("robot.py", 12), ("robot.py", 15)]


def test_what_only_nodes_have_makes_a_node(project: Path) -> None:
    """The base is not among the sources; nothing but a node has an `advertise`, so the Driver is one."""
    result = rosward.extract(project / "src", models=[project / "models"])
    assert ("driver.py", 9) in told(result, "RW204")
    assert any(e.name.endswith("driven") for node in result.network.nodes for e in node.entities)


def test_without_its_stub_nothing_is_known_of_it(project: Path) -> None:
    assert rosward.extract(project / "src").network.nodes == ()


@pytest.mark.parametrize("text", ["@node_class\nclass A(:", "creates\n" + "(" * 5000, "\0creates", "# creates \udcff"])
def test_what_cannot_be_read_says_nothing(tmp_path: Path, text: str) -> None:
    (tmp_path / "a.pyi").write_bytes(text.encode("utf-8", "surrogateescape"))
    (tmp_path / "b.pyi").write_text("@creator\ndef make(): ...\n")
    assert marked(tmp_path) == LibraryFacts(creators=frozenset({("make", "b")}))


def test_marks_do_nothing_to_what_they_stand_on(project: Path) -> None:
    assert not [f for f in rosward.extract(project / "src", models=[project / "models"]).network.findings if is_ours(f)]


def is_ours(finding: Finding) -> bool:
    return finding.place.file.startswith("models:")
