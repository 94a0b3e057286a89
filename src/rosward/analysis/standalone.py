# SPDX-License-Identifier: Apache-2.0
"""Which nodes do the processes of all sources make, each as `ros2 run` starts it?

What each process adds, `outcome.py` says. For launched systems, `launched.py` does the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rosward.analysis.of_classes import called_from_outside, node_classes
from rosward.analysis.outcome import Outcome, Outset, Task
from rosward.analysis.read import Progress, SourcesRead
from rosward.analysis.runner import Runner
from rosward.analysis.seen import note_variables
from rosward.analysis.unreached import unreached_of
from rosward.deployment.given import parameter_files
from rosward.domain.values import Const
from rosward.effects.entry import Entry
from rosward.effects.variables import Variables, not_given
from rosward.findings import Finding, Findings
from rosward.guard import guarded
from rosward.location import Place
from rosward.records import NamedTuple, replace
from rosward.ros.entities import Node

if TYPE_CHECKING:
    from rosward.cache.store import Store

__all__ = ["Gathered", "of_sources"]


class Gathered(NamedTuple):
    """The nodes and what is doubtful about them."""

    nodes: list[Node]
    findings: list[Finding]


def of_sources(
    read: SourcesRead,
    params: Sequence[str],
    progress: Progress,
    *,
    assumed: bool = True,
    jobs: int = 1,
    store: Store | None = None,
) -> Gathered:
    """The nodes of every executable, of files that nothing imports, and of node classes that nothing instantiates.

    `params` are parameter files for all of them; without `assumed`, node classes that nothing instantiates are left out. `jobs`: so many
    processes of the sources are run at once. `store`: what is known of some of them.
    """
    findings = Findings()
    net = read.budget.net
    given = parameter_files(params, read.workspace.root, findings, net=net)
    configuration = replace(given, words=(Const("--ros-args"), *given.words)) if given.words else None
    outset = Outset(read.library, read.budget, configuration, read.distro)
    with Runner(read, outset, jobs, store) as runner:
        everything = _run_all(read, runner, progress, assumed=assumed)
    findings.update((*read.sources.findings, *read.plan.findings))
    for each in everything:
        findings.update(each.findings)
    seen = [each.seen for each in everything]
    known = sorted(read.plan.related - runner.lost)
    modules = [m for f in known if (m := read.sources.module(f)) is not None]
    missing = "unreachable code is not reported"
    told = guarded(
        lambda: unreached_of(seen, modules, read.library.facts, read.sources), Place("", 0), missing, net=net
    )
    findings.update((told,) if isinstance(told, Finding) else told)
    asked = Variables()
    for one in seen:
        note_variables(one, asked)
    findings.update(not_given(asked))
    return Gathered([node for each in everything for node in each.nodes], list(findings))


def _run_all(read: SourcesRead, runner: Runner, progress: Progress, *, assumed: bool) -> list[Outcome]:
    """Every process of the plan, then the files that none imports, then the node classes, and those of frameworks, that none instantiates."""
    plan = read.plan
    found = _planned(read, runner, progress, assumed=assumed)
    entered = {code for each in found for code in each.seen.entered}
    for file in sorted(plan.related):
        module = read.sources.module(file)
        if module is not None and module.code.key not in entered:
            found.append(runner.one(plan.for_file(file)))
            entered |= found[-1].seen.entered
    unmade = node_classes(each.seen for each in found) if assumed else {}
    # nothing says that two of them share a process
    made = [plan.for_class(file, name) for file, names in unmade.items() for name in names]
    found += runner.all([Task(e) for e in made], lambda done: progress("analysing", done, len(made)))
    offered = called_from_outside(each.seen for each in found)
    called = [
        plan.for_framework(file, name, alone=len(names) == 1) for file, names in offered.items() for name in names
    ]
    # what one makes on nodes that it is given is told of its base (`unreached.py`)
    found += (
        each
        for each in runner.all([Task(e) for e in called], lambda done: progress("analysing", done, len(called)))
        if each.makes_nodes
    )
    return found


def _planned(read: SourcesRead, runner: Runner, progress: Progress, *, assumed: bool) -> list[Outcome]:
    """The processes of the plan. A component is assumed to be loaded unless a process before it makes one."""
    entries = read.plan.entries
    known = [entry for entry in entries if not entry.assumed]

    def tell(done: int) -> None:
        progress("analysing", done, len(entries))

    by_entry = dict(zip(known, runner.all([Task(e) for e in known], tell), strict=True))
    found = [by_entry[entry] for entry in known]
    left = [entry for entry in entries if entry.assumed and assumed and not _is_made(read, entry, found)]
    by_entry.update(zip(left, runner.all([Task(e) for e in left], lambda done: tell(len(known) + done)), strict=True))
    tell(len(entries))
    for entry in left:
        if not _is_made(read, entry, found):
            found.append(by_entry[entry])
    return found


def _is_made(read: SourcesRead, entry: Entry, found: Sequence[Outcome]) -> bool:
    """Whether an executable makes the component that an entry is about: then nobody has to be assumed who does."""
    made = {place for each in found for place in each.seen.instantiated}
    return any(place in made for place in read.sources.component_places(entry.program))
