# SPDX-License-Identifier: Apache-2.0
"""Snapshots and networks are read as they are written, and refused, with the place, where they are anything else."""

from __future__ import annotations

import contextlib
import copy
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from outputs.networks import fleet, node, pub, sub, talker_and_listener

from rosward.audit.document import read_snapshot, snapshot_of
from rosward.network.graph import Network
from rosward.network.network_file import read_network
from rosward.outputs.documents.network_json import network_json
from rosward.ros.entities import Node, Qos
from rosward.source.json_fields import UnreadableError

from .graphs import running, seen, snapshot, told

SCHEMAS = Path(__file__).parents[2] / "src" / "rosward" / "outputs" / "schemas"
TALKER = node("/ns/talker", pub("/chatter", qos=Qos("reliable", "volatile", None, None)), sub("/cmd"))


def document() -> dict[str, Any]:
    loose = [{"kind": "publishers", **seen("/raw", "a/msg/B", ros_prefix=False)}]
    return copy.deepcopy(snapshot(TALKER, loose=loose))


def test_a_snapshot_is_read_as_it_stands() -> None:
    jsonschema.validate(document(), json.loads((SCHEMAS / "snapshot.schema.json").read_text(encoding="utf-8")))
    graph = snapshot_of(document(), "robot.json")
    (live,) = graph.nodes
    assert (live.name, live.count, live.seen, graph.looks, graph.distro) == ("/ns/talker", 1, 10, 10, "kilted")
    assert live.entities[0].qos == (Qos("reliable", "volatile", None, None),)
    assert [(e.name, e.ros_prefix) for e in graph.loose] == [("/raw", False)]


def test_a_node_of_which_the_middleware_tells_nothing_lacks_nothing() -> None:
    broken = document()
    broken["nodes"][0].update(asked=0, publishers=[])
    graph = snapshot_of(broken, "robot.json")
    assert [f.code for f in graph.findings] == ["RW505"]
    assert told([TALKER], graph) == [("RW502", "", "publisher /raw")]


def test_a_snapshot_without_any_node_is_doubted() -> None:
    (finding,) = snapshot_of({**document(), "nodes": []}).findings
    assert (finding.code, finding.message[:17]) == ("RW505", "No node was seen.")


def test_problems_of_the_snapshot_are_told() -> None:
    broken = {**document(), "problems": ["node x in /: gone"]}
    assert [f.message for f in snapshot_of(broken).findings] == ["The snapshot could not query node x in /: gone."]


def places(value: object, way: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """Every place of a document at which a value stands that the reader looks at."""
    if way and way[-1] not in {"generator", "enclaves"}:
        yield way
    items = enumerate(value) if isinstance(value, list) else value.items() if isinstance(value, dict) else ()
    for key, inner in items:
        if key != "generator":
            yield from places(inner, (*way, key))


@pytest.mark.parametrize("wrong", [None, True, -1, 1.5, "", "x" * 2000, [], {}, [[]], [7], {"name": 1}, 1 << 70])
def test_anything_else_is_refused_or_read_and_never_raises(wrong: object) -> None:
    for way in places(document()):
        broken: Any = document()
        at: Any = broken
        for key in way[:-1]:
            at = at[key]
        at[way[-1]] = copy.deepcopy(wrong)
        with contextlib.suppress(UnreadableError):
            told([TALKER], snapshot_of(broken))


@pytest.mark.parametrize(
    "text", ["", "[", "[]", "{}", "null", "[" * 100_000, '{"schema_version": 2}', '{"schema_version": true}', "\0"]
)
def test_files_that_are_no_snapshot_are_refused(text: str, tmp_path: Path) -> None:
    file = tmp_path / "robot.json"
    file.write_text(text, encoding="utf-8")
    for read in (read_snapshot, read_network):
        with pytest.raises(UnreadableError, match=r"robot\.json: not "):
            read(str(file))
    with pytest.raises(UnreadableError):
        read_snapshot(str(tmp_path))


def test_one_node_twice_is_refused() -> None:
    twice = document()
    twice["nodes"] *= 2
    with pytest.raises(UnreadableError, match="is listed twice"):
        snapshot_of(twice)


def _of_some_runs(node: Node) -> Node:
    entities = tuple(e if e.system else replace(e, conditional=True) for e in node.entities)
    return replace(node, conditional=True, entities=entities)


@pytest.mark.parametrize("network", [fleet(), talker_and_listener()])
def test_an_earlier_network_says_what_the_sources_say(network: Network, tmp_path: Path) -> None:
    file = tmp_path / "network.json"
    nodes = tuple(_of_some_runs(n) if n.name == "talker" else n for n in network.nodes)
    file.write_text(network_json(replace(network, nodes=nodes)), encoding="utf-8")
    read = read_network(str(file))
    assert read.distro == network.distro
    assert [(f.code, f.message) for f in read.findings] == [(f.code, f.message) for f in network.findings]
    assert [(n.fqn, n.conditional, len(n.entities)) for n in read.nodes] == [
        (n.fqn, n.conditional, len(n.entities)) for n in nodes
    ]
    live = running(*(n for n in nodes if "*" not in n.fqn), node("/rogue"))
    assert told(read.nodes, live) == told(nodes, live)
