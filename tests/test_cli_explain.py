# SPDX-License-Identifier: Apache-2.0
"""`rosward explain`: its exit status, and where what it says goes. What it says stands in tests/outputs/test_explain.py."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

import jsonschema
import pytest

from rosward.cli import main

TALKER = """\
import sys

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("talker")
node.create_publisher(String, "chatter", 10)
node.create_publisher(String, sys.argv[1], 10)
rclpy.spin(node)
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("talker.py").write_text(TALKER, encoding="utf-8")


@pytest.mark.parametrize(
    ("name", "status"),
    [
        ("/chatter", 0),
        ("chatter", 0),
        ("talker", 0),
        ("talker.py:8", 0),
        ("RW101", 0),
        ("/*", 0),
        ("/chater", 1),
        ("talker.py:1", 1),
        ("RW402", 0),
        ("RW999", 1),
        ("", 1),
    ],
)
@pytest.mark.parametrize("more", [[], ["--json"]])
def test_the_status_says_whether_something_is_called_so(
    name: str, status: int, more: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """An unknown name elsewhere in the network does not count: the question is answered."""
    assert main(["explain", name, *more]) == status
    printed = capsys.readouterr()
    assert printed.out
    assert printed.err == ""
    if more:
        assert json.loads(printed.out)["query"] == name


@pytest.mark.parametrize(
    "arguments",
    [["chatter", "nowhere"], ["chatter", "--launch", "demo:none.launch.py"], ["chatter", "--node", "demo/none"]],
)
def test_wrong_use(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", *arguments]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith("rosward: ")


def test_a_name_is_needed(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["explain"])
    assert left.value.code == 2
    assert "NAME" in capsys.readouterr().err


def test_nothing_is_written() -> None:
    main(["explain", "chatter"])
    assert [path.name for path in Path().iterdir()] == ["talker.py"]


def test_a_code_alone_is_explained_without_sources(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """In an empty folder, too: nothing is read."""
    (tmp_path / "empty").mkdir()
    monkeypatch.chdir(tmp_path / "empty")
    assert main(["explain", "rw101"]) == 0
    out = capsys.readouterr().out
    assert out.startswith("RW101 unknown name\n  error     something is, or may be, missing from the result")
    assert "rosward explain RW101 PATH" in out
    assert main(["explain", "RW101", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["rule"]["severity"] == "error"


def test_a_code_that_holds_nowhere_is_explained_all_the_same(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "RW402", "talker.py"]) == 0
    assert "nowhere in the sources" in capsys.readouterr().out


@pytest.mark.parametrize(
    "name", ["/porter/battery", "/porter", "battery_monitor", "base_driver.py:31", "RW207", "/nothing"]
)
def test_json_has_the_form_of_its_schema(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    schema = json.loads((resources.files("rosward.outputs") / "schemas" / "explain.schema.json").read_text())
    main(["explain", name, str(Path(__file__).parents[1] / "examples"), "--format", "json"])
    jsonschema.Draft202012Validator(schema).validate(json.loads(capsys.readouterr().out))
