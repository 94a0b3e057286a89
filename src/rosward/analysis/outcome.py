# SPDX-License-Identifier: Apache-2.0
"""What does one process of the sources add to the result? Its nodes, its findings, and what was seen of its code; all plain records."""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

from rosward.analysis.process import Run, run
from rosward.analysis.seen import Seen, seen_of
from rosward.effects.configuration import Configuration
from rosward.effects.entry import Entry
from rosward.engine.budget import Budget
from rosward.engine.library import Library
from rosward.engine.reads import Question
from rosward.findings import Finding
from rosward.guard import guarded
from rosward.naming.collect import Process, collect
from rosward.ros.distro import Distro
from rosward.ros.entities import Node
from rosward.rules import Severity
from rosward.source.location import Place

__all__ = ["Done", "Outcome", "Outset", "outcome_of"]


class Outset(NamedTuple):
    """What all processes of the sources have in common."""

    library: Library
    budget: Budget
    configuration: Configuration | None
    distro: Distro


class Outcome(NamedTuple):
    """What a process adds. `makes_nodes`: it makes some, by whatever names."""

    nodes: tuple[Node, ...]
    findings: tuple[Finding, ...]
    makes_nodes: bool
    seen: Seen


class Done(NamedTuple):
    """What a process adds, and what it asked of the sources."""

    outcome: Outcome
    questions: tuple[Question, ...] = ()


def outcome_of(outset: Outset, entry: Entry) -> Done:
    """Run a process, and name what it makes. A probe that makes nothing, and has nothing to tell, adds nothing."""
    each = run(outset.library, entry, outset.budget, outset.configuration)
    seen = seen_of(each, outset.library)
    questions = () if each.reads is None else each.reads.questions
    if entry.probe and not (each.log.nodes or each.log.entities or _tells(each)):
        return Done(Outcome((), (), bool(each.log.nodes), seen), questions)
    process = Process(
        entry.package,
        entry.executable,
        entry.label,
        each.done,
        assumed=entry.assumed,
        shell=outset.library.environment,
    )
    missing = "the nodes of this program are missing"
    made = guarded(
        partial(collect, each.log, process, outset.distro), Place(entry.file), missing, net=outset.budget.net
    )
    nodes, doubts = ([], [made]) if isinstance(made, Finding) else made
    return Done(Outcome(tuple(nodes), (*each.log.findings, *doubts), bool(each.log.nodes), seen), questions)


def _tells(probe: Run) -> bool:
    """Whether a probe that made no node has something to tell all the same: why it may have missed one."""
    return any(f.rule.severity is Severity.ERROR or f.code in ("RW203", "RW209") for f in probe.log.findings)
