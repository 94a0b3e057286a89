# SPDX-License-Identifier: Apache-2.0
"""Promise: with `--influence`, joining is dearer by exactly what processes can then influence and could not before; without, nothing changes."""

from __future__ import annotations

import json
from dataclasses import replace
from importlib import resources
from pathlib import Path

import jsonschema
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples
from outputs.networks import node, pub, sub

from rosward.cli import main
from rosward.enclaves.influence import influence_of
from rosward.enclaves.suggestion import Suggestion, Wish, suggest
from rosward.location import Place
from rosward.network.connect import connect
from rosward.outputs.documents.enclaves_json import enclaves_json
from rosward.outputs.terminal.enclaves_text import enclaves_text
from rosward.ros.entities import Entity, Interface, Node
from rosward.ros.flows import End, NodeFlows, NodeSink

from .systems import nodes

SCHEMA = json.loads((resources.files("rosward.outputs") / "schemas" / "enclaves.schema.json").read_text("utf-8"))


def made(name: str, *entities: Entity, **flows: str) -> Node:
    """A node in a process of its name; `out="in"`: its topic /out is made of /in."""
    sinks = tuple(
        NodeSink(End("topic", f"/{out}"), Place("a.py", 1), data=(End("topic", f"/{source}"),))
        for out, source in flows.items()
    )
    return replace(node(name, *entities, system=False, process=name), flows=NodeFlows(sinks))


def robot() -> tuple[Node, ...]:
    """A joystick drives by way of /teleop; /status and /music are two publishers that nobody makes anything of."""
    return connect(
        "jazzy",
        [
            made("/joystick", pub("/joy")),
            made("/teleop", sub("/joy"), pub("/cmd_vel"), cmd_vel="joy"),
            made("/music", pub("/song")),
            made("/status", pub("/state")),
        ],
    ).nodes


def by_process(all_nodes: tuple[Node, ...]) -> dict[str, list[Node]]:
    return {p: [n for n in all_nodes if n.process == p] for p in sorted({n.process for n in all_nodes})}


def test_what_a_process_can_influence() -> None:
    found = influence_of(by_process(robot()))
    assert found["/joystick"] == {"/joy", "/cmd_vel"}
    assert found["/teleop"] == {"/cmd_vel"}
    assert found["/music"] == {"/song"}


def joined(suggestion: Suggestion, step: int) -> set[str]:
    each = suggestion.ladder.steps[step]
    return {suggestion.ladder.units[n].enclave for n in (each.left, each.right) if n < len(suggestion.ladder.units)}


def test_what_leads_to_an_actuator_is_joined_last() -> None:
    """By permissions alone the joystick is as good a neighbour of the music as the status; by what it leads to it is not."""
    plain, weighed = suggest(robot()), suggest(robot(), influence=True)
    assert joined(plain, 0) == {"/joystick", "/music"}
    assert [joined(weighed, 0), joined(weighed, 1)] == [{"/joystick", "/teleop"}, {"/music", "/status"}]


def test_it_is_told_what_a_process_could_influence() -> None:
    found = suggest(robot(), Wish.MOST, 1, influence=True)
    (enclave,) = found.enclaves
    told = {process.process: process.influenced for process in enclave.processes}
    assert told["/joystick"] == ("/song", "/state")
    assert told["/music"] == ("/cmd_vel", "/joy", "/state")
    assert "    could also influence /cmd_vel, /joy, /state\n" in enclaves_text(found)
    document = json.loads(enclaves_json(found))
    jsonschema.validate(document, SCHEMA)
    assert document["suggestion"]["enclaves"][0]["processes"][0]["influenced"] == ["/song", "/state"]


def test_without_it_nothing_is_said_of_it() -> None:
    found = suggest(robot(), Wish.MOST, 1)
    assert "influence" not in enclaves_text(found) + enclaves_json(found)


def test_a_node_of_which_nothing_is_known_does_not_lead_everywhere() -> None:
    """It may pass all on to all; then every process could influence everything already, and joining would be for nothing."""
    stranger = replace(node("/stranger", system=False, process="/stranger"), interface=Interface.UNKNOWN)
    assert influence_of(by_process((*robot(), stranger)))["/music"] == {"/song"}


@given(nodes(), st.integers(1, 9))
@settings(max_examples=examples(0.8))
def test_the_price_is_what_a_count_by_hand_says(all_nodes: tuple[Node, ...], most: int) -> None:
    """Each name once for each process that could not influence it before."""
    weighed = suggest(all_nodes, Wish.MOST, most, influence=True)
    alone = influence_of(by_process(all_nodes))
    for enclave in weighed.enclaves:
        members = [process.process for process in enclave.processes]
        together = set().union(*(alone[process] for process in members))
        rights = sum(1 if r.kind.value == "subscription" else 2 for p in enclave.processes for r in p.application)
        assert enclave.price.application == rights + sum(len(together - alone[process]) for process in members)
        assert [set(p.influenced or ()) for p in enclave.processes] == [together - alone[p] for p in members]


PROGRAM = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Relay(Node):
    def __init__(self):
        super().__init__("relay")
        self.out = self.create_publisher(String, "out", 10)
        self.create_subscription(String, "in", lambda msg: self.out.publish(msg), 10)


rclpy.init()
rclpy.spin(Relay())
"""
SOURCE = """\
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("source")
out = node.create_publisher(String, "in", 10)
node.create_timer(1.0, lambda: out.publish(String(data="x")))
rclpy.spin(node)
"""


def test_the_commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """A project's rules about flows, which are read under the key `flow`, do not switch it on."""
    monkeypatch.chdir(tmp_path)
    Path("relay.py").write_text(PROGRAM, encoding="utf-8")
    Path("source.py").write_text(SOURCE, encoding="utf-8")
    Path("rosward.toml").write_text('[[flow.rule]]\nfrom = ["/in"]\nnot-to = ["file"]\n', encoding="utf-8")
    assert main(["enclaves", "suggest", "--max", "1"]) == 0
    assert "influence" not in capsys.readouterr().out
    assert main(["enclaves", "suggest", "--max", "1", "--influence"]) == 0
    assert "could also influence /in\n" in capsys.readouterr().out
    assert main(["flow", "--to", "/out"]) == 0
    assert "\nenclaves that can influence it: /relay, /source\n" in capsys.readouterr().out
    Path("e.toml").write_text('[[enclave]]\npath = "/both"\nnodes = ["/relay", "/source"]\n', encoding="utf-8")
    assert main(["flow", "--to", "/out", "--enclaves", "e.toml"]) == 0
    assert "\nenclaves that can influence it: /both\n" in capsys.readouterr().out
