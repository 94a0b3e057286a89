# SPDX-License-Identifier: Apache-2.0
"""The files of an analysis as the engine reads them: found by module name, read and lowered at most once, failures told as findings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final, final

from rosward.analysis.deep_stack import with_deep_stack
from rosward.analysis.summary import Creation, Summary, creations_of, main_calls
from rosward.effects.entry import Entry
from rosward.engine.sources.found import FoundModule
from rosward.engine.sources.remembered import Lowered, memory_here
from rosward.findings import Finding, Findings
from rosward.frontends.front_end import FrontEnd, FrontendError
from rosward.frontends.registry import FRONT_ENDS, PYTHON, front_end_of
from rosward.guard import guarded
from rosward.ir.program import Code, Module
from rosward.location import Place
from rosward.models.facts import LibraryFacts
from rosward.source import disk, limits
from rosward.source.definitions import Definition
from rosward.source.imports import ImportResolver, ImportTarget
from rosward.source.installed import Installed
from rosward.source.interfaces import InterfaceIndex
from rosward.source.launch_function import makes_launch
from rosward.source.text import decode, place_name, read_bytes
from rosward.source.workspace import Package, SourceFile, Workspace
from rosward.source.yaml_documents import YamlDocuments

if TYPE_CHECKING:
    from rosward.analysis.compiled import Compiled
    from rosward.analysis.linked_functions import LinkedFunction
    from rosward.analysis.summaries import Summaries
    from rosward.analysis.unlinked import Unlinked
    from rosward.frontends.cpp.symbols import CppSymbols

_CODES: Final = {"syntax": "RW001", "python2": "RW006", "depth": "RW005", "null": "RW001"}


@final
class SourceTree:
    """Implements `engine.found.Sources` for a workspace."""

    def __init__(
        self,
        workspace: Workspace,
        underlays: Sequence[Path] = (),
        *,
        net: bool = True,
        front_ends: Sequence[FrontEnd] = FRONT_ENDS,
        compiled: Compiled | None = None,
        summaries: Summaries | None = None,
    ) -> None:
        self.workspace = workspace
        self._front_ends = front_ends
        self._compiled = compiled
        self.files = Installed(workspace, underlays)
        self.findings = Findings() if compiled is None else compiled.findings
        self._net = net
        self._memory = memory_here()
        self.documents = YamlDocuments() if self._memory is None else self._memory.documents
        """The YAML files that were read for what launch files start."""
        self.python_files: dict[str, int] = {}
        """The Python files that were read, and how many lines each has."""
        self._resolver = ImportResolver(workspace)
        self._interfaces = InterfaceIndex(workspace)
        self._modules: dict[str, Module | None] = {}
        self._summaries = summaries
        self._summarised: dict[Module, Summary] = {}
        self._lowered: dict[str, tuple[str, Module]] = {}
        """Each file of which a summary can be kept, with what tells its content."""
        self._files: dict[str, SourceFile] = {f.relative: f for f in (*workspace.launch_files, *workspace.files)}
        self._generated = {
            place_name(made.source, workspace.root): made.validation
            for package in workspace.packages
            for made in package.generated
        }
        """Descriptions of which the build makes modules, and the module of their validators."""
        self._launch = {f.relative for f in workspace.launch_files}
        self._packages = {p.name for p in workspace.packages} | {
            (f.module or "").partition(".")[0] for f in workspace.files
        }

    def read_all(self, progress: Callable[[int], None]) -> None:
        """Read and lower every file of the workspace."""
        for number, file in enumerate(self.workspace.files):
            progress(number)
            self.module(file.relative)
        progress(len(self.workspace.files))

    @property
    def files_read(self) -> int:
        """How many files were read."""
        return len(self.python_files) + len(self.cpp_files)

    @property
    def lines_read(self) -> int:
        """How many lines they have."""
        return sum(self.python_files.values()) + sum(self.cpp_files.values())

    def read_elsewhere(self, python: Mapping[str, int], cpp: Mapping[str, int], findings: Iterable[Finding]) -> None:
        """What another process has read of these sources, and what was wrong with it."""
        self.findings.update(findings)
        self.python_files |= {file: lines for file, lines in python.items() if file not in self.python_files}
        if self._compiled is not None:
            self._compiled.lines |= {file: lines for file, lines in cpp.items() if file not in self._compiled.lines}

    @property
    def cpp_files(self) -> Mapping[str, int]:
        """The files of the programs in C++ that were asked for, headers included, and how many lines each has."""
        return {} if self._compiled is None else self._compiled.lines

    def module(self, file: str) -> Module | None:
        """The lowered file; None where it cannot be read."""
        if file not in self._modules:
            source = self._files.get(file) or self.files.file(file)
            self._modules[file] = None if source is None else self._read(source.path, file)
        return self._modules[file]

    def created(self, module: Module, facts: LibraryFacts) -> Iterable[Creation]:
        """What in a module would create an entity."""
        summary = self._summarised.get(module)
        if summary is not None:
            return summary.created
        if self._memory is not None:
            return self._memory.derived(module, facts, lambda: tuple(creations_of(module, facts)))
        return creations_of(module, facts)

    def main_calls(self, module: Module) -> Set[str]:
        """See `summary.main_calls`."""
        summary = self._summarised.get(module)
        return main_calls(module) if summary is None else summary.main_calls

    def keep(self, facts: LibraryFacts) -> None:
        """Keep what the next run needs of each file and program that does not change; to be called when all is done."""
        if self._compiled is not None:
            self._compiled.keep()
        if self._summaries is not None:
            self._summaries.keep(self._lowered, self.python_files, facts)

    def content(self, file: str) -> str:
        """What tells the text of a module from any other; '' where there is none."""
        source = self._files.get(file) or self.files.file(file)
        if source is None:
            return ""
        made = self._generated.get(file)
        data = read_bytes(source.path, file, limits.PYTHON_FILE if made is None else limits.PARAMETERS_FILE)
        content = data.message if isinstance(data, Finding) else disk.digest(data)
        return content if made is None else f"{content} {made}"

    def program(self, name: str) -> CppSymbols | None:
        """The names of a program in C++."""
        return None if self._compiled is None else self._compiled.program(name)

    def program_digest(self, name: str) -> str:
        """What tells a program in C++ from any other; '' where there is none."""
        return "" if self._compiled is None else self._compiled.digest(name)

    def creating_functions(
        self, creating: frozenset[str], name: str, wanted: Callable[[str], bool]
    ) -> Mapping[str, Sequence[LinkedFunction]]:
        """The functions of a program in C++ that would create an entity, by file: of those of its files that are wanted."""
        return {} if self._compiled is None else self._compiled.creating_functions(name, creating, wanted)

    def unlinked(self, creating: frozenset[str]) -> Sequence[Unlinked]:
        """The libraries in C++ that no program is linked of, and that would create an entity."""
        return () if self._compiled is None else self._compiled.unlinked(creating)

    def component_places(self, name: str) -> Sequence[Place]:
        """Where the class is declared of which a program in C++ makes a component."""
        return () if self._compiled is None else self._compiled.component_places(name)

    def plugin(self, name: str) -> Entry | None:
        """How a class in C++ starts that is loaded by its name."""
        return None if self._compiled is None else self._compiled.plugin(name)

    def _read(self, path: Path, file: str) -> Module | None:
        if self._memory is None:
            return self._lower_here(path, file)
        own = self._memory.lowered(file, self.content(file), partial(self._lower_apart, path, file))
        self.findings.update(own.findings)
        if own.lines:
            self.python_files[file] = own.lines
        return own.module

    def _lower_apart(self, path: Path, file: str) -> Lowered:
        """The file, and what is told of it alone."""
        findings, self.findings = self.findings, Findings()
        try:
            module = self._lower_here(path, file)
            return Lowered(module, tuple(self.findings), self.python_files.get(file, 0))
        finally:
            self.findings = findings

    def _lower_here(self, path: Path, file: str) -> Module | None:
        found = guarded(lambda: self._lower(path, file), Place(file), "the file was not analysed", net=self._net)
        if isinstance(found, Finding):
            self.findings.add(found)
            return None
        return found

    def _lower(self, path: Path, file: str) -> Module | None:
        if file in self._generated:
            return self._generate(path, file)
        name = place_name(path, self.workspace.root)
        data = read_bytes(path, name, limits.PYTHON_FILE)
        front_end = front_end_of(file, self._front_ends)
        content = disk.digest(data) if self._summaries and isinstance(data, bytes) and front_end is PYTHON else ""
        summary = self._summaries.of(file, content) if self._summaries and content else None
        if summary is not None and isinstance(data, bytes):
            self.python_files[file] = summary.text_lines
            waiting = Code.waiting(summary.key, partial(_lower_late, data, name, file))
            module = Module(file, waiting, summary.imports, summary.first, summary.has_main, summary.lines)
            self._summarised[module] = summary
            self._lowered[file] = content, module
            return module
        text = data if isinstance(data, Finding) else decode(data, name)
        if isinstance(text, Finding):
            self.findings.add(text)
            return None
        if text.finding is not None:
            self.findings.add(text.finding)
        self.python_files[file] = text.text.count("\n") + (not text.text.endswith("\n"))
        try:
            module = front_end.lower(text.text, file)
        except FrontendError as error:
            place = Place(file, error.line, error.column)
            self.findings.add(Finding(_CODES.get(error.kind, "RW001"), error.message, place))
            return None
        if content and text.finding is None:
            self._lowered[file] = content, module
        return module

    def _generate(self, path: Path, file: str) -> Module | None:
        """The module that the build makes of the description in a file."""
        from rosward.source.parameter_module import parameter_module
        from rosward.source.yaml_nodes import Malformed

        data = read_bytes(path, file, limits.PARAMETERS_FILE)
        if isinstance(data, Finding):
            self.findings.add(data)
            return None
        try:
            made = parameter_module(data.decode("utf-8-sig", "replace"), file, self._generated[file])
        except Malformed as problem:
            message = f"The parameters of this module were not read: {problem.message}."
            self.findings.add(Finding("RW008", message, problem.place))
            return None
        try:
            return PYTHON.lower(made.text, file, made.lines)
        except FrontendError:
            message = "The parameters of this module were not read: they are nested deeper than Python allows."
            self.findings.add(Finding("RW008", message, Place(file, 1)))
            return None

    def find(self, name: str, level: int, importer: str) -> FoundModule | None:
        """The module of a name as written in the file `importer`."""
        source = self._files.get(importer)
        if source is None or (level == 0 and self._interfaces.has(name, "") is not None):
            return None  # what a build generates takes the place of a file of that name
        found = self._resolver.resolve(name, level, source)
        if found is None:
            launch = self._launch_file(name, source) if level == 0 else None
            return launch if launch is not None and self._describes_launch(source) else None
        return self._found_module(found)

    def _describes_launch(self, file: SourceFile) -> bool:
        """Whether a file is a launch file, whatever its name: one that another one includes may have any."""
        if file.relative in self._launch:
            return True
        data = read_bytes(file.path, file.relative, limits.PYTHON_FILE)
        return isinstance(data, bytes) and makes_launch(data)

    def _found_module(self, found: ImportTarget) -> FoundModule | None:
        """A file that is imported under another name than its own is a module apart from that of its own name.

        A module that the build makes is there only if what it is made of is understood.
        """
        if found.file is None:
            return FoundModule(found.name, found.name, "", guess=found.guess)
        file = found.file.relative
        self._files.setdefault(file, found.file)
        if file in self._generated and self.module(file) is None:
            return None
        key = file if found.name == found.file.module else f"{found.name} in {file}"
        return FoundModule(found.name, key, file, guess=found.guess)

    def in_folder(self, folder: str, name: str) -> FoundModule | None:
        """The module of a name, imported from a folder below that of all sources."""
        found = self._resolver.in_folder(folder, name)
        return None if found is None else self._found_module(found)

    def named(self, name: str) -> tuple[tuple[str, FoundModule], ...]:
        """All files that a name may mean, each with the folder from which it would be imported."""
        named = [(folder, self._found_module(found)) for folder, found in self._resolver.named(name)]
        return tuple((folder, found) for folder, found in named if found is not None)

    def is_of(self, file: str, package: str) -> bool:
        """Whether a file belongs to the ROS package of that name."""
        source = self._files.get(file)
        return source is not None and source.package is not None and source.package.name == package

    def _launch_file(self, name: str, importer: SourceFile) -> FoundModule | None:
        """A launch file that another one imports: `sys.path.append(…)` and `import rs_launch`; the only one of that name, nearest first."""
        named = [f for f in self.workspace.launch_files if f.relative.rpartition("/")[2] == f"{name}.py"]
        near = [f for f in named if f.package == importer.package] or named
        return FoundModule(name, near[0].relative, near[0].relative, guess=True) if len(near) == 1 else None

    def interface_has(self, module: str, name: str) -> bool | None:
        """Whether an interface package has an interface of that name."""
        return self._interfaces.has(module, name)

    def interface_definition(self, package: str, kind: str, name: str, part: str) -> Definition | None:
        """The fields of a message, or of a part of a service or action."""
        return self._interfaces.definition(package, kind, name, part)

    def belongs(self, name: str) -> bool:
        """Whether the first part of a dotted name is a package of the workspace."""
        return name.partition(".")[0] in self._packages

    def python_package(self, file: str) -> str:
        """The Python package in which a file lies, by its place; '' where it is no part of one, and for a script that is installed."""
        source = self._files.get(file)
        if source is None or source.module is None or self._resolver.is_script(source):
            return ""
        return source.module if source.is_package else source.module.rpartition(".")[0]

    def leads_out(self, file: str, name: str, level: int) -> bool:
        """Whether a relative import with so many dots leads out of the file's ROS package, or of all that is analysed; so any of a script.

        Not where there is no such package, and what is imported is not there either: the sources are then a part of a package.
        """
        source = self._files.get(file)
        if source is None or self._resolver.is_script(source):
            return source is not None
        if source.package is None and self.find(name, level, file) is None:
            return False
        inner = file if source.package is None else _inside(source.package, file)
        return level > max(inner.count("/"), (source.module or "").count("."))

    def shared(self, file: str) -> tuple[str, str] | None:
        """The package and the path in it of a launch file, and of Python files in launch folders: they are installed into share/."""
        source = self._files.get(file)
        if source is None:
            return self.files.place_of(file)
        if file not in self._launch and "launch" not in file.split("/")[:-1]:
            return None
        if source.package is None:
            return "", file
        return source.package.name, _inside(source.package, file)


def _lower_late(data: bytes, name: str, file: str) -> Code:
    """The body of a file that was lowered by an earlier run: now somebody needs it."""

    def lower() -> Code:
        text = decode(data, name)
        assert not isinstance(text, Finding)
        return PYTHON.lower(text.text, file).code

    try:
        return lower()
    except (
        FrontendError
    ):  # the interpreter stands deep in calls: what is nested deep has a stack of its own, as it had then
        return with_deep_stack(lower)


def _inside(package: Package, file: str) -> str:
    """The path of a file of a package below the package's folder."""
    return file if package.relative in ("", ".") else file.removeprefix(f"{package.relative}/")
