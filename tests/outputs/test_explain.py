# SPDX-License-Identifier: Apache-2.0
"""What `rosward explain` tells: of the delivery robot in `examples/`, of a program with unknown names, and of hand-made networks."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from rosward.cli import main
from rosward.domain.unknown import Cause, Reason
from rosward.explanation.answers import explained
from rosward.explanation.provenance import remedies
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.documents.explain_json import explain_json
from rosward.outputs.terminal.explain import explain_text
from rosward.ros.entities import Resolution

from .networks import node, pub, sub, talker_and_listener

pytestmark = pytest.mark.usefixtures("remembered")

EXAMPLES = Path(__file__).parents[2] / "examples"
FLEET = ("--launch", "delivery_bringup:fleet.launch.py")
BASE = "delivery_robot/delivery_base/delivery_base"
ROBOT = "delivery_robot/delivery_bringup/launch/robot.launch.py"
OTHERWISE = "use a constant or a parameter with a default, or accept the wildcard in the policy"

UNKNOWN = """\
import os
import sys

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.declare_parameter("topic", rclpy.Parameter.Type.STRING)
        self.declare_parameter("limit", float("nan"))
        topic = self.get_parameter("topic").value
        self.create_publisher(String, f"/robot/{topic}/state", 10)
        self.create_publisher(String, sys.argv[1], 10)
        self.create_publisher(String, "/from/" + os.environ["SIDE"], 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())


main()
"""


@pytest.fixture
def unknown(tmp_path: Path) -> Path:
    """A program with a name of which a parameter, an argument and a variable are missing."""
    (tmp_path / "talker.py").write_text(UNKNOWN, encoding="utf-8")
    return tmp_path


class Explain:
    """Runs the command; the text of an answer, or its JSON."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self._capsys = capsys

    def __call__(self, name: str, path: Path = EXAMPLES, *more: str, status: int = 0) -> str:
        assert main(["explain", name, str(path), *more]) == status
        return self._capsys.readouterr().out

    def json(self, name: str, path: Path = EXAMPLES, *more: str, status: int = 0) -> Any:
        return json.loads(self(name, path, *more, "--json", status=status), parse_constant=pytest.fail)


@pytest.fixture
def explain(capsys: pytest.CaptureFixture[str]) -> Explain:
    return Explain(capsys)


def of(network: Network, name: str) -> str:
    """The text for a network without sources."""
    return explain_text(explained(network, name, Path("/nowhere")))


def rows(text: str, word: str) -> list[str]:
    """The rows of one kind: rows("  node      /talker", "node") is ["/talker"]."""
    return re.findall(rf"^  {word} +(.*)$", text, re.MULTILINE)


def test_a_topic_with_its_two_ends(explain: Explain) -> None:
    text = explain("/porter/battery")
    assert text.startswith(
        "topic /porter/battery  sensor_msgs/msg/BatteryState\n  1 publisher     /porter/base_driver\n"
    )
    publisher, subscription = text.split("\nsubscription of ")
    assert "publisher of /porter/base_driver\n" in publisher
    assert rows(publisher, "created") == [f"{BASE}/base_driver.py:31"]
    assert "> 31 │         self._battery = self.create_publisher(BatteryState, 'battery', SENSOR)" in publisher
    assert rows(publisher, "name") == ["exact: determined by the code alone"]
    assert rows(publisher, "started") == ["ros2 run delivery_base base_driver"]
    assert rows(publisher, "policy") == [
        'enclave /porter/base_driver: <topics publish="ALLOW"> <topic>/porter/battery</topic>'
    ]
    assert rows(subscription, "callback") == ["BatteryMonitor._on_state"]
    assert rows(subscription, "name") == ["default: holds unless it is set from outside"]
    assert rows(subscription, "made of") == [f"parameter input = 'battery': its default ({BASE}/battery_monitor.py:19)"]


def test_the_same_topic_by_the_end_of_its_name(explain: Explain) -> None:
    assert explain("battery") == explain("/porter/battery") == explain("porter/battery/")


def test_a_remapped_name_with_many_nodes(explain: Explain) -> None:
    """Thirteen nodes in Python inherit the line, eight in C++ have a template in common: each is told once, with the launch of each."""
    text = explain("/fleet/heartbeat", EXAMPLES, *FLEET)
    assert "  21 publishers   /porter1/base_driver, " in text
    assert text.count("create_publisher(Header, f'/{ROBOT}/heartbeat', 10)") == 1
    assert set(rows(text, "remap")) == {"/porter/heartbeat → /fleet/heartbeat  (remap rule of the launch file)"}
    assert re.search(rf"/porter1/base_driver +delivery_base/base_driver, launched at {ROBOT}:54, included at", text)
    assert "  … and 1 more (--json has all)" in text
    ends = explain.json("/fleet/heartbeat", EXAMPLES, *FLEET)["meetings"][0]["ends"]
    assert len([end for end in ends if end["remaps"]]) == 21


