# SPDX-License-Identifier: Apache-2.0
"""What of a system is compared, whether it was written as a network or as a policy?

    Snapshot(nodes={"/talker"}, entities={("/talker", "publisher", "/chatter", "std_msgs/msg/String")}, policy=…)

The rights are a policy in both cases: that of a network is what its nodes need.
"""

from __future__ import annotations

from typing import NamedTuple

from rosward.network.asked import NOT_TOLD, Asked
from rosward.policies.records import Policy

__all__ = ["ComparedState", "EntityLine"]


class EntityLine(NamedTuple):
    """An entity of a node, as it is compared."""

    node: str
    kind: str
    name: str
    type: str

    def __str__(self) -> str:
        return f"{self.node}: {self.kind} {self.name}" + (f" ({self.type})" if self.type else "")


class ComparedState(NamedTuple):
    """One state. A policy has profiles for nodes, and no entities; `kind` is network or policy; `asked` is what the network answers."""

    kind: str
    nodes: frozenset[str]
    entities: frozenset[EntityLine]
    policy: Policy
    asked: Asked = NOT_TOLD
