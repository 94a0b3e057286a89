# SPDX-License-Identifier: Apache-2.0
"""What a declaration says about flows is what `rosward flow` tells of the node; of what it does not say, everything is assumed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from rosward.cli import main
from rosward.deployment.declared.declarations import MODELS, Declarations
from rosward.domain.text import readable

from .declared_nodes import codes, start

HEAD = "nodl_version: 2\npackage: acme\nsource: https://example.org (1.0)\nclient_library: rclcpp\n"
BLUR = """\
executables:
  blur:
    node: blur
    parameters:
      strength: {type: int, default_value: 1}
      output: {type: string, default_value: blurred}
    subscriptions:
      - {name: image, type: sensor_msgs/msg/Image, qos: 10}
      - {name: enable, type: std_msgs/msg/Bool, qos: 10}
    publishers:
      - {name: '${param:output}', type: sensor_msgs/msg/Image, qos: 10}
      - {name: state, type: std_msgs/msg/Bool, qos: 10}
    service_servers:
      - {name: '~/reset', type: std_srvs/srv/Trigger}
    flows:
"""
LAUNCH = """\
<launch>
  <node pkg="acme" exec="blur" namespace="front" args="{args}">
    <remap from="image" to="/cam/image"/>
  </node>
</launch>
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("models/nodes").mkdir(parents=True)


def flows(capsys: pytest.CaptureFixture[str], body: str, args: str = "") -> dict[str, Any]:
    """The entry of the node in flow.json."""
    Path("models/nodes/acme.yaml").write_text(HEAD + body, encoding="utf-8")
    Path("x.launch.xml").write_text(LAUNCH.replace("{args}", args), encoding="utf-8")
    assert main(["flow", ".", "--launch", "x.launch.xml", "--models", "models", "--format", "json"]) == 0
    (node,) = json.loads(capsys.readouterr().out)["nodes"]
    assert isinstance(node, dict)
    return node


def sinks(node: dict[str, Any]) -> dict[str, tuple[list[str], list[str], list[str], bool]]:
    return {s["sink"]: (s["data"], s["control"], s["trigger"], bool(s["assumed"])) for s in node["sinks"]}


def test_an_output_is_made_of_what_is_declared(capsys: pytest.CaptureFixture[str]) -> None:
    """Names are completed and remapped as those of its endpoints."""
    body = BLUR + "      - {to: '${param:output}', data: [image, 'parameter:strength'], control: [enable]}\n"
    node = flows(capsys, body)
    told = sinks(node)
    assert told["topic:/front/blurred"] == (
        ["parameter:strength", "topic:/cam/image"],
        ["topic:/front/enable"],
        [],
        False,
    )
    assert node["complete"] is True


def test_an_output_without_a_word_may_hold_everything(capsys: pytest.CaptureFixture[str]) -> None:
    told = sinks(flows(capsys, BLUR + "      - {to: '${param:output}', data: [image]}\n"))
    data, _, _, assumed = told["topic:/front/state"]
    assert assumed
    assert {"topic:/cam/image", "topic:/front/enable", "service:/front/blur/reset", "parameter:strength"} <= set(data)
    assert told["response:/front/blur/reset"][3]


def test_without_flows_all_is_assumed(capsys: pytest.CaptureFixture[str]) -> None:
    node = flows(capsys, BLUR.replace("    flows:\n", ""))
    assert all(assumed for *_, assumed in sinks(node).values())
    assert node["complete"] is False


def test_nothing_is_a_declaration_too(capsys: pytest.CaptureFixture[str]) -> None:
    assert sinks(flows(capsys, BLUR + "      - {to: state}\n"))["topic:/front/state"] == ([], [], [], False)


def test_several_entries_of_one_output_add_up(capsys: pytest.CaptureFixture[str]) -> None:
    more = "      - {to: state, control: [image]}\n      - {to: state, data: [image], trigger: [timer]}\n"
    assert sinks(flows(capsys, BLUR + more))["topic:/front/state"] == (["topic:/cam/image"], [], ["timer"], False)


def test_a_condition_decides_whether_an_entry_holds(capsys: pytest.CaptureFixture[str]) -> None:
    more = (
        "      - {to: state, data: [image], when: {argument: --all, set: true}}\n"
        "      - {to: state, data: [enable], when: {argument: --all, set: false}}\n"
    )
    assert sinks(flows(capsys, BLUR + more))["topic:/front/state"][0] == ["topic:/front/enable"]
    assert sinks(flows(capsys, BLUR + more, "--all yes"))["topic:/front/state"][0] == ["topic:/cam/image"]


