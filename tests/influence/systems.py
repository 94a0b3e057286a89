# SPDX-License-Identifier: Apache-2.0
"""Small systems, written as what each output of each node is made of.

system("/cam: topic:/image <- device", "/up: network <- topic:/image, control topic:/mode")
"""

from __future__ import annotations

from rosward.location import Place
from rosward.ros.entities import Interface, Node, Resolution
from rosward.ros.flows import End, NodeFlows, NodeSink


def system(*lines: str) -> list[Node]:
    """The nodes; several lines of one name are one node, `!` behind a name says that it was not analysed."""
    sinks: dict[str, list[NodeSink]] = {}
    for number, line in enumerate(lines, 1):
        name, _, rest = line.partition(": ")
        sink, _, sources = rest.partition(" <- ")
        found: dict[str, list[End]] = {"data": [], "control": [], "trigger": []}
        for word in filter(None, sources.split(", ")):
            strength, _, source = word.rpartition(" ")
            found[strength or "data"].append(_end(source))
        data, control, trigger = (tuple(ends) for ends in found.values())
        assumed = data if name.endswith("!") else ()
        made = NodeSink(_end(sink), Place("a.py", number), data, control, trigger, assumed)
        sinks.setdefault(name.rstrip("!"), []).append(made)
    return [_node(name, tuple(made)) for name, made in sinks.items()]


def _end(text: str) -> End:
    kind, _, name = text.partition(":")
    return End(kind, name)


def _node(name: str, sinks: tuple[NodeSink, ...]) -> Node:
    namespace, _, own = name.rpartition("/")
    return Node(
        namespace=namespace or "/",
        name=own,
        resolution=Resolution.EXACT,
        enclave=name,
        package=None,
        executable=None,
        process=own,
        launched_by=None,
        defined_at=Place("a.py", 1),
        interface=Interface.ANALYSED,
        flows=NodeFlows(sinks),
    )
