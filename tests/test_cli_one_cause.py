# SPDX-License-Identifier: Apache-2.0
"""One cause, one finding: how a person and a program read what one thing brings with it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from rosward.cli import main

ROBOT = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    node = Node("robot")
    prefix = node.declare_parameter("prefix", "p").value
    node.create_publisher(String, prefix, 10){comment}
    node.create_publisher(String, prefix + "/scan", 10)
    node.create_publisher(String, prefix + "/odom", 10)
    rclpy.spin(node)
"""
UNSET = """\
<launch>
  <arg name="prefix"/>
  <node pkg="demo" exec="robot"><param name="prefix" value="$(var prefix)" type="str"/></node>
</launch>
"""
LOOP = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory("demo")
    return LaunchDescription([
        Node(package="demo", executable="robot", name=name, parameters=[share + "/" + name + ".yaml"])
        for name in ("left", "right", "rear")
    ])
"""
PACKAGE = """\
<package format="3"><name>demo</name><version>1.0.0</version><description>d</description>
<maintainer email="m@demo.org">m</maintainer><license>MIT</license></package>
"""
SETUP = "from setuptools import setup\nsetup(name='demo', packages=['demo'], entry_points={'console_scripts': ['robot = demo.robot:main']})\n"


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A package with a robot; each test runs in its folder."""
    (tmp_path / ".git").mkdir()
    files = {
        "package.xml": PACKAGE,
        "setup.py": SETUP,
        "demo/__init__.py": "",
        "demo/robot.py": ROBOT.format(comment=""),
        "launch/unset.launch.xml": UNSET,
        "launch/loop.launch.py": LOOP,
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)


def extract(launch: str, *arguments: str) -> int:
    return main(["extract", "--launch", f"demo:{launch}", "--format", "json", *arguments])


def written(name: str) -> Any:
    return json.loads((Path("rosward-out") / name).read_text(encoding="utf-8"))


def test_the_names_of_one_unset_argument_are_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert extract("unset.launch.xml") == 1
    lines = capsys.readouterr().out.splitlines()
    told = [line for line in lines if line.startswith(("  launch/", "  demo/"))]
    assert told == [
        "  launch/unset.launch.xml:2  The launch argument 'prefix' has no default and was not given a value. "
        "(and 3 more with this cause: 1 RW101, 2 RW102)"
    ]
    assert "Incomplete: 1 error, 0 warnings." in lines
    assert extract("unset.launch.xml", "--arg", "prefix:=/a") == 0
    assert "more of this cause" not in capsys.readouterr().out


def test_verbose_lists_them_all_with_their_codes(capsys: pytest.CaptureFixture[str]) -> None:
    extract("unset.launch.xml", "-v")
    lines = [line.partition("  the ")[0] for line in capsys.readouterr().out.splitlines() if "RW10" in line]
    assert [" ".join(line.split()[:2]) for line in lines] == [
        "demo/robot.py:10 RW101",
        "demo/robot.py:11 RW102",
        "demo/robot.py:12 RW102",
    ]


def test_programs_read_every_place() -> None:
    extract("unset.launch.xml", "--format", "json,sarif")
    diagnostics = written("network.json")["diagnostics"]
    assert [(d["code"], d["line"]) for d in diagnostics if d["causes"]] == [
        ("RW101", 10),
        ("RW102", 11),
        ("RW302", 11),
        ("RW102", 12),
        ("RW302", 12),
        ("RW312", 2),
    ]
    (result,) = written("findings.sarif")["runs"][0]["results"]
    assert result["ruleId"] == "RW312"
    lines = [r["physicalLocation"]["region"]["startLine"] for r in result["relatedLocations"]]
    assert lines == [10, 11, 12, 11, 12]


def test_another_one_of_a_known_cause_is_new(capsys: pytest.CaptureFixture[str]) -> None:
    extract("unset.launch.xml", "--write-baseline", "known.json")
    assert extract("unset.launch.xml", "--baseline", "known.json", "--format", "sarif") == 0
    (old,) = written("findings.sarif")["runs"][0]["results"]
    with Path("demo/robot.py").open("a", encoding="utf-8") as file:
        file.write("\n\n")
    text = ROBOT.format(comment="").replace(
        "    rclpy.spin", "    node.create_publisher(String, prefix, 1)\n    rclpy.spin"
    )
    Path("demo/robot.py").write_text(text, encoding="utf-8")
    capsys.readouterr()
    assert extract("unset.launch.xml", "--baseline", "known.json", "--format", "sarif,github") == 1
    assert "::error file=demo/robot.py,line=13" in capsys.readouterr().out
    states = [(r["ruleId"], r["baselineState"]) for r in written("findings.sarif")["runs"][0]["results"]]
    assert sorted(states) == [("RW101", "new"), ("RW312", "unchanged")]
    extract("unset.launch.xml", "--format", "sarif")
    (new,) = written("findings.sarif")["runs"][0]["results"]
    assert new["partialFingerprints"] != old["partialFingerprints"]


def test_a_comment_ignores_its_place_and_leaves_the_others(capsys: pytest.CaptureFixture[str]) -> None:
    text = ROBOT.format(comment="").replace('"/scan", 10)', '"/scan", 10)  # rosward: ignore')
    Path("demo/robot.py").write_text(text, encoding="utf-8")
    assert extract("unset.launch.xml") == 1
    out = capsys.readouterr().out
    assert "(and 2 more with this cause: 1 RW101, 1 RW102)" in out
    assert "2 ignored." in out


def test_annotations_are_one_for_each_cause(capsys: pytest.CaptureFixture[str]) -> None:
    extract("unset.launch.xml", "-q", "--format", "github")
    (line,) = capsys.readouterr().out.splitlines()
    assert line.startswith("::error file=launch/unset.launch.xml,line=2")
    assert line.endswith("(and 3 more with this cause: 1 RW101, 2 RW102)")


def test_findings_of_a_loop_belong_to_each_of_its_items() -> None:
    """Three nodes of one line, each with a file of its own that is not there: three findings, not nine."""
    extract("loop.launch.py")
    found = [d for d in written("network.json")["diagnostics"] if d["code"] == "RW315"]
    told = {d["message"].split("/")[-1].split()[0]: d["nodes"] for d in found}
    assert told == {"left.yaml": ["/left"], "rear.yaml": ["/rear"], "right.yaml": ["/right"]}


def test_a_node_of_a_loop_is_explained_with_its_own(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "/left", "--launch", "demo:loop.launch.py"]) == 0
    out = capsys.readouterr().out
    assert "/left.yaml" in out
    assert "/right.yaml" not in out


def test_a_name_that_is_made_at_each_start_is_one_note(capsys: pytest.CaptureFixture[str]) -> None:
    """Each listener in C++ names its node by an address: nobody can change that, so nobody is warned."""
    nodes = "".join(
        f'<node pkg="robot_localization" exec="ekf_node" name="ekf_{n}"><param name="frequency" value="{n}.0"/></node>'
        for n in (1, 2)
    )
    Path("launch/ekf.launch.xml").write_text(f"<launch>\n{nodes}\n</launch>\n", encoding="utf-8")
    assert extract("ekf.launch.xml", "-v") == 0
    out = capsys.readouterr().out
    assert "note RW107 name generated at each start: 1" in out
    assert "RW102" not in out
    assert "RW302" not in out
    assert "/transform_listener_impl_*" in {n["fqn"] for n in written("network.json")["nodes"]}
