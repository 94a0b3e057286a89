# SPDX-License-Identifier: Apache-2.0
"""What are the sources of code that has none? Models see this in the place of files, so that what they make is the same for all analyses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

if TYPE_CHECKING:
    from rosward.engine.sources.found import FoundModule
    from rosward.ir.program import Module
    from rosward.ir.symbols import Symbols
    from rosward.source.definitions import Definition


@final
class NoSources:
    """See `Sources` and `Files`: nothing is there, and nothing is known of interfaces."""

    @property
    def files(self) -> NoSources:
        """No files either."""
        return self

    def find(self, _name: str, _level: int, _importer: str) -> FoundModule | None:
        """No module."""
        return None

    def module(self, _file: str) -> Module | None:
        """No file."""
        return None

    def content(self, _file: str) -> str:
        """There is none."""
        return ""

    def program(self, _name: str) -> Symbols | None:
        """No program."""
        return None

    def program_digest(self, _name: str) -> str:
        """None."""
        return ""

    def interface_has(self, _module: str, _name: str) -> bool | None:
        """Not known."""
        return None

    def interface_definition(self, _package: str, _kind: str, _name: str, _part: str) -> Definition | None:
        """Not known."""
        return None

    def in_folder(self, _folder: str, _name: str) -> FoundModule | None:
        """No module."""
        return None

    def named(self, _name: str) -> tuple[tuple[str, FoundModule], ...]:
        """No file."""
        return ()

    def is_of(self, _file: str, _package: str) -> bool:
        """No."""
        return False

    def belongs(self, _name: str) -> bool:
        """No."""
        return False

    def python_package(self, _file: str) -> str:
        """None."""
        return ""

    def leads_out(self, _file: str, _name: str, _level: int) -> bool:
        """No."""
        return False

    def shared(self, _file: str) -> tuple[str, str] | None:
        """Nothing is installed."""
        return None

    def read(self, _package: str, _relative: str) -> str | None:
        """No text."""
        return None

    def is_file(self, _package: str, _relative: str) -> bool:
        """No."""
        return False

    def is_folder(self, _package: str, _relative: str) -> bool:
        """No."""
        return False

    def listing(self, _package: str, _relative: str) -> tuple[str, ...] | None:
        """No folder."""
        return None

    def name_of(self, _package: str, _relative: str) -> str | None:
        """None."""
        return None

    def modules(self, _relative: str) -> tuple[str, ...]:
        """None."""
        return ()


NO_SOURCES: Final = NoSources()
