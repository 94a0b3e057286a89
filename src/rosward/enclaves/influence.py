# SPDX-License-Identifier: Apache-2.0
"""What can a process influence with the rights that it has, by what other nodes make of what it may send?

/joystick may publish /joy; /teleop makes /cmd_vel of /joy  ->  /joystick: /joy, /cmd_vel
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from rosward.influence.graph import SHARED, Vertex, graph_of
from rosward.influence.search import at_least, downstream
from rosward.influence.senders import Senders
from rosward.ros.entities import Interface, Node

__all__ = ["influence_of"]

_SERVICE: Final = ("request", "response")
_ACTION: Final = ("goal", "feedback", "result")
_NOBODY_ACTS_ON: Final = ("log", "stdout")


def influence_of(by_process: Mapping[str, Sequence[Node]]) -> dict[str, frozenset[str]]:
    """By process, the topics, services, actions and outputs to the outside whose content it can be part of, or decide.

    A node of which nothing is known would pass anything on to everything, which tells processes apart no longer; it is left out.
    """
    known = [node for nodes in by_process.values() for node in nodes if node.interface is not Interface.UNKNOWN]
    graph = graph_of(known)
    senders = Senders(graph)
    strong = at_least("control")
    return {
        process: frozenset(_names(downstream(graph, {v for node in nodes for v in senders.may_send(node)}, strong)))
        for process, nodes in by_process.items()
    }


def _names(reached: Iterable[Vertex]) -> set[str]:
    """Both sides of a service or action are one thing."""
    found = set()
    for end, node, side in reached:
        if end.kind in _SERVICE:
            found.add(f"service {end.name}")
        elif end.kind in _ACTION:
            found.add(f"action {end.name}")
        elif end.kind == "topic":
            found.add(end.name)
        elif end.kind in SHARED or side == "sent":
            found |= {f"{end} of {node}" if node else str(end)} if end.kind not in _NOBODY_ACTS_ON else set()
    return found
