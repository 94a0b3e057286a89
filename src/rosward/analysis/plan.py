# SPDX-License-Identifier: Apache-2.0
"""Which processes a workspace has, and how each starts.

console script  talker = demo.talker:main      demo/talker: imports demo.talker, calls main
file with a __main__ block, installed script    runs the file
file that no other imports, of which nothing else starts    probed: runs the file; counts if it makes a node
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Mapping, Sequence
from typing import Final

from rosward.analysis.makes_nothing import LIBRARIES, makes_nothing
from rosward.analysis.source_tree import SourceTree
from rosward.effects.entry import Entry
from rosward.engine.libraries.library import Library
from rosward.findings import Finding
from rosward.frontends.python.loads import ANY
from rosward.records import NamedTuple
from rosward.ros.entities import assumed_label
from rosward.source.standard_library import STANDARD_LIBRARY
from rosward.source.workspace import ExecutableKind, SourceFile, Workspace

_WITHOUT_NODES: Final = (
    *("attr", "attrs", "beartype", "click", "fastapi", "numpy", "pydantic", "pydantic_settings"),
    *("toml", "tomli", "typeguard", "typing_extensions", "uvicorn", "yaml"),
)
"""Modelled libraries that are not Python's own and know nothing of ROS."""


class Plan(NamedTuple):
    """The processes to interpret, and what is told about those that cannot be."""

    entries: tuple[Entry, ...]
    files: dict[str, SourceFile]
    related: frozenset[str] = frozenset()  # the files whose imports can have to do with ROS
    findings: tuple[Finding, ...] = ()
    programs: tuple[
        Entry, ...
    ] = ()  # what a launch file can start that is linked, whether or not it can have to do with ROS

    def with_programs(self, programs: Sequence[Entry], related: Sequence[Entry]) -> Plan:
        """With the processes of programs that are linked."""
        return self._replace(entries=tuple(_distinct([*self.entries, *related])), programs=tuple(programs))

    def for_file(self, file: str) -> Entry:
        """The process that runs a file that nothing else does."""
        return _entry(self.files.get(file), file, probe=True)

    def for_class(self, file: str, name: str) -> Entry:
        """The process that instantiates a node class that nothing else does. Its label is not that of an executable: there is none."""
        return _entry(self.files.get(file), file, classes=(name,))._replace(
            label=assumed_label(file, name), assumed=True
        )

    def for_framework(self, file: str, name: str, *, alone: bool) -> Entry:
        """The process in which a framework makes a class; named after it where the file has several."""
        entry = _entry(self.files.get(file), file, classes=(name,))
        return entry if alone else entry._replace(label=f"{entry.label}:{name}")


def _entry(source: SourceFile | None, file: str, *, classes: tuple[str, ...] = (), probe: bool = False) -> Entry:
    package = source.package.name if source is not None and source.package is not None else None
    stem = file.rpartition("/")[2].removesuffix(".py")
    label = f"{package}/{stem}" if package else file
    module = (source.module if source is not None else None) or stem
    return Entry(file, module, "", classes, package, None, label, probe)


def make_plan(workspace: Workspace, sources: SourceTree, library: Library) -> Plan:
    """The processes of a workspace, in a fixed order, each with a label of its own."""
    files = {f.relative: f for f in workspace.files}
    importers: dict[str, set[str]] = {}
    started = {e.file.relative for e in workspace.executables if e.file is not None}
    importing, related = _related(files, sources, library, importers, started)
    entries: list[Entry] = []
    covered: dict[str, set[str]] = {}
    for executable in workspace.executables:
        if executable.file is None or executable.file.relative not in related:
            continue
        file = executable.file.relative
        package = executable.package.name
        label = f"{package}/{executable.name}"
        if executable.kind is ExecutableKind.CONSOLE_SCRIPT:
            function = executable.function or "main"
            covered.setdefault(file, set()).add(function)
            entries.append(Entry(file, executable.module or "", function, (), package, executable.name, label))
        else:
            covered.setdefault(file, set()).add("")
            entries.append(Entry(file, "__main__", "", (), package, executable.name, label))
    imported = {file for file, by in importers.items() if by != {file}}
    for file in sorted(related):
        module = sources.module(file)
        if module is None or "" in covered.get(file, ()):
            continue
        if module.has_main:
            calls = sources.main_calls(module)
            if not (calls and calls <= covered.get(file, set())):
                entries.append(_entry(files[file], file))
        elif file not in covered and file not in imported and file in importing:
            entries.append(_entry(files[file], file, probe=True))
    return Plan(tuple(_distinct(entries)), files, frozenset(importing))


def plain_plan(workspace: Workspace) -> Plan:
    """What stands in for a plan that cannot be made: every file is run by itself, and counts where it makes a node."""
    files = {f.relative: f for f in workspace.files}
    entries = [_entry(source, file, probe=True) for file, source in sorted(files.items())]
    return Plan(tuple(_distinct(entries)), files, frozenset(files))


