# SPDX-License-Identifier: Apache-2.0
"""Which nodes do launched systems make?

    Request(launches=(LaunchRequest("robot.launch.py", "bringup"),))
    ->  the nodes of every process that the launch file starts, each with the command line that it gets

The same program, started in the same way, is interpreted once, and is in the result once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final, final

from rosward.analysis.attempts import how_started
from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.outcome import Outcome, Task
from rosward.analysis.outcome import Outset as ProcessOutset
from rosward.analysis.plan import Plan
from rosward.analysis.read import EVERYTHING, Progress, SourcePath, SourcesRead, read_sources
from rosward.analysis.runner import Runner
from rosward.analysis.seen import note_variables
from rosward.analysis.source_tree import SourceTree
from rosward.analysis.standalone import Gathered
from rosward.analysis.systems import Outset, System, systems_of
from rosward.analysis.unreached import unreached_of
from rosward.deployment.alike import renumbered
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
from rosward.location import Place
from rosward.naming.collect import Process, collect
from rosward.naming.command_line import read_words
from rosward.naming.doubts import unknown_arguments
from rosward.network.launch_tree import LaunchSystem
from rosward.records import NamedTuple
from rosward.ros.distro import DEFAULT_DISTRO, Distro
from rosward.ros.entities import Interface, Node
from rosward.rules import INTERNAL_ERROR
from rosward.source.exclude import Exclusion
from rosward.source.workspace import Workspace

if TYPE_CHECKING:
    from rosward.cache.store import Store

__all__ = ["Deployed", "launched", "of_request"]


_MISSING: Final = "what this program creates is missing"


class Deployed(NamedTuple):
    """The nodes of the systems that a request starts, and what the launch files say of them."""

    gathered: Gathered
    systems: tuple[LaunchSystem, ...]


def of_request(
    request: Request, read: SourcesRead, progress: Progress, *, jobs: int = 1, store: Store | None = None
) -> Deployed:
    """Start all that is asked for. Raises UnknownRequestError where it is not there. See `standalone.of_sources` for `jobs` and `store`."""
    outset = Outset.of(read)
    systems, findings, asked = systems_of(request, outset)
    started = _start(systems, outset)
    with Runner(read, ProcessOutset(read.library, read.budget, None, read.distro), jobs, store) as runner:
        tasks = started.tasks
        found = runner.all(tasks, lambda done: progress("analysing", done, len(tasks)))
    nodes, doubts = _of_systems(systems, read.sources, outset, started, found, runner.lost, asked)
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


class _All(NamedTuple):
    """What becomes of each program of each system, and what of it is to be interpreted."""

    programs: list[list[_Started | Finding]]
    tasks: list[Task]


def _start(systems: Iterable[System], outset: Outset) -> _All:
    tasks, net = _Tasks(outset), outset.budget.net
    programs = [
        [guarded(partial(tasks.of, p), p.started.place, _MISSING, net=net) for p in system.programs]
        for system in systems
    ]
    return _All(programs, tasks.all())


def _of_systems(
    systems: Iterable[System],
    sources: SourceTree,
    outset: Outset,
    every: _All,
    outcomes: Sequence[Outcome],
    lost: Collection[str],
    asked: Variables,
) -> Gathered:
    """The nodes of launched systems, `asked` what their programs ask for. What several systems start in the same way is in the result once."""
    by_task = {id(task): outcome for task, outcome in zip(every.tasks, outcomes, strict=True)}
    findings = Findings()
    known = _Processes()
    nodes: list[Node] = []
    packages: set[str] = set()
    for system, of_system in zip(systems, every.programs, strict=True):
        processes: dict[str, list[Node]] = {}
        for program, started in zip(system.programs, of_system, strict=True):
            found = (
                started
                if isinstance(started, Finding)
                else guarded(
                    partial(_made, started, outset, by_task), program.started.place, _MISSING, net=outset.budget.net
                )
            )
            made = _Made((), (found,)) if isinstance(found, Finding) else found
            findings.update(made.findings)
            processes.setdefault(program.process, []).extend(made.nodes)
            packages.add(program.package or "")
        for own in system.own:
            processes.setdefault(own.process, []).append(own)
        for label, members in processes.items():
            nodes += known.distinct(label, members)
    findings.update(_of_packages(sources, outset.workspace, packages))
    seen = [each.seen for each in outcomes]
    for one in seen:
        note_variables(one, asked)
    entered = {code for one in seen for code in one.entered}
    read = [
        m
        for f in sorted(outset.related.difference(lost))
        if (m := sources.module(f)) is not None and m.code.key in entered
    ]
    missing = "unreachable code is not reported"
    told = guarded(
        lambda: unreached_of(seen, read, outset.library.facts, sources, everywhere=False),
        Place("", 0),
        missing,
        net=outset.budget.net,
    )
    findings.update((told,) if isinstance(told, Finding) else told)
    return Gathered(nodes, list(findings))


@final
class _Processes:
    """The processes of all systems so far."""

    def __init__(self) -> None:
        self._counts: Counter[str] = Counter()
        self._known: dict[tuple[str, ...], list[tuple[Node, ...]]] = {}
        """By label and names of nodes: of those of one label, few have the same names, and these alone are compared as a whole."""

    def distinct(self, label: str, members: list[Node]) -> list[Node]:
        """The nodes of a process, unless another system has the same process; under a label of its own."""
        stem = label.partition("#")[0]
        bare = tuple(replace(n, process="", launched_by=None) for n in members)
        alike = self._known.setdefault((stem, *(n.fqn for n in members)), [])
        if label == stem and bare in alike:
            return []
        if label != stem and alike.count(bare) >= int(label.rpartition("#")[2]):
            return []
        alike.append(bare)
        self._counts[stem] += 1
        name = stem if self._counts[stem] == 1 else f"{stem}#{self._counts[stem]}"
        return [replace(n, process=name) for n in members]


class _Started(NamedTuple):
    """One program as it is started: the process that is run for it, or what is declared of it, and the classes of the sources that it loads."""

    program: Launched
    task: Task | None
    log: EffectLog | None
    loaded: tuple[_Started, ...]


@final
class _Tasks:
    """The programs that are run: one that is started twice in the same way is interpreted once."""

    def __init__(self, outset: Outset) -> None:
        self._outset = outset
        self._tasks: dict[object, Task] = {}

    def all(self) -> list[Task]:
        """What is to be interpreted."""
        return list(self._tasks.values())

    def of(self, program: Launched) -> _Started:
        """What becomes of a program, before anything is interpreted."""
        outset = self._outset
        if program.entry is not None:
            return _Started(program, self._task(program.entry, program.configuration), None, ())
        if program.program is None:
            return _Started(program, None, undeclared(program), ())
        loaded: list[Launched] = []

        def take(node: PluginNode) -> bool:
            entry = outset.plugin(node.plugin)
            if entry is not None:
                own = replace(program.configuration, component=node.words)
                conditional = program.conditional or not node.certain
                loaded.append(program._replace(entry=entry, program=None, configuration=own, conditional=conditional))
            return entry is not None

        log = declared(
            program.program,
            program.configuration,
            program.started.place,
            outset.declarations,
            outset.distro,
            outset.text_at,
            take,
        )
        return _Started(program, None, log, tuple(map(self.of, loaded)))

    def _task(self, entry: Entry, configuration: Configuration) -> Task:
        configuration = renumbered(configuration)
        key = (entry, *how_started(configuration))
        return self._tasks.setdefault(key, Task(entry, configuration))


def _made(started: _Started, outset: Outset, outcomes: Mapping[int, Outcome]) -> _Made:
    """The nodes of a program and its findings; with those of classes of the sources that it loads, though it is declared."""
    if started.task is not None:
        outcome = outcomes[id(started.task)]
        own = _told(started.program, _made_by(started.program, outcome), outcome.findings)
    else:
        assert started.log is not None
        # what is doubtful of a name is about its node alone, though a declared one stands at the place of its start, too
        own = _told(started.program, _declared(started.program, started.log, outset), started.log.findings)
    made = [own, *(_made(each, outset, outcomes) for each in started.loaded)]
    return _Made(tuple(n for m in made for n in m.nodes), tuple(f for m in made for f in m.findings))


def _made_by(program: Launched, outcome: Outcome) -> _Made:
    """What a process adds, as the process that is started: another one may be interpreted in the same way."""
    place = program.started.place
    by = place if place.file else None
    nodes = tuple(
        replace(
            node,
            package=program.package,
            executable=program.executable,
            process=program.process,
            launched_by=by,
            conditional=node.conditional or program.conditional,
            entities=tuple(replace(e, conditional=True) for e in node.entities)
            if program.conditional
            else node.entities,
        )
        for node in outcome.nodes
    )
    return _Made(nodes, outcome.findings)


def _declared(program: Launched, log: EffectLog, outset: Outset) -> _Made:
    done = frozenset[tuple[object, ...]]()
    for index, end in enumerate(log.ends):
        done = end if index == 0 else done & end
    place = program.started.place if program.started.place.file else None
    process = Process(
        *(program.package, program.executable, program.process, done, place, program.conditional),
        shell=outset.library.environment,
        interface=_interface(program),
        lacks=(program.unknown,) if program.unknown is not None else (),
    )
    nodes, doubts = collect(log, process, outset.distro)
    return _Made(tuple(nodes), (*log.findings, *doubts))


def _told(program: Launched, made: _Made, found: Iterable[Finding]) -> _Made:
    """With what is doubtful of its start, which is about each of its nodes."""
    started = program.started
    line = read_words(Series(program.configuration.own), program.configuration)
    told = [
        Finding("RW320", f"rcl rejects the command line of {program.process}: {error}", started.place)
        for error in line.errors
    ]
    doubtful = tuple(dict.fromkeys((*line.open, *line.holes)))
    if doubtful:
        told.append(unknown_arguments(doubtful, started.place))
    own = (*told, *started.told, *(f for f in found if f.place == started.place))
    about = tuple(node.fqn for node in made.nodes)
    return _Made(made.nodes, (*made.findings, *(f._replace(nodes=about) for f in own)))


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
