# SPDX-License-Identifier: Apache-2.0
"""What is known of a node: said of each, why not all, and said again by a file of either version."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import rosward
from rosward.cli import main
from rosward.deployment.request import LaunchRequest, Request
from rosward.network.network_file import read_network
from rosward.outputs.documents.network_json import network_json
from rosward.ros.entities import Interface, Node

FILES = {
    "demo/package.xml": "<package format='3'><name>demo</name><version>1.0.0</version></package>",
    "demo/setup.py": "from setuptools import setup\nsetup(name='demo', packages=['demo'], entry_points={'console_scripts': "
    "['good = demo.good:main', 'odd = demo.odd:main']})\n",
    "demo/demo/__init__.py": "",
    "demo/demo/good.py": "import rclpy\nfrom std_msgs.msg import String\n\n\ndef main():\n    rclpy.init()\n"
    "    node = rclpy.create_node('good')\n    node.create_publisher(String, 'out', 1)\n    rclpy.spin(node)\n",
    "demo/demo/odd.py": "import rclpy\nfrom std_msgs.msg import String\n\n\ndef main():\n    rclpy.init()\n"
    "    node = rclpy.create_node('odd')\n    node.create_publisher(String, input(), 1)\n    rclpy.spin(node)\n",
    "demo/launch/a.launch.xml": "<launch>"
    + "".join(
        f'\n<node pkg="{pkg}" exec="{exe}"/>'
        for pkg, exe in (("demo", "good"), ("demo", "odd"), ("acme", "whole"), ("acme", "open"), ("acme", "other"))
    )
    + "</launch>",
    "models/nodes/acme.yaml": "nodl_version: 2\npackage: acme\nsource: x\nclient_library: rclcpp\nexecutables:\n"
    "  whole: {node: whole}\n  open: {node: open, open: it loads plugins}\n",
}


@pytest.fixture(autouse=True)
def in_a_workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each test runs beside the sources."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)


def nodes() -> dict[str, Node]:
    request = Request((LaunchRequest("a.launch.xml", "demo"),))
    network = rosward.extract(".", models=["models"], request=request).network
    Path("network.json").write_text(network_json(network))
    return {node.display_name: node for node in network.nodes}


def test_each_node_says_what_is_known_of_it() -> None:
    found = nodes()
    assert {name: node.interface.value for name, node in found.items()} == {
        "/good": "analysed",
        "/odd": "partial",
        "/whole": "declared",
        "/open": "partial",
        "acme/other": "unknown",
    }
    assert found["/good"].lacks == found["/whole"].lacks == ()
    assert found["/odd"].lacks == ("RW101: the name of a publisher is unknown",)
    assert "it loads plugins" in found["/open"].lacks[0]
    assert "no executable of that name" in found["acme/other"].lacks[0] or "neither" in found["acme/other"].lacks[0]


def test_the_summary_counts_them(capsys: pytest.CaptureFixture[str]) -> None:
    main(["extract", "--models", "models", "--launch", "demo:a.launch.xml", "--format", "none"])
    assert "  5 nodes: 1 analysed, 1 declared, 2 partially known, 1 unknown\n" in capsys.readouterr().out


def test_it_comes_back_from_the_file() -> None:
    found = nodes()
    again = {node.display_name: node for node in read_network("network.json").nodes}
    assert [(n, v.interface, v.lacks, v.label) for n, v in again.items()] == [
        (n, v.interface, v.lacks, v.label) for n, v in found.items()
    ]


def test_a_file_of_version_1_says_it_by_its_findings() -> None:
    found = nodes()
    document: dict[str, Any] = json.loads(Path("network.json").read_text())
    document["schema_version"] = 1
    del document["asked"]
    for node in document["nodes"]:
        del node["interface"], node["lacks"], node["label"]
    text = json.dumps(document).replace("not completely known", "not wholly known")  # as such files have it
    Path("network.json").write_text(text)
    again = {n.fqn: n.interface for n in read_network("network.json").nodes}
    assert again == {n.fqn: n.interface for n in found.values()} | {"/odd": Interface.ANALYSED}


def test_they_come_and_go(capsys: pytest.CaptureFixture[str]) -> None:
    request = Request((LaunchRequest("a.launch.xml", "demo"),))
    network = rosward.extract(".", models=["models"], request=request).network
    for name, kept in (("old.json", [n for n in network.nodes if n.label is None]), ("new.json", network.nodes)):
        Path(name).write_text(network_json(replace(network, nodes=tuple(kept))))
    main(["diff", "old.json", "new.json"])
    assert "nodes gained: 1\n  + acme/other\n" in capsys.readouterr().out


@pytest.mark.parametrize("query", ["other", "acme/other", "acme/whole"])
def test_they_are_found_by_what_starts_them(query: str, capsys: pytest.CaptureFixture[str]) -> None:
    main(["explain", query, ".", "--models", "models", "--launch", "demo:a.launch.xml"])
    told = capsys.readouterr().out
    assert told.startswith("node ")
    assert "  interface " in told


def test_in_pictures_they_are_no_idle_nodes() -> None:
    main(["extract", "--models", "models", "--launch", "demo:a.launch.xml", "--format", "dot,mermaid,svg", "-q"])
    dot = Path("rosward-out/graph.dot").read_text()
    line = next(line for line in dot.splitlines() if line.startswith('  "node acme/other"'))
    assert r'label="acme/other\nunknown"' in line
    assert "unknown-interface" in line
    assert dot.count("unknown-interface") == 1
    assert "rosUnknown" in Path("rosward-out/graph.mmd").read_text()
    assert Path("rosward-out/graph.svg").read_text().count('<ellipse fill="url(#unknown-interface)"') == 1
