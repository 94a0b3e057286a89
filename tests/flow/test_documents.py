# SPDX-License-Identifier: Apache-2.0
"""Promise: `rosward flow` writes what its schema says, and the same of the same result (`test_each_run.py`: the same on each run)."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

import jsonschema
import pytest
from sampling import sample

from rosward.cli import main

EXAMPLES = str(Path(__file__).parents[2] / "examples")
SCHEMA = json.loads((resources.files("rosward.outputs") / "schemas" / "flow.schema.json").read_text())
FLEET = ["--launch", "delivery_bringup:fleet.launch.py"]

pytestmark = pytest.mark.usefixtures("remembered")


def printed(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(["flow", *words]) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize("system", sample([[], FLEET], 2))
def test_the_document_fits_its_schema(system: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    text = printed(capsys, EXAMPLES, *system, "--format", "json")
    document = json.loads(text)
    jsonschema.Draft202012Validator(SCHEMA).validate(document)
    assert text == printed(capsys, EXAMPLES, *system, "--format", "json")
    for node in document["nodes"]:
        for sink in node["sinks"]:
            listed = [*sink["data"], *sink["control"], *sink["trigger"]]
            assert len(listed) == len(set(listed)), "a source stands in one list only"
            assert set(sink["assumed"]) <= set(listed)
            assert set(sink["paths"]) <= set(listed)


def test_links_join_what_is_sent_to_what_arrives(capsys: pytest.CaptureFixture[str]) -> None:
    document = json.loads(printed(capsys, EXAMPLES, "--format", "json"))
    links = {(link["from"], link["to"]) for link in document["links"]}
    picture = "topic:/porter/camera/image_raw"
    assert (f"/porter/camera {picture}", f"/porter/dock_detector {picture}") in links
    doors = "/building/doors/open"
    assert (f"/porter/delivery_planner request:{doors}", f"/building/door_gateway service:{doors}") in links
    assert (f"/building/door_gateway response:{doors}", f"/porter/delivery_planner response:{doors}") in links


_KEPT_BY_A_LIBRARY = """
import rclpy
import smach
from rclpy.node import Node
from std_msgs.msg import String


class Send(smach.State):
    def execute(self, userdata):
        userdata.out.publish(userdata.message)
        return "done"


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.echo = self.create_publisher(String, "echo", 1)
        self.create_subscription(String, "heard", self.hear, 1)
        self.machine = smach.StateMachine(["done"])
        self.machine.userdata.out = self.create_publisher(String, "kept", 1)
        self.machine.add("SEND", Send())

    def hear(self, message):
        self.machine.userdata.message = message
        self.machine.execute()
        self.echo.publish(String(data="heard"))


rclpy.init()
rclpy.spin(Robot())
"""


def test_what_a_library_got_hold_of_may_send(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Over an output that nothing else sends over, anything; where the program sends, what it does."""
    (tmp_path / "robot.py").write_text(_KEPT_BY_A_LIBRARY)
    (node,) = json.loads(printed(capsys, str(tmp_path), "--format", "json"))["nodes"]
    sinks = {sink["sink"]: (sink["data"], sink["assumed"]) for sink in node["sinks"]}
    assert node["interface"] == "partial"
    assert sinks["topic:/kept"] == (["topic:/heard"], ["topic:/heard"])
    assert sinks["topic:/echo"] == ([], [])
    assert "partially known; each input is assumed for /kept" in printed(capsys, str(tmp_path))


def test_it_is_written_to_a_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert printed(capsys, EXAMPLES, "--format", "json", "-o", str(tmp_path)) == f"wrote {tmp_path}/flow.json\n"
    assert json.loads((tmp_path / "flow.json").read_text())["schema"] == 1


def test_the_graph_for_graphviz(capsys: pytest.CaptureFixture[str]) -> None:
    text = printed(capsys, EXAMPLES, "--format", "dot")
    assert text.startswith("digraph flow {")
    assert '"/porter/teleop/mux/joystick" -> "/porter/cmd_vel"' in text


def test_what_is_not_there_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["flow", EXAMPLES, "--to", "/porter/cmd_vle"]) == 2
    assert "did you mean /porter/cmd_vel?" in capsys.readouterr().err