def _distinct(entries: list[Entry]) -> list[Entry]:
    """Entries with labels of their own: the second of one label gets #2, and so on."""
    seen: dict[str, int] = {}
    result: list[Entry] = []
    for entry in entries:
        count = seen[entry.label] = seen.get(entry.label, 0) + 1
        result.append(entry if count == 1 else entry._replace(label=f"{entry.label}#{count}"))
    return result


def _related(
    files: dict[str, SourceFile],
    sources: SourceTree,
    library: Library,
    importers: dict[str, set[str]],
    started: Container[str],
) -> tuple[set[str], set[str]]:
    """The files whose imports lead, directly or through other files, to a modelled ROS library.

    Nothing else can create an entity: a node is made by rclpy only, an entity has a type. A file that cannot be read is not related.
    `importers` gets the files that import each one. A file that loads modules by names that do not stand in it may load any with such a name;
    if the package does not stand there either, any that nothing imports and nothing starts: the files that are related only so, the first of
    the two results is without.
    """
    related: set[str] = set()
    asking: set[str] = set()  # that import what can make nothing
    loaders: dict[str, set[str]] = {}
    for file in files:
        module = sources.module(file)
        if module is None:
            continue
        for name in module.imports:
            if ANY in name:
                loaders.setdefault(_path_pattern(name, file), set()).add(file)
                continue
            top = name.lstrip(".").partition(".")[0]
            if not name.startswith(".") and (_is_ros(top, library) or _is_interfaces(name)):
                (asking if top in LIBRARIES else related).add(file)
            for found in _follow(name, file, sources):
                importers.setdefault(found, set()).add(file)
    _spread(related, importers)
    asking -= related
    related |= asking - makes_nothing(asking, related, importers, files, sources)
    _spread(related, importers)
    importing = set(related)
    for is_open in (False, True):
        before = -1
        while len(related) != before:
            before = len(related)
            for pattern in (p for p in loaders if _is_open(p) is is_open):
                loading = _loading(related, pattern, importers, sources, started)
                _spread(related, {**importers, **{f: importers.get(f, set()) | loaders[pattern] for f in loading}})
        if not is_open:
            importing = set(related)
    return importing & set(files), related & set(files)


def _path_pattern(name: str, file: str) -> str:
    """A regular expression for the files that a name of which not all is known may mean: the whole path, or what is behind a slash of it."""
    dots = len(name) - len(name.lstrip("."))
    folder = "/".join(file.split("/")[:-dots]) if dots else ""
    start = re.escape(f"{folder}/" if folder else "")
    path = ".*".join(re.escape(part.replace(".", "/")) for part in name[dots:].split(ANY))
    around = re.escape(name[dots:].partition(ANY)[0].replace(".", "/").rpartition("/")[0])
    package = f"|{start}{around}/__init__" if around else f"|{start}__init__" if dots else ""
    return f"{start}{path}(?:/__init__)?{package}"


def _is_open(pattern: str) -> bool:
    """Whether not even the package is known."""
    return pattern.startswith(".*")


def _spread(related: set[str], importers: Mapping[str, set[str]]) -> None:
    """What imports a file that can have to do with ROS can have to do with it."""
    work = list(related)
    while work:
        for file in importers.get(work.pop(), ()):
            if file not in related:
                related.add(file)
                work.append(file)


def _loading(
    related: set[str], pattern: str, importers: Mapping[str, set[str]], sources: SourceTree, started: Container[str]
) -> list[str]:
    """Which files that have to do with ROS may be loaded by a name that is so written."""
    meant = re.compile(rf"(?:.*/)?(?:{pattern})\.py")
    found = []
    for file in related:
        module = sources.module(file)
        if (
            module is not None
            and meant.fullmatch(file)
            and not (_is_open(pattern) and (module.has_main or file in started or importers.get(file, set()) - {file}))
        ):
            found.append(file)
    return found


def _follow(name: str, file: str, sources: SourceTree) -> Iterator[str]:
    """The source files that an import runs: that of the module and those of the packages around it; none where it leads out of the sources."""
    bare = name.lstrip(".")
    level = len(name) - len(bare)
    while found := sources.find(bare, level, file):
        yield found.file
        bare = bare.rpartition(".")[0]
        if not bare:
            return


def _is_ros(top: str, library: Library) -> bool:
    """Whether a top-level module is a modelled library that is neither Python's own nor free of ROS, or one that the user describes."""
    if top in STANDARD_LIBRARY or top in _WITHOUT_NODES:
        return False
    return library.describes(top)


def _is_interfaces(name: str) -> bool:
    """Whether a module name is that of generated interfaces: who has a type can make an entity on a node that it is given."""
    return name.split(".")[1:2] in (["msg"], ["srv"], ["action"])
