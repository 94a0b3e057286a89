# SPDX-License-Identifier: Apache-2.0
"""Which findings were there before?

{"version": 1, "findings": [{"fingerprint": "3f2a…", "code": "RW102", "file": "src/talker.py", "message": "…"}]}

Only the fingerprints count; the rest is for people who read a change of the file. Lines have no part in it, so it changes only when findings do.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rosward.findings import Finding
from rosward.source import limits
from rosward.source.text import read_bytes

if TYPE_CHECKING:
    from rosward.suppression.judge import Judged

__all__ = ["BaselineError", "baseline_text", "read_baseline"]

_VERSION: Final = 1


class BaselineError(Exception):
    """The file is no baseline; the message says why."""


def read_baseline(path: str | Path) -> frozenset[str]:
    """The fingerprints of a baseline. Raises BaselineError."""
    data = read_bytes(path, str(path), limits.BASELINE_FILE)
    if isinstance(data, Finding):
        raise BaselineError(f"{path}: {data.message}")
    try:
        document = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise BaselineError(f"{path}: this is no JSON: {error}") from error
    entries = document.get("findings") if isinstance(document, dict) and document.get("version") == _VERSION else None
    if not isinstance(entries, list):
        raise BaselineError(f"{path}: this is no baseline of version {_VERSION}, as --write-baseline writes it")
    found = [entry.get("fingerprint") if isinstance(entry, dict) else None for entry in entries]
    if not all(isinstance(fingerprint, str) for fingerprint in found):
        raise BaselineError(f"{path}: a finding without a fingerprint")
    return frozenset(str(fingerprint) for fingerprint in found)


def baseline_text(judged: Iterable[Judged]) -> str:
    """The baseline that holds these findings."""
    entries = [
        {"fingerprint": j.fingerprint, "code": j.finding.code, "file": j.file, "message": j.finding.message}
        for j in judged
    ]
    entries.sort(key=lambda e: (e["file"], e["code"], e["message"], e["fingerprint"]))
    return json.dumps({"version": _VERSION, "findings": entries}, indent=2) + "\n"