def test_what_leaves_and_comes_from_outside(capsys: pytest.CaptureFixture[str]) -> None:
    more = "      - {to: network, data: [image, 'file:/etc/key']}\n      - {to: 'response:~/reset', data: [device]}\n"
    told = sinks(flows(capsys, BLUR + more))
    assert told["network"] == (["file:/etc/key", "topic:/cam/image"], [], [], False)
    assert told["response:/front/blur/reset"] == (["device"], [], [], False)


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("{to: state, data: [imag]}", "The declared flows name topic:imag, which is no declared input."),
        ("{to: stat, data: [image]}", "The declared flows name topic:stat, which is no declared output."),
        ("{to: image}", "The declared flows name topic:image, which is no declared output."),
        ("{to: state, data: ['parameter:strenght']}", "name parameter:strenght, which is no declared input."),
        ("{to: state, data: ['service:reset']}", "name service:reset, which is no declared input."),
    ],
)
def test_a_name_that_is_not_declared_is_told(entry: str, message: str, capsys: pytest.CaptureFixture[str]) -> None:
    """With its line; and then nothing is believed of these flows alone."""
    node = flows(capsys, f"{BLUR}      - {{to: state, data: [enable]}}\n      - {entry}\n")
    assert "topic:/cam/image" in sinks(node)["topic:/front/state"][0]
    assert main(["extract", ".", "--launch", "x.launch.xml", "--models", "models"]) == 1
    out = capsys.readouterr().out
    assert f"models/nodes/acme.yaml:{HEAD.count(chr(10)) + BLUR.count(chr(10)) + 2}  " in out
    assert message in out


def test_an_interface_that_is_not_wholly_known_may_hold_more(capsys: pytest.CaptureFixture[str]) -> None:
    body = BLUR.replace("    node: blur\n", "    node: blur\n    open: a file names more topics\n")
    node = flows(capsys, body + "      - {to: state, data: [enable]}\n")
    assert node["complete"] is False
    assert "topic:/cam/image" in sinks(node)["topic:/front/state"][0]


def test_flows_stand_in_groups_with_their_endpoints(capsys: pytest.CaptureFixture[str]) -> None:
    """What the group of one item does not have is no mistake of another one."""
    body = """\
interfaces:
  passed:
    subscriptions: [{name: '${what}', type: std_msgs/msg/String, qos: 10}]
    publishers: [{name: '${what}_out', type: std_msgs/msg/String, qos: 10}]
    flows: [{to: '${what}_out', data: ['${what}']}]
executables:
  blur:
    node: blur
    groups:
      - for_each: {as: n, values: [a, b]}
        include: [{interface: passed, with: {what: 'in_${n}'}}]
      - when: {argument: --more, set: true}
        subscriptions: [{name: more, type: std_msgs/msg/String, qos: 10}]
    flows: [{to: in_a_out, data: [more]}]
"""
    told = sinks(flows(capsys, body))
    assert told["topic:/front/in_a_out"] == (["topic:/front/in_a"], [], [], False)
    assert told["topic:/front/in_b_out"] == (["topic:/front/in_b"], [], [], False)
    assert sinks(flows(capsys, body, "--more yes"))["topic:/front/in_a_out"][0] == [
        "topic:/front/in_a",
        "topic:/front/more",
    ]


def test_nodes_of_one_program_share_what_arrives(capsys: pytest.CaptureFixture[str]) -> None:
    """A helper node listens, the first one publishes: without a word, that may be the same content."""
    body = """\
executables:
  blur:
    node: blur
    publishers: [{name: out, type: std_msgs/msg/String, qos: 10}]
    nodes:
      - node: helper
        subscriptions: [{name: in, type: std_msgs/msg/String, qos: 10}]
"""
    Path("models/nodes/acme.yaml").write_text(HEAD + body, encoding="utf-8")
    Path("x.launch.xml").write_text(LAUNCH.replace("{args}", ""), encoding="utf-8")
    assert main(["flow", ".", "--launch", "x.launch.xml", "--models", "models", "--format", "json"]) == 0
    nodes = {n["node"]: n for n in json.loads(capsys.readouterr().out)["nodes"]}
    (out,) = [s for n in nodes.values() for s in n["sinks"] if s["sink"] == "topic:/front/out"]
    assert out["assumed"] == out["data"]
    assert any(source.endswith("/in") for source in out["data"])


def _programs() -> list[tuple[str, str]]:
    """The programs of the packages of which rosward says anything about flows."""
    every = Declarations()
    packages = [path.stem for path in sorted(MODELS.glob("*.yaml")) if "flows:" in path.read_text(encoding="utf-8")]
    return [(package, name) for package in packages for found in every._of(package) for name in found.executables]


@pytest.mark.parametrize(("package", "name"), _programs())
@pytest.mark.parametrize("words", [(), ("/in",), ("/in", "/out")])
@pytest.mark.parametrize("missing", [False, True])
def test_the_declarations_of_rosward_name_what_they_have(
    package: str, name: str, words: tuple[str, ...], missing: bool
) -> None:
    log = start(package, name, words, missing=missing)
    assert "RW324" not in codes(log)


@pytest.mark.parametrize(
    ("package", "name", "output", "inputs"),
    [
        ("topic_tools", "relay", "/out", ["topic:/in"]),
        ("joy", "joy_node", "joy", ["clock", "device", "parameter:deadzone", "parameter:device_id"]),
        (
            "twist_mux",
            "twist_marker",
            "marker",
            ["parameter:frame_id", "parameter:scale", "parameter:vertical_position", "topic:twist"],
        ),
    ],
)
def test_well_known_programs(package: str, name: str, output: str, inputs: list[str]) -> None:
    log = start(package, name, ("/in", "/out") if package == "topic_tools" else ())
    assert log.flows is not None
    (flow,) = [f for f in log.flows.flows if f.sink.given is not None and readable(f.sink.given) == output]
    names = {s: s.name or (readable(s.given) if s.given is not None else "") for s in flow.data}
    told = {f"{s.kind}:{name}" if name else s.kind for s, name in names.items()}
    assert sorted(told) == inputs
    assert not flow.assumed
