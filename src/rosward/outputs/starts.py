# SPDX-License-Identifier: Apache-2.0
"""How is each process started so that it runs in its enclave?

    /left/talker
      demo/talker, started at bringup/launch/robot.launch.py:12: add ros_arguments=['--enclave', '/left/talker'] there

A process has one enclave; which, its command line or ROS_SECURITY_ENCLAVE_OVERRIDE says (rcl, init.c).
"""

from __future__ import annotations

from rosward.network.enclaves import enclave_paths
from rosward.network.graph import Network
from rosward.outputs.safe import printable
from rosward.ros.entities import Node

_HEAD = """\
# The enclave of each process, and how it gets there. Without --enclave a process runs in /, and its rights are those of /.
"""


def starts_text(network: Network) -> str:
    """One paragraph an enclave."""
    paths = enclave_paths(network.nodes)
    by_enclave: dict[str, dict[str, list[Node]]] = {}
    for node in network.nodes:
        by_enclave.setdefault(paths[node.enclave], {}).setdefault(node.process, []).append(node)
    lines = [_HEAD]
    for enclave in sorted(by_enclave):
        lines.append(enclave)
        for process, members in sorted(by_enclave[enclave].items()):
            lines.append(f"  {printable(process)}{_nodes(members, enclave)}{_how(members[0], enclave)}")
        lines.append("")
    return "\n".join(lines)


def _nodes(members: list[Node], enclave: str) -> str:
    names = sorted({node.fqn for node in members})
    return "" if names == [enclave] else f" (nodes {printable(', '.join(names))})"


def _how(node: Node, enclave: str) -> str:
    if node.given_enclave == enclave:
        return ": its start says so"
    if node.launched_by is not None:
        return f", started at {printable(str(node.launched_by))}: add ros_arguments=['--enclave', '{enclave}'] there"
    if node.package and node.executable:
        return f": ros2 run {node.package} {node.executable} --ros-args --enclave {enclave}"
    return f": start it with --ros-args --enclave {enclave}"
