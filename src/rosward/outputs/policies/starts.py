# SPDX-License-Identifier: Apache-2.0
"""How is each process started so that it runs in its enclave?

    /left/talker
      demo/talker, started at bringup/launch/robot.launch.py:12: ros_arguments=['--enclave', '/left/talker']

A process has one enclave; which, its command line or ROS_SECURITY_ENCLAVE_OVERRIDE says (rcl, init.c).
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

from rosward.location import Place
from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Network
from rosward.network.launch_tree import CONTAINER
from rosward.ros.entities import Node
from rosward.safe import printable

_HEAD = """\
# The enclave of each process, and how to start it there. Without --enclave, a process runs in / with the permissions of /.
"""


def starts_text(network: Network) -> str:
    """One paragraph an enclave."""
    paths = enclave_paths(network.nodes)
    by_enclave: dict[str, dict[str, list[Node]]] = {}
    for node in network.nodes:
        by_enclave.setdefault(paths[node.enclave], {}).setdefault(node.process, []).append(node)
    shared = _shared_places(network.nodes)
    lines = [_HEAD]
    for enclave in sorted(by_enclave):
        lines.append(enclave)
        for process, members in sorted(by_enclave[enclave].items()):
            lines.append(f"  {printable(process)}{_nodes(members, enclave)}{_how(_starter(members), enclave, shared)}")
        lines.append("")
    return "\n".join(lines)


def _nodes(members: list[Node], enclave: str) -> str:
    names = sorted({node.display_name for node in members})
    return "" if names in ([enclave], [members[0].process]) else f" (nodes {printable(', '.join(names))})"


def _starter(members: list[Node]) -> Node:
    """The node that the process is started for: in a container it is the container's, not that of a component."""
    program = members[0].process.partition("#")[0]
    return next((n for n in members if f"{n.package}/{n.executable}" == program), members[0])


def _how(node: Node, enclave: str, shared: Collection[Place]) -> str:
    place = node.launched_by
    if node.assumed:
        return f", which nothing in the sources creates: start what creates it with --ros-args --enclave {enclave}"
    if node.given_enclave == enclave:
        return ": already set by its start"
    if node.process.startswith(CONTAINER):
        return f", which nothing here starts: start it with --ros-args --enclave {enclave}"
    if place is not None and place in shared:
        return f", started at {printable(str(place))} like others: add --enclave {enclave} to its ROS arguments"
    if place is not None:
        return f", started at {printable(str(place))}: {_option(place.file, enclave)}"
    if node.package and node.executable:
        return f": ros2 run {node.package} {node.executable} --ros-args --enclave {enclave}"
    return f": start it with --ros-args --enclave {enclave}"


def _option(file: str, enclave: str) -> str:
    """What to add in the launch file, in its own language."""
    if file.endswith(".py"):
        return f"ros_arguments=['--enclave', '{enclave}']"
    word = "ros_args: " if file.endswith((".yaml", ".yml")) else "ros_args="
    return f'{word}"--enclave {enclave}"'


def _shared_places(nodes: Iterable[Node]) -> set[Place]:
    """The places in launch files that start several processes."""
    processes: dict[Place, set[str]] = {}
    for node in nodes:
        if node.launched_by is not None:
            processes.setdefault(node.launched_by, set()).add(node.process)
    return {place for place, several in processes.items() if len(several) > 1}
