# SPDX-License-Identifier: Apache-2.0
"""Do the static graph and the real one agree? Both directions, and how precise the static one is.

static: pub /robot_*/cmd      real: pub /robot_1/cmd     covered
static: pub /a                real: nothing              missing, unless it is conditional
static: nothing               real: pub /b               uncovered
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from typing import Final, NamedTuple

from rosward import EntityKind, Resolution, Result

from .harness import Fact, Seen

WORDS: Final = {
    EntityKind.PUBLISHER: "pub",
    EntityKind.SUBSCRIPTION: "sub",
    EntityKind.SERVICE_SERVER: "ss",
    EntityKind.SERVICE_CLIENT: "sc",
    EntityKind.ACTION_SERVER: "as",
    EntityKind.ACTION_CLIENT: "ac",
}
TELLS: Final = frozenset({"RW202", "RW203", "RW204", "RW210"})
"""Findings which say that something may be missing, besides the errors."""


class Claim(NamedTuple):
    """An entity of the static graph. `certain` says that every execution creates it, `exact` that its name is known."""

    node: str
    kind: str
    name: str
    type: str | None
    certain: bool
    exact: bool

    def covers(self, fact: Fact) -> bool:
        """Whether this is what was seen."""
        node, kind, name, type_ = fact
        if self.kind != kind or (self.type is not None and self.type != type_):
            return False
        return _matches(self.node, node) and (_matches(self.name, name))

    def __str__(self) -> str:
        doubt = ("" if self.exact else " (not exact)") + ("" if self.certain else " (conditional)")
        return f"{self.node}: {self.kind} {self.name} {self.type or '?'}{doubt}"


class Verdict(NamedTuple):
    """What is wrong, in words, and the measures of precision."""

    uncovered: tuple[str, ...]
    missing: tuple[str, ...]
    vague: tuple[str, ...]
    unseen: tuple[str, ...]
    told: bool

    @property
    def holds(self) -> bool:
        """Whether the static graph is right, or says itself that something may be missing."""
        return not self.missing and (self.told or not self.uncovered)


def claims_of(result: Result) -> list[Claim]:
    """What the static graph says."""
    return [
        Claim(
            node.fqn,
            WORDS[entity.kind],
            entity.name if entity.resolution is not Resolution.UNKNOWN else "*",
            entity.type,
            not entity.conditional and not node.conditional,
            entity.resolution not in {Resolution.PATTERN, Resolution.UNKNOWN},
        )
        for node in result.network.nodes
        for entity in node.entities
    ]


def judge(result: Result, runs: Iterable[Seen]) -> Verdict:
    """Compare a static result with what was seen when the programs of the same sources ran."""
    seen = tuple(runs)
    claims = claims_of(result)
    facts = sorted(frozenset[Fact]().union(*(s.facts for s in seen)))
    nodes = sorted(frozenset[str]().union(*(s.nodes for s in seen)))
    static_nodes = {node.fqn for node in result.network.nodes}
    uncovered = [f"node {n}" for n in nodes if not any(_matches(s, n) for s in static_nodes)]
    uncovered += [" ".join(fact) for fact in facts if not any(c.covers(fact) for c in claims)]
    whole = all(s.whole for s in seen)
    absent = [c for c in claims if not any(c.covers(fact) for fact in facts)]
    return Verdict(
        uncovered=tuple(uncovered),
        missing=tuple(str(c) for c in absent if c.certain) if whole else (),
        vague=tuple(str(c) for c in claims if not c.exact),
        unseen=tuple(str(c) for c in absent if not c.certain),
        told=not result.complete or any(f.code in TELLS for f in result.findings),
    )


@lru_cache(maxsize=4096)
def _pattern(name: str) -> re.Pattern[str]:
    return re.compile(".*".join(map(re.escape, name.split("*"))))


def _matches(claimed: str, name: str) -> bool:
    return claimed == name or ("*" in claimed and _pattern(claimed).fullmatch(name) is not None)
