# SPDX-License-Identifier: Apache-2.0
"""How a finding is recognised again when the file around it changes, or the wording of its message.

    src/talker.py:20  RW102 the name 'a' of src/talker.py:12 is unknown   ->  3f2a90c1…
    src/talker.py:31  the same, after eleven lines were added             ->  3f2a90c1…

A hash of code, file, the text of the line and what the message names. Line numbers, indentation and the words of the message are not part
of it. Findings that are equal in all of these are numbered in their order.
"""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from typing import Final

from rosward.findings import Finding
from rosward.records import NamedTuple

__all__ = ["BaselineEntry", "LineAt", "fingerprints", "fingerprints_without_line"]

LineAt = Callable[[str, int], str]
"""The text of a line of a file, as places name both; empty where there is none."""


class BaselineEntry(NamedTuple):
    """What an entry of a baseline says of a finding."""

    code: str
    file: str
    message: str


_PLACE: Final = re.compile(r"(?<![\w./-])(?:[\w.-]*/)*([\w.-]+):\d+(?::\d+)?(?!\d)")
_LINE: Final = re.compile(r"(?<=\bline )\d+")
_QUOTED: Final = re.compile(r"(?<!\w)'[^']*'(?!\w)|`[^`]*`")
_CAMEL: Final = re.compile(r"[a-z][A-Z]")
_PUNCTUATION: Final = "!\"'(),.:;?…"
_ROLES: Final = frozenset(
    {"publisher", "subscription", "server", "client", "publish", "subscribe", "request", "reply", "call", "execute"}
)
"""Words of ROS that tell findings about one name apart."""

_LENGTH: Final = 32


def fingerprints(findings: Sequence[Finding], line_at: LineAt, prefix: str = "") -> list[str]:
    """One for each finding, in the same order. `prefix` is the folder of the places below the root of the repository."""
    ordered = sorted(set(findings), key=lambda f: (f.place, f.code, f.message))
    lines = (line_at(f.place.file, f.place.line) if f.place.line else "" for f in ordered)
    parts = (
        (f.code, prefix + f.place.file, " ".join(line.split()), *_names(f.message.removesuffix(f.remedy)))
        for f, line in zip(ordered, lines, strict=True)
    )
    by_finding = dict(zip(ordered, _numbered(parts), strict=True))
    return [by_finding[finding] for finding in findings]


def fingerprints_without_line(entries: Sequence[BaselineEntry]) -> list[str]:
    """By code, file and what the message names alone: all that a baseline of version 1 says, whose own hashes depend on words."""
    return list(_numbered(("", each.code, each.file, *_names(each.message)) for each in entries))


def _numbered(each: Iterable[tuple[str, ...]]) -> Iterable[str]:
    seen: Counter[str] = Counter()
    for parts in each:
        text = "\0".join(parts)
        seen[text] += 1
        yield hashlib.sha256(f"{text}\0{seen[text]}".encode("utf-8", "backslashreplace")).hexdigest()[:_LENGTH]


def _names(message: str) -> list[str]:
    """What a message names: quoted texts, names of ROS, files by their last part, numbers, identifiers; no words of English, no options."""
    bare = _LINE.sub("", _PLACE.sub(r"\1", message))
    words = (word.strip(_PUNCTUATION) for word in _QUOTED.sub(" ", bare).split())
    named = {word for word in words if word in _ROLES or (_is_name(word) and not word.startswith("--"))}
    return sorted({*named, *(quoted[1:-1] for quoted in _QUOTED.findall(bare))})


def _is_name(word: str) -> bool:
    return any(not (c.isalpha() or c == "-") for c in word) or _CAMEL.search(word) is not None
