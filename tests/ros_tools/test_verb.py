# SPDX-License-Identifier: Apache-2.0
"""`ros2 security extract_policy`, in front of a stand-in for sros2 that has the documented interface of its verbs.

With the real ros2cli and sros2 it is tried by hand, see docs/ros2-cli.md.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import types
from collections.abc import Callable
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from rosward.cli import main

from .test_package import PROJECT

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, {name}, 10)
rclpy.spin(node)
"""
PROGRAM = """\
import rclpy
from std_msgs.msg import String

def main():
    rclpy.init()
    node = rclpy.create_node("talker")
    node.create_publisher(String, "chatter", 10)
    rclpy.spin(node)
"""
SETUP = """\
from setuptools import setup

setup(name="demo", packages=["demo"], entry_points={"console_scripts": ["talker = demo.talker:main"]})
"""
LAUNCH = '<launch><node pkg="demo" exec="talker"/></launch>'
PACKAGE = """\
<package format="3">
  <name>{}</name><version>1.0.0</version><description>d</description><maintainer email="a@b.c">a</maintainer><license>l</license>
</package>
"""

Verb = Callable[..., int]


class VerbExtension:
    """What `sros2.verb` documents: `NAME` is set by who loads it, `main` must be defined, `add_arguments` can be."""

    NAME: str | None = None

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:
        pass

    def main(self, *, args: argparse.Namespace) -> int:
        raise NotImplementedError


@pytest.fixture
def verb(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Verb:
    """`ros2 security extract_policy WORDS…`, in an empty folder, as ros2cli finds and calls it."""
    monkeypatch.chdir(tmp_path)
    for name in ("ROS_DISTRO", "AMENT_PREFIX_PATH"):
        monkeypatch.delenv(name, raising=False)
    for name, members in {"sros2": {}, "sros2.verb": {"VerbExtension": VerbExtension}}.items():
        module = types.ModuleType(name)
        vars(module).update(members)
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.delitem(sys.modules, "rosward.ros2_security", raising=False)
    value = PROJECT["entry-points"]["sros2.verb"]["extract_policy"]
    extension = EntryPoint("extract_policy", value, "sros2.verb").load()()
    assert isinstance(extension, VerbExtension)

    def call(*words: str) -> int:
        parser = argparse.ArgumentParser(formatter_class=argparse.RawDescriptionHelpFormatter)
        extension.add_arguments(parser, "ros2 security extract_policy")
        status: int = extension.main(args=parser.parse_args(words))
        return status

    return call


def write(path: str, text: str) -> None:
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text(text, encoding="utf-8")


def talker(name: str = '"chatter"') -> None:
    write("src/talker.py", TALKER.format(name=name))


def policy(file: str = "policy.xml") -> str:
    return Path(file).read_text(encoding="utf-8")


def test_it_writes_the_policy_that_extract_writes(verb: Verb, capsys: pytest.CaptureFixture[str]) -> None:
    talker()
    assert verb("policy.xml", "src") == 0
    out = capsys.readouterr().out
    assert out.startswith("rosward read 1 file (8 lines) for jazzy: 1 node in 1 process.\n")
    assert out.endswith("\n  policy.xml\n")
    assert main(["extract", "-q", "src"]) == 0
    assert policy() == policy("rosward-out/policy.xml")
    assert [p.name for p in Path().iterdir() if p.suffix == ".xml"] == ["policy.xml"], "one file, and nothing beside it"


def test_the_status_is_that_of_rosward(verb: Verb, capsys: pytest.CaptureFixture[str]) -> None:
    talker("input()")
    assert verb("policy.xml", "src", "-q") == 1
    assert verb("policy.xml", "nowhere") == 2
    assert capsys.readouterr().err == "rosward: no such file or folder: nowhere\n"


def test_the_distro_is_the_sourced_one(
    verb: Verb, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """get_type_description came with iron. The command line counts more, then the configuration of the sources, then ROS_DISTRO."""
    talker()
    for sourced, words, expected in (
        ("humble", [], False),
        ("kilted", [], True),
        ("", [], True),
        ("kilted", ["--distro", "humble"], False),
    ):
        monkeypatch.setenv("ROS_DISTRO", sourced)
        assert verb("policy.xml", "src", "-q", *words) == 0
        assert ("get_type_description" in policy()) is expected, (sourced, words)
    write("src/rosward.toml", 'distro = "humble"')
    assert verb("policy.xml", "src", "-q") == 0
    assert "get_type_description" not in policy()
    assert verb("policy.xml", "src", "-q", "--no-config") == 0
    assert "get_type_description" in policy()
    monkeypatch.setenv("ROS_DISTRO", "foxy")
    assert verb("policy.xml", "src", "--no-config") == 2
    assert "ROS_DISTRO is foxy, which is unknown: choose --distro humble|" in capsys.readouterr().err


def test_sourced_folders_are_underlays(
    verb: Verb, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Who runs `ros2` has sourced what the launch files name; `rosward extract` asks for --ament-prefix-path."""
    write("src/demo/package.xml", PACKAGE.format("demo"))
    write("src/demo/setup.py", SETUP)
    write("src/demo/demo/__init__.py", "")
    write("src/demo/demo/talker.py", PROGRAM)
    write("opt/share/base/package.xml", PACKAGE.format("base"))
    write("opt/share/ament_index/resource_index/packages/base", "")
    write("opt/share/base/launch/base.launch.xml", LAUNCH)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(Path("opt").absolute()))
    words = ["policy.xml", "src", "-q", "--launch", "base:base.launch.xml"]
    assert verb(*words) == 0
    assert "/chatter" in policy()
    assert verb(*words, "--no-ament-prefix-path") == 2
    assert "no package base in the sources or underlays" in capsys.readouterr().err


def test_its_own_file_is_written_anew_and_another_is_left_alone(verb: Verb, capsys: pytest.CaptureFixture[str]) -> None:
    """generate_policy would add to it, and what the code no longer needs would stay for ever."""
    talker()
    assert verb("policy.xml", "src", "-q") == 0
    talker('"news"')
    assert verb("policy.xml", "src", "-q") == 0
    assert "/chatter" not in policy()

    write("mine.xml", '<policy version="0.2.0"/>')
    assert verb("mine.xml", "src") == 2
    assert "mine.xml was not written by rosward" in capsys.readouterr().err
    assert policy("mine.xml") == '<policy version="0.2.0"/>'
    assert verb("mine.xml", "src", "-q", "--replace") == 0
    assert policy("mine.xml") == policy()


def test_without_a_node_there_is_no_policy(verb: Verb, capsys: pytest.CaptureFixture[str]) -> None:
    write("src/plain.py", "x = 1\n")
    assert verb("policy.xml", "src", "-q") == 1
    assert capsys.readouterr().err == "rosward: no nodes found, no policy written\n"
    assert not Path("policy.xml").exists()


@pytest.mark.parametrize("file", ["src", "src/talker.py/policy.xml", "src/\0"])
def test_a_path_that_cannot_be_written_is_wrong_use(verb: Verb, file: str, capsys: pytest.CaptureFixture[str]) -> None:
    talker()
    assert verb(file, "src", "-q", "--replace") == 2
    assert capsys.readouterr().err.startswith(f"rosward: cannot write to {file}".replace("\0", "\\x00"))


def test_nothing_of_ros_is_needed_elsewhere() -> None:
    """Only the module that sros2 loads imports sros2."""
    code = "import sys; sys.modules['sros2'] = None; import rosward.cli.extract_policy, rosward.cli"
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
