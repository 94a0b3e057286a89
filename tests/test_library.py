# SPDX-License-Identifier: Apache-2.0
"""`import rosward`: what is public, and how a program says what is started."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import rosward
from rosward.cli import main

EXAMPLES = Path(__file__).parent.parent / "examples"
FLEET = "delivery_bringup:fleet.launch.py"


def test_what_is_public_is_listed_before_it_is_used() -> None:
    code = "import rosward, sys; print(sorted(set(rosward.__all__) - set(dir(rosward))), 'rosward.pipeline' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout == "[] False\n"
    assert {n for n in dir(rosward) if not n.startswith("_")} == {n for n in rosward.__all__ if not n.startswith("_")}
    assert all(getattr(rosward, name) is not None for name in rosward.__all__)


@pytest.mark.slow
def test_a_launch_file_is_started_with_its_arguments(tmp_path: Path) -> None:
    """As the command does it: the same network.json."""
    given = {"robots": "a,b"}
    result = rosward.extract(EXAMPLES, launch=FLEET, arguments=given)
    main(
        [
            "extract",
            str(EXAMPLES),
            "--launch",
            FLEET,
            "--arg",
            "robots:=a,b",
            "-q",
            "--format",
            "json",
            "-o",
            str(tmp_path),
        ]
    )
    from rosward.outputs.documents.network_json import network_json

    assert network_json(result.network) == (tmp_path / "network.json").read_text(encoding="utf-8")
    assert {node.launched_by is not None for node in result.network.nodes} == {True}


def test_a_path_is_nothing_but_a_path(tmp_path: Path) -> None:
    odd = tmp_path / "a,b:=c.launch.xml"
    odd.write_text('<launch><node pkg="rviz2" exec="rviz2" name="view"/></launch>', encoding="utf-8")
    assert "/view" in {n.fqn for n in rosward.extract(tmp_path, launch=odd).network.nodes}
    assert "/view" in {n.fqn for n in rosward.extract(tmp_path, launch=[odd]).network.nodes}


def test_each_launch_file_has_arguments_of_its_own(tmp_path: Path) -> None:
    file = tmp_path / "one.launch.xml"
    file.write_text(
        '<launch><arg name="n"/><node pkg="rviz2" exec="rviz2" name="$(var n)"/></launch>', encoding="utf-8"
    )
    result = rosward.extract(tmp_path, launch=[f"{file},n:=left", file], arguments={"n": "right"})
    assert {"/left", "/right"} <= {node.fqn for node in result.network.nodes}


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"launch": "p/q:f"}, "is not of the form FILE or PKG:FILE"),
        ({"arguments": {"a": "b"}}, "none was given"),
        ({"launch": FLEET, "arguments": {"a": 1}}, "'a' must be a string"),
    ],
)
def test_what_cannot_be_meant_is_refused(wrong: dict[str, object], said: str) -> None:
    with pytest.raises((rosward.RequestError, rosward.UnknownRequestError), match=said):
        rosward.extract(EXAMPLES, **wrong)  # type: ignore[arg-type]


def test_what_is_not_there_is_told() -> None:
    with pytest.raises(rosward.UnknownRequestError, match="nowhere"):
        rosward.extract(EXAMPLES, launch="nowhere:x.launch.py")


def test_a_request_and_launch_files_are_too_much() -> None:
    from rosward.deployment.request import Request

    with pytest.raises(rosward.RequestError, match="pass either a request"):
        rosward.extract(EXAMPLES, launch=FLEET, request=Request(all_launch=True))
