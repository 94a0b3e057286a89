# SPDX-License-Identifier: Apache-2.0
"""Nodes that were not analysed: each output may hold each input; of one of which nothing is known, any topic may hold any other."""

from __future__ import annotations

from typing import Final

from rosward.ros.entities import Interface, Node
from rosward.ros.flows import End, NodeFlows, NodeSink
from rosward.ros.roles import all_to_all

_ANYTHING: Final = End("topic", "/*")


def flows_of(node: Node) -> NodeFlows:
    """The flows of a node, assumed where nobody knows them."""
    if node.flows is not None:
        return node.flows
    if node.interface is Interface.UNKNOWN:
        anything = NodeSink(_ANYTHING, node.defined_at, data=(_ANYTHING,), assumed=(_ANYTHING,))
        return NodeFlows((anything,), complete=False)
    return NodeFlows(tuple(all_to_all(node, (node,))), complete=False)
