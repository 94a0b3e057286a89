# SPDX-License-Identifier: Apache-2.0
"""Is the result of an extraction known already?

    question_of(paths=("ws",), distro="jazzy", …)      the same bytes for the same question
    kept_result(store, question)                       the result, if all that was seen of the disk for it is still so; else None

A result is kept with each look that its extraction took at the disk (`source/disk.py`), also at what is not there. Nothing else counts but the
question, the working directory, and this program (`version.py`).
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Set
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from rosward.cache.codec import NUMBER, TEXT, Json, MalformedError, loaded, mapping, pair, sequence, text
from rosward.cache.records import NETWORK, SYSTEMS
from rosward.cache.version import version_key
from rosward.records import replace
from rosward.result import Result
from rosward.rules import INTERNAL_ERROR, KILLED, TIME_LIMIT
from rosward.source.disk import Look, Trace, by_how, digest, holds, looks_of, tear
from rosward.source.workspace import SourceFile

if TYPE_CHECKING:
    from rosward.cache.store import Store
    from rosward.findings import Finding

__all__ = ["keep_result", "kept_result", "question_of", "read_looks", "written_looks"]

_KIND: Final = "result"
_FILES: Final = sequence(pair(TEXT, TEXT))
_LOOKS: Final = mapping(mapping(TEXT))
_PARTS: Final = 5
_COUNTS: Final = 3


def question_of(**arguments: object) -> bytes:
    """The same bytes for the same arguments, asked in the same folder of the same program. Raises TypeError for what has no plain form."""
    return text([version_key(), os.getcwd(), _plain(arguments)])  # noqa: PTH109


def _plain(value: Any) -> Json:
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, Mapping):
        return {"map": [[_plain(key), _plain(each)] for key, each in value.items()]}
    if isinstance(value, Set):
        return {"set": sorted(map(_plain, value))}
    if isinstance(value, (tuple, list)):
        return [type(value).__name__, *map(_plain, value)]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "__match_args__"):  # a record
        return {type(value).__name__: [_plain(getattr(value, name)) for name in value.__match_args__]}
    raise TypeError(f"{type(value)} has no plain form")


def kept_result(store: Store, question: bytes) -> Result | None:
    """The result that is known of a question."""
    return store.kept(_KIND, question, partial(_read, question))


def keep_result(store: Store, question: bytes, result: Result, trace: Trace) -> Result:
    """Keep a result, unless another run may find something else; the result, with what it is kept as."""
    if any(map(_depends_on_the_machine, result.findings)):
        tear()
        return result
    if trace.torn:
        return result
    try:
        written = text(_written(result))
        store.keep(_KIND, question, b"\n".join((digest(question).encode(), written_looks(trace.seen), written)))
    except ValueError:  # a number of thousands of digits
        return result
    return replace(result, kept_as=digest(written))


def _read(question: bytes, answer: bytes) -> Result | None:
    asked, looks, written = (*answer.split(b"\n", 2), b"", b"")[:3]
    try:
        if asked != digest(question).encode() or not holds(read_looks(looks)):
            return None
        return replace(_result(loaded(written)), kept_as=digest(written))
    except MalformedError:
        return None


def _depends_on_the_machine(finding: Finding) -> bool:
    return finding.code == INTERNAL_ERROR or (
        finding.code == "RW201" and any(each in finding.message for each in (KILLED, TIME_LIMIT))
    )


# As a document


def written_looks(seen: Mapping[Look, str]) -> bytes:
    """What was seen, in one line."""
    return text(by_how(seen))


def read_looks(line: bytes) -> dict[Look, str]:
    """The same again. Raises MalformedError."""
    found = _LOOKS.read(loaded(line))
    return looks_of(found)


def _written(result: Result) -> Json:
    files = tuple((os.fspath(file.path), file.relative) for file in result.files)
    counts = [result.excluded, result.ignored, result.launch_files]
    root = os.fspath(result.root)
    return [root, NETWORK.write(result.network), _FILES.write(files), SYSTEMS.write(result.systems), counts]


def _result(document: Json) -> Result:
    if document.__class__ is not list or len(document) != _PARTS or document[-1].__class__ is not list:
        raise MalformedError
    root, network, files, systems, counts = document
    if len(counts) != _COUNTS:
        raise MalformedError
    return Result(
        NETWORK.read(network),
        Path(TEXT.read(root)),
        tuple(SourceFile(Path(path), relative) for path, relative in _FILES.read(files)),
        SYSTEMS.read(systems),
        NUMBER.read(counts[0]),
        NUMBER.read(counts[1]),
        NUMBER.read(counts[2]),
    )
