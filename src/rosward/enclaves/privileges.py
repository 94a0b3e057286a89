# SPDX-License-Identifier: Apache-2.0
"""Which rights do nodes need, as a policy grants them, and which on DDS?

    node /dock: action server /dock, publisher /rosout
      ->  {Privilege(ACTION_SERVER, /dock): False, Privilege(PUBLISHER, /rosout): True}      True: only the client library needs it

An action is three services and two topics, and a policy can also name each of these by itself:

    Privilege(ACTION_SERVER, /dock)  ->  service server /dock/_action/send_goal, …, publisher /dock/_action/status
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from rosward.network.checks import UnknownNames
from rosward.network.enclaves import enclave_paths
from rosward.policies.granted import OUTSIDE, name_to_grant, why_not
from rosward.policies.rights import ACTION_SERVICES, ACTION_TOPICS, Right, rights_of
from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind, Node

__all__ = ["Privilege", "by_enclave", "on_dds", "parts", "privileges"]

_OF_ACTION: Final = {
    EntityKind.ACTION_SERVER: (EntityKind.SERVICE_SERVER, EntityKind.PUBLISHER),
    EntityKind.ACTION_CLIENT: (EntityKind.SERVICE_CLIENT, EntityKind.SUBSCRIPTION),
}


class Privilege(NamedTuple):
    """The right to have one kind of endpoint at one name; `ros` is False for a topic outside the ROS name space."""

    kind: EntityKind
    name: str
    ros: bool = True

    def __str__(self) -> str:
        return f"{self.kind.value} {self.name}"


def privileges(nodes: Iterable[Node], unknown: UnknownNames = "deny") -> dict[Privilege, bool]:
    """What these nodes need; with each, whether nothing but the client library needs it."""
    needed: dict[Privilege, bool] = {}
    for node in nodes:
        for entity in node.entities:
            why = why_not(entity, unknown)
            if why is None or why == OUTSIDE:
                key = Privilege(entity.kind, name_to_grant(entity), entity.ros_prefix)
                needed[key] = needed.get(key, True) and entity.system
    return needed


def by_enclave(nodes: Iterable[Node]) -> list[tuple[str, list[Node]]]:
    """The nodes of each enclave, by the path to write, sorted."""
    members: dict[str, list[Node]] = {}
    for node in nodes:
        members.setdefault(node.enclave, []).append(node)
    paths = enclave_paths(node for group in members.values() for node in group)
    return sorted(((paths[found], group) for found, group in members.items()), key=lambda pair: pair[0])


def parts(privilege: Privilege) -> tuple[Privilege, ...]:
    """The services and topics of an action; anything else is its one part."""
    kinds = _OF_ACTION.get(privilege.kind)
    if kinds is None:
        return (privilege,)
    service, topic = kinds
    return (
        *(Privilege(service, f"{privilege.name}/_action/{each}") for each in ACTION_SERVICES),
        *(Privilege(topic, f"{privilege.name}/_action/{each}") for each in ACTION_TOPICS),
    )


def on_dds(privilege: Privilege) -> tuple[Right, ...]:
    """The rights on DDS."""
    return rights_of(privilege.kind, privilege.name, ros=privilege.ros)