def test_a_name_from_the_parameter_of_a_launch_file(explain: Explain) -> None:
    text = explain("/porter1/eye/image_raw", EXAMPLES, *FLEET)
    subscription = text[text.index("subscription of /porter1/dock_detector") :].split("\n\n")[0]
    assert rows(subscription, "by") == ["message_filters.Subscriber"]
    assert rows(subscription, "name") == ["bound: set from outside"]
    assert rows(subscription, "made of") == [f"parameter camera = 'eye': set in the launch file ({ROBOT}:77)"]


def test_a_name_from_a_parameter_file(explain: Explain) -> None:
    text = explain("/porter1/battery", EXAMPLES, *FLEET)
    file = "$(find-pkg-share delivery_bringup)/config/robot.yaml"
    assert rows(text, "made of") == [f"parameter input = 'battery': set from outside; the launch passes {file}"]


@pytest.mark.slow
def test_a_value_that_is_not_of_the_launch_is_not_said_to_be(explain: Explain, tmp_path: Path) -> None:
    """`--params` goes over what the launch passes."""
    file = tmp_path / "more.yaml"
    file.write_text("/**:\n  ros__parameters: {input: other, camera: ear}\n", encoding="utf-8")
    text = explain("/porter1/other", EXAMPLES, *FLEET, "--params", str(file))
    assert "parameter input = 'other': set from outside; the launch passes " in text
    text = explain("/porter1/ear/image_raw", EXAMPLES, *FLEET, "--params", str(file))
    over = "set from outside, overriding or in addition to the launch file"
    assert rows(text, "made of") == [f"parameter camera = 'ear': {over} ({ROBOT}:77)"]


def test_a_name_known_in_part_what_is_missing_and_how_to_supply_it(explain: Explain, unknown: Path) -> None:
    """A full name asks for the names with a hole that it may be, too."""
    text = explain("/robot/left/state", unknown)
    assert text.startswith("topic /robot/*/state  std_msgs/msg/String\n")
    assert rows(text, "name") == ["pattern: partially known"]
    assert rows(text, "missing") == ["parameter without a value: topic (talker.py:12)"]
    assert rows(text, "supply") == [
        "give the parameter a default, or a value with --params FILE.yaml or in the launch file"
    ]
    assert rows(text, "policy") == ['enclave /talker: <topics publish="ALLOW"> <topic>/robot/*/state</topic>']


def test_what_is_told_to_supply_makes_the_name_known(explain: Explain, unknown: Path) -> None:
    (unknown / "p.yaml").write_text("/**:\n  ros__parameters: {topic: left}\n", encoding="utf-8")
    text = explain("/robot/left/state", unknown, "--params", str(unknown / "p.yaml"))
    assert text.startswith("topic /robot/left/state ")
    assert rows(text, "name") == ["bound: set from outside"]
    assert rows(text, "made of") == ["parameter topic = 'left': set from outside"]


def test_the_unknown_name(explain: Explain, unknown: Path) -> None:
    """`/*` is what the graph calls a name of which nothing is known: it means those names, not every name."""
    text = explain("/*", unknown)
    assert text.count("\npublisher of /talker\n") == 1
    assert rows(text, "created")[0] == "talker.py:16"
    assert rows(text, "name") == ["unknown: cannot be determined"]
    assert rows(text, "missing") == ["command-line argument: sys.argv"]
    assert rows(text, "supply") == [
        "give the argument a default, or analyse the launch file that passes it (--launch FILE)"
    ]
    assert rows(text, "policy") == ["enclave /talker: no rule: unknown name"]


def test_the_names_that_end_in_an_unknown_part(explain: Explain, unknown: Path) -> None:
    text = explain("*", unknown)
    assert re.findall(r"^topic (\S+)", text, re.MULTILINE) == ["/*", "/from/*"]
    assert rows(text, "missing")[1] == "environment variable: SIDE (talker.py:17)"


def test_the_unknown_name_in_a_policy_with_wildcards(explain: Explain, unknown: Path) -> None:
    text = explain("/*", unknown, "--unknown", "wildcard")
    assert rows(text, "policy") == ['enclave /talker: <topics publish="ALLOW"> <topic>/*</topic>']


