# SPDX-License-Identifier: Apache-2.0
"""Which headers stand for the libraries that a program uses?

    models/cpp/headers/rclcpp/node.hpp      what rclcpp::Node does, in C++: a file "models:rclcpp/node.hpp" of every program

Each is read by itself: none includes another, as all of them are there. What the preprocessor leaves of them is the same in every run of one
installed rosward, and takes longer than to parse it: it is kept (`source/kept.py`).
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final

from rosward.findings import Finding
from rosward.frontends.cpp.parse import CppParser
from rosward.frontends.cpp.prepared import Prepared
from rosward.frontends.cpp.preprocess import Preprocessor
from rosward.frontends.cpp.store import Versions
from rosward.frontends.cpp.symbol_file import FileSymbols, Seen
from rosward.source.kept import kept

PREFIX: Final = "models:"
"""What the names of files that are models begin with."""

_HEADERS: Final = Path(__file__).parent.parent.parent / "models" / "cpp" / "headers"
YIELDING: Final = frozenset({"controller_interface", "hardware_interface", "nav2", "nav2_util"})
"""Libraries whose own sources count where they are there: they are written with the others."""
_NOT_OF_ROS: Final = frozenset({"std"})
_OF_ROS: Final = re.compile(r"rcl\w*/.*|[\w.]+/(?:msg|srv|action)/.*")

_OWN: Final[dict[tuple[tuple[str, tuple[int, int, int]], ...], tuple[FileSymbols, ...]]] = {}
"""The models under each set of versions: they and what is found in them never change, so that one run has them from the run before."""


def modelled() -> frozenset[str]:
    """The libraries of ROS that there are models of."""
    return frozenset(folder.name for folder in _folders()) - _NOT_OF_ROS


def of_ros(name: str, libraries: frozenset[str]) -> bool:
    """Whether a header is one of ROS where the folders of headers do not have it: of one of the libraries, or of an interface."""
    return name.partition("/")[0] in libraries or _OF_ROS.fullmatch(name) is not None


def model_headers(versions: Versions, parser: CppParser) -> Sequence[FileSymbols]:
    """The models, in a fixed order; read once."""
    key = tuple(sorted(versions.items()))
    if key not in _OWN:
        _OWN[key] = tuple(_read_all(versions, parser))
    return _OWN[key]


def _read_all(versions: Versions, parser: CppParser) -> list[FileSymbols]:
    seen = Seen()
    for prepared in _prepared(versions):
        parsed = parser.parse(prepared)
        if not isinstance(parsed, Finding):
            seen.files.append(FileSymbols(parsed, seen, source=False))
    return seen.files


def _prepared(versions: Versions) -> list[Prepared]:
    """The models without comments, directives and macros: as they were kept, where that can be."""
    told = json.dumps(sorted(versions.items())).encode()
    content = kept(f"headers.{hashlib.sha256(told).hexdigest()[:16]}", lambda: _written(_prepare(versions)))
    if content is None:
        return list(_prepare(versions))
    return [
        Prepared(str(_HEADERS / file.removeprefix(PREFIX)), file, text, expanded=frozenset(expanded))
        for file, text, expanded in json.loads(content)
    ]


def _written(headers: Iterator[Prepared]) -> bytes | None:
    """Headers of which there is nothing more to say than their text; None where there is of one."""
    entries = []
    for header in headers:
        if header != Prepared(header.path, header.file, header.text, expanded=header.expanded):
            return None
        entries.append((header.file, header.text, sorted(header.expanded)))
    return json.dumps(entries).encode()


def _prepare(versions: Versions) -> Iterator[Prepared]:
    preprocessor = Preprocessor(_read, _named, lambda *_: None, versions)
    for folder in _folders():
        for path in sorted(folder.rglob("*.hpp")):
            yield from preprocessor.translate(str(path), (), ()).files


def library_of(file: FileSymbols) -> str:
    """The library of a file of the models."""
    return file.parsed.prepared.file.removeprefix(PREFIX).partition("/")[0]


def _folders() -> list[Path]:
    return sorted(p for p in _HEADERS.iterdir() if p.is_dir()) if _HEADERS.is_dir() else []


def _read(path: str) -> str:
    return Path(path).read_text(encoding="utf-8")


def _named(path: str) -> str:
    return PREFIX + Path(path).relative_to(_HEADERS).as_posix()
