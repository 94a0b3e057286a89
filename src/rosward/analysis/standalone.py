# SPDX-License-Identifier: Apache-2.0
"""Which nodes do the processes of all sources make, each as `ros2 run` starts it?

What each process adds, `outcome.py` says. For launched systems, `launched.py` does the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from rosward.analysis.of_classes import called_from_outside, node_classes
from rosward.analysis.outcome import Outcome, Outset, outcome_of
from rosward.analysis.read import Progress, SourcesRead
from rosward.analysis.seen import variables_of
from rosward.analysis.unreached import unreached_of
from rosward.deployment.given import parameter_files
from rosward.domain.values import Const
from rosward.effects.entry import Entry
from rosward.effects.variables import Variables, not_given
from rosward.findings import Finding, Findings
from rosward.guard import guarded
from rosward.ros.entities import Node
from rosward.source.location import Place

__all__ = ["Gathered", "of_sources"]


class Gathered(NamedTuple):
    """The nodes and what is doubtful about them."""

    nodes: list[Node]
    findings: list[Finding]


def of_sources(read: SourcesRead, params: Sequence[str], progress: Progress, *, assumed: bool = True) -> Gathered:
    """The nodes of every executable, of files that nothing imports, and of node classes that nothing instantiates.

    `params` are parameter files for all of them; without `assumed`, node classes that nothing instantiates are left out.
    """
    findings = Findings()
    net = read.budget.net
    given = parameter_files(params, read.workspace.root, findings, net=net)
    configuration = replace(given, words=(Const("--ros-args"), *given.words)) if given.words else None
    everything = _run_all(
        read, Outset(read.library, read.budget, configuration, read.distro), progress, assumed=assumed
    )
    findings.update((*read.sources.findings, *read.plan.findings))
    for each in everything:
        findings.update(each.findings)
    seen = [each.seen for each in everything]
    modules = [m for f in sorted(read.plan.related) if (m := read.sources.module(f)) is not None]
    missing = "unreachable code is not reported"
    told = guarded(
        lambda: unreached_of(seen, modules, read.library.facts, read.sources), Place("", 0), missing, net=net
    )
    findings.update((told,) if isinstance(told, Finding) else told)
    asked = Variables()
    for one in seen:
        asked.add_required(variables_of(one))
    findings.update(not_given(asked))
    return Gathered([node for each in everything for node in each.nodes], list(findings))


def _run_all(read: SourcesRead, outset: Outset, progress: Progress, *, assumed: bool) -> list[Outcome]:
    """Every process of the plan, then the files that none imports, then the node classes, and those of frameworks, that none instantiates."""
    plan = read.plan
    found: list[Outcome] = []
    total = len(plan.entries)
    for number, entry in enumerate(plan.entries):
        progress("analysing", number, total)
        if not entry.assumed or (assumed and not _is_made(read, entry, found)):
            found.append(outcome_of(outset, entry))
    progress("analysing", total, total)
    entered = {code for each in found for code in each.seen.entered}
    for file in sorted(plan.related):
        module = read.sources.module(file)
        if module is not None and module.code.key not in entered:
            found.append(outcome_of(outset, plan.for_file(file)))
            entered |= found[-1].seen.entered
    for file, names in node_classes(each.seen for each in found).items() if assumed else ():
        for name in names:  # nothing says that two of them share a process
            found.append(outcome_of(outset, plan.for_class(file, name)))
    for file, names in called_from_outside(each.seen for each in found).items():
        for name in names:
            each = outcome_of(outset, plan.for_framework(file, name, alone=len(names) == 1))
            if each.makes_nodes:  # what it makes on nodes that it is given is told of its base (`unreached.py`)
                found.append(each)
    return found


def _is_made(read: SourcesRead, entry: Entry, found: Sequence[Outcome]) -> bool:
    """Whether an executable makes the component that an entry is about: then nobody has to be assumed who does."""
    program = read.sources.program(entry.program)
    made = {place for each in found for place in each.seen.instantiated}
    *scope, name = entry.classes[0].removeprefix("::").split("::")
    return program is not None and any(symbol.place in made for symbol in program.at(tuple(scope), name))
