# SPDX-License-Identifier: Apache-2.0
"""What was asked: it is in the file, the same on every machine, comes back from it, and a difference of it is told."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import rosward
from rosward.deployment.request import LaunchRequest, NodeRequest, Request
from rosward.network.asked import NOT_TOLD, Asked, LaunchAsked, asked_differently
from rosward.network.network_file import read_network
from rosward.outputs.documents.network_json import network_json

LAUNCH = '<launch><arg name="who" default="a"/><node pkg="demo" exec="talker" name="$(var who)"/></launch>'
ACME = """\
nodl_version: 2
package: acme
source: https://example.org/acme (1.0)
client_library: rclcpp
executables: {driver: {node: driver}}
"""
PACKAGE = "<package format='3'><name>demo</name><version>1.0.0</version></package>"


def workspace(folder: Path) -> Path:
    files = {
        "ws/demo/package.xml": PACKAGE,
        "ws/demo/launch/a.launch.xml": LAUNCH,
        "models/nodes/acme.yaml": ACME,
        "p.yaml": "",
    }
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def question(folder: Path) -> Asked:
    request = Request(
        (
            LaunchRequest("a.launch.xml", "demo", (("who", "b"),)),
            LaunchRequest(str(folder / "ws/demo/launch/a.launch.xml")),
        ),
        (NodeRequest("acme", "driver", "third"),),
        (str(folder / "p.yaml"),),
        (("x", "1"), ("a", "2")),
    )
    return rosward.extract(folder / "ws", models=[folder / "models"], request=request, exclude=["*.md"]).network.asked


def test_all_that_was_asked_is_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace(tmp_path))
    asked = question(Path())
    assert asked.paths == (".",)
    assert asked.launch == (LaunchAsked("demo:a.launch.xml", (("who", "b"),)), LaunchAsked("demo/launch/a.launch.xml"))
    assert (asked.arguments, asked.nodes) == ((("a", "2"), ("x", "1")), ("acme/driver:third",))
    assert asked.parameter_files == ("../p.yaml",)
    assert dict(asked.options) == {
        "assumed": True,
        "budget": 1.0,
        "enclaves": "process",
        "exclude": ("*.md",),
        "follow_links": False,
        "models": ("../models",),
        "tests": False,
        "underlays": (),
        "unknown": "deny",
    }


def test_it_does_not_say_where_the_sources_lie(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = []
    for name in ("here", "elsewhere/deep"):
        monkeypatch.chdir(workspace(tmp_path / name))
        found.append(question(Path()))
    assert found[0] == found[1]
    assert os.fspath(tmp_path) not in repr(found)


def test_a_model_that_changed_is_another_question(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace(tmp_path))
    before = question(Path())
    Path("models/nodes/acme.yaml").write_text(ACME.replace("rclcpp", "rclpy"))
    told = list(asked_differently(before, question(Path())))
    assert len(told) == 1
    assert told[0].startswith("different options: models was ")


def test_it_comes_back_from_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(workspace(tmp_path))
    network = rosward.extract("ws", request=Request((LaunchRequest("a.launch.xml", "demo", (("who", "b"),)),))).network
    Path("network.json").write_text(network_json(network))
    assert read_network("network.json").asked == network.asked
    assert not list(asked_differently(network.asked, network.asked))


def test_what_differs_is_told_line_by_line() -> None:
    old = Asked(paths=(".",), launch=(LaunchAsked("a:b"),), options=(("tests", False), ("unknown", "deny")))
    new = old._replace(launch=(LaunchAsked("a:b", (("who", "c"),)),), options=(("tests", True), ("unknown", "deny")))
    assert list(asked_differently(old, new)) == [
        "different options: launch argument who of a:b was not set, is now c",
        "different options: option tests was off, is now on",
    ]
    assert list(asked_differently(NOT_TOLD, new)) == []
