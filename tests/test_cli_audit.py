# SPDX-License-Identifier: Apache-2.0
"""`rosward audit` and `rosward snapshot`: what is compared with what, in which form it is told, and with which status."""

from __future__ import annotations

import io
import json
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from audit.graphs import snapshot

from rosward import extract
from rosward.audit import snapshot as script
from rosward.cli import main

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, "chatter", 10)
rclpy.spin(node)
"""
INFO = """\
/talker
  Subscribers:

  Publishers:
    /chatter: std_msgs/msg/String
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /rosout: rcl_interfaces/msg/Log
"""
SCHEMA = Path(__file__).parents[1] / "src" / "rosward" / "outputs" / "schemas" / "audit.schema.json"


@pytest.fixture(autouse=True)
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """A program, and the snapshot of a robot on which it runs."""
    monkeypatch.chdir(tmp_path)
    Path("src").mkdir()
    Path("src/talker.py").write_text(NODE, encoding="utf-8")
    made = snapshot(*extract("src", distro="kilted").network.nodes)
    Path("robot.json").write_text(json.dumps(made), encoding="utf-8")
    return made


def with_debug(robot: dict[str, Any]) -> None:
    """One publisher more."""
    chatter = {"name": "/debug", "type": "std_msgs/msg/String", "seen": 3, "qos": []}
    robot["nodes"][0]["publishers"].append(chatter)
    Path("robot.json").write_text(json.dumps(robot), encoding="utf-8")


def audited(capsys: pytest.CaptureFixture[str], *options: str) -> tuple[int, str]:
    status = main(["audit", *options])
    return status, capsys.readouterr().out


def test_a_robot_that_its_source_explains(capsys: pytest.CaptureFixture[str]) -> None:
    assert audited(capsys, "src", "--snapshot", "robot.json") == (
        0,
        "1 node runs: 1 explained. The explained node has 10 entities: 10 explained.\n"
        "The source explains everything that runs, and everything it expects is running.\n",
    )


def test_a_difference_as_it_is_printed(robot: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    with_debug(robot)
    assert audited(capsys, "src", "--snapshot", "robot.json") == (
        1,
        "/talker\n"
        "  error   RW502 talker.py:6  publisher /debug (std_msgs/msg/String) of /talker is not explained by the source"
        " (seen in 3 of 10 looks)\n"
        "\n"
        "1 node runs: 1 explained. The explained node has 11 entities: 10 explained.\n"
        "1 unexplained running entity.\n",
    )


@pytest.mark.parametrize("form", ["json", "sarif", "junit", "github"])
def test_the_forms_for_programs(form: str, robot: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    with_debug(robot)
    status, text = audited(capsys, "src", "--snapshot", "robot.json", "--format", form)
    assert status == 1
    assert "publisher /debug (std_msgs/msg/String) of /talker is not explained" in text
    if form == "json":
        document = json.loads(text)
        jsonschema.validate(document, json.loads(SCHEMA.read_text(encoding="utf-8")))
        (difference,) = document["differences"]
        assert (difference["node"], difference["entity"], difference["seen"]) == ("/talker", "publisher /debug", 3)
    elif form == "sarif":
        (result,) = json.loads(text)["runs"][0]["results"]
        assert (result["ruleId"], result["level"]) == ("RW502", "error")


def test_what_is_known_is_accepted(robot: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    with_debug(robot)
    told = audited(capsys, "src", "--snapshot", "robot.json", "--allow", "/talker /debug")
    assert (told[0], "1 is accepted." in told[1]) == (0, True)
    Path("known.txt").write_text("# of the maker\n/talker /deb*  # since May\n", encoding="utf-8")
    assert audited(capsys, "src", "--snapshot", "robot.json", "--accept", "known.txt")[0] == 0


def test_a_baseline_holds_what_was_there_before(robot: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    with_debug(robot)
    assert audited(capsys, "src", "--snapshot", "robot.json", "--write-baseline", "known.json")[0] == 1
    status, text = audited(capsys, "src", "--snapshot", "robot.json", "--baseline", "known.json")
    assert (status, "1 is in the baseline." in text) == (0, True)


def test_an_earlier_extraction_takes_the_place_of_sources(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["extract", "src", "-q", "--format", "json", "-o", ".", "--distro", "kilted"]) == 0
    Path("src/talker.py").unlink()
    assert audited(capsys, "--network", "network.json", "--snapshot", "robot.json")[0] == 0


def test_the_distro_is_that_of_the_robot(robot: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    """The service for type descriptions came with iron."""
    status, text = audited(capsys, "src", "--snapshot", "robot.json", "--distro", "humble")
    assert (status, "get_type_description" in text) == (1, True)
    robot["ros_distro"] = None
    Path("robot.json").write_text(json.dumps(robot), encoding="utf-8")
    assert audited(capsys, "src", "--snapshot", "robot.json")[0] == 0


def test_texts_of_ros2_node_info(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    Path("info.txt").write_text(INFO, encoding="utf-8")
    assert audited(capsys, "src", "--node-info", "info.txt")[0] == 0
    monkeypatch.setattr(sys, "stdin", io.StringIO(INFO + "    /debug: std_msgs/msg/String\n"))
    status, text = audited(capsys, "src", "--node-info", "-")
    assert (status, text.count("RW50")) == (1, 1)


@pytest.mark.parametrize(
    "options",
    [
        ["--snapshot", "src/talker.py"],
        ["--snapshot", "absent.json"],
        ["--node-info", "robot.json"],
        ["--node-info", "absent.txt"],
        ["--snapshot", "robot.json", "--allow", "talker"],
        ["--snapshot", "robot.json", "--accept", "absent.txt"],
        ["--snapshot", "robot.json", "--network", "robot.json"],
        ["--snapshot", "robot.json", "--distro", "none"],
    ],
)
def test_wrong_use_is_status_2(options: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    try:
        status = main(["audit", "src", *options])
    except SystemExit as end:
        status = int(str(end.code))
    assert status == 2
    assert "rosward" in capsys.readouterr().err


def test_without_rclpy_something_has_to_say_what_runs(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(script, "rclpy", None)
    assert main(["audit", "src"]) == 2
    assert "use --snapshot or --node-info" in capsys.readouterr().err
    assert main(["snapshot", "-o", "new.json"]) == 2
    assert not Path("new.json").exists()


def test_the_script_is_printed_as_it_is(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["snapshot", "--print-script"]) == 0
    assert capsys.readouterr().out == Path(script.__file__).read_text(encoding="utf-8")
    assert main(["snapshot"]) == 2
