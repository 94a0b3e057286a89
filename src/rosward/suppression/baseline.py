# SPDX-License-Identifier: Apache-2.0
"""The findings that are already known.

{"version": 2, "findings": [{"fingerprint": "3f2a…", "code": "RW102", "file": "src/talker.py", "message": "…"}]}

Only the fingerprints count; the rest is for people who read a change of the file. Line numbers are not part of it, so it changes only when
findings do. The fingerprints of version 1 depended on the words of messages: its entries are recognised by code, file and what the message names.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rosward.findings import Finding
from rosward.source import limits
from rosward.source.text import read_bytes
from rosward.suppression.fingerprints import BaselineEntry, fingerprints_without_line

if TYPE_CHECKING:
    from rosward.suppression.judge import Judged

__all__ = ["BaselineError", "baseline_text", "read_baseline"]

_VERSION: Final = 2
_OF_WORDS: Final = 1
"""The version whose fingerprints depended on the words of messages."""


class BaselineError(Exception):
    """The file is no baseline; the message says why."""


def read_baseline(path: str | Path) -> frozenset[str]:
    """The fingerprints of a baseline; of version 1 those without the text of the line. Raises BaselineError."""
    data = read_bytes(path, str(path), limits.BASELINE_FILE)
    if isinstance(data, Finding):
        raise BaselineError(f"{path}: {data.message}")
    try:
        document = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise BaselineError(f"{path}: not valid JSON: {error}") from error
    version = document.get("version") if isinstance(document, dict) else None
    entries = document.get("findings") if version in (_VERSION, _OF_WORDS) else None
    if not isinstance(entries, list):
        raise BaselineError(f"{path}: not a baseline of version {_VERSION} written by --write-baseline")
    found = [entry.get("fingerprint") if isinstance(entry, dict) else None for entry in entries]
    if not all(isinstance(fingerprint, str) for fingerprint in found):
        raise BaselineError(f"{path}: a finding without a fingerprint")
    if version == _OF_WORDS:
        described = [
            BaselineEntry(*(str(entry.get(key, "")) for key in ("code", "file", "message"))) for entry in entries
        ]
        return frozenset(fingerprints_without_line(described))
    return frozenset(str(fingerprint) for fingerprint in found)


def baseline_text(judged: Iterable[Judged]) -> str:
    """The baseline that holds these findings."""
    entries = [
        {"fingerprint": j.fingerprint, "code": j.finding.code, "file": j.file, "message": j.finding.message}
        for j in judged
    ]
    entries.sort(key=lambda e: (e["file"], e["code"], e["message"], e["fingerprint"]))
    return json.dumps({"version": _VERSION, "findings": entries}, indent=2) + "\n"
