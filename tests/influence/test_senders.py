# SPDX-License-Identifier: Apache-2.0
"""Promise: every enclave that may send something of which a name is made is named, and no other."""

from __future__ import annotations

from dataclasses import replace

from outputs.networks import entity, node, pub, sub

from rosward.influence.graph import graph_of
from rosward.influence.search import at_least, upstream
from rosward.influence.select import Selection, meant
from rosward.influence.senders import influencing
from rosward.location import Place
from rosward.ros.entities import Entity, EntityKind, Node
from rosward.ros.flows import End, NodeFlows, NodeSink

HERE = Place("a.py", 1)


def made(name: str, *entities: Entity, enclave: str = "", **flows: str) -> Node:
    """A node; `out='data /in'`: its topic /out is made of /in."""
    sinks = []
    for out, words in flows.items():
        strength, _, source = words.partition(" ")
        ends = (End("topic", source),) if source else ()
        sinks.append(
            NodeSink(
                End("topic", f"/{out}"),
                HERE,
                data=ends if strength == "data" else (),
                control=ends if strength == "control" else (),
            )
        )
    plain = node(name, *entities, system=False, **({"enclave": enclave} if enclave else {}))
    return replace(plain, flows=NodeFlows(tuple(sinks)))


def enclaves(name: str, *nodes: Node, by: str = "control") -> list[str]:
    graph = graph_of(nodes)
    found = upstream(graph, meant([Selection(name)], graph.vertices), at_least(by))
    return [f"{e.enclave} {e.strength}{' assumed' * e.assumed}" for e in influencing(nodes, graph, found)]


ROBOT = (
    made("/joy", pub("/joy"), joy=""),
    made("/teleop", sub("/joy"), pub("/cmd_vel"), cmd_vel="data /joy"),
    made("/stop", pub("/e_stop"), e_stop=""),
    made("/base", sub("/cmd_vel"), sub("/e_stop"), pub("/wheels"), wheels="data /cmd_vel"),
    made("/guard", sub("/e_stop"), pub("/cmd_vel"), cmd_vel="control /e_stop"),
    made("/camera", pub("/image"), image=""),
)


def test_who_sends_on_the_way() -> None:
    assert enclaves("/wheels", *ROBOT) == ["/base data", "/guard data", "/joy data", "/stop control", "/teleop data"]
    assert enclaves("/wheels", *ROBOT, by="data") == ["/base data", "/guard data", "/joy data", "/teleop data"]
    assert enclaves("/joy", *ROBOT) == ["/joy data"]


def test_who_may_send_counts_even_if_its_code_sends_nothing() -> None:
    idle = made("/idle", pub("/joy"))
    assert "/idle data" in enclaves("/wheels", *ROBOT, idle)


def test_who_may_send_under_any_name_counts() -> None:
    anyone = made("/bridge", pub("/*"))
    assert "/bridge data" in enclaves("/wheels", *ROBOT, anyone)


def test_processes_of_one_enclave_are_one() -> None:
    together = [replace(n, enclave="/all") for n in ROBOT]
    assert enclaves("/wheels", *together) == ["/all data"]


def test_what_is_assumed_is_told() -> None:
    """A declared node of which nothing more is known stands between."""
    declared = replace(made("/filter", sub("/raw"), pub("/joy")), flows=None)
    raw = made("/source", pub("/raw"), raw="")
    assert "/source data assumed" in enclaves("/wheels", *ROBOT, declared, raw)


def test_what_the_client_library_may_send_counts_not() -> None:
    system = replace(pub("/joy"), system=True)
    assert "/library data" not in enclaves("/wheels", *ROBOT, made("/library", system))


def test_who_may_ask_for_other_parameters() -> None:
    """Parameters decide, too: a client of their service is one who influences."""
    flows = NodeFlows((NodeSink(End("topic", "/out"), HERE, data=(End("parameter", "gain"),)),))
    tuned = replace(made("/tuned", pub("/out")), flows=flows)
    client = entity(EntityKind.SERVICE_CLIENT, "/tuned/set_parameters", "rcl_interfaces/srv/SetParameters")
    request = NodeFlows((NodeSink(End("request", "/tuned/set_parameters"), HERE, data=(End("topic", "/joy"),)),))
    tuner = replace(made("/tuner", client), flows=request)
    assert enclaves("/out", tuned, tuner, ROBOT[0]) == ["/joy data", "/tuned data", "/tuner data"]
