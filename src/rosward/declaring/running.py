# SPDX-License-Identifier: Apache-2.0
"""What does a running node say of its program? A snapshot of rosward, or a text of `ros2 node info`.

    /front/lidar with a publisher of /front/scan, a server of /front/lidar/restart, and what every node has
      ->  Sketch("lidar", (publishers scan, service_servers ~/restart))

The names are those of one start, behind its remap rules: they are right for that start.
"""

from __future__ import annotations

from typing import Final

from rosward.audit.graph import LiveGraph, LiveNode
from rosward.audit.tools import tool_of
from rosward.declaring.sketch import SeenEndpoint, Sketch, is_usable
from rosward.ros.distro import Distro
from rosward.ros.entities import ENTITY_LISTS, Entity, Qos
from rosward.ros.implicit import ClientLibrary, implicit_entities

__all__ = ["NotRunningError", "node_of", "sketch_of"]

_LISTS: Final = {kind: key for key, kind in ENTITY_LISTS.items()}
_LIFECYCLE: Final = "change_state"


class NotRunningError(Exception):
    """None, or several, of the running nodes may be the program; the message says which there are."""


def node_of(graph: LiveGraph, executable: str, wanted: str | None) -> LiveNode:
    """The node of a program: the one that is named, else the only one, else the one that is called as the executable is."""
    nodes = [node for node in graph.nodes if tool_of(node.name) is None]
    if wanted is not None:
        nodes = [n for n in graph.nodes if n.name == "/" + wanted.strip("/")]
    elif len(nodes) > 1:
        stem = executable.rpartition("::")[2].lower()
        names = {stem, stem.removesuffix("_node"), f"{stem}_node"}
        nodes = [n for n in nodes if n.name.rpartition("/")[2].lower() in names]
    if len(nodes) == 1:
        return nodes[0]
    there = ", ".join(sorted(n.name for n in nodes or graph.nodes)[:12])
    raise NotRunningError(f"several nodes are possible: choose one with --node: {there or 'there is none'}")


def sketch_of(node: LiveNode, source: str) -> Sketch:
    """What a running node has beside what every node has."""
    lifecycle = any(e.name == f"{node.name}/{_LIFECYCLE}" for e in node.entities)
    made = {(e.kind, e.name) for library in ClientLibrary for e in _made(node.name, library, lifecycle=lifecycle)}
    own = [e for e in node.entities if (e.kind, e.name) not in made and e.ros_prefix]
    seen = [SeenEndpoint(_LISTS[e.kind], _relative(e.name, node.name), e.type, _qos(e.qos), e.name) for e in own]
    usable = tuple(each for each in seen if is_usable(each))
    told = [
        f"{each.kind}: {each.at} of type {each.type or 'unknown'} cannot be declared"
        for each in seen
        if each not in usable
    ]
    told += [
        f"{e.kind.value} {e.name} has no rt prefix in its DDS name: no policy can grant it"
        for e in node.entities
        if not e.ros_prefix
    ]
    return Sketch(
        node=node.name.rpartition("/")[2],
        lifecycle=lifecycle,
        entities=usable,
        told=(
            *told,
            "names are as observed: write scan instead of /scan for names relative to the namespace of the node",
        ),
        open=f"as observed ({source}); other runs may differ",
    )


def _made(name: str, library: ClientLibrary, *, lifecycle: bool) -> tuple[Entity, ...]:
    return implicit_entities(
        Distro.ROLLING,
        node_fqn=name,
        logger_service=True,
        use_sim_time=True,
        lifecycle=lifecycle,
        client_library=library,
    )


def _relative(name: str, node: str) -> str:
    """A name as the program may have given it: below its node, below its namespace, else the whole."""
    if name.startswith(f"{node}/"):
        return f"~{name[len(node) :]}"
    space = node.rpartition("/")[0]
    return name[len(space) + 1 :] if space and name.startswith(f"{space}/") else name


def _qos(profiles: tuple[Qos, ...]) -> Qos | None:
    return profiles[0] if len(set(profiles)) == 1 else None
