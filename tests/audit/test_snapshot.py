# SPDX-License-Identifier: Apache-2.0
"""The script unites what it sees, and asks rclpy for no more than the oldest one has. Here rclpy is a table."""

from __future__ import annotations

import ast
import enum
import json
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import jsonschema
import pytest

from rosward.audit import snapshot
from rosward.audit.document import snapshot_of
from rosward.audit.snapshot import Observer

from .test_documents import SCHEMAS

STRING = "std_msgs/msg/String"
BARE = ("_CREATED_BY_BARE_DDS_APP_", "_CREATED_BY_BARE_DDS_APP_")


class Policy(enum.Enum):
    RELIABLE = 1
    TRANSIENT_LOCAL = 2
    UNKNOWN = 3


class Profile(NamedTuple):
    reliability: Policy = Policy.RELIABLE
    durability: Policy = Policy.TRANSIENT_LOCAL
    history: Policy = Policy.UNKNOWN
    depth: int = 0


class Endpoint(NamedTuple):
    node_name: str
    node_namespace: str
    topic_type: str
    endpoint_gid: list[int]
    qos_profile: Profile = Profile()


class Humble:
    """The part of a node of rclpy that is asked, over tables. Without enclaves, as the oldest ones are."""

    def __init__(self) -> None:
        self.nodes: list[tuple[str, str]] = [("_own", "/"), ("talker", "/ns")]
        self.publishers = {("talker", "/ns"): [("/chatter", [STRING])]}
        self.servers: dict[tuple[str, str], list[tuple[str, list[str]]]] = {}
        self.by_topic = {"/chatter": [Endpoint("talker", "/ns", STRING, [1])]}
        self.raw: dict[str, dict[str, list[Endpoint]]] = {}

    def get_name(self) -> str:
        return "_own"

    def get_namespace(self) -> str:
        return "/"

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        return self.nodes

    def get_publisher_names_and_types_by_node(self, name: str, space: str) -> list[tuple[str, list[str]]]:
        if name == "gone":
            raise RuntimeError("cannot get what is gone")
        return self.publishers.get((name, space), [])

    def get_subscriber_names_and_types_by_node(self, *_: str) -> list[Any]:
        return []

    def get_service_names_and_types_by_node(self, name: str, space: str) -> list[tuple[str, list[str]]]:
        return self.servers.get((name, space), [])

    def get_client_names_and_types_by_node(self, *_: str) -> list[Any]:
        return []

    def get_topic_names_and_types(self, no_demangle: bool = False) -> list[tuple[str, list[str]]]:
        names = [f"rt{name}" for name in self.by_topic] + list(self.raw) if no_demangle else list(self.by_topic)
        return [(name, []) for name in names]

    def get_publishers_info_by_topic(self, topic: str, no_mangle: bool = False) -> list[Endpoint]:
        return self.raw[topic].get("publishers", []) if no_mangle else self.by_topic[topic]

    def get_subscriptions_info_by_topic(self, topic: str, no_mangle: bool = False) -> list[Endpoint]:
        return self.raw[topic].get("subscriptions", []) if no_mangle else []


class Kilted(Humble):
    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        return [(name, space, f"/enclave/{name}") for name, space in self.nodes]


def document(observer: Observer) -> dict[str, Any]:
    made: dict[str, Any] = observer.document(1.0, {"ros_distro": None})
    jsonschema.validate(made, json.loads((SCHEMAS / "snapshot.schema.json").read_text(encoding="utf-8")))
    snapshot_of(made)
    return made


def looked(robot: Humble, looks: int = 1) -> dict[str, Any]:
    observer = Observer(robot)
    for _ in range(looks):
        observer.look()
    return document(observer)


@pytest.mark.parametrize(("robot", "enclaves"), [(Humble(), []), (Kilted(), ["/enclave/talker"])])
def test_a_node_and_its_topic_without_the_own_node(robot: Humble, enclaves: list[str]) -> None:
    (node,) = looked(robot, 3)["nodes"]
    assert (node["name"], node["namespace"], node["enclaves"], node["seen"], node["count"]) == (
        *("talker", "/ns", enclaves),
        *(3, 1),
    )
    assert node["publishers"] == [
        {
            "name": "/chatter",
            "type": STRING,
            "seen": 3,
            "qos": [{"reliability": "reliable", "durability": "transient_local", "history": None, "depth": None}],
        }
    ]


