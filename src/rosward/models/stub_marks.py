# SPDX-License-Identifier: Apache-2.0
"""What do stubs say of how information flows through a function, by its dotted name?

    socket.socket.send        @sink("network") in the class `socket` of socket.pyi
    zmq.Context.socket.send   the same of the class that `Context.socket` says it gives
    boto3.client.put_object   the mark of the whole module

Each stub is read when a name of it is first asked for, in the order of the folders: the user's, rosward's own, and then `marks/`, where
libraries stand that have no stub, or whose functions are models in code.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Final, NamedTuple, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.models.facts import stub_names
from rosward.models.flow_marks import NO_MARK, FlowMark
from rosward.models.marked_stubs import Scope, Wrong, imports_of, scope_of
from rosward.source import disk, limits
from rosward.source.text import read_bytes

_HERE: Final = Path(__file__).parent
OWN: Final = (_HERE / "stubs", _HERE / "marks")
_BUILTINS: Final = "builtins"
_DEPTH: Final = 8
_LONGEST: Final = 12
"""A name of so many parts is that of no function of a stub."""
_NOTATION: Final = b"_rosward"


class _Said(NamedTuple):
    own: FlowMark | None
    whole: FlowMark | None
    """That of the class or module around it."""
    found: bool = False
    """Whether it stands in a stub."""


_NOTHING: Final = _Said(None, None)


@final
class StubMarks:
    """The marks of all stubs of some folders."""

    def __init__(self, folders: Sequence[Path] = ()) -> None:
        self._folders = (*folders, *OWN)
        self._modules: dict[tuple[Path, str], Scope | None] = {}
        self._packages: dict[tuple[Path, str], bool] = {}
        self._known: dict[str, FlowMark] = {}
        self._told: dict[str, bool] = {}

    def of(self, name: str) -> FlowMark:
        """The marks of a function, by its dotted name; of one of Python itself that is a bare name."""
        found = self._known.get(name)
        if found is None:
            said = self._said(tuple(name.split(".")), _DEPTH)
            found = self._known[name] = said.own or said.whole or NO_MARK
        return found

    def tells(self, name: str) -> bool:
        """Whether a stub describes this name, or a mark is about what it is a part of; where that is known of a part already, it tells no more."""
        found = self._told.get(name)
        if found is None:
            parts = tuple(name.split("."))
            said = self._said(parts, _DEPTH)
            above = len(parts) > 1 and said.whole is not None and self._said(parts[:-1], _DEPTH).found
            found = self._told[name] = said.found or above or self._is_package("/".join(parts))
        return found

    def _is_package(self, path: str) -> bool:
        return any(self._packages.get((folder, path)) for folder in self._folders)

    def _said(self, parts: tuple[str, ...], depth: int) -> _Said:
        if not depth or len(parts) > _LONGEST or not all(part.isidentifier() for part in parts):
            return _NOTHING
        whole: FlowMark | None = None
        deepest, found = 0, False
        for folder in self._folders:
            for length in range(self._deepest(folder, parts), 0, -1):
                module = self._module(folder, "/".join(parts[:length]))
                if module is None:
                    continue
                said = self._in_module(module, parts[length:], depth)
                if said.own is not None:
                    return said
                found = found or said.found
                if length > deepest:  # what is said of a package is not said of a module in it that is described itself
                    whole, deepest = said.whole, length
                elif length == deepest:
                    whole = whole or said.whole
        if not deepest and parts[0] != _BUILTINS:
            return self._said((_BUILTINS, *parts), depth - 1)
        return _Said(None, whole, found)

    def _in_module(self, module: Scope, rest: tuple[str, ...], depth: int) -> _Said:
        scope, whole = module, module.mark
        for number, part in enumerate(rest, 1):
            inner = scope.member(part, module)
            if inner is None:
                break
            if inner.alias:
                return self._said((*inner.alias.split("."), *rest[number:]), depth - 1)
            if number == len(rest):
                made = inner.inner.get("__init__") if inner.is_class else None
                own = (made.mark if made is not None else None) or inner.mark
                if own is None and inner.writes and whole is not None and whole.pure:
                    own = whole._replace(changes=("self",))
                return _Said(own, whole, found=True)
            if inner.is_class:
                scope, whole = inner, inner.mark or whole
                continue
            given = module.inner.get(inner.gives)
            if given is None:
                break
            if given.alias:
                return self._said((*given.alias.split("."), *rest[number:]), depth - 1)
            scope, whole = given, given.mark or whole
        return _Said(None, whole, found=not rest)

    def _deepest(self, folder: Path, parts: tuple[str, ...]) -> int:
        """So many of these may name a module there: behind what is no folder nothing is looked for."""
        path = ""
        for length, part in enumerate(parts, 1):
            path = f"{path}/{part}" if path else part
            key = (folder, path)
            if key not in self._packages:
                self._packages[key] = disk.is_folder(folder / path)
            if not self._packages[key]:
                return length
        return len(parts)

    def _module(self, folder: Path, path: str) -> Scope | None:
        key = (folder, path)
        if key not in self._modules:
            self._modules[key] = next(filter(None, map(_read, _files(folder, path))), None)
        return self._modules[key]


def _files(folder: Path, path: str) -> tuple[Path, Path]:
    return folder / f"{path}.pyi", folder / path / "__init__.pyi"


def _read(file: Path) -> Scope | None:
    tree = _tree(file)
    return None if tree is None else scope_of(tree)


def _tree(file: Path) -> ast.Module | None:
    """A stub; None where there is none, where it has nothing of the notation, or cannot be read, which is told where it is imported."""
    if not disk.is_file(file):
        return None
    data = read_bytes(file, file.name, limits.STUB_FILE)
    if isinstance(data, Finding):
        return None
    try:
        return ast.parse(data)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def wrong_marks(folder: Path, prefix: str, is_known: Callable[[str], bool]) -> Iterator[Finding]:
    """What is wrong with the marks in the stubs of a folder; `is_known`: whether the notation of stubs has a name."""
    for name in stub_names(folder):
        file = folder / name
        tree = _tree(file) if _speaks(file, name) else None
        if tree is None:
            continue
        complaints: list[Wrong] = []
        scope_of(tree, complaints)
        for word, line in imports_of(tree).items():
            if not is_known(word):
                complaints.append(Wrong(line, f"{_NOTATION.decode()} has no {word}"))
        for line, message in sorted(complaints):
            yield Finding("RW214", message, Place(f"{prefix}{name}", line))


def _speaks(file: Path, name: str) -> bool:
    data = read_bytes(file, name, limits.STUB_FILE)
    return not isinstance(data, Finding) and _NOTATION in data
