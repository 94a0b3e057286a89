# SPDX-License-Identifier: Apache-2.0
"""The notation of declared interfaces: what is rejected, where, and that nothing breaks the reader."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosward.deployment.declared.declarations import Declarations
from rosward.deployment.declared.read import read_package
from rosward.ros.distro import Distro
from rosward.ros.entities import Qos

from .declared_nodes import codes, lines, nodes, start

HEAD = "nodl_version: 2\npackage: acme\nsource: https://example.org (1.0)\nclient_library: rclpy\n"


def complaint(body: str, head: str = HEAD) -> str:
    package, findings = read_package(head + body, "models/acme.yaml", "acme")
    assert package is None
    (finding,) = findings
    assert finding.code == "RW324"
    assert finding.place.file == "models/acme.yaml"
    return f"{finding.place.line}: {finding.message}"


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("executables: {a: {node: a, publisher: []}}", "unknown key 'publisher'"),
        ("executables: {a: {publishers: []}}", "'node' is missing"),
        ("executables: {a: {}}", "'nodes' is missing: write 'nodes: []' if it creates no node"),
        ("executables: {a: {node: a, publishers: [{name: x, qos: 1}]}}", "'type' is missing"),
        ("executables: {a: {node: a, publishers: [{name: x, type: std_msgs/msg/String}]}}", "'qos' is missing"),
        ("executables: {a: {node: a, publishers: [{name: x, type: a/srv/B, qos: 1}]}}", "expected package/msg/Name"),
        ("executables: {a: {node: a, publishers: [{name: x, type: a/msg/B, qos: often}]}}", "unknown profile 'often'"),
        (
            "executables: {a: {node: a, publishers: [{name: '*', type: a/msg/B, qos: 1}]}}",
            "a name must not contain spaces",
        ),
        ("executables: {a: {node: a, groups: [{when: {param: x}}]}}", "one of is, not, in, set"),
        ("executables: {a: {node: a, groups: [{for_each: {as: x}}]}}", "one of family, words, list, below, values"),
        ("executables: {a: {node: a, groups: [{for_each: {as: x, family: odom}}]}}", "a family must have {n}"),
        ("executables: {a: {node: a, groups: [{since: indigo}]}}", "'since' must name a distribution"),
        (
            "executables: {a: {node: a, groups: [{cases: {}}]}}",
            "'switch', 'cases' and 'otherwise' must be used together",
        ),
        ("executables: {a: {node: a, options: {fast: true}}}", "unknown option 'fast'"),
        ("executables: {a: {same_as: b}}", "same_as does not name another executable"),
        ("interfaces: {x: {include: [y]}}", "there is no interface y"),
        ("interfaces: {x: {include: [y]}, y: {include: [x]}}", "includes itself"),
        ("executables: {a: {node: a, flows: [{data: [x]}]}}", "'to' is missing: the output"),
        ("executables: {a: {node: a, flows: [{to: x, datum: [y]}]}}", "unknown key 'datum'"),
        ("executables: {a: {node: a, flows: [{to: x, data: y}]}}", "expected a list"),
        (
            "executables: {a: {node: a, flows: [{to: 'service:x'}]}}",
            "service:x is no output: expected a topic, or KIND",
        ),
        (
            "executables: {a: {node: a, flows: [{to: x, data: ['request:y']}]}}",
            "request:y is no input: expected a topic",
        ),
        ("executables: {a: {node: a, flows: [{to: x, data: ['topic:']}]}}", "topic: is no input"),
        ("executables: {a: {node: a, flows: [{to: x, data: ['timer:t']}]}}", "timer:t is no input"),
        ("executables: {a: {node: a, flows: [{to: x, data: [y z]}]}}", "a name without spaces"),
        ("executables: {a: {node: a, flows: [{to: x, data: [y], control: [y]}]}}", "y stands here twice"),
        ("executables: &x {a: *x}", "aliases are not supported"),
        ("executables: {a: {node: a, node: b}}", "'node' occurs twice here"),
        ("executables: [", "not valid YAML"),
        ("executables: " + "[" * 120 + "]" * 120, "nested too deeply"),
        ("executables: {a: {node: [1]}}", "expected a string here"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(body: str, expected: str) -> None:
    message = complaint(body)
    assert expected in message
    assert message.startswith("5: ")


def test_the_head() -> None:
    assert "expected nodl_version: 2" in complaint("package: acme", "")
    assert "declares package other" in complaint("", HEAD.replace("acme", "other"))
    assert "client_library must be rclcpp or rclpy" in complaint("", HEAD.replace("rclpy", "roscpp"))
    assert "the file is empty" in complaint("", "")


def test_qos_is_that_of_nodl_or_short() -> None:
    body = (
        "executables: {a: {node: a, publishers: ["
        "{name: a, type: p/msg/T, qos: 5},"
        "{name: b, type: p/msg/T, qos: sensor_data},"
        "{name: c, type: p/msg/T, qos: {history: KEEP_LAST, depth: 1, reliability: RELIABLE, durability: TRANSIENT_LOCAL}}"
        "]}}"
    )
    package, findings = read_package(HEAD + body, "acme.yaml", "acme")
    assert package is not None, findings
    (node,) = package.executables["a"].nodes
    assert [e.qos for e in node.group.endpoints] == [
        Qos("reliable", "volatile", "keep_last", 5),
        Qos("best_effort", "volatile", "keep_last", 5),
        Qos("reliable", "transient_local", "keep_last", 1),
    ]


def write(folder: Path, body: str, name: str = "acme.yaml") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(HEAD + body)
    return folder


def test_a_users_folder_stands_before_the_builtin_ones(tmp_path: Path) -> None:
    write(tmp_path / "nodes", "executables: {tool: {node: tool, publishers: [{name: x, type: p/msg/T, qos: 1}]}}")
    log = start("acme", "tool", folders=[tmp_path])
    assert (nodes(log), lines(log)) == (["/tool"], ["pub x T"])
    joy = HEAD.replace("acme", "joy") + "executables: {joy_node: {node: mine}}"
    (tmp_path / "joy.yaml").write_text(joy)
    known = Declarations([tmp_path])
    mine = known.executable("joy", "joy_node")
    assert mine is not None
    assert [n.name for n in mine.nodes] == ["mine"]
    assert known.executable("joy", "game_controller_node") is not None  # the others stay


def test_a_file_that_cannot_be_read_is_a_finding_once(tmp_path: Path) -> None:
    write(tmp_path, "executables: {a: {}}")
    known = Declarations([tmp_path])
    assert known.executable("acme", "a") is None
    assert known.component("acme", "a") is None
    assert [f.code for f in known.findings] == ["RW324"]


@pytest.mark.parametrize("name", ["../acme", "a/b", "", ".", "acme\0", "no_such_package"])
def test_names_of_packages_are_no_paths(name: str, tmp_path: Path) -> None:
    known = Declarations([tmp_path / "deeper"])
    write(tmp_path, "")
    assert known.executable(name, "a") is None
    assert not known.findings


BODY = """
interfaces:
  camera:
    publishers: [{name: '${name}/image', type: sensor_msgs/msg/Image, qos: sensor_data}]
