# SPDX-License-Identifier: Apache-2.0
"""What does one process add to the result? Its nodes, its findings, and what was seen of its code; all plain records."""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

from rosward.analysis.attempts import run
from rosward.analysis.process import Run
from rosward.analysis.seen import Seen, seen_of
from rosward.effects.configuration import Configuration
from rosward.effects.entry import Entry
from rosward.engine.budget import Budget
from rosward.engine.libraries.library import Library
from rosward.engine.sources.reads import Question
from rosward.findings import Finding
from rosward.guard import guarded
from rosward.location import Place
from rosward.naming.collect import Process, collect
from rosward.ros.distro import Distro
from rosward.ros.entities import Node
from rosward.rules import Severity

__all__ = ["Done", "Outcome", "Outset", "Task", "outcome_of"]


class Outset(NamedTuple):
    """What all processes have in common. `configuration`: how those are started of which nobody says how."""

    library: Library
    budget: Budget
    configuration: Configuration | None
    distro: Distro


class Task(NamedTuple):
    """A process that is to be run. `configuration`: how a launch file starts it; None: nobody says that it does."""

    entry: Entry
    configuration: Configuration | None = None


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


def outcome_of(outset: Outset, task: Task) -> Done:
    """Run a process, and name what it makes. A probe that makes nothing, and has nothing to tell, adds nothing, unless it is launched."""
    entry, is_launched = task.entry, task.configuration is not None
    each = run(outset.library, entry, outset.budget, task.configuration if is_launched else outset.configuration)
    reads = each.reads
    questions = () if reads is None else reads.questions
    if reads is not None and outset.library.has_further_models:
        questions += tuple(("model", name) for name in reads.models)
    memory = outset.library.memory
    if memory is None:
        return Done(_outcome(outset, entry, each, is_launched=is_launched), questions)
    make = partial(_outcome, outset, entry, each, is_launched=is_launched)
    return Done(memory.derived(each, (entry, is_launched, outset.distro), make), questions)


def _outcome(outset: Outset, entry: Entry, each: Run, *, is_launched: bool) -> Outcome:
    """What a process adds that was run."""
    seen = seen_of(each, outset.library)
    if entry.probe and not is_launched and not (each.log.nodes or each.log.entities or _tells(each)):
        return Outcome((), (), bool(each.log.nodes), seen)
    process = Process(
        entry.package,
        entry.executable,
        entry.label,
        each.done,
        assumed=entry.assumed and not is_launched,
        shell=outset.library.environment,
    )
    missing = "the nodes of this program are missing"
    made = guarded(
        partial(collect, each.log, process, outset.distro), Place(entry.file), missing, net=outset.budget.net
    )
    nodes, doubts = ([], [made]) if isinstance(made, Finding) else made
    return Outcome(tuple(nodes), (*each.log.findings, *doubts), bool(each.log.nodes), seen)


def _tells(probe: Run) -> bool:
    """Whether a probe that made no node has something to tell all the same: why it may have missed one."""
    return any(f.rule.severity is Severity.ERROR or f.code in ("RW203", "RW209") for f in probe.log.findings)
