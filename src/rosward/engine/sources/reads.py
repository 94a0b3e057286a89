# SPDX-License-Identifier: Apache-2.0
"""What did the interpretation of a process read?

    import util                              ("find", "util", 0, "talker.py"), ("module", "util.py")
    ros2 run demo pump                       ("program", "demo/pump", the digest of all its files)
    open(share + "/config/names.yaml")       ("read", "demo", "config/names.yaml")
    os.environ["ROBOT"]                      the variable ROBOT

Another process, or the same one later, gives the same result where these questions have the same answers: the record does not depend on what
was asked before it by other processes, although most of that is computed once for all.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, final

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.effects.configuration import Configuration
    from rosward.engine.budget import Budget
    from rosward.engine.sources.found import FoundModule, Sources
    from rosward.ir.program import Module
    from rosward.ir.symbols import Symbols
    from rosward.models.file_paths import Files
    from rosward.source.definitions import Definition

__all__ = ["Question", "Reading", "Reads", "RecordedSources"]

Question = tuple[str | int, ...]
"""The name of a method of `Library`, `Sources` or `Files`, and what it was given."""


class Reads(NamedTuple):
    """What a result stands on, each part sorted. `models`: the names of modules of which the model was asked for; each with all that it needs
    (`model_units.units`). `variables`: those of the environment. `budget` and `configuration`: what the process was started with.
    """

    questions: tuple[Question, ...]
    models: tuple[str, ...]
    variables: tuple[str, ...]
    budget: Budget
    configuration: Configuration | None


@final
class Reading:
    """Collects it while a process runs."""

    __slots__ = ("models", "questions")

    def __init__(self) -> None:
        self.questions: set[Question] = set()
        self.models: set[str] = set()


Note = Callable[..., None]


@final
class RecordedSources:
    """Sources of which each question is noted."""

    def __init__(self, sources: Sources, note: Note) -> None:
        self._sources = sources
        self._note = note
        self._files = _RecordedFiles(sources.files, note)

    @property
    def files(self) -> Files:
        """Noted as well."""
        return self._files

    def find(self, name: str, level: int, importer: str) -> FoundModule | None:
        """See `Sources`."""
        self._note("find", name, level, importer)
        return self._sources.find(name, level, importer)

    def module(self, file: str) -> Module | None:
        """See `Sources`."""
        self._note("module", file)
        return self._sources.module(file)

    def content(self, file: str) -> str:
        """See `Sources`."""
        self._note("content", file)
        return self._sources.content(file)

    def program(self, name: str) -> Symbols | None:
        """See `Sources`. What its files become for it is noted with it."""
        found = self._sources.program(name)
        self._note("program", name, "" if found is None else found.digest)
        return found

    def program_digest(self, name: str) -> str:
        """See `Sources`."""
        found = self._sources.program_digest(name)
        self._note("program", name, found)
        return found

    def interface_has(self, module: str, name: str) -> bool | None:
        """See `Sources`."""
        self._note("interface_has", module, name)
        return self._sources.interface_has(module, name)

    def interface_definition(self, package: str, kind: str, name: str, part: str) -> Definition | None:
        """See `Sources`."""
        self._note("interface_definition", package, kind, name, part)
        return self._sources.interface_definition(package, kind, name, part)

    def in_folder(self, folder: str, name: str) -> FoundModule | None:
        """See `Sources`."""
        self._note("in_folder", folder, name)
        return self._sources.in_folder(folder, name)

    def named(self, name: str) -> tuple[tuple[str, FoundModule], ...]:
        """See `Sources`."""
        self._note("named", name)
        return self._sources.named(name)

    def is_of(self, file: str, package: str) -> bool:
        """See `Sources`."""
        self._note("is_of", file, package)
        return self._sources.is_of(file, package)

    def belongs(self, name: str) -> bool:
        """See `Sources`."""
        self._note("belongs", name)
        return self._sources.belongs(name)

    def python_package(self, file: str) -> str:
        """See `Sources`."""
        self._note("python_package", file)
        return self._sources.python_package(file)

    def leads_out(self, file: str, name: str, level: int) -> bool:
        """See `Sources`."""
        self._note("leads_out", file, name, level)
        return self._sources.leads_out(file, name, level)

    def shared(self, file: str) -> tuple[str, str] | None:
        """See `Sources`."""
        self._note("shared", file)
        return self._sources.shared(file)


@final
class _RecordedFiles:
    """Files of which each question is noted."""

    def __init__(self, files: Files, note: Note) -> None:
        self._files = files
        self._note = note

    def read(self, package: str, relative: str) -> str | None:
        """See `Files`."""
        self._note("read", package, relative)
        return self._files.read(package, relative)

    def is_file(self, package: str, relative: str) -> bool:
        """See `Files`."""
        self._note("is_file", package, relative)
        return self._files.is_file(package, relative)

    def is_folder(self, package: str, relative: str) -> bool:
        """See `Files`."""
        self._note("is_folder", package, relative)
        return self._files.is_folder(package, relative)

    def listing(self, package: str, relative: str) -> tuple[str, ...] | None:
        """See `Files`."""
        self._note("listing", package, relative)
        return self._files.listing(package, relative)

    def name_of(self, package: str, relative: str) -> str | None:
        """See `Files`."""
        self._note("name_of", package, relative)
        return self._files.name_of(package, relative)

    def modules(self, relative: str) -> tuple[str, ...]:
        """See `Files`."""
        self._note("modules", relative)
        return self._files.modules(relative)