executables:
  cameras:
    node: cameras
    parameters:
      names: {type: string_array, default_value: [left, right]}
      mode: {type: string, default_value: fast}
    groups:
      - for_each: {as: camera, list: names}
        include: [{interface: camera, with: {name: '${camera}'}}]
      - switch: '${param:mode}'
        cases:
          fast: {publishers: [{name: fast, type: p/msg/T, qos: 1}]}
          slow: {publishers: [{name: slow, type: p/msg/T, qos: 1}]}
        otherwise:
          open: its mode is not known
      - when: [{param: mode, in: [slow, off]}, {argument: --log, set: true}]
        publishers: [{name: '${argument:--log}', type: p/msg/T, qos: 1}]
      - since: jazzy
        service_servers: [{name: '~/reset', type: p/srv/T}]
      - until: iron
        service_servers: [{name: reset, type: p/srv/T}]
      - when: {installed: extras}
        publishers: [{name: extra, type: p/msg/T, qos: 1}]
    nodes:
      - node: '${node_name}_helper'
        namespace: '${namespace}/inner'
        arguments: [--ros-args, -r, '__node:=${node_name}_helper']
        publishers: [{name: '${node}/state', type: p/msg/T, qos: 1}]
"""


@pytest.mark.parametrize(
    ("words", "distro", "expected"),
    [
        ([], Distro.JAZZY, ["?pub extra T", "pub fast T", "pub left/image Image", "pub right/image Image", "srv ~/reset T"]),
        (
            ["--ros-args", "-p", "names:=[top]", "-p", "mode:=slow"],
            Distro.HUMBLE,
            ["?pub extra T", "pub slow T", "pub top/image Image", "srv reset T"],
        ),
        (["--log", "/l", "--ros-args", "-p", "names:=[]", "-p", "mode:=off"], Distro.HUMBLE, ["?pub extra T", "pub /l T", "srv reset T"]),
    ],
)  # fmt: skip
def test_the_notation(words: list[str], distro: Distro, expected: list[str], tmp_path: Path) -> None:
    write(tmp_path, BODY)
    log = start("acme", "cameras", list(words), distro=distro, folders=[tmp_path])
    assert lines(log) == expected
    assert codes(log) == (["RW314"] if "mode:=off" in words else [])


def test_a_node_whose_namespace_may_be_the_root_has_one_slash_before_its_name(tmp_path: Path) -> None:
    write(
        tmp_path, "executables: {tool: {node: 't${random}', publishers: [{name: '${node}/x', type: p/msg/T, qos: 1}]}}"
    )
    log = start("acme", "tool", ["--ros-args", "-r", "t_7:__ns:=/left"], folders=[tmp_path])
    assert lines(log) == ["pub /left/t*/x T", "pub /t*/x T"]


def test_further_nodes_see_the_names_of_the_first(tmp_path: Path) -> None:
    write(tmp_path, BODY)
    log = start("acme", "cameras", ["--ros-args", "-r", "__node:=eyes", "-r", "__ns:=/head"], folders=[tmp_path])
    assert nodes(log) == ["/head/eyes", "/head/eyes_helper"]  # the rule of the process moves both
    assert lines(log, 2) == ["pub /head/eyes_helper/state T"]


@given(st.text(max_size=200))
def test_any_text_ends_in_a_package_or_a_finding(text: str) -> None:
    for head in ("", HEAD):
        package, findings = read_package(head + text, "acme.yaml", "acme")
        assert (package is None) == bool(findings)


HOSTILE = """
interfaces:
  a: {include: [acme/b, acme/b, acme/b, acme/b]}
  b: {include: [acme/c, acme/c, acme/c, acme/c]}
  c: {include: [other/a, other/a, other/a, other/a]}
