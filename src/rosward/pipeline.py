# SPDX-License-Identifier: Apache-2.0
"""The whole way, on one page: source text to workspace to processes to effects to nodes to network.

result = rosward.extract("my_ws", distro="jazzy")
result.network.nodes
"""

from __future__ import annotations

import gc
import sys
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Final

from rosward.engine.budget import Budget
from rosward.engine.library import Library
from rosward.findings import Finding, Severity
from rosward.models.tables import natives
from rosward.network.checks import UnknownNames
from rosward.network.collect import Process, collect
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.plan import Plan, make_plan
from rosward.processes import Entry, Run, node_classes, run
from rosward.ros.distro import Distro
from rosward.ros.entities import Node
from rosward.source.discover import discover
from rosward.source.location import Place
from rosward.sources import SourceTree
from rosward.unreached import unreached

Progress = Callable[[str, int, int], None]
"""Told of each step: what, how many are done, how many there are."""

_STACK: Final = 512 * 1024 * 1024
_RECURSION: Final = 60_000


@dataclass(frozen=True)
class Result:
    """What an extraction gave. `complete` is False where a finding says that something is missing from the network."""

    network: Network
    root: Path

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings, sorted."""
        return self.network.findings

    @property
    def complete(self) -> bool:
        """Whether the network holds all that the sources do, as far as the documented assumptions go."""
        return not any(f.rule.severity is Severity.ERROR for f in self.findings)


class NothingToReadError(Exception):
    """None of the paths holds a Python file."""


def extract(
    *paths: str | PathLike[str],
    distro: str = "jazzy",
    unknown: UnknownNames = "deny",
    models: Sequence[str | PathLike[str]] = (),
    tests: bool = False,
    budget: Budget | None = None,
    progress: Progress | None = None,
) -> Result:
    """Read the sources under `paths` and return the network of nodes that they make.

    Args:
        paths: files, packages or workspaces; the working directory where there is none.
        distro: humble, iron, jazzy, kilted or rolling; decides what the client library adds by itself.
        unknown: 'deny' or 'wildcard', what a policy made of the result will write for a name that is not known.
        models: folders of stub files that describe libraries.
        tests: whether test files are read too.
        budget: limits of the analysis.
        progress: called as the work goes on.

    Raises:
        NothingToReadError: where no Python file is found.
        ValueError: where the distro is not known.

    Nothing of what is read is imported or executed.
    """
    chosen = Distro(distro)
    folders = tuple(Path(m) for m in models)
    wanted = [Path(p) for p in paths] or [Path()]
    return _with_deep_stack(
        lambda: _extract(wanted, chosen, unknown, folders, tests, budget or Budget(), progress or _silent)
    )


def _silent(_what: str, _done: int, _all: int) -> None:
    """No progress is shown."""


def _extract(
    paths: list[Path],
    distro: Distro,
    unknown: UnknownNames,
    models: tuple[Path, ...],
    tests: bool,
    budget: Budget,
    progress: Progress,
) -> Result:
    workspace = discover(paths, include_tests=tests)
    if not workspace.files:
        raise NothingToReadError(", ".join(map(str, paths)))
    sources = SourceTree(workspace)
    sources.read_all(lambda done: progress("reading", done, len(workspace.files)))
    library = Library(sources, natives(), models)
    plan = make_plan(workspace, sources, library)
    everything = _run_all(library, sources, plan, budget, progress)
    runs = [r for r in everything if r.log.nodes or r.log.entities or not r.entry.probe or _tells(r)]
    findings: dict[Finding, None] = dict.fromkeys((*workspace.findings, *sources.findings, *plan.findings))
    nodes: list[Node] = []
    for each in runs:
        entry = each.entry
        found, doubts = collect(each.log, Process(entry.package, entry.executable, entry.label, each.done), distro)
        nodes += found
        findings.update(dict.fromkeys((*each.log.findings, *doubts)))
    findings.update(
        dict.fromkeys(unreached(everything, (m for f in sorted(plan.related) if (m := sources.module(f)) is not None)))
    )
    if not nodes:
        findings[Finding("RW007", "No node was found in what was read.", Place("", 0))] = None
    network = connect(
        distro.value,
        nodes,
        findings,
        files=sources.files_read,
        lines=sources.lines_read,
        processes=len({n.process for n in nodes}),
        unknown=unknown,
    )
    return Result(network, workspace.root)


def _run_all(library: Library, sources: SourceTree, plan: Plan, budget: Budget, progress: Progress) -> list[Run]:
    """Every process of the plan, then the files that none of them imports, then the node classes that none of them instantiates."""
    runs: list[Run] = []
    total = len(plan.entries)
    for number, entry in enumerate(plan.entries):
        progress("analysing", number, total)
        runs.append(run(library, entry, budget))
    progress("analysing", total, total)
    for file in sorted(plan.related):
        module = sources.module(file)
        if module is not None and not any(id(module.code) in r.entered for r in runs):
            runs.append(run(library, plan.for_file(file), budget))
    for file, names in node_classes(runs, library.node_class(None)).items():
        for name in names:  # nothing says that two of them share a process
            runs.append(run(library, plan.for_class(file, name, alone=len(names) == 1), budget))
    return runs


def _tells(probe: Run) -> bool:
    """Whether a probe that made no node has something to tell all the same: why it may have missed one."""
    return any(f.rule.severity is Severity.ERROR or f.code in ("RW203", "RW209") for f in probe.log.findings)


def _with_deep_stack(work: Callable[[], Result]) -> Result:
    """Run in a thread whose stack is deep enough for sources that nest deeply."""
    outcome: list[Result] = []
    failure: list[BaseException] = []

    def body() -> None:
        collecting = gc.isenabled()
        gc.disable()  # most of what is made here lives to the end
        limit = sys.getrecursionlimit()
        sys.setrecursionlimit(max(limit, _RECURSION))
        try:
            outcome.append(work())
        except BaseException as error:
            failure.append(error)
        finally:
            sys.setrecursionlimit(limit)
            if collecting:
                gc.enable()

    before = threading.stack_size(_STACK)
    try:
        thread = threading.Thread(target=body, name="rosward")
        thread.start()
    finally:
        threading.stack_size(before)
    thread.join()
    if failure:
        raise failure[0]
    return outcome[0]


__all__ = ["Entry", "NothingToReadError", "Progress", "Result", "extract"]
