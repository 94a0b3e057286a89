# SPDX-License-Identifier: Apache-2.0
"""enclaves.txt: each process, and what to write where so that it runs in its enclave."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rosward.location import Place
from rosward.network.connect import connect
from rosward.outputs.policies.starts import starts_text
from rosward.ros.entities import Node

from .networks import node


def text(*nodes: Node) -> str:
    body = starts_text(connect("jazzy", nodes, ())).split("\n", 1)[1]
    return body.strip("\n")


def launched(file: str, line: int = 3) -> Node:
    return replace(
        node("/talker", system=False), process="demo/talker", executable="talker", launched_by=Place(file, line)
    )


@pytest.mark.parametrize(
    ("file", "words"),
    [
        ("a.launch.py", "ros_arguments=['--enclave', '/talker']"),
        ("a.launch.xml", 'ros_args="--enclave /talker"'),
        ("a.launch.yaml", 'ros_args: "--enclave /talker"'),
        ("a.launch.yml", 'ros_args: "--enclave /talker"'),
    ],
)
def test_in_the_language_of_the_launch_file(file: str, words: str) -> None:
    assert text(launched(file)) == f"/talker\n  demo/talker, started at {file}:3: {words}"


def test_without_a_launch_file() -> None:
    started = replace(launched("x.py"), launched_by=None)
    assert text(started) == "/talker\n  demo/talker: ros2 run demo talker --ros-args --enclave /talker"


def test_without_an_executable() -> None:
    started = replace(launched("x.py"), launched_by=None, executable=None)
    assert text(started) == "/talker\n  demo/talker: start it with --ros-args --enclave /talker"


def test_what_the_start_names_needs_nothing() -> None:
    assert (
        text(replace(launched("x.py"), given_enclave="/talker")) == "/talker\n  demo/talker: already set by its start"
    )


def test_one_place_that_starts_several() -> None:
    """A constant in a loop would be the same for all of them."""
    first = launched("x.py")
    second = replace(first, name="other", enclave="/other", process="demo/talker#2")
    assert "  demo/talker, started at x.py:3 like others: add --enclave /talker to" in text(first, second)


def test_the_nodes_of_a_shared_enclave() -> None:
    first = replace(launched("x.py"), enclave="/both")
    second = replace(first, name="other")
    assert text(first, second).splitlines()[1].startswith("  demo/talker (nodes /other, /talker), started at x.py:3")


def test_a_container_is_started_where_it_stands_not_where_its_components_do() -> None:
    box = replace(launched("x.py", 9), enclave="/box", package="rc", executable="container", process="rc/container#2")
    part = replace(box, name="a", package="acme", executable="acme::A", launched_by=Place("x.py", 15))
    assert "started at x.py:9: " in text(part, box)