executables:
  bomb: {node: bomb, include: [a]}
  loops:
    node: loops
    parameters: {many: {type: string_array, default_value: [MANY]}}
    groups:
      - for_each: [{as: x, list: many}, {as: y, list: many}, {as: z, list: many}]
        when: {value: '${x}', is: never}
        publishers: [{name: x, type: p/msg/T, qos: 1}]
  long: {node: 'LONG'}
"""


@pytest.mark.parametrize("name", ["bomb", "loops", "long"])
def test_hostile_files_end_in_bounded_time(name: str, tmp_path: Path) -> None:
    body = HOSTILE.replace("MANY", ", ".join(f"n{n}" for n in range(150))).replace("LONG", "${random}" * 3000)
    write(tmp_path, body)
    other = HEAD.replace("acme", "other") + "interfaces: {a: {include: [acme/a, acme/a, acme/a, acme/a]}}"
    (tmp_path / "other.yaml").write_text(other)
    log = start("acme", name, folders=[tmp_path])
    assert codes(log)[-1:] == ([] if name == "long" else ["RW201"])


def test_includes_that_fan_out_are_read_once() -> None:
    body = (
        "interfaces:\n" + "".join(f"  i{n}: {{include: [i{n + 1}, i{n + 1}]}}\n" for n in range(150)) + "  i150: {}\n"
    )
    package, findings = read_package(HEAD + body, "acme.yaml", "acme")
    assert package is not None, findings
    assert "more than 200 interfaces" in complaint("interfaces: {" + ", ".join(f"i{n}: {{}}" for n in range(300)) + "}")
