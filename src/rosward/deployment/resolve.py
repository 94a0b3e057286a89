# SPDX-License-Identifier: Apache-2.0
"""Which program is behind what a launch file starts?

    Started(package='demo', executable='talker')         the console script of the workspace: interpreted
    Started(package='rviz2', executable='rviz2')         a declared interface
    Started(package='acme', executable='driver')         a node of unknown interface (RW314)
    Started(command=('python3', 'scripts/x.py'))         the script of the workspace: interpreted

A component belongs to the process of its container.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Final, Protocol, final

from rosward.deployment.containers import Containers, is_container, label_of, loaded, target_of
from rosward.deployment.launched import Launched
from rosward.deployment.started import Started, StartKind
from rosward.domain.choice import options, reasons_of
from rosward.domain.text import readable
from rosward.domain.values import Const, Value
from rosward.effects.entry import Entry
from rosward.findings import Finding, Findings
from rosward.source.workspace import Executable, ExecutableKind

if TYPE_CHECKING:
    from rosward.deployment.declared.shapes import Program
    from rosward.source.workspace import Target


class DeclaredInterfaces(Protocol):
    """The declared interfaces, as this module asks for them (`deployment/declared/effects.py`)."""

    def executable(self, package: str, name: str) -> Program | None:
        """The declaration of an executable."""

    def component(self, package: str, plugin: str) -> Program | None:
        """The declaration of a component."""


class FileOf(Protocol):
    """Where files and packages are, as this module asks for them (`deployment/files.py`)."""

    def find(self, path: Value) -> str | None:
        """The file behind a path."""

    def has_package(self, package: str) -> bool:
        """Whether a package is among the sources."""


_INERT: Final = frozenset(
    {
        "echo",
        "sleep",
        "mkdir",
        "rm",
        "cp",
        "mv",
        "chmod",
        "cat",
        "touch",
        "true",
        "false",
        "test",
        "printf",
        "ls",
        "killall",
        "pkill",
        "kill",
        *("awk", "cut", "date", "grep", "head", "hostname", "sed", "sort", "tail", "tee", "which"),
    }
)


@final
class Programs:
    """Every program that a launch file can start: of the workspace, and declared."""

    def __init__(
        self,
        executables: Iterable[Executable],
        targets: Iterable[Target],
        declared: DeclaredInterfaces,
        related: frozenset[str],
        file_of: FileOf,
        linked: Iterable[Entry] = (),
    ) -> None:
        self._executables: dict[tuple[str, str], Executable] = {}
        for executable in executables:
            self._executables.setdefault((executable.package.name, executable.name), executable)
        self._targets = {(t.package.name, t.name): t for t in targets}
        self._plugins = {(t.package.name, t.plugin): t for t in targets if t.plugin}
        self._linked = {(e.package, e.executable or e.classes[0]): e for e in linked if e.executable or e.classes}
        self._declared = declared
        self._related = related
        self._file_of = file_of
        self.findings = Findings()
        self.orphans: tuple[Started, ...] = ()
        self._labels: dict[str, int] = {}
        self._containers = Containers(())

    def resolve(self, started: Sequence[Started]) -> list[Launched]:
        """The programs of one system, in the order in which they are started, each process with a label of its own.

        Components whose container is none of them are `orphans`: it may be in another system.
        """
        components = [s for s in started if s.kind is StartKind.COMPONENT]
        found: list[Launched] = []
        for each in started:
            if each.kind is not StartKind.COMPONENT:
                found += (p._replace(process=_numbered(p.process, self._labels)) for p in self._of(each))
        self._containers = Containers(found)
        self.orphans = tuple(c for c in components if not self._containers.of(c))
        return [*found, *(p for c in components for p in self.adopt(c))]

    def adopt(self, component: Started) -> list[Launched]:
        """The component in each process of this system that loads it."""
        return [
            loaded(program, container, conditional=open_)
            for program in self._of(component)
            for container, open_ in self._containers.of(component)
        ]

    def alone(self, components: Iterable[Started]) -> list[Launched]:
        """Components whose container nothing starts: one process for each container, as if somebody did."""
        wanted: dict[str, list[Started]] = {}
        for each in components:
            wanted.setdefault(target_of(each), []).append(each)
        for target, members in wanted.items():
            first = f"component {_readable(members[0].plugin)}"
            several = f"{first} and {len(members) - 1} more are loaded" if len(members) > 1 else f"{first} is loaded"
            message = f"{several} into {target}, which nothing starts"
            self.findings.add(Finding("RW318", message, members[0].place, (f"container {target}",)))
        return [p._replace(process=label_of(t)) for t, members in wanted.items() for c in members for p in self._of(c)]

    def _of(self, each: Started) -> Iterator[Launched]:
        """The programs that may be meant by what is started."""
        for package, executable, conditional in _alternatives(each):
            launched = self._one(each, package, executable, conditional)
            if launched is not None:
                yield launched

    def _one(self, each: Started, package: str | None, executable: str | None, conditional: bool) -> Launched | None:
        made = Launched("", package, executable, each, each.configuration, conditional or each.conditional)
        if each.kind is StartKind.COMPONENT:
            return self._component(made)
        if package is None:
            return self._command(made)
        if executable is None:
            return self._nameless(made)
        made = made._replace(process=f"{package}/{executable}")
        known = self._executables.get((package, executable))
        if known is not None and known.file is not None:
            return made._replace(entry=entry_of(known))
        linked = self._linked.get((package, executable))
        program = self._declared.executable(package, executable)
        if linked is not None and not (program is not None and is_container(program)):
            return made._replace(entry=linked)
        if program is not None:
            return made._replace(program=program)
        return made._replace(unknown=self._why(package, executable, known), cause=self._cause(package, executable))

    def _cause(self, package: str, executable: str) -> str:
        """What is missing for all that start it: the package, or the interface of the one program."""
        return f"interface of {package}/{executable}" if self._file_of.has_package(package) else f"package {package}"

    def _why(self, package: str, executable: str, known: Executable | None) -> str:
        if known is not None:
            return "its source file is not among the sources"
        if (package, executable) in self._targets:
            return "it is written in C++, and its sources are not among those that are read"
        if self._file_of.has_package(package):
            return f"the package {package} has no such executable among the sources"
        return f"the package {package} is neither among the sources nor declared"

    def _component(self, made: Launched) -> Launched:
        plugin = _readable(made.started.plugin)
        made = made._replace(process=f"{made.package or 'unknown'}/{plugin}", executable=plugin)
        linked = self._linked.get((made.package, plugin))
        if linked is not None:
            return made._replace(entry=linked)
        program = self._declared.component(made.package or "", plugin)
        if program is not None:
            return made._replace(program=program)
        if made.package is None:
            return made._replace(unknown=f"its package is unknown{_because(made.started.package)}")
        inside = self._file_of.has_package(made.package)
        why = (
            "it is written in C++, and its sources are not among those that are read"
            if inside
            else f"the package {made.package} is neither among the sources nor declared"
        )
        return made._replace(unknown=why, cause=self._cause(made.package, plugin))

    def _nameless(self, made: Launched) -> Launched:
        value = made.started.executable
        return made._replace(
            process=f"{made.package}/{_readable(value)}", unknown=f"its executable is unknown{_because(value)}"
        )

    def _command(self, made: Launched) -> Launched | None:
        """A process that is no node of a package: a script of the workspace, or something of its own."""
        words = made.started.command
        for word in (made.started.executable, *words[:3]):
            file = self._file_of.find(word) if word is not None else None
            if file is not None and file in self._related:
                stem = file.rpartition("/")[2].removesuffix(".py")
                entry = Entry(file, "__main__", "", (), None, None, file)
                return made._replace(process=file, executable=stem, entry=entry)
        if made.started.kind is not StartKind.PROCESS:
            shown = _readable(made.started.executable)
            if made.started.package is not None:
                return made._replace(process=shown, unknown=f"its package is unknown{_because(made.started.package)}")
            return made._replace(
                process=shown, unknown="it names no package, and its path leads to no file of the sources"
            )
        shown = " ".join(readable(w) for w in words)
        program = shown.split()[0].rpartition("/")[2] if shown.split() else ""
        if program not in _INERT:
            self.findings.add(
                Finding("RW319", f"`{shown[:200]}` is started, and its interface is unknown", made.started.place)
            )
        return None


def entry_of(executable: Executable) -> Entry:
    """How an executable of the workspace starts; its file is known."""
    package, label = executable.package.name, f"{executable.package.name}/{executable.name}"
    file = executable.file.relative if executable.file is not None else ""
    if executable.kind is ExecutableKind.CONSOLE_SCRIPT:
        return Entry(file, executable.module or "", executable.function or "main", (), package, executable.name, label)
    return Entry(file, "__main__", "", (), package, executable.name, label)


def _alternatives(each: Started) -> list[tuple[str | None, str | None, bool]]:
    """The package and executable that may be meant: several, each conditional, where that is not decided."""
    packages = _texts(each.package)
    executables = _texts(each.executable)
    several = len(packages) * len(executables) > 1
    return [(p, e, several) for p in packages for e in executables]


def _texts(value: Value | None) -> list[str | None]:
    found = (
        [o.value if isinstance(o, Const) and isinstance(o.value, str) else None for o in options(value)]
        if value is not None
        else [None]
    )
    return list(dict.fromkeys(found))


def _because(value: Value | None) -> str:
    """Why a value is not known, behind what says that it is not."""
    reasons = "; ".join(map(str, reasons_of(value))) if value is not None else ""
    return f": {reasons}" if reasons else ""


def _readable(value: Value | None) -> str:
    return readable(value) if value is not None else "unknown"


def _numbered(label: str, labels: dict[str, int]) -> str:
    count = labels[label] = labels.get(label, 0) + 1
    return label if count == 1 else f"{label}#{count}"
