# SPDX-License-Identifier: Apache-2.0
"""How many there are of everything: what the summary on the terminal and the report both show."""

from __future__ import annotations

from collections.abc import Sequence

from rosward.network.graph import Action, Network, Service, Topic
from rosward.one_cause import by_cause
from rosward.records import NamedTuple
from rosward.ros.entities import Interface, Resolution
from rosward.rules import Severity

__all__ = ["Count", "Counts", "counts_of", "listed", "several", "some"]


class Count(NamedTuple):
    """A number of things, and how many of them the client library made."""

    total: int
    system: int


class Counts(NamedTuple):
    """The numbers of one network. `assumed` are the nodes that nothing starts.

    `names` counts the names that the user's own code gives: endpoints, not nodes; `interfaces` the nodes by what is known of them;
    `severities` causes: what is there for one is one."""

    nodes: int
    assumed: int
    topics: Count
    services: Count
    actions: Count
    names: dict[Resolution, int]
    severities: dict[Severity, int]
    interfaces: dict[Interface, int]


def counts_of(network: Network) -> Counts:
    """Count everything once."""
    own = [entity for node in network.nodes for entity in node.entities if not entity.system]
    weights = [one.finding.rule.severity for one in by_cause(network.findings)]
    return Counts(
        nodes=len(network.nodes),
        assumed=sum(node.assumed for node in network.nodes),
        topics=_count(network.topics),
        services=_count(network.services),
        actions=_count(network.actions),
        names={resolution: sum(e.resolution is resolution for e in own) for resolution in Resolution},
        severities={severity: weights.count(severity) for severity in Severity},
        interfaces={each: sum(node.interface is each for node in network.nodes) for each in Interface},
    )


def _count(meetings: Sequence[Topic | Service | Action]) -> Count:
    return Count(len(meetings), sum(meeting.system for meeting in meetings))


def listed(items: Sequence[str], most: int) -> str:
    """The first of several, and how many more there are: `a, b and 3 more`."""
    more = f" and {len(items) - most} more" if len(items) > most else ""
    return ", ".join(items[:most]) + more


def several(number: int, one: str, many: str) -> str:
    """`3 tools`."""
    return f"{number} {one if number == 1 else many}"


def some(number: int, one: str, many: str) -> str:
    """The same, and nothing for none."""
    return several(number, one, many) if number else ""
