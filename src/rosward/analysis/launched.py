# SPDX-License-Identifier: Apache-2.0
"""Which nodes do launched systems make?

    Request(launches=(LaunchRequest("robot.launch.py", "bringup"),))
    ->  the nodes of every process that the launch file starts, each with the command line that it gets

The same program, started in the same way, is interpreted once, and is in the result once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.plan import Plan
from rosward.analysis.process import Run, run
from rosward.analysis.read import EVERYTHING, Progress, SourcePath, SourcesRead, read_sources
from rosward.analysis.seen import note_variables, seen_of
from rosward.analysis.source_tree import SourceTree
from rosward.analysis.standalone import Gathered
from rosward.analysis.systems import Outset, System, systems_of
from rosward.analysis.unreached import unreached_of
from rosward.deployment.alike import renumbered, what_it_sees
from rosward.deployment.declared.effects import declared
from rosward.deployment.declared.shapes import PluginNode
from rosward.deployment.launched import Launched
from rosward.deployment.request import Request
from rosward.deployment.undeclared import undeclared
from rosward.domain.series import Series
from rosward.effects.configuration import Configuration
from rosward.effects.entry import Entry
from rosward.effects.log import EffectLog
from rosward.effects.variables import Variables, not_given
from rosward.engine.budget import Budget
from rosward.findings import Finding, Findings
from rosward.guard import Steps, guarded
from rosward.naming.collect import Process, collect
from rosward.naming.command_line import read_words
from rosward.naming.doubts import unknown_arguments
from rosward.network.launch_tree import LaunchSystem
from rosward.records import NamedTuple
from rosward.ros.distro import DEFAULT_DISTRO, Distro
from rosward.ros.entities import Interface, Node
from rosward.rules import INTERNAL_ERROR
from rosward.source.exclude import Exclusion
from rosward.source.location import Place
from rosward.source.workspace import Workspace

__all__ = ["Deployed", "launched", "of_request"]


class Deployed(NamedTuple):
    """The nodes of the systems that a request starts, and what the launch files say of them."""

    gathered: Gathered
    systems: tuple[LaunchSystem, ...]


def of_request(request: Request, read: SourcesRead, progress: Progress) -> Deployed:
    """Start all that is asked for. Raises UnknownRequestError where it is not there."""
    outset = Outset.of(read)
    systems, findings, asked = systems_of(request, outset)
    nodes, doubts = _of_systems(systems, read.sources, outset, progress, asked)
    findings += not_given(asked)
    doubts += _never_launched(systems, read.plan) if request.all_launch else []
    steps = Steps(net=read.budget.net)
    trees = tuple(s.tree(steps) for s in systems)
    return Deployed(Gathered(nodes, [*findings, *doubts, *steps.findings]), trees)


def launched(
    *paths: SourcePath,
    distro: str = DEFAULT_DISTRO,
    models: Sequence[SourcePath] = (),
    tests: bool = False,
    exclude: Sequence[str | Exclusion] = (),
    follow_links: bool = False,
    request: Request = EVERYTHING,
    env: Mapping[str, str] | None = None,
    underlays: Sequence[SourcePath] = (),
    budget: Budget | None = None,
) -> tuple[tuple[LaunchSystem, ...], tuple[Finding, ...]]:
    """What the launch files of a request start, without a look into the programs. See `pipeline.extract` for the arguments."""

    def work() -> tuple[tuple[LaunchSystem, ...], tuple[Finding, ...]]:
        chosen = Distro(distro)
        read = read_sources(
            paths,
            chosen,
            models,
            underlays,
            budget,
            None,
            request,
            environment=env,
            tests=tests,
            exclude=exclude,
            follow_links=follow_links,
        )
        steps = Steps(net=read.budget.net)
        systems, findings, asked = systems_of(request, Outset.of(read))
        trees = tuple(s.tree(steps) for s in systems)
        every = {
            *findings,
            *not_given(asked),
            *steps.findings,
            *(f for f in read.plan.findings if f.code == INTERNAL_ERROR),
        }
        return trees, tuple(sorted(every, key=lambda f: (f.place, f.code, f.message)))

    return with_deep_stack(work)


class _Made(NamedTuple):
    """What the programs of one process make."""

    nodes: tuple[Node, ...]
    findings: tuple[Finding, ...]


def _of_systems(
    systems: Iterable[System], sources: SourceTree, outset: Outset, progress: Progress, asked: Variables
) -> Gathered:
    """The nodes of launched systems, `asked` what their programs ask for. What several systems start in the same way is in the result once."""
    runs = _Runs(outset)
    findings = Findings()
    known: dict[str, list[tuple[Node, ...]]] = {}
    nodes: list[Node] = []
    programs = [p for s in systems for p in s.programs]
    packages: set[str] = set()
    number = 0
    for system in systems:
        processes: dict[str, list[Node]] = {}
        for program in system.programs:
            progress("analysing", number, len(programs))
            number += 1
            missing = "what this program creates is missing"
            found = guarded(partial(runs.of, program), program.started.place, missing, net=outset.budget.net)
            made = _Made((), (found,)) if isinstance(found, Finding) else found
            findings.update(made.findings)
            processes.setdefault(program.process, []).extend(made.nodes)
            packages.add(program.package or "")
        for label, members in processes.items():
            nodes += _distinct(label, members, known)
    findings.update(_of_packages(sources, outset.workspace, packages))
    seen = [seen_of(each, outset.library) for each in runs.all()]
    for one in seen:
        note_variables(one, asked)
    entered = {code for one in seen for code in one.entered}
    read = [m for f in sorted(outset.related) if (m := sources.module(f)) is not None and m.code.key in entered]
    missing = "unreachable code is not reported"
    told = guarded(
        lambda: unreached_of(seen, read, outset.library.facts, sources, everywhere=False),
        Place("", 0),
        missing,
        net=outset.budget.net,
    )
    findings.update((told,) if isinstance(told, Finding) else told)
    return Gathered(nodes, list(findings))


def _distinct(label: str, members: list[Node], known: dict[str, list[tuple[Node, ...]]]) -> list[Node]:
    """The nodes of a process, unless another system has the same process; under a label of its own."""
    stem = label.partition("#")[0]
    bare = tuple(replace(n, process="", launched_by=None) for n in members)
    earlier = known.setdefault(stem, [])
    if label == stem and bare in earlier:
        return []
    if label != stem and earlier.count(bare) >= int(label.rpartition("#")[2]):
        return []
    earlier.append(bare)
    name = stem if len(earlier) == 1 else f"{stem}#{len(earlier)}"
    return [replace(n, process=name) for n in members]


class _Runs:
    """The programs that were run: one that is started twice in the same way is interpreted once."""

    def __init__(self, outset: Outset) -> None:
        self._outset = outset
        self._runs: dict[object, Run] = {}

    def all(self) -> list[Run]:
        """What was interpreted."""
        return list(self._runs.values())

    def of(self, program: Launched) -> _Made:
        """The nodes of a program and its findings; with those of classes of the sources that it loads, though it is declared."""
        log, done, loaded = self._log(program)
        made = [self._made(program, log, done), *(self.of(each) for each in loaded)]
        return _Made(tuple(n for m in made for n in m.nodes), tuple(f for m in made for f in m.findings))

    def _made(self, program: Launched, log: EffectLog, done: frozenset[tuple[object, ...]]) -> _Made:
        started = program.started
        place = started.place if started.place.file else None
        process = Process(
            *(program.package, program.executable, program.process, done, place, program.conditional),
            shell=self._outset.library.environment,
            interface=_interface(program),
            lacks=(program.unknown,) if program.unknown is not None else (),
        )
        nodes, doubts = collect(log, process, self._outset.distro)
        line = read_words(Series(program.configuration.own), program.configuration)
        told = [
            Finding("RW320", f"rcl rejects the command line of {program.process}: {error}", started.place)
            for error in line.errors
        ]
        doubtful = tuple(dict.fromkeys((*line.open, *line.holes)))
        if doubtful:
            told.append(unknown_arguments(doubtful, started.place))
        own = (*told, *started.told, *(f for f in log.findings if f.place == started.place))
        about = tuple(node.fqn for node in nodes)
        return _Made(tuple(nodes), (*log.findings, *doubts, *(f._replace(nodes=about) for f in own)))

    def _log(self, program: Launched) -> tuple[EffectLog, frozenset[tuple[object, ...]], list[Launched]]:
        outset = self._outset
        loaded: list[Launched] = []

        def take(node: PluginNode) -> bool:
            entry = outset.plugin(node.plugin)
            if entry is not None:
                own = replace(program.configuration, component=node.words)
                conditional = program.conditional or not node.certain
                loaded.append(program._replace(entry=entry, program=None, configuration=own, conditional=conditional))
            return entry is not None

        if program.entry is not None:
            found = self._run(program.entry, program.configuration)
            return found.log, found.done, loaded
        if program.program is not None:
            log = declared(
                program.program,
                program.configuration,
                program.started.place,
                outset.declarations,
                outset.distro,
                outset.text_at,
                take,
            )
        else:
            log = undeclared(program)
        done = frozenset[tuple[object, ...]]()
        for index, end in enumerate(log.ends):
            done = end if index == 0 else done & end
        return log, done, loaded

    def _run(self, entry: Entry, configuration: Configuration) -> Run:
        configuration = renumbered(configuration)
        keys = [(entry, what_it_sees(configuration, process=process)) for process in (False, True)]
        found = next((self._runs[key] for key in keys if key in self._runs), None)
        if found is None:
            found = run(self._outset.library, entry, self._outset.budget, configuration)
            self._runs[keys[found.log.asked_for_words]] = found
        return found


def _interface(program: Launched) -> Interface:
    if program.unknown is not None:
        return Interface.UNKNOWN
    return Interface.DECLARED if program.program is not None else Interface.ANALYSED


def _of_packages(sources: SourceTree, workspace: Workspace, packages: set[str]) -> list[Finding]:
    """What is wrong with files of these packages, of those that they depend on, and outside of any."""
    depends = {p.name: p.depends for p in workspace.packages}
    wanted: set[str] = set()
    work = [p for p in packages if p in depends]
    while work:
        name = work.pop()
        if name not in wanted:
            wanted.add(name)
            work += [d for d in depends[name] if d in depends]
    owners = {
        f.relative: f.package.name if f.package is not None else "" for f in (*workspace.files, *workspace.cpp_sources)
    }
    return [f for f in sources.findings if owners.get(f.place.file, "") in wanted | {""}]


def _never_launched(systems: Iterable[System], plan: Plan) -> list[Finding]:
    """RW323: the executables of the workspace that have to do with ROS and that no system starts."""
    started = {(p.package, p.executable) for s in systems for p in s.programs}
    return [
        Finding("RW323", f"no launch file starts {e.label}", Place(e.file))
        for e in plan.entries
        if e.executable is not None and (e.package, e.executable) not in started
    ]
