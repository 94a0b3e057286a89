# SPDX-License-Identifier: Apache-2.0
"""What is read, before anything of it is interpreted?

read_sources([Path("my_ws")], Distro.JAZZY, …)  ->  SourcesRead(workspace, sources, plan, library, …)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rosward.analysis.plan import Plan, make_plan, plain_plan
from rosward.analysis.source_tree import SourceTree
from rosward.deployment.request import Request
from rosward.effects.shell import shell
from rosward.engine.budget import Budget
from rosward.engine.libraries.library import Library
from rosward.engine.sources.remembered import memory_here
from rosward.guard import Steps
from rosward.models.tables import own_models
from rosward.records import NamedTuple
from rosward.ros.distro import Distro
from rosward.source import disk
from rosward.source.discover import discover
from rosward.source.exclude import Exclusion, exclusions_of
from rosward.source.surroundings import surroundings
from rosward.source.workspace import Workspace

if TYPE_CHECKING:
    from rosward.analysis.compiled import Compiled
    from rosward.analysis.kept_programs import Keeper
    from rosward.analysis.summaries import Summaries
    from rosward.cache.store import Store

__all__ = ["EVERYTHING", "NothingToReadError", "Progress", "SourcePath", "SourcesRead", "read_sources", "silent"]

SourcePath = str | PathLike[str]
Progress = Callable[[str, int, int], None]
"""Told of each step: what, how many are done, how many there are."""

EVERYTHING: Final = Request()


class NothingToReadError(Exception):
    """None of the paths holds a file that can be read."""


class SourcesRead(NamedTuple):
    """The sources, what is known of the libraries that they use, and with what they are analysed."""

    workspace: Workspace
    sources: SourceTree
    plan: Plan
    library: Library
    models: tuple[Path, ...]
    distro: Distro
    budget: Budget


def read_sources(
    paths: Sequence[SourcePath],
    distro: Distro,
    models: Sequence[SourcePath] = (),
    underlays: Sequence[SourcePath] = (),
    budget: Budget | None = None,
    progress: Progress | None = None,
    request: Request = EVERYTHING,
    *,
    environment: Mapping[str, str] | None = None,
    tests: bool = False,
    exclude: Sequence[str | Exclusion] = (),
    follow_links: bool = False,
    store: Store | None = None,
) -> SourcesRead:
    """Read what is under `paths`, and the launch files that a request names by their path. What a store knows of a file is not read from it.

    `environment` has the variables that are given. Raises SurroundingsError where one of them contradicts the distro.
    """
    variables = surroundings(distro.value, environment)
    wanted = [Path(p) for p in paths] or [Path()]
    named = [Path(r.file) for r in request.launches if r.package is None and disk.is_file(r.file)]
    patterns = exclusions_of(exclude, map(str, wanted))
    bounds = budget or Budget()
    workspace = discover(
        wanted,
        launch_files=named,
        include_tests=tests,
        exclude=patterns,
        follow_links=follow_links,
        environment=variables,
        net=bounds.net,
    )
    if not (workspace.files or workspace.launch_files or workspace.cpp_sources or request.nodes):
        raise NothingToReadError(f"nothing to read: no Python, C++ or launch file in {', '.join(map(str, wanted))}")
    folders = tuple(Path(m) for m in models)
    known = None if store is None else _Store.of(store, folders)
    compiled = _compiled(workspace, distro, bounds, folders, known) if workspace.cpp_sources else None
    summaries = None if known is None else _summaries(known, workspace)
    sources = SourceTree(
        workspace, [Path(u) for u in underlays], net=bounds.net, compiled=compiled, summaries=summaries
    )
    tell = progress or silent
    sources.read_all(lambda done: tell("reading", done, len(workspace.files)))
    library = Library(sources, own_models(), folders, shell(variables), net=bounds.net)
    steps = Steps(net=bounds.net)
    missing = "each file is analysed as a program of its own, under its own name"
    made = steps(lambda: make_plan(workspace, sources, library), None, missing)
    plan = made or plain_plan(workspace)
    if compiled is not None:
        plan = plan.with_programs(compiled.all, compiled.related)
    plan = plan._replace(findings=(*plan.findings, *steps.findings))
    return SourcesRead(workspace, sources, plan, library, folders, distro, bounds)


class _Store(NamedTuple):
    """A store, and for which rosward and which models of the user it is asked."""

    store: Store
    version: str
    models: list[list[str]]

    @classmethod
    def of(cls, store: Store, folders: Sequence[Path]) -> _Store | None:
        """None where what the models say cannot be told."""
        from rosward.analysis.models_state import models_state
        from rosward.cache.version import version_key

        models = models_state(folders)
        return None if models is None else cls(store, version_key(), models)


def _compiled(
    workspace: Workspace, distro: Distro, budget: Budget, folders: Sequence[Path], known: _Store | None
) -> Compiled:
    """The programs in C++: what reads them is loaded where there are some."""
    from rosward.analysis.compiled import Compiled
    from rosward.analysis.kept_programs import InMemory, InStore

    keeper: Keeper | None = None
    memory = memory_here()
    if known is not None:
        keeper = InStore(*known, distro.value, str(workspace.root))
    elif memory is not None and not folders:  # what the user's own models say, nobody remembers
        keeper = InMemory(memory)
    return Compiled(workspace, distro, net=budget.net, keeper=keeper)


def _summaries(known: _Store, workspace: Workspace) -> Summaries:
    """What a store knows of the files."""
    from rosward.analysis.summaries import Summaries

    return Summaries(*known, str(workspace.root))


def silent(_what: str, _done: int, _all: int) -> None:
    """No progress is shown."""
