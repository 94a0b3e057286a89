# SPDX-License-Identifier: Apache-2.0
"""The whole way, on one page: source text to workspace to processes to effects to nodes to network.

result = rosward.extract("my_ws", distro="jazzy")
result.network.nodes
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.nothing_found import nothing_found, nothing_started
from rosward.analysis.read import (
    EVERYTHING,
    NothingToReadError,
    Progress,
    SourcePath,
    SourcesRead,
    read_sources,
    silent,
)
from rosward.analysis.standalone import Gathered, of_sources
from rosward.deployment.asked import asked_of
from rosward.deployment.request import Request, RequestError, UnknownRequestError, Wanted, launching
from rosward.enclaves.size import size_findings
from rosward.engine.budget import Budget
from rosward.engine.sources.remembered import Memory, remembering
from rosward.findings import Finding, Findings
from rosward.guard import Steps
from rosward.network.assigned import NOTHING_ASSIGNED, Assignment
from rosward.network.checks import UnknownNames
from rosward.network.connect import apart, connect, with_findings
from rosward.network.contexts import each_its_own, with_enclaves
from rosward.network.enclave_mode import EnclaveMode
from rosward.network.graph import Network
from rosward.network.labels import labelled
from rosward.network.launch_tree import LaunchSystem
from rosward.records import NamedTuple, replace
from rosward.result import Result
from rosward.ros.distro import DEFAULT_DISTRO, Distro
from rosward.source.exclude import Exclusion
from rosward.source.text import place_name
from rosward.source.workspace import SkipReason, SourceFile

if TYPE_CHECKING:
    from rosward.cache.store import Store

__all__ = [
    "Budget",
    "Memory",
    "NothingToReadError",
    "Progress",
    "RequestError",
    "Result",
    "UnknownRequestError",
    "extract",
    "of_read",
    "remembering",
]


NO_ARGUMENTS: Final[Mapping[str, str]] = MappingProxyType({})


def budget_of(factor: float) -> Budget:
    """The limits of an analysis, with so many times the steps."""
    return Budget().times(factor)


def extract(
    *paths: SourcePath,
    distro: str = DEFAULT_DISTRO,
    unknown: UnknownNames = "deny",
    models: Sequence[SourcePath] = (),
    tests: bool = False,
    exclude: Sequence[str | Exclusion] = (),
    follow_links: bool = False,
    request: Request = EVERYTHING,
    launch: Wanted | Sequence[Wanted] = (),
    arguments: Mapping[str, str] = NO_ARGUMENTS,
    env: Mapping[str, str] | None = None,
    underlays: Sequence[SourcePath] = (),
    enclaves: str | None = None,
    assigned: Assignment = NOTHING_ASSIGNED,
    assumed: bool = True,
    budget: Budget | None = None,
    jobs: int = 1,
    store: Store | None = None,
    progress: Progress | None = None,
) -> Result:
    """Read the sources under `paths` and return the network of nodes that they make.

    Args:
        paths: files, packages or workspaces; the working directory where there is none.
        distro: One of `rosward.ros.distro.DISTROS`; decides what the client library adds.
        unknown: 'deny' or 'wildcard', what a policy made of the result will write for a name that is not known.
        models: folders of stub files that describe libraries, and of declared interfaces of nodes.
        tests: whether test files are read too.
        exclude: patterns, as in .gitignore, of files and folders that are not read at all.
        follow_links: whether symbolic links are entered that lead out of `paths`.
        request: what is started; by default every executable, as `ros2 run` starts it.
        launch: in its place, a launch file or several: `PKG:FILE` or a path.
        arguments: launch arguments for all of these; `*` leaves one open.
        env: environment variables of the shell in which everything is started; those of the distro need not be given.
        underlays: further workspaces, or install folders, in which launch and parameter files are looked for.
        enclaves: 'node', 'process' or 'launch'; by default per process where launch files are followed, else per node.
        assigned: enclaves that somebody chose for some of the processes.
        assumed: whether the nodes of classes that nothing instantiates are in the result, each marked as assumed.
        budget: limits of the analysis; `Budget().times(4)` has four times the steps.
        jobs: so many processes of this machine work at once, where there is enough to do; the result is the same.
        store: a cache; what is known of processes of which nothing has changed is taken from there.
        progress: called as the work goes on.

    Raises:
        NothingToReadError: where no Python file is found.
        UnknownRequestError: where what is to be started is not there.
        ValueError: where the distro or the kind of enclaves is not known, `env` contradicts the distro, or what is to be started has no meaning
            (RequestError).
        PatternError: where a pattern has no meaning.

    Nothing of what is read is imported or executed.
    """
    chosen = Distro(distro)
    if launch or arguments:
        if request != EVERYTHING:
            raise RequestError("pass either a request, or launch and arguments")
        request = launching(launch, arguments)
    mode = (
        EnclaveMode(enclaves) if enclaves is not None else EnclaveMode.PROCESS if request.deploys else EnclaveMode.NODE
    )
    tell = progress or silent
    result = with_deep_stack(
        lambda: _extract(
            read_sources(
                paths,
                chosen,
                models,
                underlays,
                budget,
                tell,
                request,
                environment=env,
                tests=tests,
                exclude=exclude,
                follow_links=follow_links,
                store=store,
            ),
            request,
            unknown,
            _Enclaves(mode, assigned),
            tell,
            assumed=assumed,
            jobs=jobs,
            store=store,
        )
    )
    asked = asked_of(
        request,
        result.root,
        paths,
        models,
        underlays,
        exclude,
        env or {},
        unknown=unknown,
        tests=tests,
        follow_links=follow_links,
        enclaves=_chosen_enclaves(mode, assigned, result.root),
        assumed=assumed,
        budget=(budget or Budget()).factor,
    )
    return replace(result, network=replace(result.network, asked=asked))


def of_read(read: SourcesRead, request: Request, progress: Progress = silent, *, assumed: bool = True) -> Result:
    """What a request starts of sources that are read: for those who ask several of them. The caller has the deep stack.

    Raises UnknownRequestError where what is to be started is not there.
    """
    mode = EnclaveMode.PROCESS if request.deploys else EnclaveMode.NODE
    return _extract(
        read, request, "deny", _Enclaves(mode, NOTHING_ASSIGNED), progress, assumed=assumed, jobs=1, store=None
    )


def _chosen_enclaves(mode: EnclaveMode, assigned: Assignment, root: Path) -> str:
    """How enclaves were chosen: the mode, or the file that assigns them."""
    return place_name(os.path.abspath(assigned.file), root) if assigned.file else mode.value  # noqa: PTH100


class _Enclaves(NamedTuple):
    """How enclaves are chosen."""

    mode: EnclaveMode
    assigned: Assignment


def _extract(
    read: SourcesRead,
    request: Request,
    unknown: UnknownNames,
    wanted: _Enclaves,
    progress: Progress,
    *,
    assumed: bool,
    jobs: int,
    store: Store | None,
) -> Result:
    systems: tuple[LaunchSystem, ...] = ()
    if request.deploys:
        from rosward.analysis.launched import of_request  # a fifth of the start-up, for those who launch something

        gathered, systems = of_request(request, read, progress, jobs=jobs, store=store)
    else:
        gathered = of_sources(read, request.params, progress, assumed=assumed, jobs=jobs, store=store)
    findings = Findings((*read.workspace.findings, *gathered.findings, *read.library.findings))
    workspace = read.workspace
    known = (*workspace.files, *workspace.launch_files, *workspace.cpp_sources)
    headers = sorted(read.sources.cpp_files.keys() - {f.relative for f in known})
    files = (
        *(SourceFile(file.path, file.relative) for file in known),
        *(SourceFile(workspace.root / name, name) for name in headers),
    )
    reasons = Counter(skipped.reason for skipped in workspace.skipped)
    read.sources.keep(read.library.facts)
    read.library.given_back()
    return Result(
        _network(read, gathered, findings, unknown, wanted, deploys=request.deploys),
        workspace.root,
        files,
        systems,
        reasons[SkipReason.EXCLUDED],
        reasons[SkipReason.IGNORED],
        len(workspace.launch_files),
    )


def _network(
    read: SourcesRead,
    gathered: Gathered,
    findings: Findings,
    unknown: UnknownNames,
    wanted: _Enclaves,
    *,
    deploys: bool,
) -> Network:
    steps = Steps(net=read.budget.net)
    named = labelled(gathered.nodes)
    placed = steps(
        lambda: with_enclaves(named, wanted.mode, wanted.assigned),
        None,
        "the enclaves are not the requested ones: each node has its own",
    )
    nodes, conflicts = placed or (each_its_own(named), [])
    nothing: list[Finding] = []
    too_large = steps(
        lambda: size_findings(nodes, unknown), nothing, "whether permissions are too large was not checked"
    )
    findings.update((*conflicts, *too_large))
    if not nodes:
        findings.add(nothing_started(read) if deploys else nothing_found(read))
    counts = _ReadCounts(
        read.sources.files_read, read.sources.lines_read, len({n.process for n in nodes if not n.assumed})
    )
    distro = read.distro.value
    network = steps(
        lambda: connect(distro, nodes, findings, **counts._asdict(), unknown=unknown, net=read.budget.net),
        None,
        "connections between nodes are missing, and the whole system was not checked",
    )
    if network is None:
        network = with_findings(apart(distro, nodes, **counts._asdict()), findings)
    return with_findings(network, steps.findings)


class _ReadCounts(NamedTuple):
    """How much was read."""

    files: int
    lines: int
    processes: int