def test_no_full_name_is_said_to_be_the_unknown_one(explain: Explain, unknown: Path) -> None:
    """It may be any: as an answer to `/else` it would say nothing."""
    assert "no name in the result" in explain("/else", unknown, status=1)


def test_the_causes_that_have_a_remedy_of_their_own() -> None:
    """A remedy is found by the words that its cause begins with: they are those of `Cause`."""
    own = {c: remedies([str(Reason(c, "it", Place("a.py", 1)))]) for c in Cause}
    special = {cause for cause, told in own.items() if told != (OTHERWISE,)}
    assert special == {
        Cause.PARAMETER,
        Cause.ARGUMENT,
        Cause.LAUNCH_ARGUMENT,
        Cause.ENVIRONMENT,
        Cause.SET,
        Cause.MODULE,
        Cause.CALL,
        Cause.CALLER,
    }
    assert own[Cause.SET] == own[Cause.ENVIRONMENT]  # it is set there too
    assert len({own[cause] for cause in special}) == len(special) - 1


def test_a_remedy_is_told_once() -> None:
    reasons = [str(Reason(Cause.LAUNCH_ARGUMENT, name, Place("a.launch.py", 1))) for name in ("left", "right")]
    assert remedies([*reasons, "something else"]) == ("--arg NAME:=VALUE", OTHERWISE)


def test_a_node(explain: Explain) -> None:
    text = explain("/porter1/battery_monitor", EXAMPLES, *FLEET)
    assert text.startswith("node /porter1/battery_monitor\n")
    assert rows(text, "enclave") == ["/porter1/battery_monitor"]
    assert re.search(rf"/porter1/battery  sensor_msgs/msg/BatteryState  {BASE}/battery_monitor.py:24  \[bound\]", text)
    assert f"    low = 0.15  (default 0.2)  {BASE}/battery_monitor.py:19" in text
    assert "entities that the client library creates" in text


def test_a_node_with_its_findings(explain: Explain, unknown: Path) -> None:
    text = explain("talker", unknown)
    assert "    limit = nan  talker.py:13\n" in text
    assert "    topic = (unknown or not a plain value)  talker.py:12\n" in text
    assert "error RW101 unknown name\n" in text
    assert "warning RW102 partially known name\n" in text


def test_several_names_with_one_end(explain: Explain) -> None:
    text = explain("battery_low", EXAMPLES, *FLEET)
    assert "topic /porter1/battery_low " in text
    assert "topic /porter2/battery_low " in text
    text = explain("get_parameters", EXAMPLES)
    assert text.startswith("get_parameters matches the end of several names; pass a longer name to see all details\n")
    assert re.search(r"^  service  /porter/base_driver/get_parameters  1 service.server$", text, re.MULTILINE)


def test_what_the_client_library_creates(explain: Explain, unknown: Path) -> None:
    assert rows(explain("/rosout", unknown), "created") == ["by the client library"]


@pytest.mark.parametrize("place", ["base_driver.py:31", f"./{BASE}/base_driver.py:31", f"{BASE}/base_driver.py:31:9"])
def test_a_line(place: str, explain: Explain) -> None:
    text = explain(place)
    assert text.startswith("publisher /porter/battery  sensor_msgs/msg/BatteryState, of /porter/base_driver\n")


def test_a_line_that_leads_to_others(explain: Explain) -> None:
    """The call of the base class, in the line of which the node gets its heartbeat."""
    text = explain(f"{BASE}/base_driver.py:23")
    assert text.startswith("through a call on this line\n")
    assert "  publisher /porter/heartbeat of /porter/base_driver  delivery_robot/delivery_common/" in text


def test_a_line_with_a_finding(explain: Explain, unknown: Path) -> None:
    text = explain("talker.py:16", unknown)
    assert text.startswith("publisher /*  std_msgs/msg/String, of /talker\n")
    assert "error RW101 unknown name\n" in text


def test_an_entry_of_a_launch_file(explain: Explain) -> None:
    assert explain("robot.launch.py:69", EXAMPLES, *FLEET).startswith("node /porter1/eye\n")


@pytest.mark.parametrize("code", ["RW101", "rw101"])
def test_a_finding(code: str, explain: Explain, unknown: Path) -> None:
    text = explain(code, unknown)
    assert rows(text, "where") == ["talker.py:16"]
    assert rows(text, "do") == ["Give the missing value a default in the source."]
    assert "> 16 │         self.create_publisher(String, sys.argv[1], 10)" in text


