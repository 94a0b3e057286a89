# SPDX-License-Identifier: Apache-2.0
"""`rosward explain`: its exit status, and where what it says goes. What it says stands in tests/outputs/test_explain.py."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import pytest

from rosward.cli import main

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "explain.md").read_text(encoding="utf-8")
SHOWN = re.findall(r"```text\n\$ rosward (explain .*)\n([^`]*)```", PAGE)

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
        ("RW402", 1),
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


@pytest.mark.parametrize(("command", "output"), SHOWN)
def test_the_page_shows_what_is_printed(
    command: str, output: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of each output in docs/explain.md, every line is printed, in that order; `…` alone stands for lines left out."""
    monkeypatch.chdir(ROOT)
    main(shlex.split(command))
    printed = iter(capsys.readouterr().out.splitlines())
    for line in output.splitlines():
        assert line == "…" or line in printed, line


def test_the_page_shows_outputs() -> None:
    assert len(SHOWN) >= 4
