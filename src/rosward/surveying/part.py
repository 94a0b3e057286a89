# SPDX-License-Identifier: Apache-2.0
"""What is known of one repository, as a file?

    {"part": 1, "key": "9f86…", "cpu": 1.25, "peak": 81264640, "ended": null, "sha256": "…"}    one line
    the rows of all tables                                                       JSON, compressed

The key is that of sources, options and the rosward that made it. A part that is cut off, damaged, of another form or not ours is none. Nothing
in it is executed, and no more is unpacked than a part may have.
"""

from __future__ import annotations

import gzip
import hashlib
import json
import math
import zlib
from collections.abc import Mapping
from typing import Any, Final

from rosward._version import __version__
from rosward.records import NamedTuple
from rosward.surveying.columns import TABLES, Row, row_is_valid
from rosward.surveying.job import Bounds, Job

__all__ = ["LARGEST", "Part", "Repository", "Rows", "failed", "key_of", "pack", "packed", "unpacked"]

_FORM: Final = 1
LARGEST: Final = 2**28
"""Bytes of a part as it is stored."""
_MOST_UNPACKED: Final = 2**31
_OF_ROWS: Final = {name: table.columns for name, table in TABLES.items()} | {
    "repositories": TABLES["repositories"].columns[1:]  # without the path, which another run may call otherwise
}

Rows = Mapping[str, list[Row]]


class Repository(NamedTuple):
    """The row of a repository, without its name and path."""

    state: str
    reason: str | None
    fault: bool
    complete: bool
    started: str | None
    files: int
    lines: int
    processes: int
    launch_files: int
    version: str
    options: str


class Part(NamedTuple):
    """A part: its key, what it cost, and its rows, still packed.

    `ended`: the bounds within which there was no result; None where there is one, which no bounds change.
    """

    key: str
    cpu: float
    peak: int | None
    body: bytes
    ended: Bounds | None = None

    def counts_for(self, bounds: Bounds, *, retry: bool) -> bool:
        """Whether another analysis of the same would give the same; with `retry` that is not taken for granted where it failed."""
        return bool(self.key) and (self.ended is None or (not retry and self.ended == bounds))

    def stored(self) -> bytes:
        """The content of its file."""
        digest = hashlib.sha256(self.body).hexdigest()
        head = {"part": _FORM, "key": self.key, "cpu": self.cpu, "peak": self.peak}
        head |= {"ended": self.ended, "sha256": digest}
        return json.dumps(head).encode() + b"\n" + self.body


def failed(
    job: Job, state: str, reason: str, *, key: str = "", fault: bool = False, cpu: float = 0.0, peak: int | None = None
) -> Part:
    """The part of a repository of which there is no result. One without a key is for this run alone."""
    options = job.options
    row = Repository(state, reason, fault, False, None, 0, 0, 0, 0, __version__, options.text())
    return Part(key, cpu, peak, pack(row, {}), job.bounds)


def key_of(job: Job, state: str) -> str:
    """What a part depends on: the rosward that makes it, the options, and the state of the sources."""
    return hashlib.sha256(json.dumps([_FORM, job.identity, job.options.text(), state]).encode()).hexdigest()


def pack(repository: Repository, rows: Rows) -> bytes:
    """The body of a part."""
    found = {**{name: [] for name in TABLES}, **rows, "repositories": [list(repository)]}
    text = json.dumps(found, ensure_ascii=False, separators=(",", ":"))
    return gzip.compress(text.encode(), mtime=0)


def packed(stored: bytes) -> Part | None:
    """The part that a file holds, its rows unread; None where it holds none."""
    line, mark, body = stored.partition(b"\n")
    try:
        head = json.loads(line)
        if not mark or head["part"] != _FORM or head["sha256"] != hashlib.sha256(body).hexdigest():
            return None
        key, cpu, peak, ended = (head[name] for name in ("key", "cpu", "peak", "ended"))
        bounds = None if ended is None else Bounds(*ended)
    except (ValueError, KeyError, TypeError, RecursionError):
        return None
    valid = isinstance(key, str) and type(cpu) is float and math.isfinite(cpu)
    valid = valid and (peak is None or (type(peak) is int and 0 <= peak < 2**63))
    return Part(key, cpu, peak, body, bounds) if valid else None


def unpacked(part: Part) -> Rows | None:
    """The rows of a part; None where they are not what the tables have."""
    unpacking = zlib.decompressobj(wbits=31)
    try:
        text = unpacking.decompress(part.body, _MOST_UNPACKED)
        found: Any = json.loads(text) if unpacking.eof else None
    except (ValueError, zlib.error, RecursionError):
        return None
    if not isinstance(found, dict) or found.keys() != TABLES.keys():
        return None
    valid = all(
        isinstance(rows, list) and all(row_is_valid(row, _OF_ROWS[name]) for row in rows)
        for name, rows in found.items()
    )
    return found if valid and len(found["repositories"]) == 1 else None
