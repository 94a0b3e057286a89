# SPDX-License-Identifier: Apache-2.0
"""The whole way, on one page: source text to workspace to processes to effects to nodes to network.

result = rosward.extract("my_ws", distro="jazzy")
result.network.nodes
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Final, NamedTuple

from rosward.deep_stack import with_deep_stack
from rosward.deployment.declared.effects import Declarations
from rosward.deployment.files import WorkspaceFiles
from rosward.deployment.request import Request
from rosward.engine.budget import Budget
from rosward.engine.library import Library
from rosward.findings import Finding, Severity
from rosward.gather import Gathered, Progress, never_launched, of_sources, of_systems
from rosward.models.tables import natives
from rosward.network.checks import UnknownNames
from rosward.network.connect import connect
from rosward.network.contexts import EnclaveMode, with_enclaves
from rosward.network.graph import Network
from rosward.network.launch_tree import LaunchSystem
from rosward.plan import Plan, make_plan
from rosward.ros.distro import Distro
from rosward.source.discover import discover
from rosward.source.location import Place
from rosward.source.workspace import SourceFile, Workspace
from rosward.sources import SourceTree
from rosward.systems import Outset, System, UnknownRequestError, parameters_for_all, systems_of

__all__ = ["NothingToReadError", "Progress", "Result", "UnknownRequestError", "extract", "launched"]

_Path = str | PathLike[str]
_EVERYTHING: Final = Request()


@dataclass(frozen=True)
class Result:
    """What an extraction gave. `complete` is False where a finding says that something is missing from the network."""

    network: Network
    root: Path
    files: tuple[SourceFile, ...] = ()
    """The programs and launch files that were read."""
    systems: tuple[LaunchSystem, ...] = ()
    """What the launch files start, where they were followed."""

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
    *paths: _Path,
    distro: str = "jazzy",
    unknown: UnknownNames = "deny",
    models: Sequence[_Path] = (),
    tests: bool = False,
    request: Request = _EVERYTHING,
    underlays: Sequence[_Path] = (),
    enclaves: str | None = None,
    budget: Budget | None = None,
    progress: Progress | None = None,
) -> Result:
    """Read the sources under `paths` and return the network of nodes that they make.

    Args:
        paths: files, packages or workspaces; the working directory where there is none.
        distro: humble, iron, jazzy, kilted or rolling; decides what the client library adds by itself.
        unknown: 'deny' or 'wildcard', what a policy made of the result will write for a name that is not known.
        models: folders of stub files that describe libraries, and of declared interfaces of nodes.
        tests: whether test files are read too.
        request: what is started; by default every executable, as `ros2 run` starts it.
        underlays: further workspaces, or install folders, in which launch and parameter files are looked for.
        enclaves: 'node', 'process' or 'launch'; by default per process where launch files are followed, else per node.
        budget: limits of the analysis.
        progress: called as the work goes on.

    Raises:
        NothingToReadError: where no Python file is found.
        UnknownRequestError: where what is to be started is not there.
        ValueError: where the distro or the kind of enclaves is not known.

    Nothing of what is read is imported or executed.
    """
    chosen = Distro(distro)
    mode = (
        EnclaveMode(enclaves) if enclaves is not None else EnclaveMode.PROCESS if request.deploys else EnclaveMode.NODE
    )
    tell = progress or _silent
    return with_deep_stack(
        lambda: _extract(
            read_sources(paths, chosen, models, underlays, budget, tell, request, tests=tests),
            request,
            unknown,
            mode,
            tell,
        )
    )


def launched(
    *paths: _Path,
    distro: str = "jazzy",
    models: Sequence[_Path] = (),
    tests: bool = False,
    request: Request = _EVERYTHING,
    underlays: Sequence[_Path] = (),
    budget: Budget | None = None,
) -> tuple[tuple[LaunchSystem, ...], tuple[Finding, ...]]:
    """What the launch files of a request start, without a look into the programs. See `extract` for the arguments."""

    def work() -> tuple[tuple[LaunchSystem, ...], tuple[Finding, ...]]:
        read = read_sources(paths, Distro(distro), models, underlays, budget, _silent, request, tests=tests)
        systems, findings = systems_of(request, read.outset)
        return tuple(s.tree() for s in systems), tuple(sorted(findings, key=lambda f: (f.place, f.code, f.message)))

    return with_deep_stack(work)


class SourcesRead(NamedTuple):
    """What was read, before anything of it is interpreted."""

    workspace: Workspace
    sources: SourceTree
    plan: Plan
    outset: Outset


def _silent(_what: str, _done: int, _all: int) -> None:
    """No progress is shown."""


def read_sources(
    paths: Sequence[_Path],
    distro: Distro,
    models: Sequence[_Path],
    underlays: Sequence[_Path],
    budget: Budget | None,
    progress: Progress,
    request: Request = _EVERYTHING,
    *,
    tests: bool,
) -> SourcesRead:
    """Read what is under `paths`, and the launch files that a request names by their path."""
    wanted = [Path(p) for p in paths] or [Path()]
    named = [Path(r.file) for r in request.launches if r.package is None and os.path.isfile(r.file)]  # noqa: PTH113
    workspace = discover(wanted, launch_files=named, include_tests=tests)
    if not (workspace.files or workspace.launch_files or request.nodes):
        raise NothingToReadError(f"nothing to read: no Python file in {', '.join(map(str, wanted))}")
    sources = SourceTree(workspace, [Path(u) for u in underlays])
    sources.read_all(lambda done: progress("reading", done, len(workspace.files)))
    folders = tuple(Path(m) for m in models)
    library = Library(sources, natives(), folders)
    plan = make_plan(workspace, sources, library)
    files = WorkspaceFiles(sources.files)
    outset = Outset(workspace, library, files, Declarations(folders), plan.related, distro, budget or Budget())
    return SourcesRead(workspace, sources, plan, outset)


def _extract(
    read: SourcesRead, request: Request, unknown: UnknownNames, mode: EnclaveMode, progress: Progress
) -> Result:
    outset, sources = read.outset, read.sources
    findings: dict[Finding, None] = dict.fromkeys(read.workspace.findings)
    systems: list[System] = []
    if request.deploys:
        systems, doubts = systems_of(request, outset)
        gathered = of_systems(systems, sources, outset, progress)
        doubts += never_launched(systems, read.plan) if request.all_launch else []
    else:
        configuration, doubts = parameters_for_all(request, read.workspace)
        gathered = of_sources(outset.library, sources, read.plan, outset.budget, outset.distro, configuration, progress)
    findings.update(dict.fromkeys((*doubts, *gathered.findings, *outset.library.findings)))
    workspace = read.workspace
    files = (*workspace.files, *workspace.launch_files)
    network = _network(read, gathered, findings, unknown, mode)
    return Result(network, workspace.root, files, tuple(s.tree() for s in systems))


def _network(
    read: SourcesRead, gathered: Gathered, findings: dict[Finding, None], unknown: UnknownNames, mode: EnclaveMode
) -> Network:
    nodes, conflicts = with_enclaves(gathered.nodes, mode)
    findings.update(dict.fromkeys(conflicts))
    if not nodes:
        findings[Finding("RW007", "No node was found in what was read.", Place("", 0))] = None
    return connect(
        read.outset.distro.value,
        nodes,
        findings,
        files=read.sources.files_read,
        lines=read.sources.lines_read,
        processes=len({n.process for n in nodes}),
        unknown=unknown,
    )
