# SPDX-License-Identifier: Apache-2.0
"""What does an audit say? The records that its outputs read.

Audit(differences=(Difference("/rogue", "", Finding("RW501", …)),), tools=(Tool("/rviz2", "RViz", 14),), nodes=Counts(5, 3, 1), …)
"""

from __future__ import annotations

from dataclasses import dataclass, field

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple

__all__ = ["Audit", "AuditCounts", "Difference", "Tool", "Unjudged", "Unseen"]


class Difference(NamedTuple):
    """One difference. `entity` is what it is about, '' where that is the node; `seen` in how many looks, 0 where that was not counted."""

    node: str
    entity: str
    finding: Finding
    seen: int = 0


class Unseen(NamedTuple):
    """What only some executions have, and was not seen; `entity` as in a difference."""

    node: str
    entity: str
    place: Place


class Tool(NamedTuple):
    """A running node that is a tool, and how many entities it has."""

    node: str
    tool: str
    entities: int


class Unjudged(NamedTuple):
    """A running node whose interface is not known by the source, and the entities that are so explained by its name alone."""

    node: str
    entities: tuple[str, ...]
    place: Place


class AuditCounts(NamedTuple):
    """How many are running, and how many of them the source explains: by their name, or by a name that is known in part."""

    running: int = 0
    exact: int = 0
    pattern: int = 0


@dataclass(frozen=True, slots=True)
class Audit:
    """What was found. `accepted` counts what a person accepts, `untold` the expected nodes of which the texts say nothing."""

    source: str
    looks: int
    differences: tuple[Difference, ...]
    unseen: tuple[Unseen, ...] = ()
    tools: tuple[Tool, ...] = ()
    unjudged: tuple[Unjudged, ...] = ()
    findings: tuple[Finding, ...] = ()
    nodes: AuditCounts = field(default_factory=AuditCounts)
    entities: AuditCounts = field(default_factory=AuditCounts)
    accepted: int = 0
    untold: int = 0

    @property
    def clean(self) -> bool:
        """Whether everything that runs is explained, and everything that is expected runs."""
        return not self.differences and not self.findings