def test_an_enclave_of_several_nodes() -> None:
    nodes = [
        node("/left", pub("/a"), system=False, enclave="/robot/arms"),
        node("/right", sub("/a"), pub("/b*", resolution=Resolution.UNKNOWN), system=False, enclave="/robot/arms"),
    ]
    text = of(connect("jazzy", nodes), "/robot/arms")
    assert text.startswith("enclave /robot/arms\n  nodes     /left, /right\n  rules\n")
    assert '    <topics publish="ALLOW"> <topic>/a</topic>\n' in text
    assert '    <topics subscribe="ALLOW"> <topic>/a</topic>\n' in text
    assert "  omitted\n    /b*: unknown name" in text


def test_nothing_is_called_so(explain: Explain) -> None:
    text = explain("/porter/batery", status=1)
    assert text.startswith(
        "/porter/batery: no name in the result matches or ends with this, and nothing is at this place\ndid you mean\n"
    )
    assert text.splitlines()[2] == "  /porter/battery"


@pytest.mark.parametrize("query", ["", "/", "//", ":1", "x.py:0", "x.py:999999999", "q" * 5000, "*" * 5000, "\udc80"])
def test_no_query_is_too_odd(query: str) -> None:
    answer = explained(talker_and_listener(), query, Path("/nowhere"))
    assert answer.empty
    assert explain_text(answer).encode()
    assert json.loads(explain_json(answer))["meetings"] == []


@pytest.mark.parametrize(
    ("query", "options"), [("/porter1/battery", FLEET), ("/fleet/heartbeat", FLEET), ("/porter/battery", ())]
)
def test_json_has_the_facts_of_the_text(query: str, options: tuple[str, ...], explain: Explain) -> None:
    text, document = explain(query, EXAMPLES, *options), explain.json(query, EXAMPLES, *options)
    assert document["schema_version"] == 1
    assert document["query"] == query
    for end in document["meetings"][0]["ends"]:
        assert f"{end['kind']} of " in text
        assert f"{end['created'][0]['place']['file']}:{end['created'][0]['place']['line']}" in text
        assert end["policy"]["rule"] in text
        assert all(f"{s['what']} {s['name']} = {s['value']!r}: {s['origin']}" in text for s in end["made_of"])
    assert set(re.findall(r"^(\w+) of (/\S+)$", text, re.MULTILINE)) <= {
        (end["kind"], end["node"]) for end in document["meetings"][0]["ends"]
    }


def test_json_of_a_value_that_json_does_not_have(explain: Explain, unknown: Path) -> None:
    (told,) = explain.json("/talker", unknown)["nodes"]
    assert {p["name"]: p["value"] for p in told["parameters"]} == {"limit": "nan", "topic": None}
    assert {d["code"] for d in told["doubts"]} >= {"RW101", "RW102"}


def test_json_of_nothing(explain: Explain) -> None:
    document = explain.json("/porter/batery", status=1)
    assert document["meetings"] == document["nodes"] == []
    assert document["close"][0] == "/porter/battery"


def test_names_cannot_steer_the_terminal() -> None:
    """The name of a topic, its reason and the query may hold anything."""
    evil = "/a\x1b[2J\x9b1m\u202e\nline"
    network = connect(
        "jazzy",
        [node("/n" + evil, pub(evil, evil, resolution=Resolution.PATTERN, reasons=(evil,), via=evil, callback=evil))],
    )
    for query in (evil, "/n" + evil, "/none" + evil):
        text = of(network, query)
        assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]", text)
        assert "\nline" not in text
        assert "\\x1b[2J\\x9b1m\\u202e\\x0aline" in text
    document = json.loads(explain_json(explained(network, evil, Path("/nowhere"))))
    assert document["meetings"][0]["name"] == evil


def test_source_cannot_steer_the_terminal(explain: Explain, unknown: Path) -> None:
    evil = UNKNOWN.replace("sys.argv[1], 10)", "sys.argv[1], 10)  # \x1b[2J")
    (unknown / "talker.py").write_text(evil, encoding="utf-8")
    text = explain("/*", unknown)
    assert "\x1b" not in text
    assert "# \\x1b[2J" in text


def test_no_file_outside_of_the_sources_is_shown(tmp_path: Path) -> None:
    """A place may name any path, and a link in the sources may lead anywhere."""
    (tmp_path / "secret.py").write_text("secret\n", encoding="utf-8")
    root = tmp_path / "root"
    root.mkdir()
    (root / "link.py").symlink_to(tmp_path / "secret.py")
    for file in ("../secret.py", "link.py", str(tmp_path / "secret.py"), "no\0name"):
        network = connect("jazzy", [node("/n", pub("/a", created_at=(Place(file, 1),)), system=False)])
        assert "secret\n" not in explain_text(explained(network, "/a", root))
