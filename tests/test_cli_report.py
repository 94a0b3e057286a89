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


RELAY = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("relay")
out = node.create_publisher(String, "out", 10)
node.create_subscription(String, "in", lambda message: out.publish(message), 10)
"""
RULE = """
[[flow.rule]]
from = ["/in"]
not-to = ["/out"]
"""
RELEASE = """
[[flow.release]]
through = ["node:/relay"]
of = ["/in"]
because = "it is harmless"
"""


def relayed(*arguments: str, configuration: str = "") -> dict[str, Any]:
    """The report of a node that passes on what it gets."""
    Path("relay.py").write_text(RELAY, encoding="utf-8")
    Path("rosward.toml").write_text(configuration, encoding="utf-8")
    main(["extract", "-q", "--format", "html", *arguments])
    return report()


def test_flows_are_in_the_report_where_they_are_asked_for() -> None:
    assert "flows" not in relayed()
    plain = Path("rosward-out/report.html").read_bytes()
    for document in (relayed("--flows"), relayed(configuration="flows = true"), relayed(configuration=RELEASE)):
        (node,) = document["flows"]["nodes"]
        (output,) = node["outputs"]
        assert [source[1:3] for source in output["sources"]] == [[0, 0]]
    assert relayed()
    assert Path("rosward-out/report.html").read_bytes() == plain


def test_a_broken_rule_is_in_the_report_with_its_way() -> None:
    document = relayed(configuration=RULE)
    (finding,) = (f for f in document["findings"] if f["code"] == "RW601")
    assert [place["line"] for place in finding["way"]] == [8]
    assert [row["fqn"] for row in document["nodes"] if row["id"] in finding["subjects"]] == ["/relay"]
    assert document["code"]["relay.py"]["8"].startswith("node.create_subscription")
    assert [f["code"] for f in relayed(configuration=RULE + RELEASE)["findings"] if f["code"].startswith("RW6")] == []
