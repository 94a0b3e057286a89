# SPDX-License-Identifier: Apache-2.0
"""Which processes do the programs in C++ make, and which names has each program?

    add_executable(talker src/talker.cpp)                            demo/talker: `main`
    rclcpp_components_register_node(pump PLUGIN "demo::Pump" …)      demo/demo::Pump: a container makes one
    a source with `main` that no CMakeLists.txt is about             named after its file
    a source that registers a component and is of no package         named after the class

Nothing is read before a process asks for its program; a workspace without C++ does not even load the parser.
"""

from __future__ import annotations

import importlib.util
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING, Final, final

from rosward.analysis.kept_programs import Kept, KeptProgram
from rosward.analysis.linked_functions import LinkedFunction, creating_functions
from rosward.analysis.plugins import Plugins, plugins_of
from rosward.analysis.ros_headers import RosHeaders
from rosward.analysis.unlinked import Unlinked, unlinked_libraries
from rosward.analysis.unpacked import MAIN, REGISTERED, components_of
from rosward.effects.entry import Entry
from rosward.findings import Finding, Findings
from rosward.frontends.cpp.headers import Headers
from rosward.frontends.cpp.model_headers import PREFIX, model_headers
from rosward.frontends.cpp.preprocess import Preprocessor
from rosward.frontends.cpp.program import Linked, SymbolStore
from rosward.guard import guarded
from rosward.location import Place
from rosward.models.cpp.facts import GENERIC
from rosward.records import NamedTuple
from rosward.source import disk
from rosward.source.cmake.programs import Builds, Program, Unit
from rosward.source.text import place_name
from rosward.source.workspace import Package, SourceFile, Workspace

if TYPE_CHECKING:
    from pathlib import Path

    from rosward.analysis.kept_programs import Keeper
    from rosward.frontends.cpp.symbols import CppSymbols
    from rosward.ros.distro import Distro

_LOADER: Final = "pluginlib/class_loader"
_PLUGINS: Final = "pluginlib/workspace.hpp"
_HOSTS: Final = dict.fromkeys(
    ("controller_interface::ControllerInterface", "controller_interface::ChainableControllerInterface"),
    "controller_interface::host",
)
"""Bases of classes that programs of ROS load, and what in the models does with a class what they do."""
_PARSERS: Final = ("tree_sitter", "tree_sitter_cpp")


class Planned(NamedTuple):
    """A process, and what it is linked of. `related`: it can have to do with ROS."""

    entry: Entry
    units: tuple[Unit, ...]
    related: bool


