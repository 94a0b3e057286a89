# SPDX-License-Identifier: Apache-2.0
"""Which nodes do the processes of all sources make, each as `ros2 run` starts it?

The effects of each process become nodes (`naming/collect.py`). For launched systems, `launched.py` does the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from rosward.analysis.process import Run, called_from_outside, node_classes, run
from rosward.analysis.read import Progress, SourcesRead
from rosward.analysis.unreached import unreached_of
from rosward.deployment.given import parameter_files
from rosward.domain.values import Const
from rosward.effects.configuration import Configuration
from rosward.effects.entry import Entry
from rosward.effects.variables import Variables, not_given
from rosward.findings import Finding, Findings
from rosward.guard import guarded
from rosward.naming.collect import Process, collect
from rosward.records import NamedTuple, replace
from rosward.ros.entities import Node
from rosward.rules import Severity
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
    everything = _run_all(read, configuration, progress, assumed=assumed)
    findings.update((*read.sources.findings, *read.plan.findings))
    nodes: list[Node] = []
    for each in everything:
        if each.log.nodes or each.log.entities or not each.entry.probe or _tells(each):
            entry = each.entry
            process = Process(
                entry.package,
                entry.executable,
                entry.label,
                each.done,
                assumed=entry.assumed,
                shell=read.library.environment,
            )
            findings.update(each.log.findings)
            missing = "the nodes of this program are missing"
            made = guarded(partial(collect, each.log, process, read.distro), Place(entry.file), missing, net=net)
            if isinstance(made, Finding):
                findings.add(made)
                continue
            nodes += made[0]
            findings.update(made[1])
    modules = [m for f in sorted(read.plan.related) if (m := read.sources.module(f)) is not None]
    missing = "unreachable code is not reported"
    told = guarded(
        lambda: unreached_of(everything, modules, read.library.facts, read.sources), Place("", 0), missing, net=net
    )
    findings.update((told,) if isinstance(told, Finding) else told)
    asked = Variables()
    for each in everything:
        asked.add_required(each.log.variables)
    findings.update(not_given(asked))
    return Gathered(nodes, list(findings))


def _run_all(read: SourcesRead, configuration: Configuration | None, progress: Progress, *, assumed: bool) -> list[Run]:
    """Every process of the plan, then the files that none imports, then the node classes, and those of frameworks, that none instantiates."""
    library, plan, budget = read.library, read.plan, read.budget
    runs: list[Run] = []
    total = len(plan.entries)
    for number, entry in enumerate(plan.entries):
        progress("analysing", number, total)
        if not entry.assumed or (assumed and not _is_made(read, entry, runs)):
            runs.append(run(library, entry, budget, configuration))
    progress("analysing", total, total)
    entered = {code for r in runs for code in r.entered}
    for file in sorted(plan.related):
        module = read.sources.module(file)
        if module is not None and module.code.key not in entered:
            runs.append(run(library, plan.for_file(file), budget, configuration))
            entered |= runs[-1].entered
    for file, names in node_classes(runs, library).items() if assumed else ():
        for name in names:  # nothing says that two of them share a process
            runs.append(run(library, plan.for_class(file, name), budget, configuration))
    for file, names in called_from_outside(runs, library).items():
        for name in names:
            each = run(library, plan.for_framework(file, name, alone=len(names) == 1), budget, configuration)
            if each.log.nodes:  # what it makes on nodes that it is given is told of its base (`unreached.py`)
                runs.append(each)
    return runs


def _is_made(read: SourcesRead, entry: Entry, runs: Sequence[Run]) -> bool:
    """Whether an executable makes the component that an entry is about: then nobody has to be assumed who does."""
    program = read.sources.program(entry.program)
    made = {place for each in runs for place in each.instantiated}
    *scope, name = entry.classes[0].removeprefix("::").split("::")
    return program is not None and any(symbol.place in made for symbol in program.at(tuple(scope), name))


def _tells(probe: Run) -> bool:
    """Whether a probe that made no node has something to tell all the same: why it may have missed one."""
    return any(f.rule.severity is Severity.ERROR or f.code in ("RW203", "RW209") for f in probe.log.findings)
