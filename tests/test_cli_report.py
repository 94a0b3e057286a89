# SPDX-License-Identifier: Apache-2.0
"""The report and the loose ends on the command line: the report has what nobody asked to ignore, the other outputs what was asked for."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from rosward.cli import main
from rosward.outputs.report.packed import document_in

PROGRAM = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, "chatter", 10){comment}
"""


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each test runs in an empty folder, which is the root of a repository."""
    (tmp_path / ".git").mkdir()
    monkeypatch.chdir(tmp_path)


def extract(*arguments: str, comment: str = "", configuration: str = "") -> int:
    Path("talker.py").write_text(PROGRAM.format(comment=comment), encoding="utf-8")
    Path("rosward.toml").write_text(configuration, encoding="utf-8")
    return main(["extract", "--format", "json,html", *arguments])


def report() -> dict[str, Any]:
    text = Path("rosward-out/report.html").read_text(encoding="utf-8")
    parsed: dict[str, Any] = json.loads(document_in(text))
    return parsed


def told() -> tuple[list[str], list[str]]:
    """The codes in network.json, and those in the report."""
    network = json.loads(Path("rosward-out/network.json").read_text(encoding="utf-8"))
    return [d["code"] for d in network["diagnostics"]], [f["code"] for f in report()["findings"]]


def test_the_report_has_the_source() -> None:
    assert extract() == 0
    document = report()
    (publisher,) = (e for e in document["entities"] if e["name"] == "/chatter")
    (place,) = publisher["places"]
    assert document["code"][place["file"]][str(place["line"])] == 'node.create_publisher(String, "chatter", 10)'


def test_loose_ends_are_in_the_report_and_elsewhere_on_request(capsys: pytest.CaptureFixture[str]) -> None:
    assert extract("-v") == 0
    assert told() == ([], ["RW332"])
    assert "RW332" not in capsys.readouterr().out
    assert extract("-v", "--loose-ends") == 0
    assert told() == (["RW332"], ["RW332"])
    assert "topic /chatter: publisher in /talker, but no subscription" in capsys.readouterr().out


def test_the_configuration_can_ask_for_them() -> None:
    extract(configuration="loose-ends = true")
    assert told() == (["RW332"], ["RW332"])


@pytest.mark.parametrize(("comment", "configuration"), [("  # rosward: ignore[RW332]", ""), ("", 'ignore = ["RW332"]')])
def test_what_is_ignored_is_in_no_output(comment: str, configuration: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Such a comment is of use, so it is no RW010; and it counts as ignored where loose ends are told."""
    extract(comment=comment, configuration=configuration)
    assert told() == ([], [])
    assert "1 ignored" not in capsys.readouterr().out
    extract("--loose-ends", comment=comment, configuration=configuration)
    assert told() == ([], [])
    assert "1 ignored" in capsys.readouterr().out


def test_a_baseline_has_what_was_asked_for() -> None:
    extract("--write-baseline", "known.json")
    assert "RW332" not in Path("known.json").read_text(encoding="utf-8")
    extract("--loose-ends", "--write-baseline", "known.json")
    assert "RW332" in Path("known.json").read_text(encoding="utf-8")
