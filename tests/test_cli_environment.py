# SPDX-License-Identifier: Apache-2.0
"""The environment that a user gives: by `--env`, `--env-from-shell`, `[env]` of rosward.toml, `extract(env=…)`, or on the page of `serve`.

What it does is in tests/systems/surroundings.md.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import rosward
from rosward.cli import main
from rosward.server.places import UploadRefusedError
from rosward.server.settings import read_settings
from rosward.source.discover import discover
from rosward.source.surroundings import surroundings

NODE = """\
import os

import rclpy
from rclpy.node import Node

rclpy.init()
rclpy.spin(Node("n_" + os.environ["A"] + os.environ["B"] + os.environ["C"]))
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A node whose name is made of three variables."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("C", "shell")
    monkeypatch.delenv("B", raising=False)
    Path("node.py").write_text(NODE, encoding="utf-8")


def node(*arguments: str) -> str:
    main(["extract", "--format", "json", "-q", *arguments])
    document = json.loads(Path("rosward-out/network.json").read_text(encoding="utf-8"))
    return str(document["nodes"][0]["fqn"])


def test_the_last_value_counts_and_the_shell_is_asked_for_what_is_named() -> None:
    assert (
        node("--env", "A=1", "--env", "B=x=y", "--env", "A=2", "--env", "B=2", "--env-from-shell", "C") == "/n_22shell"
    )
    assert node("--env", "A=1", "--env", "B=2") == "/n_12*"


def test_several_names_of_the_shell(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("B", "b")
    assert node("--env-from-shell", "B,C", "--env", "A=") == "/n_bshell"


@pytest.mark.parametrize(
    ("given", "told"),
    [
        (("--env", "A"), "'A' is not of the form NAME=VALUE"),
        (("--env", "=1"), "'' is not a valid name of an environment variable"),
        (("--env", "A B=1"), "'A B' is not a valid name of an environment variable"),
        (("--env", "A:=1"), "A:=1 has the form of a launch argument (--arg)"),
        (("--env-from-shell", "B,C"), "not set in this shell: B"),
    ],
)
def test_what_is_no_variable_is_refused(given: tuple[str, ...], told: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["extract", *given])
    assert told in capsys.readouterr().err


def test_the_command_line_adds_to_the_file() -> None:
    Path("rosward.toml").write_text('[env]\nA = "file"\nB = "file"\n', encoding="utf-8")
    assert node("--env", "B=line", "--env", "C=c") == "/n_filelinec"
    assert node("--no-config", "--env", "B=line") == "/n_*line*"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("env = 1", "env must be a table of strings"),
        ("[env]\nA = 1", "env must be a table of strings"),
        ('[env]\n"A B" = ""', "env must be a table of variables: 'A B' is not a valid name"),
        ('[env]\nROS_VERSION = "1"', "ROS_VERSION is '2' for the distro jazzy, so it cannot be '1'"),
    ],
)
def test_what_is_no_table_of_variables_is_refused(text: str, told: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("rosward.toml").write_text(text, encoding="utf-8")
    assert main(["extract"]) == 2
    assert told in capsys.readouterr().err


def test_the_library_takes_it() -> None:
    (found,) = rosward.extract(env={"A": "a", "B": "b", "C": "c"}).network.nodes
    assert found.fqn == "/n_abc"
    with pytest.raises(ValueError, match="cannot be"):
        rosward.extract(env={"ROS_DISTRO": "humble"})


def test_the_page_takes_it() -> None:
    settings = read_settings({"env": {"A": "1"}})
    assert (settings.env, settings.words()) == ((("A", "1"),), "jazzy, A=1")
    assert read_settings(settings.document()) == settings
    for wrong in ({"A B": "1"}, {"A": 1}, ["A"], {"ROS_DISTRO": "humble"}):
        with pytest.raises(UploadRefusedError):
            read_settings({"env": wrong})


def test_conditions_of_a_package_hold_for_the_distro(tmp_path: Path) -> None:
    needs = "".join(
        f'<exec_depend condition="{condition}">{name}</exec_depend>'
        for name, condition in (
            ("old", "$ROS_DISTRO == humble"),
            ("new", "$ROS_DISTRO != humble"),
            ("own", "$KIND == a"),
        )
    )
    Path("package.xml").write_text(
        '<package format="3"><name>demo</name><version>1.0.0</version><description>d</description>'
        f'<maintainer email="m@d.org">m</maintainer><license>MIT</license>{needs}</package>',
        encoding="utf-8",
    )
    found = [
        discover([tmp_path], environment=surroundings(distro, given)).packages[0].depends
        for distro, given in (("humble", {}), ("kilted", {"KIND": "a"}))
    ]
    assert found == [{"old"}, {"new", "own"}]
