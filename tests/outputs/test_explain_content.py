# SPDX-License-Identifier: Apache-2.0
"""What `rosward explain --made-of` tells: each part with its lines, what is assumed, and what is not known."""

from __future__ import annotations

import json
import re
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from rosward.cli import main

PROGRAM = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Relay(Node):
    def __init__(self):
        super().__init__("relay")
        self.out = self.create_publisher(String, "out", 10)
        self.alive = self.create_publisher(String, "alive", 10)
        self.create_publisher(String, "silent", 10)
        self.loud = True
        self.create_subscription(String, "in", self.on_in, 10)
        self.create_subscription(String, "mode", self.on_mode, 10)
        self.create_service(Trigger, "state", self.on_state)
        self.create_timer(1.0, self.tick)

    def on_mode(self, msg):
        self.loud = msg.data == "loud"

    def on_in(self, msg):
        if self.loud:
            self.out.publish(String(data=msg.data.upper()))

    def on_state(self, request, response):
        response.message = str(self.loud)
        return response

    def tick(self):
        self.alive.publish(String(data="alive"))


rclpy.init()
rclpy.spin(Relay())
"""
LAUNCH = """\
<launch>
  <node pkg="demo" exec="relay.py"/>
  <node pkg="acme" exec="unheard_of"/>
</launch>
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("relay.py").write_text(PROGRAM, encoding="utf-8")


def text(capsys: pytest.CaptureFixture[str], name: str, *more: str) -> str:
    assert main(["explain", name, "--made-of", *more]) == 0
    return capsys.readouterr().out


def content(capsys: pytest.CaptureFixture[str], name: str) -> Any:
    document = json.loads(text(capsys, name, "--json"))
    schema = json.loads((resources.files("rosward.outputs") / "schemas" / "explain.schema.json").read_text())
    jsonschema.Draft202012Validator(schema).validate(document)
    return document["meetings"][0]["content"]


def test_each_part_with_its_lines(capsys: pytest.CaptureFixture[str]) -> None:
    out = text(capsys, "/out")
    assert "\n/out is made of\n  data      /in  by /relay\n            relay.py\n" in out
    assert re.search(
        r"  control   /mode  by /relay\n +relay.py\n( +\d+ │ .*\n)* +20 │ +self.loud = msg.data == \"loud\"", out
    )
    (told,) = content(capsys, "/out")
    assert told["of"] == "topic:/out"
    assert [(s["depth"], s["strength"], s["source"], s["node"], s["assumed"]) for s in told["steps"]] == [
        (1, "data", "topic:/in", "/relay", False),
        (1, "control", "topic:/mode", "/relay", False),
    ]
    assert told["steps"][0]["lines"][-1]["place"] == {"file": "relay.py", "line": 24}
    assert told["unsure"] == told["constant"] == []


def test_what_is_sent_the_same_each_time(capsys: pytest.CaptureFixture[str]) -> None:
    assert "  constant  by /relay\n            relay.py\n                31 │         self.alive." in text(
        capsys, "/alive"
    )
    (told,) = content(capsys, "/alive")
    assert [each["node"] for each in told["constant"]] == ["/relay"]
    assert told["steps"] == []


def test_what_nothing_sends(capsys: pytest.CaptureFixture[str]) -> None:
    assert "topic /silent: no statement of the sources sends it\n" in text(capsys, "/silent")
    assert content(capsys, "/silent") == []


def test_what_client_libraries_send(capsys: pytest.CaptureFixture[str]) -> None:
    """Log calls go to /rosout, transforms to /tf."""
    more = "        self.get_logger().info(msg.data)\n"
    Path("relay.py").write_text(
        PROGRAM.replace("        if self.loud:\n", more + "        if self.loud:\n"), encoding="utf-8"
    )
    (told,) = content(capsys, "/rosout")
    assert told["of"] == "log"
    assert [step["source"] for step in told["steps"]] == ["topic:/in"]


def test_a_service_has_an_answer(capsys: pytest.CaptureFixture[str]) -> None:
    assert [told["of"] for told in content(capsys, "/state")] == ["response:/state"]


def test_without_it_nothing_changes(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "/out", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["meetings"][0]["content"] is None
    assert main(["explain", "/out"]) == 0
    assert "is made of" not in capsys.readouterr().out


@pytest.mark.parametrize("name", ["/relay", "RW101", "relay.py:10"])
def test_what_has_no_content_is_refused(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", name, "--made-of", "relay.py"]) == 2
    assert capsys.readouterr().err == f"rosward: --made-of: {name} is no topic, service or action\n"


def test_a_name_that_is_not_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "/outt", "--made-of"]) == 1
    assert "did you mean" in capsys.readouterr().out


def test_a_node_of_which_nothing_is_known_may_send_it_too(capsys: pytest.CaptureFixture[str]) -> None:
    """It is told which parts are only assumed, and because of whom."""
    Path("package.xml").write_text("<package format='3'><name>demo</name><version>0.0.0</version></package>")
    Path("CMakeLists.txt").write_text("install(PROGRAMS relay.py DESTINATION lib/demo)\n")
    Path("demo.launch.xml").write_text(LAUNCH, encoding="utf-8")
    out = text(capsys, "/in", ".", "--launch", "demo.launch.xml")
    assert re.search(r"  data +/\*  by acme/unheard_of  \(assumed\)", out)
    assert "  not all is known of acme/unheard_of: what it sends may hold more\n" in out
