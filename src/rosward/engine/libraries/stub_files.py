# SPDX-License-Identifier: Apache-2.0
"""Which stub file describes a module of a library, and what does it say?

    StubFiles((Path("models"),)).find("rclpy.node")  ->  "models:rclpy/node.pyi"

A stub of the user goes before rosward's own; one that cannot be read is told, and the next of its name stands in.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final, final

from rosward.findings import Finding, Findings
from rosward.frontends.front_end import FrontendError
from rosward.frontends.registry import front_end_of
from rosward.guard import guarded
from rosward.ir.program import MODEL_PREFIX, Module
from rosward.location import Place
from rosward.source import disk, limits
from rosward.source.text import decode, read_bytes

STUBS: Final = Path(__file__).parent.parent.parent / "models" / "stubs"
_LONGEST_NAME: Final = 200
"""No file has a longer name."""
_CODES: Final = {"python2": "RW006", "depth": "RW005"}

_OWN: Final[dict[str, Module]] = {}
"""rosward's own stubs, lowered: they and their IR never change, so that one run has them from the run before."""


def own_names() -> list[str]:
    """The modules that rosward's own stubs describe."""
    files = (path.relative_to(STUBS).with_suffix("").as_posix() for path in STUBS.rglob("*.pyi"))
    return sorted(file.removesuffix("/__init__").replace("/", ".") for file in files)


@final
class StubFiles:
    """The stubs of several folders; what is wrong with them stands in `findings`."""

    def __init__(self, folders: tuple[Path, ...], *, net: bool = True) -> None:
        self._net = net
        self._folders = (*folders, STUBS)
        self._found: dict[str, str | None] = {}
        self._packages: dict[str, bool] = {}
        self._modules: dict[str, Module] = {}
        self.findings = Findings()

    def find(self, name: str) -> str | None:
        """The file of a module, as places name it; None where no stub describes it."""
        if name not in self._found:
            self._found[name] = self._look_up(name) if name and "\0" not in name else None
        return self._found[name]

    def describes(self, package: str) -> bool:
        """Whether there is any stub of a top-level package or module."""
        if package not in self._packages:
            self._packages[package] = len(package) <= _LONGEST_NAME and any(
                disk.is_folder(folder / package) or disk.is_file(folder / f"{package}.pyi") for folder in self._folders
            )
        return self._packages[package]

    def module(self, file: str) -> Module | None:
        """The lowered file of a stub that was found."""
        return self._modules.get(file)

    def _look_up(self, name: str) -> str | None:
        inner = name.replace(".", "/")
        for folder in self._folders:
            for candidate in (f"{inner}.pyi", f"{inner}/__init__.pyi"):
                there = disk.is_file(folder / candidate)
                file = MODEL_PREFIX + candidate
                if there and (own := _OWN.get(file) if folder == STUBS else None) is not None:
                    self._modules[file] = own
                    return file
                if there and self._is_read(folder / candidate, file):
                    if folder == STUBS:
                        _OWN[file] = self._modules[file]
                    return file
        return None

    def _is_read(self, path: Path, file: str) -> bool:
        found = guarded(lambda: self._read(path, file), Place(file), "this stub was not read", net=self._net)
        if isinstance(found, Finding):
            self.findings.add(found)
            return False
        return found

    def _read(self, path: Path, file: str) -> bool:
        data = read_bytes(path, file, limits.STUB_FILE)
        source = data if isinstance(data, Finding) else decode(data, file)
        if isinstance(source, Finding):
            self.findings.add(source)
            return False
        if source.finding is not None:
            self.findings.add(source.finding)
            return False
        try:
            self._modules[file] = front_end_of(file).lower(source.text, file)
        except FrontendError as error:
            place = Place(file, error.line, error.column)
            self.findings.add(Finding(_CODES.get(error.kind, "RW001"), error.message, place))
            return False
        return True
