# SPDX-License-Identifier: Apache-2.0
"""What does the user ask to be started, and which programs are that?

    Request(launches=(LaunchRequest('robot.launch.py', 'bringup'),))
    ->  System('bringup:robot.launch.py', 'bringup/launch/robot.launch.py', started=(…), programs=(…))

Each launch file is executed by itself (never for real); `--node` and `--params` add to all of what they start.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from difflib import get_close_matches
from functools import partial
from pathlib import Path
from typing import Final

from rosward.analysis.cases import Executed, in_each_case
from rosward.analysis.read import SourcesRead
from rosward.deployment.declared.declarations import Declarations
from rosward.deployment.execution.execution import Execution
from rosward.deployment.files import WorkspaceFiles
from rosward.deployment.given import parameter_files
from rosward.deployment.launched import Launched
from rosward.deployment.named_files import NamedFiles
from rosward.deployment.python.code import LaunchPython
from rosward.deployment.request import LaunchRequest, NodeRequest, Request, UnknownRequestError
from rosward.deployment.resolve import Programs
from rosward.deployment.shown import entry
from rosward.deployment.started import Started, StartKind
from rosward.domain.values import Const, Value
from rosward.effects.configuration import Configuration
from rosward.effects.entry import Entry
from rosward.effects.log import EffectLog
from rosward.effects.shell import Shell
from rosward.effects.variables import Variables
from rosward.engine.budget import Budget
from rosward.engine.libraries.library import Library
from rosward.findings import Finding, Findings
from rosward.guard import Steps, guarded
from rosward.location import Place
from rosward.models.file_paths import Location, path_of
from rosward.naming.collect import Process, collect
from rosward.network.launch_tree import LaunchEntry, LaunchSystem
from rosward.records import NamedTuple
from rosward.ros.distro import Distro
from rosward.ros.entities import Node
from rosward.rules import UNREAD_ARGUMENT
from rosward.source.workspace import SourceFile, Workspace


class System(NamedTuple):
    """What one launch file starts, or the nodes that the user named: records of launch, and the program behind each.

    `elsewhere`: those of its components that a container of another system loads, whose programs they are. `own`: the nodes that the launch
    file makes itself, in the process of launch.
    """

    name: str
    file: str
    started: tuple[Started, ...]
    programs: tuple[Launched, ...]
    elsewhere: tuple[Launched, ...] = ()
    own: tuple[Node, ...] = ()

    def tree(self, steps: Steps) -> LaunchSystem:
        """In plain words."""
        behind = {id(p.started): p for p in (*self.programs, *self.elsewhere)}
        entries: list[LaunchEntry | None] = [
            steps(partial(entry, s, behind.get(id(s))), None, "the launch tree omits this", s.place)
            for s in self.started
        ]
        return LaunchSystem(self.name, self.file, tuple(e for e in entries if e is not None))


class Outset(NamedTuple):
    """What everything that is started is looked up in."""

    workspace: Workspace
    library: Library
    files: WorkspaceFiles
    declarations: Declarations
    related: frozenset[str]
    linked: tuple[Entry, ...]
    distro: Distro
    budget: Budget
    plugin: Callable[[str], Entry | None]
    """How a class starts that is loaded by its name; None where the sources do not have it."""

    @classmethod
    def of(cls, read: SourcesRead) -> Outset:
        """That of sources which were read."""
        files, declarations = (
            WorkspaceFiles(read.sources.files),
            Declarations(read.models, net=read.budget.net, documents=read.sources.documents),
        )
        plan = read.plan
        return cls(
            read.workspace,
            read.library,
            files,
            declarations,
            plan.related,
            plan.programs,
            read.distro,
            read.budget,
            read.sources.plugin,
        )

    def text_at(self, path: Value) -> str | None:
        """The text of the file at a path; None where it is not among the sources."""
        file = self.files.find(path)
        return None if file is None else self.files.text(file)


class SystemsRead(NamedTuple):
    """The systems of a request, what is doubtful about them, and the environment variables that they ask for and nobody gave."""

    systems: list[System]
    findings: list[Finding]
    asked: Variables


def systems_of(request: Request, outset: Outset) -> SystemsRead:
    """The systems of a request. Raises UnknownRequestError where a launch file or executable is not there."""
    findings = Findings()
    net = outset.budget.net
    extra = parameter_files(request.params, outset.workspace.root, findings, net=net)
    found: list[System] = []
    made: list[Programs] = []
    unread: dict[str, list[str]] = {}
    known: set[str] = set()
    asked = Variables()
    for launch, file in _launch_files(request, outset):
        arguments = {**dict(request.arguments), **dict(launch.arguments)}
        missing = "what this launch file starts is missing"
        variables = Variables()
        ran = guarded(partial(_execute, file, arguments, outset, variables), Place(file), missing, net=net)
        if isinstance(ran, Finding):
            ran = Executed((), (ran,), ())
        asked.add(variables)
        known |= ran.known
        findings.update(ran.findings)
        for name in ran.unread:
            unread.setdefault(name, []).append(file)
        started = [_with_files(s, extra) for s in ran.started]
        made.append(_programs(outset))
        make = partial(_system, str(launch), file, started, made[-1])
        system = guarded(make, Place(file), "the programs that it starts are unknown", net=net)
        if isinstance(system, Finding):
            findings.add(system)
            system = System(str(launch), file, tuple(started), ())
        found.append(system._replace(own=ran.nodes))
    own = {name for launch in request.launches for name, _ in launch.arguments}
    for name, files in unread.items():
        if name in own or len(files) == len(found):  # what is given to all files is for those that know it
            near = get_close_matches(name, sorted(known), n=1)
            hint = f" Did you mean '{near[0]}'?" if near else ""
            message = f"No launch file declares or reads the launch argument '{name}'.{hint}"
            findings.update(Finding(UNREAD_ARGUMENT, message, Place(file)) for file in files)
    if request.nodes:
        named = [_with_files(_node(n), extra) for n in request.nodes]
        title = ", ".join(f"{n.package}/{n.executable}" for n in request.nodes)
        made.append(_programs(outset))
        found.append(_system(title, "", named, made[-1]))
        _check_nodes(found[-1])
    found = _with_components(found, made, together=not request.all_launch)
    findings.update(f for programs in made for f in programs.findings)
    findings.update(outset.declarations.findings)
    findings.update(outset.library.findings)
    return SystemsRead(found, list(findings), asked)


def _launch_files(request: Request, outset: Outset) -> list[tuple[LaunchRequest, str]]:
    if request.all_launch:
        known = sorted(f.relative for f in outset.workspace.launch_files)
        return [(LaunchRequest(file), file) for file in known if not _is_for_ros_1(file, outset)]
    return [(launch, _find(launch, outset)) for launch in request.launches]


_SHOWN: Final = 5
_ROS_1: Final = re.compile(r"<node\b[^<>]*\stype\s*=")
_ROS_2: Final = re.compile(r"<node\b[^<>]*\sexec\s*=")


def _is_for_ros_1(file: str, outset: Outset) -> bool:
    """Whether an XML launch file speaks the language of roslaunch, of which ROS 2 refuses every node."""
    text = outset.files.text(file) if not file.endswith(".py") else None
    return text is not None and _ROS_1.search(text) is not None and _ROS_2.search(text) is None


def _find(launch: LaunchRequest, outset: Outset) -> str:
    """The launch file that is meant: by package and name as `ros2 launch` finds it, by path from here or from the root of the analysis."""
    files = (*outset.workspace.launch_files, *outset.workspace.files)
    if launch.package is not None:
        return _find_in_package(launch.package, launch.file, files, outset)
    path = Path(launch.file).absolute()
    for each in files:
        if each.path.absolute() == path or each.relative == launch.file:
            return each.relative
    named = [f.relative for f in files if f.relative.endswith(f"/{launch.file}")]
    if not named:
        raise UnknownRequestError(f"no launch file {launch.file}; {_there_is(outset)}")
    return _only(named, launch.file)


def _find_in_package(package: str, name: str, files: Iterable[SourceFile], outset: Outset) -> str:
    """The launch file of a package, which may be of an underlay: what is installed counts first, as for `ros2 launch`."""
    for folder in ("launch/", ""):
        installed = outset.files.find(path_of(Location(package, f"{folder}{name}")))
        if installed is not None:
            return installed
    own = [f for f in files if f.package is not None and f.package.name == package and f.path.name == Path(name).name]
    named = [f.relative for f in own if f.relative.endswith(f"/{name}")] or [f.relative for f in own]
    if not named:
        known = any(each.name == package for each in outset.workspace.packages)
        if not known and outset.files.find(path_of(Location(package, "package.xml"))) is None:
            raise UnknownRequestError(f"no package {package} in the sources or underlays; {_there_is(outset)}")
        raise UnknownRequestError(f"the package {package} has no launch file {name}; {_there_is(outset)}")
    return _only(named, f"{name} in the package {package}")


def _there_is(outset: Outset) -> str:
    """The launch files that could be meant, so that a refusal shows what to write instead."""
    known = sorted(each.relative for each in outset.workspace.launch_files)
    if not known:
        return "the sources contain no launch file"
    more = f" and {len(known) - _SHOWN} more (`rosward launch-tree` lists them)" if len(known) > _SHOWN else ""
    return f"the sources contain {', '.join(known[:_SHOWN])}{more}"


def _only(named: Sequence[str], what: str) -> str:
    if len(named) > 1:
        raise UnknownRequestError(f"several launch files are named {what}: {', '.join(named)}")
    return named[0]


def _execute(file: str, arguments: dict[str, str], outset: Outset, asked: Variables) -> Executed:
    given = {n: Const(v) for n, v in arguments.items()}
    path = outset.files.place_value(file)

    def execute(shell: Shell, variables: Variables) -> Executed:
        python = LaunchPython(outset.library, outset.budget, variables)
        execution = Execution(
            NamedFiles(outset.files, variables),
            python,
            outset.distro,
            given,
            environment=shell,
            variables=variables,
            net=outset.budget.net,
        )
        started = execution.run(file, path)
        nodes, doubts = _own_nodes(file, python.log, outset)
        return Executed(started, (*execution.findings, *doubts), execution.unread, execution.known, nodes)

    return in_each_case(execute, outset.library.environment, asked)


def _own_nodes(file: str, log: EffectLog, outset: Outset) -> tuple[tuple[Node, ...], list[Finding]]:
    """The nodes that launch files make themselves. How long they live nobody knows: often only while launch waits for something."""
    if not log.nodes:
        return (), []
    owner = next((f.package for f in outset.workspace.launch_files if f.relative == file), None)
    process = Process(
        owner.name if owner is not None else None, None, f"ros2 launch {file}", frozenset(), conditional=True
    )
    nodes, doubts = collect(log, process, outset.distro)
    return tuple(nodes), doubts


def _programs(outset: Outset) -> Programs:
    workspace = outset.workspace
    return Programs(
        workspace.executables,
        workspace.targets,
        outset.declarations,
        outset.related,
        outset.files,
        outset.linked,
    )


def _system(name: str, file: str, started: Sequence[Started], programs: Programs) -> System:
    return System(name, file, tuple(started), tuple(programs.resolve(started)))


def _with_components(systems: Sequence[System], made: Sequence[Programs], *, together: bool) -> list[System]:
    """The systems with the components whose container none of their own starts: that of a system which runs beside loads them, or nobody."""
    found = list(systems)
    for index, programs in enumerate(made):
        alone: list[Started] = []
        for component in programs.orphans:
            adopted = {n: p for n, other in enumerate(made) if together and (p := other.adopt(component))}
            for n, loaded in adopted.items():
                found[n] = found[n]._replace(programs=(*found[n].programs, *loaded))
                found[index] = found[index]._replace(elsewhere=(*found[index].elsewhere, *loaded))
            alone += [] if adopted else [component]
        if alone:
            found[index] = found[index]._replace(programs=(*found[index].programs, *programs.alone(alone)))
    return found


def _node(request: NodeRequest) -> Started:
    words: tuple[Value, ...] = ()
    if request.name is not None:
        words = (Const("--ros-args"), Const("-r"), Const(f"__node:={request.name}"))
    return Started(
        kind=StartKind.NODE,
        place=Place(""),
        configuration=Configuration(words),
        package=Const(request.package),
        executable=Const(request.executable),
        name=Const(request.name) if request.name else None,
    )


def _check_nodes(system: System) -> None:
    missing = [f"{p.package}/{p.executable} ({p.unknown})" for p in system.programs if p.unknown is not None]
    if missing:
        raise UnknownRequestError(f"no such executable: {', '.join(missing)}")


def _with_files(started: Started, extra: Configuration) -> Started:
    """The same start with further parameter files behind its own."""
    if not extra.words:
        return started
    own = started.configuration
    mark = () if any(isinstance(w, Const) and w.value == "--ros-args" for w in own.words) else (Const("--ros-args"),)
    return replace(
        started,
        configuration=replace(own, words=(*own.words, *mark, *extra.words), files={**own.files, **extra.files}),
    )
