# SPDX-License-Identifier: Apache-2.0
"""By what is a finding known again when the file around it changes?

    src/talker.py:20  RW102 'a' of src/talker.py:12 is not known   ->  3f2a90c1…
    src/talker.py:31  the same, after eleven lines were added      ->  3f2a90c1…

A hash of code, file, message and the text of the line, in which no line number and no indentation counts; findings that are equal in all
of these are numbered in their order.
"""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from collections.abc import Callable, Sequence
from typing import Final

from rosward.findings import Finding

__all__ = ["LineAt", "fingerprints"]

LineAt = Callable[[str, int], str]
"""The text of a line of a file, as places name both; empty where there is none."""

_PLACE: Final = re.compile(r"(?<![\w./-])(?:[\w.-]*/)*([\w.-]+):\d+(?::\d+)?(?!\d)")
_LINE: Final = re.compile(r"(?<=\bline )\d+")
_LENGTH: Final = 32


def fingerprints(findings: Sequence[Finding], line_at: LineAt, prefix: str = "") -> list[str]:
    """One for each finding, in the same order. `prefix` is the folder of the places below the root of the repository."""
    seen: Counter[str] = Counter()
    by_finding: dict[Finding, str] = {}
    for finding in sorted(set(findings), key=lambda f: (f.place, f.code, f.message)):
        place = finding.place
        line = line_at(place.file, place.line) if place.line else ""
        parts = (finding.code, prefix + place.file, " ".join(line.split()), _bare(finding.message))
        text = "\0".join(parts)
        seen[text] += 1
        digest = hashlib.sha256(f"{text}\0{seen[text]}".encode("utf-8", "backslashreplace")).hexdigest()
        by_finding[finding] = digest[:_LENGTH]
    return [by_finding[finding] for finding in findings]


def _bare(message: str) -> str:
    """The message without line numbers, and with files by their last name: the rest of it depends on which folder is analysed."""
    return _LINE.sub("", _PLACE.sub(r"\1", message))
