# SPDX-License-Identifier: Apache-2.0
"""Promise: a parameter file gives what rcl reads from it, each value with its line, or is refused with the line where rcl stops."""

from __future__ import annotations

import time

import pytest

from rosward.deployment.parameter_files import read_parameter_file
from rosward.domain.compound import Tuple
from rosward.domain.values import Const, Unknown, Value

ROBOT = """\
/**:
  ros__parameters:
    use_sim_time: true
left:
  arm:
    ros__parameters:
      rate: 010
      frame.id: base
      pid:
        gains: [1.0, 0.5]
        joints: []
  /*/gripper:
    ros__parameters: {force: "5"}
"""


def plain(value: Value) -> object:
    if isinstance(value, Tuple):
        return [plain(item) for item in value.items]
    assert isinstance(value, Const)
    return value.value


def rows(text: str) -> list[tuple[str, str, object, int]]:
    given, findings = read_parameter_file(text, "config/robot.yaml")
    assert not findings, findings
    assert all(row.place is not None and row.place.file == "config/robot.yaml" for row in given)
    return [(row.node, row.name, plain(row.value), row.place.line if row.place else 0) for row in given]


def refused(text: str) -> str:
    given, (finding,) = read_parameter_file(text, "robot.yaml")
    assert given == ()
    assert finding.code == "RW317"
    return f"{finding.place}: {finding.message.removeprefix('rcl rejects this parameter file: ')}"


def test_nodes_names_and_values() -> None:
    assert rows(ROBOT.replace("  /*/gripper", "  '*/gripper'")) == [
        ("/**", "use_sim_time", True, 3),
        ("left/arm", "rate", 8, 7),
        ("left/arm", "frame.id", "base", 8),
        ("left/arm", "pid.gains", [1.0, 0.5], 10),
        ("left/arm", "pid.joints", [], 11),
        ("left/*/gripper", "force", "5", 13),
    ]


@pytest.mark.parametrize(
    ("key", "node"),
    [("arm", "arm"), ("/arm", "/arm"), ("/left/arm", "/left/arm"), ("/**/arm", "/**/arm"), ("/*", "/*"), ("'*'", "*")],
)
def test_keys(key: str, node: str) -> None:
    assert rows(f"{key}:\n  ros__parameters:\n    x: 1\n") == [(node, "x", 1, 3)]


def test_nodes_beside_parameters() -> None:
    text = "a:\n  ros__parameters: {x: 1}\n  b:\n    ros__parameters: {x: 2}\n  ros__parameters: {y: 3}\n"
    assert rows(text) == [("a", "x", 1, 2), ("a", "y", 3, 5), ("a/b", "x", 2, 4)]


def test_one_parameter_keeps_a_value_for_each_type() -> None:
    """So that a later file can be told which of them holds."""
    text = "a:\n  ros__parameters:\n    x: 1\n    x: hello\n    x: 2\n"
    assert rows(text) == [("a", "x", 2, 5), ("a", "x", "hello", 4)]


def test_a_nested_name_replaces() -> None:
    """rcl finds no nested name again, so what comes later holds, whatever its type."""
    given, _ = read_parameter_file("a:\n  ros__parameters:\n    p: {x: 1}\n    p: {x: hello}\n    q: 1\n", "f")
    assert [(row.name, plain(row.value), row.nested) for row in given] == [
        ("p.x", 1, True),
        ("p.x", "hello", True),
        ("q", 1, False),
    ]


def test_documents_go_on() -> None:
    text = "a:\n  ros__parameters: {x: 1}\n---\na:\n  ros__parameters: {y: 2}\n"
    assert rows(text) == [("a", "x", 1, 2), ("a", "y", 2, 5)]


@pytest.mark.parametrize("text", ["", "# nothing\n", "a:\n  ros__parameters: {}\n", "hello\n"])
def test_nothing(text: str) -> None:
    assert rows(text) == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a:\n  ros__parameters:\n    x:\n    y: 1\n", "robot.yaml:3: a parameter has no value."),
        ("a:\n  ros__parameters:\n    x: [1, b]\n", "robot.yaml:3: the items of a list must have one type."),
        ("a:\n  ros__parameters:\n    x: &v 1\n    y: *v\n", "robot.yaml:4: it has an alias."),
        ("a:\n  x: 1\n", "robot.yaml:2: a value comes before ros__parameters."),
        ("a: [1]\n", "robot.yaml:1: a list comes before ros__parameters."),
        ("- a\n", "robot.yaml:1: a list is in place of a name."),
        ("ros__parameters:\n  x: 1\n", "robot.yaml:1: there is no node name before ros__parameters."),
        ("a-b:\n  ros__parameters: {x: 1}\n", "robot.yaml:2: 'a-b' is not a valid node name: a node name must hold only alphanumerics and '_'."),
        ("/a*:\n  ros__parameters: {x: 1}\n", "robot.yaml:2: '/a*' is not a valid node name: a wildcard must be a whole name."),
        ("/a:\n  /b:\n    ros__parameters: {x: 1}\n", "robot.yaml:3: '/a//b' is not a valid node name: it has an empty part."),
        ("a: {ros__parameters: {x: 1}\n", "robot.yaml:2: not YAML (did not find expected ',' or '}')."),
        ("%YAML 1.2\n---\na:\n", "robot.yaml:1: rcl does not support YAML 1.2."),
    ],
)  # fmt: skip
def test_refused(text: str, expected: str) -> None:
    assert refused(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "a:\n  ros__parameters:\n" + "".join(f"    k{n}: 1\n" for n in range(60_000)),
        "a:\n  ros__parameters:\n" + "".join("    k: {x: 1}\n" for _ in range(30_000)),
        "a:\n" * 1 + "".join("  " * n + "a:\n" for n in range(1, 400)),
        "a: {ros__parameters: {x: " + "[" * 100_000,
        "{a: " * 5_000,
        "\ud800: 1",
        "a: \x00",
    ],
)
def test_hostile(text: str) -> None:
    start = time.process_time()
    given, findings = read_parameter_file(text, "f")
    assert time.process_time() - start < 10
    assert [finding.code for finding in findings] in (["RW201"], ["RW317"])
    if findings[0].code == "RW201":
        assert [(row.node, row.name, isinstance(row.value, Unknown)) for row in given] == [("/**", "*", True)]
