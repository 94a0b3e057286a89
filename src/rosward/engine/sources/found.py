# SPDX-License-Identifier: Apache-2.0
"""What does the engine ask the sources, and where does a module name lead?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from rosward.ir.program import Module
from rosward.models.file_paths import Files
from rosward.records import NamedTuple
from rosward.source.definitions import Definition

if TYPE_CHECKING:
    from rosward.ir.symbols import Symbols


class FoundModule(NamedTuple):
    """Where a module name leads: its full dotted name, a key that identifies it, its file ('' for a folder), whether it is a model."""

    name: str
    key: str
    file: str
    model: bool = False
    guess: bool = False


class Sources(Protocol):
    """The files of the analysis, as the engine sees them."""

    @property
    def files(self) -> Files:
        """What is installed into the share folders of packages, as data."""

    def find(self, name: str, level: int, importer: str) -> FoundModule | None:
        """The module of a name as written in the file `importer`."""

    def module(self, file: str) -> Module | None:
        """The lowered file; None where it cannot be read (a finding has said so)."""

    def content(self, file: str) -> str:
        """What tells the text of a module from any other; '' where there is none."""

    def program(self, name: str) -> Symbols | None:
        """The names of a program of a language with a linker (`Entry.program`); None where it cannot be read (a finding has said so)."""

    def program_digest(self, name: str) -> str:
        """What tells such a program from any other; '' where it cannot be read."""

    def interface_has(self, module: str, name: str) -> bool | None:
        """Whether `package.msg` (srv, action) has an interface of that name; None where the package is not known."""

    def interface_definition(self, package: str, kind: str, name: str, part: str) -> Definition | None:
        """The fields of a message, or of a `part` (`Request`, `Goal`) of a service or action; None where they are not known."""

    def in_folder(self, folder: str, name: str) -> FoundModule | None:
        """The module of a name, imported from a folder below that of all sources."""

    def named(self, name: str) -> tuple[tuple[str, FoundModule], ...]:
        """All files that a name may mean, each with the folder from which it would be imported."""

    def is_of(self, file: str, package: str) -> bool:
        """Whether a file belongs to the ROS package of that name."""

    def belongs(self, name: str) -> bool:
        """Whether the first part of a dotted name is a package of the analysis."""

    def python_package(self, file: str) -> str:
        """The Python package in which a file lies, by its place; '' where it is no part of one, and for a script that is installed."""

    def leads_out(self, file: str, name: str, level: int) -> bool:
        """Whether a relative import with so many dots leads out of the file's ROS package, or of all that is analysed; so any of a script.

        Not where there is no such package, and what is imported is not there either: the sources are then a part of a package.
        """

    def shared(self, file: str) -> tuple[str, str] | None:
        """The package and the path in it of a file that is installed into the package's share folder; None for any other.

        The package is '' for a launch file outside of packages; its path is then that below the folder of all sources.
        """
