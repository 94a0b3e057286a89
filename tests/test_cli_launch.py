# SPDX-License-Identifier: Apache-2.0
"""The commands for launched systems: what they print and write, and their exit status. What comes out of launch files stands in tests/systems."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

import jsonschema
import pytest
import yaml
from outputs.test_nodl import VALIDATOR

from rosward.cli import main

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    node = Node("talker")
    node.create_publisher(String, "chatter", 10)
    rclpy.spin(node)
"""
PACKAGE = """\
<package format="3"><name>{name}</name><version>1.0.0</version><description>d</description>
  <maintainer email="m@demo.org">m</maintainer><license>MIT</license></package>
"""
SETUP = """\
from setuptools import setup

setup(name="demo", packages=["demo"], entry_points={"console_scripts": ["talker = demo.talker:main"]})
"""
XML = """\
<launch>
  <arg name="side" default="left"/>
  <node pkg="demo" exec="talker" namespace="$(var side)"/>
</launch>
"""
PYTHON = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package="demo", executable="talker")])
"""
YAML = """\
launch:
- node: {pkg: demo, exec: talker}
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A package with a talker, and a launch file in each language."""
    monkeypatch.chdir(tmp_path)
    for name, text in {
        "package.xml": PACKAGE.format(name="demo"),
        "setup.py": SETUP,
        "demo/__init__.py": "",
        "demo/talker.py": TALKER,
        "launch/x.launch.xml": XML,
        "launch/p.launch.py": PYTHON,
        "launch/y.launch.yaml": YAML,
    }.items():
        write(f"demo/{name}", text)


def write(name: str, text: str) -> None:
    path = Path(name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


@pytest.mark.parametrize(
    ("file", "told"),
    [
        ("x.launch.xml", '/left/talker\n  demo/talker, started at {}:3: ros_args="--enclave /left/talker"'),
        ("p.launch.py", "/talker\n  demo/talker, started at {}:6: ros_arguments=['--enclave', '/talker']"),
        ("y.launch.yaml", '/talker\n  demo/talker, started at {}:2: ros_args: "--enclave /talker"'),
    ],
)
def test_how_to_start_in_an_enclave_is_told_in_the_language_of_the_launch_file(file: str, told: str) -> None:
    assert main(["extract", "-q", "--launch", f"demo:{file}"]) == 0
    assert told.format(f"demo/launch/{file}") in Path("rosward-out/enclaves.txt").read_text(encoding="utf-8")


def test_what_enclaves_txt_says_is_what_it_takes() -> None:
    """Written into the launch file, the process runs in its enclave."""
    write("demo/launch/x.launch.xml", XML.replace("/>\n</", ' ros_args="--enclave /left/talker"/>\n</'))
    assert main(["extract", "-q", "--launch", "demo:x.launch.xml", "--enclaves", "launch"]) == 0
    starts = Path("rosward-out/enclaves.txt").read_text(encoding="utf-8")
    assert "/left/talker\n  demo/talker: already set by its start" in starts


@pytest.mark.parametrize("arguments", [[], ["--launch", "demo:x.launch.xml"], ["--node", "demo/talker:north"]])
def test_the_tree_as_json(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    schema = json.loads((resources.files("rosward.outputs") / "schemas" / "launch-tree.schema.json").read_text())
    assert main(["launch-tree", "--json", *arguments]) == 0
    document = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator(schema).validate(document)
    entries = [e for s in document["systems"] for e in s["entries"]]
    assert {e["program"] for e in entries} == {"demo/demo/talker.py"}
    assert len(document["systems"]) == (1 if arguments else 3)


def test_the_interface_of_an_executable(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["nodl", "demo/talker"]) == 0
    printed = capsys.readouterr().out
    assert main(["nodl", "demo/talker", "-o", "out/nodl"]) == 0
    assert capsys.readouterr().out == ""
    assert Path("out/nodl/talker.nodl.yaml").read_text(encoding="utf-8") == printed
    document = yaml.safe_load(printed)
    assert document["publishers"][0]["name"] == "chatter"
    VALIDATOR.validate(document)


def test_the_interface_where_a_file_is_in_the_way(capsys: pytest.CaptureFixture[str]) -> None:
    write("taken", "")
    assert main(["nodl", "demo/talker", "-o", "taken"]) == 2
    assert capsys.readouterr().err.startswith("rosward: cannot write to taken: ")


def test_sourced_underlays(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Only where they are asked for: a result must not depend on the terminal that it was made in."""
    write("opt/share/base/package.xml", PACKAGE.format(name="base"))
    write("opt/share/ament_index/resource_index/packages/base", "")
    write("opt/share/base/launch/base.launch.xml", XML)
    monkeypatch.setenv("AMENT_PREFIX_PATH", f"/nowhere:{Path('opt').absolute()}")
    arguments = ["extract", "-q", "demo", "--launch", "base:base.launch.xml"]
    assert main(arguments) == 2
    assert "no package base in the sources or underlays" in capsys.readouterr().err
    assert main([*arguments, "--ament-prefix-path"]) == 0


def test_the_summary_counts_what_was_launched(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["extract", "--launch", "demo:x.launch.xml", "--launch", "demo:p.launch.py"]) == 0
    assert "2 nodes in 2 processes" in capsys.readouterr().out


def test_a_second_run_gives_the_same_bytes() -> None:
    outputs = []
    for _ in range(2):
        assert main(["extract", "-q", "--all-launch", "--format", "json,policy,dot,permissions"]) == 0
        outputs.append({p: p.read_bytes() for p in Path("rosward-out").rglob("*") if p.is_file()})
    assert outputs[0] == outputs[1]


@pytest.mark.parametrize("command", ["extract", "launch-tree", "nodl"])
def test_help(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as exit_:
        main([command, "--help"])
    assert exit_.value.code == 0
    assert "Exit status: 0" in capsys.readouterr().out


@pytest.mark.parametrize(
    "arguments",
    [("nodl",), ("extract", "--enclaves", "none"), ("launch-tree", "--enclaves", "node"), ("extract", "--launch")],
)
def test_wrong_use_is_status_2(arguments: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as exit_:
        main(list(arguments))
    assert exit_.value.code == 2
    assert "--help` for usage" in capsys.readouterr().err
