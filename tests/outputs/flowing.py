# SPDX-License-Identifier: Apache-2.0
"""Small systems in which something flows, made by hand, for the tests of the report."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.ros.entities import EntityKind, Interface, Node, Resolution
from rosward.ros.flows import End, NodeFlows, NodeSink
from rosward.ros.roles import all_to_all

from .networks import entity, node, pub, sub


def end(word: str) -> End:
    """`topic:/scan`, or a kind alone."""
    kind, _, name = word.partition(":")
    return End(kind, name)


def sink(word: str, line: int = 9, file: str = "a.py", **sources: Any) -> NodeSink:
    """An output of these sources, each by a line before it and that of the output; `assumed` are words, too."""
    at = Place(file, line)
    ends = {strength: tuple(map(end, sources.get(strength, ()))) for strength in ("data", "control", "trigger")}
    assumed = tuple(map(end, sources.get("assumed", ())))
    paths = tuple((one, (Place(file, line - 4), at)) for one in (*ends["data"], *ends["control"]))
    return NodeSink(end(word), at, ends["data"], ends["control"], ends["trigger"], assumed, paths)


def flowing(one: Node, *sinks: NodeSink, **more: Any) -> Node:
    """The node with these outputs."""
    return replace(one, flows=NodeFlows(sinks, **more))


def all_flowing(network: Network) -> Network:
    """The same network, where each output of a node is known to be made of each of its inputs."""
    return replace(network, nodes=tuple(flowing(one, *all_to_all(one, [one])) for one in network.nodes))


def robot(file: str = "a.py") -> Network:
    """A camera, a detector that a mode decides and a timer wakes, a planner that asks a service, its server, a driver that nobody analysed, an
    eye of a name that is known in part, and a lamp that nothing leads to.
    """
    ask, answer = EntityKind.SERVICE_CLIENT, EntityKind.SERVICE_SERVER
    image, boxes, plan = "topic:/image", "topic:/boxes", "topic:/plan"
    return connect(
        "jazzy",
        [
            flowing(
                node("/camera", pub("/image"), pub("/quality"), system=False),
                sink(image, 20, file, data=["device"]),
                sink("topic:/quality", 30, file),
            ),
            flowing(
                node("/detector", sub("/image"), sub("/mode"), pub("/boxes"), pub("/status"), system=False),
                sink(boxes, 40, file, data=[image, "parameter:size"], control=["topic:/mode"]),
                sink("topic:/status", 50, file, trigger=["topic:/image", "timer"]),
                sink("file", 60, file, data=[image]),
            ),
            flowing(
                node("/planner", sub("/boxes"), pub("/plan"), entity(ask, "/route", "demo/srv/Route"), system=False),
                sink("request:/route", 70, file, data=[boxes]),
                sink(plan, 80, file, data=["response:/route"], control=[boxes]),
            ),
            flowing(
                node("/router", entity(answer, "/route", "demo/srv/Route"), system=False),
                sink("response:/route", 90, file, data=["service:/route", "file"]),
            ),
            node("/driver", sub("/plan"), pub("/cmd_vel"), system=False, interface=Interface.DECLARED, lacks=("declared",)),
            flowing(
                node("/eye", pub("/image_*", resolution=Resolution.PATTERN), pub("/image_left"), system=False),
                sink("topic:/image_*", 100, file, data=["clock"]),
            ),
            flowing(node("/viewer", sub("/image_left"), pub("/view"), system=False), sink("topic:/view", 110, file, data=["topic:/image_left"])),
            flowing(node("/lamp", pub("/light"), system=False), sink("topic:/light", 120, file)),
        ],
    )  # fmt: skip
