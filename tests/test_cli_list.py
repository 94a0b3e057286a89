# SPDX-License-Identifier: Apache-2.0
"""`rosward list`: a line for each thing of one kind."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

import jsonschema
import pytest

from rosward.cli import main
from rosward.cli.listing import _KINDS
from rosward.explanation.listing import KINDS

pytestmark = pytest.mark.usefixtures("remembered")

EXAMPLES = str(Path(__file__).parents[1] / "examples")
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.declare_parameter("rate", 10)
node.create_publisher(String, {name}, 10)
rclpy.spin(node)
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("talker.py").write_text(NODE.format(name='"chatter"'), encoding="utf-8")


@pytest.mark.parametrize(
    ("kind", "lines"),
    [
        (
            "topics",
            [
                "topic     types                publishers  subscriptions",
                "/chatter  std_msgs/msg/String  /talker     -",
            ],
        ),
        (
            "nodes",
            [
                "node     package  executable  interface  assumed  enclave  entities  defined",
                "/talker  -        -           analysed   -        /talker  1         talker.py:6",
            ],
        ),
        ("services", ["no services"]),
        ("packages", ["package  nodes  executables  entities", "-        1      -            1"]),
        (
            "parameters",
            ["parameter  node     type     value  declared", "rate       /talker  integer  10     talker.py:7"],
        ),
    ],
)
def test_a_table(kind: str, lines: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", kind]) == 0
    assert capsys.readouterr().out.splitlines() == lines


def test_what_the_client_library_creates(capsys: pytest.CaptureFixture[str]) -> None:
    main(["list", "topics", "--system"])
    assert "\n/rosout " in capsys.readouterr().out


@pytest.mark.parametrize("kind", KINDS)
def test_json_has_the_form_of_its_schema(kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    schema = json.loads((resources.files("rosward.outputs") / "schemas" / "list.schema.json").read_text())
    assert main(["list", kind, EXAMPLES, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator(schema).validate(document)
    assert document["rows"]


def test_a_list_that_may_lack_something_is_status_1(capsys: pytest.CaptureFixture[str]) -> None:
    Path("talker.py").write_text(NODE.format(name="input()"), encoding="utf-8")
    assert main(["list", "nodes"]) == 1
    assert "something may be missing" in capsys.readouterr().err


def test_the_kinds_are_those_that_can_be_listed() -> None:
    """The command line names them without loading what lists them."""
    assert tuple(KINDS) == _KINDS