def test_what_only_sometimes_exists_is_there_with_how_often() -> None:
    robot = Humble()
    observer = Observer(robot)
    observer.look()
    robot.publishers["talker", "/ns"].append(("/late", [STRING]))
    robot.nodes.append(("second", "/"))
    observer.look()
    robot.nodes.remove(("second", "/"))
    observer.look()
    second, talker = document(observer)["nodes"]
    assert (second["name"], second["seen"]) == ("second", 1)
    assert [(e["name"], e["seen"]) for e in talker["publishers"]] == [("/chatter", 3), ("/late", 2)]


def test_a_second_node_of_one_name_is_counted_and_its_topics_are_seen() -> None:
    robot = Humble()
    robot.nodes.append(("talker", "/ns"))
    robot.by_topic["/spy"] = [Endpoint("talker", "/ns", STRING, [9])]
    (node,) = looked(robot)["nodes"]
    assert node["count"] == 2
    assert [e["name"] for e in node["publishers"]] == ["/chatter", "/spy"]


def test_services_of_a_second_node_are_seen_by_their_topics_on_dds() -> None:
    robot = Humble()
    type_ = "std_srvs::srv::dds_::Empty_Request_"
    robot.raw["rq/spyRequest"] = {"subscriptions": [Endpoint("talker", "/ns", type_, [7])]}
    (node,) = looked(robot)["nodes"]
    assert [(e["name"], e["type"]) for e in node["service_servers"]] == [("/spy", "std_srvs/srv/Empty")]


def test_topics_outside_of_ros_and_endpoints_of_no_node() -> None:
    robot = Humble()
    robot.raw["plain"] = {"publishers": [Endpoint("talker", "/ns", "a::msg::dds_::B_", [5])]}
    robot.raw["ros_discovery_info"] = {"publishers": [Endpoint(*BARE, "x", [6])]}
    robot.by_topic["/spy"] = [Endpoint(*BARE, STRING, [8])]
    made = looked(robot)
    (node,) = made["nodes"]
    assert [(e["name"], e["type"], e.get("ros_prefix")) for e in node["publishers"]] == [
        ("/chatter", STRING, None),
        ("plain", "a/msg/B", False),
    ]
    assert [(e["kind"], e["name"]) for e in made["without_node"]] == [("publishers", "/spy")]


def test_an_endpoint_whose_node_is_only_told_later_is_not_of_no_node() -> None:
    robot = Humble()
    robot.by_topic["/chatter"] = [Endpoint(*BARE, STRING, [1])]
    observer = Observer(robot)
    observer.look()
    robot.by_topic["/chatter"] = [Endpoint("talker", "/ns", STRING, [1])]
    observer.look()
    assert document(observer)["without_node"] == []


def test_a_node_that_has_just_gone_is_told() -> None:
    robot = Humble()
    robot.nodes.append(("gone", "/"))
    made = looked(robot)
    assert [(n["name"], n["asked"]) for n in made["nodes"]] == [("gone", 0), ("talker", 1)]
    assert made["problems"] == ["node gone in /: cannot get what is gone"]


def test_an_action_is_where_its_service_for_goals_is() -> None:
    robot = Humble()
    robot.servers["talker", "/ns"] = [("/fib/_action/send_goal", ["test_msgs/action/Fibonacci_SendGoal"])]
    (node,) = looked(robot)["nodes"]
    assert [(e["name"], e["type"]) for e in node["action_servers"]] == [("/fib", "test_msgs/action/Fibonacci")]


def test_the_script_stands_alone() -> None:
    """It imports the standard library and rclpy, in the language of Python 3.8, and says what it lacks."""
    path = Path(snapshot.__file__)
    tree = ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 8))
    imported = {a.name.partition(".")[0] for n in ast.walk(tree) if isinstance(n, ast.Import) for a in n.names}
    imported |= {str(n.module).partition(".")[0] for n in ast.walk(tree) if isinstance(n, ast.ImportFrom)}
    assert imported - set(sys.stdlib_module_names) == {"rclpy"}
    run = subprocess.run(
        [sys.executable, "-I", "-c", "import sys; sys.modules['rclpy'] = None; import runpy; sys.argv = ['s', '-o', '-'];"
         f"runpy.run_path({str(path)!r}, run_name='__main__')"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr == "snapshot: rclpy cannot be imported: source the setup file of ROS 2 first\n"
