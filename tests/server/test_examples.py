# SPDX-License-Identifier: Apache-2.0
"""The examples of the gallery: each is a program of its own, and shows what it promises."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import rosward
from rosward.deployment.request import LaunchRequest, Request
from rosward.server.examples import Example, examples, write_example
from rosward.server.launch_files import OfferedArgument, launch_files
from rosward.server.places import read_left_out

SEEN = {
    "talker": {"/listener: subscription /chatter", "/talker: publisher /chatter"},
    "parameters": {
        *(f"/arm/driver: publisher /arm/joint_{n}/state, default" for n in (1, 2, 3)),
        *(f"/arm/driver: subscription /arm/joint_{n}/command" for n in (1, 2, 3)),
    },
    "unknown": {
        "/recorder: publisher /recorder/running",
        "/recorder: subscription /*, unknown",
        "/recorder: subscription /*/events, pattern",
    },
    "services": {
        "/building/door: service server /building/door/open",
        "/planner: service client /building/door/open",
        "/planner: action server /navigate",
        "/sender: action client /navigate",
    },
    "lifecycle": {"/camera: publisher /image_raw, conditional", "/camera: publisher /camera_info, conditional"},
    "robots": {
        "/left/robot: publisher /left/battery, default",
        "/left/robot: subscription /fleet/left/cmd_vel, default",
        "/right/robot: publisher /right/battery, default",
        "/right/robot: subscription /fleet/right/cmd_vel, default",
        "/supervisor: subscription /left/battery, default",
        "/supervisor: subscription /right/battery, default",
    },
}
FINDINGS = {"unknown": {"RW101", "RW102", "RW302"}}


def written(example: Example, folder: Path) -> Path:
    write_example(example, folder)
    return folder / "tree"


@pytest.mark.parametrize("example", examples(), ids=lambda e: e.name)
def test_an_example_shows_what_it_promises(example: Example, tmp_path: Path) -> None:
    request = Request(tuple(LaunchRequest(file) for file in example.settings.launch))
    network = rosward.extract(written(example, tmp_path), request=request).network
    own = [(node, entity) for node in network.nodes for entity in node.entities if not entity.system]
    found = set()
    for node, entity in own:
        marks = [entity.resolution.value] if entity.resolution.value != "exact" else []
        marks += ["conditional"] if entity.conditional else []
        found.add(", ".join([f"{node.fqn}: {entity.kind.value} {entity.name}", *marks]))
    assert found == SEEN[example.name]
    assert {finding.code for finding in network.findings} == FINDINGS.get(example.name, set())


@pytest.mark.parametrize("example", examples(), ids=lambda e: e.name)
def test_an_example_is_well_formed(example: Example, tmp_path: Path) -> None:
    assert example.title
    assert 20 < len(example.short) < 200
    assert example.text
    for name, text in example.files.items():
        if name.endswith(".py"):
            ast.parse(text, name)
            assert max(map(len, text.splitlines()), default=0) <= 120
    written(example, tmp_path)
    assert read_left_out(tmp_path / "left_out.json") == []


def test_the_launch_file_and_its_argument_can_be_chosen(tmp_path: Path) -> None:
    example = next(e for e in examples() if e.name == "robots")
    (file,) = launch_files(written(example, tmp_path), "jazzy")
    assert (file.file, file.package) == (example.settings.launch[0], "fleet_demo")
    assert file.arguments == (OfferedArgument("robots", "left,right", (), "names, with commas between them"),)


def test_arguments_are_found_in_all_three_languages(tmp_path: Path) -> None:
    (tmp_path / "a.launch.xml").write_text(
        '<launch><arg name="sim" default="false" description="Simulate"><choice value="true"/><choice value="false"/></arg>'
        '<group><arg name="map"/></group><arg name="file" default="$(find-pkg-share demo)/a.yaml"/></launch>',
        encoding="utf-8",
    )
    (tmp_path / "b.launch.yaml").write_text("launch:\n- arg: {name: speed, default: '1.0'}\n", encoding="utf-8")
    (tmp_path / "c.launch.py").write_text("def broken(:\n", encoding="utf-8")
    found = {file.file: file.arguments for file in launch_files(tmp_path, "jazzy")}
    assert found["a.launch.xml"][:2] == (
        OfferedArgument("sim", "false", ("true", "false"), "Simulate"),
        OfferedArgument("map", None, (), ""),
    )
    assert found["b.launch.yaml"] == (OfferedArgument("speed", "1.0", (), ""),)
    assert found["c.launch.py"] == ()
