# SPDX-License-Identifier: Apache-2.0
"""Nodes of classes that nothing makes: told apart in every output, and left out where they are not wanted."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import rosward
from rosward.cli import main
from rosward.network.network_file import read_network
from rosward.outputs.documents.network_json import network_json
from rosward.outputs.graphs.dot import graph_dot
from rosward.outputs.graphs.mermaid import graph_mermaid
from rosward.outputs.policies.nodl import nodl_document
from rosward.outputs.policies.policy import policy_xml
from rosward.outputs.policies.starts import starts_text

PROGRAM = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Started(Node):
    def __init__(self):
        super().__init__("started")
        self.create_publisher(String, "said", 10)


class Assumed(Node):
    def __init__(self, handler=None):
        super().__init__("assumed")
        self.create_subscription(String, "said", handler, 10)


def main():
    rclpy.init()
    rclpy.spin(Started())


if __name__ == "__main__":
    main()
"""


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    folder = tmp_path / "sources"
    folder.mkdir()
    (folder / "robot.py").write_text(PROGRAM)
    return folder


def test_it_is_marked_and_the_other_is_not(sources: Path) -> None:
    found = {n.fqn: n for n in rosward.extract(sources).network.nodes}
    assert found["/assumed"].assumed
    assert found["/assumed"].process == "class robot.py:Assumed"
    assert found["/assumed"].conditional
    assert all(e.conditional for e in found["/assumed"].entities)
    assert not found["/started"].assumed
    assert not any(e.conditional for e in found["/started"].entities if not e.system)


def test_it_is_left_out_where_it_is_not_wanted(sources: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert [n.fqn for n in rosward.extract(sources, assumed=False).network.nodes] == ["/started"]
    main(["list", "nodes", str(sources), "--no-assumed", "--json"])
    assert [row["node"] for row in json.loads(capsys.readouterr().out)["rows"]] == ["/started"]
    (sources / "rosward.toml").write_text("no-assumed = true\n")
    main(["list", "nodes", str(sources), "--json"])
    assert [row["node"] for row in json.loads(capsys.readouterr().out)["rows"]] == ["/started"]


def test_network_json_tells_it_by_the_process(sources: Path, tmp_path: Path) -> None:
    network = rosward.extract(sources).network
    text = network_json(network)
    row = next(n for n in json.loads(text)["nodes"] if n["fqn"] == "/assumed")
    assert (row["executable"], row["process"]) == (None, "class robot.py:Assumed")
    file = tmp_path / "network.json"
    file.write_text(text)
    assert {n.fqn: n.assumed for n in read_network(str(file)).nodes} == {"/assumed": True, "/started": False}


def test_every_text_names_it(sources: Path) -> None:
    network = rosward.extract(sources).network
    assert "Assumed: nothing in the sources creates class robot.py:Assumed" in policy_xml(network)
    assert "which nothing in the sources creates" in starts_text(network)
    assert graph_dot(network).count('style="filled,dashed"') == 1
    assert "rosAssumed" in graph_mermaid(network)
    documents = {n.fqn: nodl_document(n) for n in network.nodes}
    assert "Assumed" in documents["/assumed"].splitlines()[0]
    assert "nothing in the sources" not in documents["/started"]


def test_the_command_line_tells_it(sources: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["extract", str(sources), "--format", "none"])
    printed = capsys.readouterr().out
    assert "2 nodes in 1 process." in printed
    assert "1 node is assumed: nothing starts it" in printed
    main(["explain", "/assumed", str(sources)])
    assert "class robot.py:Assumed is assumed to be created elsewhere" in capsys.readouterr().out
    main(["list", "nodes", str(sources), "--json"])
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert {row["node"]: row["assumed"] for row in rows} == {"/assumed": True, "/started": False}


def test_a_node_that_something_starts_is_drawn_as_started(sources: Path) -> None:
    (sources / "other.py").write_text(PROGRAM.replace('"assumed"', '"started"'))
    network = rosward.extract(sources / "other.py").network
    assert [n.assumed for n in network.nodes].count(True) == 1
    assert "filled,dashed" not in graph_dot(network)
    assert "rosAssumed" not in graph_mermaid(network)