@final
class Compiled:
    """The programs in C++ of a workspace."""

    def __init__(self, workspace: Workspace, distro: Distro, *, net: bool = True, keeper: Keeper | None = None) -> None:
        self.findings = Findings()
        self.lines: dict[str, int] = {}
        """The files that were read, and how many lines each has."""
        self._workspace = workspace
        self._distro = distro
        self._net = net
        self._keeper = keeper
        self._linked: dict[str, KeptProgram] = {}
        """Those that were linked here, to be kept."""
        self._programs: dict[str, CppSymbols | None] = {}
        root = os.fspath(workspace.root)
        self._headers = Headers(workspace.root, [root], workspace.boundary)
        self._store: SymbolStore | None = None

    @property
    def all(self) -> tuple[Entry, ...]:
        """How each program starts, executables before components."""
        return tuple(p.entry for p in self._planned.values())

    @property
    def related(self) -> tuple[Entry, ...]:
        """Those that can have to do with ROS."""
        return tuple(p.entry for p in self._planned.values() if p.related)

    @cached_property
    def _planned(self) -> dict[str, Planned]:
        """Every program by its name."""
        if not self._has_parser():
            return {}
        made = guarded(self._plan, Place(""), "the programs in C++ are missing", net=self._net)
        if isinstance(made, Finding):
            self.findings.add(made)
            return {}
        found: dict[str, Planned] = {}
        for each in made:
            found.setdefault(each.entry.program, each)
        return found

    def program(self, name: str) -> CppSymbols | None:
        """The names of a program; None where it cannot be read."""
        if name not in self._programs:
            planned = self._planned.get(name)
            self._programs[name] = None if planned is None else self._link(planned)
        return self._programs[name]

    def digest(self, name: str) -> str:
        """What tells a program from any other, '' where it cannot be read; where it is known, it is not linked."""
        before = self._before(name)
        if before is not None:
            return before.digest
        found = self.program(name)
        return "" if found is None else found.digest

    def creating_functions(
        self, name: str, creating: frozenset[str], wanted: Callable[[str], bool]
    ) -> Mapping[str, Sequence[LinkedFunction]]:
        """The functions of a program that would create an entity, by file: of those of its files that are wanted."""
        before = self._before(name)
        known = None if before is None else before.functions_in(wanted)
        program = self.program(name) if known is None else None
        if program is None:
            return known or {}
        files = [f for f in program.files if not f.text.startswith(PREFIX) and wanted(f.text)]
        found = {file.text: creating_functions(program, file, creating | GENERIC) for file in files}
        linked = self._linked[name]
        self._linked[name] = linked._replace(functions={**linked.functions, **found})
        return found

    def unlinked(self, creating: frozenset[str]) -> Sequence[Unlinked]:
        """The libraries that no program has been linked of and that say the name of something that creates an entity."""
        if not self._has_parser():
            return ()
        programs = {**self._kept, **self._linked}
        loads = any(programs[name].loads for name in self._planned if name in programs)
        taken = {unit.path for planned in self._planned.values() for unit in planned.units}
        described = frozenset([unit.path for unit in self._described.units])
        taken |= described if loads else set()
        known = {file for name in self._planned if name in programs for file in programs[name].lines}
        found = guarded(
            lambda: unlinked_libraries(
                self._workspace, self._builds, taken, self._headers, creating | GENERIC, described, known
            ),
            Place(""),
            "libraries in C++ are not looked at",
            net=self._net,
        )
        if isinstance(found, Finding):
            self.findings.add(found)
            return ()
        for each in found:
            entry = Entry(each.file, "", "", (), None, None, each.name, program=each.name)
            self._planned.setdefault(each.name, Planned(entry, each.units, True))
        return found

    def component_places(self, name: str) -> Sequence[Place]:
        """Where the class is declared of which a program makes a component."""
        before = self._before(name)
        if before is not None and before.places is not None:
            return before.places
        program = self.program(name)
        if program is None:
            return ()
        places = tuple(symbol.place for symbol in program.registered_class(self._planned[name].entry.classes[0]))
        self._linked[name] = self._linked[name]._replace(places=places)
        return places

    def keep(self) -> None:
        """Keep what is known of the programs that were linked, and of those that still are what they were."""
        if self._keeper is not None and self._linked:
            programs = {name: kept for name, kept in self._kept.items() if name in self._planned}
            programs |= {name: linked.with_more(programs.get(name)) for name, linked in self._linked.items()}
            self._keeper.keep(Kept(self._headers.asked(), programs))

    def _before(self, name: str) -> KeptProgram | None:
        """What is known of a program that was linked before, and is what it was; what was told of it is told again."""
        kept, planned = self._kept.get(name), self._planned.get(name)
        if kept is None or planned is None or name in self._programs or kept.units != _of_units(planned):
            return None
        if kept.loads:
            self._described  # noqa: B018  tells what is wrong with plugins
        self._tell(kept.findings, kept.lines)
        return kept

    @cached_property
    def _kept(self) -> Mapping[str, KeptProgram]:
        """The programs that were linked before, if all of their files are what they were."""
        kept = None if self._keeper is None else self._keeper.latest()
        if kept is None:
            return {}
        if any(program.loads for program in kept.programs.values()):
            self._write_plugins()
        return kept.programs if self._headers.answers(kept.asked) else {}

    def _tell(self, findings: Iterable[Finding], lines: Mapping[str, int]) -> None:
        """What is wrong with a program, and how many lines its files have."""
        self.findings.update(findings)
        self.lines |= {file: count for file, count in lines.items() if file not in self.lines}

    def _link(self, planned: Planned) -> CppSymbols | None:
        if self._store is None:
            self._store = self._new_store()
        store = self._store
        place = Place(planned.entry.file)
        loads = False

        def link() -> Linked:
            nonlocal loads
            linked = store.symbols(planned.units)
            loads = any(name.startswith(_LOADER) for file in linked.files for name in file.external)
            return store.symbols((*planned.units, *self._plugins)) if loads and self._plugins else linked

        found = guarded(link, place, "this program is missing", net=self._net)
        if isinstance(found, Finding):
            self.findings.add(found)
            return None
        lines = {each.file: each.text.count("\n") + (not each.text.endswith("\n")) for each in reversed(found.files)}
        self._tell(found.findings, lines)
        self._linked[planned.entry.program] = KeptProgram(
            _of_units(planned),
            found.symbols.digest,
            found.findings,
            lines,
            loads,
            {file.text: None for file in found.symbols.files if not file.text.startswith(PREFIX)},
        )
        return found.symbols

    def plugin(self, name: str) -> Entry | None:
        """How a class starts that a program which is not among the sources loads by its name, and of which a model knows what that does."""
        found = self._described.named(name) if self._has_parser() else None
        host = _HOSTS.get(found.base) if found is not None else None
        if found is None or host is None:
            return None
        package, units = self._described.libraries[found]
        if not units:
            return None
        label = f"{package}/{found.type}"
        key = f"{label} as {found.base}"
        file = place_name(units[0].path, self._workspace.root)
        entry = Entry(file, "", "", (found.type,), package, None, label, program=key, host=host)
        self._planned.setdefault(key, Planned(entry, units, True))
        return entry

    @cached_property
    def _described(self) -> Plugins:
        self.findings.update(self._found_plugins.findings)
        return self._found_plugins

    @cached_property
    def _found_plugins(self) -> Plugins:
        return plugins_of(self._workspace, self._builds)

    @cached_property
    def _plugins(self) -> tuple[Unit, ...]:
        """What a program is linked of that loads plugins."""
        plugins = self._described
        if not plugins.text:
            return ()
        self._write_plugins()
        return (*plugins.units, Unit(_PLUGINS, (), ()))

    def _write_plugins(self) -> None:
        self._headers.write(_PLUGINS, f"{PREFIX}{_PLUGINS}", self._found_plugins.text)

    @cached_property
    def _builds(self) -> Builds:
        return Builds.of(self._workspace)

    def _new_store(self) -> SymbolStore:
        versions = {"RCLCPP_VERSION_GTE": self._distro.facts.rclcpp}
        headers = self._headers
        preprocessor = Preprocessor(headers.read, headers.named, headers.find, versions, headers.above)
        return SymbolStore(preprocessor, partial(model_headers, versions))

    def _has_parser(self) -> bool:
        missing = [name.replace("_", "-") for name in _PARSERS if importlib.util.find_spec(name) is None]
        if missing:
            first = self._workspace.cpp_sources[0].relative
            message = f"C++ is not read, as Python packages are missing: pip install {' '.join(missing)}."
            self.findings.add(Finding("RW018", message, Place(first)))
        return not missing

    # Which programs there are

    def _plan(self) -> list[Planned]:
        builds = self._builds
        ros = RosHeaders(self._headers)
        taken = {os.fspath(file.path) for file in self._workspace.cpp_sources}
        packages = {id(f.package): f.package for f in self._workspace.cpp_sources if f.package is not None}
        found: list[Planned] = []
        components: list[Planned] = []
        built: set[int] = set()
        for key, package in packages.items():
            build = builds.build(package.name)
            if build is None or os.fspath(package.path) != build.folder:
                continue
            built.add(key)
            self.findings.update(build.findings)
            for header in build.parameters:
                self._headers.generate(f"{header.name}.hpp", header.source, build.folder)
            programs = [p for p in builds.programs(package.name) if any(u.path in taken for u in p.units)]
            plugins = {p.plugin for p in programs}
            self.findings.update(self._registered(package, plugins))
            for program in programs:
                entry = self._entry(program)
                planned = Planned(entry, program.units, any(ros.reached(u.path, u.includes) for u in program.units))
                (components if entry.assumed else found).append(planned)
        alone = [f for f in self._workspace.cpp_sources if id(f.package) not in built]
        texts = {f: text if isinstance(text := self._headers.read(os.fspath(f.path)), str) else "" for f in alone}
        unpacked = (Planned(*each, True) for each in components_of(texts, lambda file: self._unit(file, builds)))
        return [*found, *self._alone(texts, builds, ros), *components, *unpacked]

    def _entry(self, program: Program) -> Entry:
        """The process of a program; a component that no executable is made for is assumed to be loaded by somebody."""
        file = place_name(program.units[0].path, self._workspace.root)
        is_component = bool(program.plugin) and program.name == program.library
        name = program.plugin if is_component else program.name
        label = f"{program.package}/{name}"
        return Entry(
            file,
            "",
            "" if program.plugin else "main",
            (program.plugin,) if program.plugin else (),
            program.package,
            None if is_component else program.name,
            label,
            assumed=is_component,
            program=label,
        )

    def _registered(self, package: Package, plugins: set[str]) -> Iterator[Finding]:
        """Classes that the source registers as components, and no library is said to have."""
        for file in self._workspace.cpp_sources:
            if file.package is not package:
                continue
            text = self._headers.read(os.fspath(file.path))
            if isinstance(text, Finding):
                continue
            for match in REGISTERED.finditer(text):
                if match[1].removeprefix("::") not in plugins:
                    message = f"{match[1]} is registered as a component, but not with CMake: no container can load it."
                    yield Finding("RW009", message, Place(file.relative, text.count("\n", 0, match.start()) + 1))

    def _unit(self, file: SourceFile, builds: Builds) -> Unit:
        """A source that no build is known for."""
        return builds.alone(os.fspath(file.path), tuple(_include_folders(file, self._workspace)))

    def _alone(self, files: Mapping[SourceFile, str], builds: Builds, ros: RosHeaders) -> Iterator[Planned]:
        """Sources with `main` that no build is known for, each with the sources beside it that have none."""
        starts = {f: None for f, text in files.items() if MAIN.search(text)}
        others: dict[Path, list[SourceFile]] = {}
        for file in files:
            if file not in starts:
                others.setdefault(file.path.parent, []).append(file)
        labels: dict[str, int] = {}
        for file in starts:
            beside = others.get(file.path.parent, ())
            includes = tuple(_include_folders(file, self._workspace))
            units = tuple(builds.alone(os.fspath(f.path), includes) for f in (file, *beside))
            label = f"{file.package.name}/{file.path.stem}" if file.package is not None else file.relative
            count = labels[label] = labels.get(label, 0) + 1
            label = label if count == 1 else f"{label}#{count}"
            package = file.package.name if file.package is not None else None
            entry = Entry(file.relative, "", "main", (), package, None, label, program=label)
            yield Planned(entry, units, ros.reached(units[0].path, units[0].includes))


def _of_units(planned: Planned) -> str:
    """What a program is linked of."""
    return disk.digest(repr(planned.units).encode("utf-8", "surrogatepass"))


def _include_folders(file: SourceFile, workspace: Workspace) -> Iterable[str]:
    """The folders named `include` beside a source and above it."""
    folder = file.path.parent
    root = workspace.root
    while folder.is_relative_to(root):
        if disk.is_folder(folder / "include"):
            yield os.fspath(folder / "include")
        if folder == root:
            break
        folder = folder.parent
