# SPDX-License-Identifier: Apache-2.0
"""Can a publisher and a subscription of one topic never talk because of their QoS? (RW309)

    driver: publisher /scan, best_effort      viewer: subscription /scan, reliable     ->  no message ever arrives

DDS connects the two only where what is offered is at least what is requested, policy by policy. Of reliability and durability the sources tell;
deadline and liveliness are not recorded. What is not known, and what the middleware chooses (`system_default`, `best_available`), clashes with
nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain
from typing import Final

from rosward.findings import Finding
from rosward.network.ends import End, Meeting, listed_names, meetings
from rosward.ros.entities import Node, Qos

__all__ = ["incompatible_qos"]

_CLASHES: Final = (("reliability", "best_effort", "reliable"), ("durability", "volatile", "transient_local"))
"""Policy, what is offered, what is requested."""


def incompatible_qos(nodes: Iterable[Node]) -> Iterator[Finding]:
    """RW309, once for each topic and policy. A partly known name may be two names, and what the client library makes fits together."""
    for topic in meetings(nodes, ("topic",)):
        if "*" not in topic.name:
            for policy, offered, requested in _CLASHES:
                yield from _clash(topic, policy, offered, requested)


def _clash(topic: Meeting, policy: str, offered: str, requested: str) -> Iterator[Finding]:
    publishers = [end for end in topic.sources if _has(end, policy, offered)]
    subscriptions = [end for end in topic.sinks if _has(end, policy, requested)]
    offering, requesting = _that_would_talk(publishers, subscriptions), _that_would_talk(subscriptions, publishers)
    if offering:
        message = (
            f"topic {topic.name}: subscription in {listed_names(end.node.fqn for end in requesting)} requests {requested}, "
            f"publisher in {listed_names(end.node.fqn for end in offering)} offers {offered}: they exchange no messages"
        )
        yield Finding("RW309", message, requesting[0].place)


def _has(end: End, policy: str, value: str) -> bool:
    qos = end.entity.qos
    return qos is not None and not end.entity.system and _value(qos, policy) == value


def _value(qos: Qos, policy: str) -> str | None:
    return qos.reliability if policy == "reliability" else qos.durability


def _that_would_talk(ends: list[End], others: list[End]) -> list[End]:
    """The ends that would talk with one of the others if not for their QoS: of one type, as far as it is known, and not alternatives of one node."""
    of_type: dict[str | None, list[End]] = {}
    for other in others:
        of_type.setdefault(other.entity.type, []).append(other)
    found = []
    for end in ends:
        own = end.entity.type
        partners = others if own is None else chain(of_type.get(own, ()), of_type.get(None, ()))
        if any(not _alternatives(end, partner) for partner in partners):
            found.append(end)
    return found


def _alternatives(one: End, other: End) -> bool:
    return one.node is other.node and one.entity.conditional and other.entity.conditional
