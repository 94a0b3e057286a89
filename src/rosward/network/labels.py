# SPDX-License-Identifier: Apache-2.0
"""What is a node called whose name nobody knows?

    the programs acme/driver and acme/camera, of unknown name      both /*          ->  acme/driver, acme/camera
    acme/driver, started twice without a name                      both /*          ->  acme/driver, acme/driver#2
    a node of unknown interface, in a namespace that is not known  /*/driver        ->  acme/driver

So that it is not taken for another one: by a person, by a graph, by the policy of its enclave.
"""

from __future__ import annotations

from collections.abc import Iterable

from rosward.holes import HOLE
from rosward.location import Place
from rosward.network.free import free
from rosward.records import replace
from rosward.ros.entities import Interface, Node

__all__ = ["labelled"]


def labelled(nodes: Iterable[Node]) -> list[Node]:
    """The nodes in their order, with a label where the name is not known; no two have the same."""
    listed = list(nodes)
    taken: set[str] = set()
    labels: dict[int, str] = {}
    for number in sorted((n for n, node in enumerate(listed) if _is_nameless(node)), key=lambda n: _order(listed[n])):
        labels[number] = free(_wanted(listed[number]), taken, "#")
        taken.add(labels[number])
    return [replace(node, label=labels[n]) if n in labels else node for n, node in enumerate(listed)]


def _is_nameless(node: Node) -> bool:
    """Whether the name says nothing; that of an unknown program has to say all."""
    return node.name == HOLE or (node.interface is Interface.UNKNOWN and HOLE in node.fqn)


def _order(node: Node) -> tuple[str, str, str, Place, str]:
    return (_wanted(node), node.process, node.fqn, node.defined_at, repr(node))


def _wanted(node: Node) -> str:
    if node.package is None or node.executable is None:
        return node.process.partition("#")[0]
    return f"{node.package}/{node.executable}"
