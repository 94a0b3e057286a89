# SPDX-License-Identifier: Apache-2.0
"""What do the JSON documents have in common? Their head, and how a place and a finding stand in them.

header(1)                        {"schema_version": 1, "generator": {"name": "rosward", "version": "0.1.0"}}
place_row(Place("a.py", 3, 9))   {"file": "a.py", "line": 3}
"""

from __future__ import annotations

from rosward._version import __version__
from rosward.findings import Finding
from rosward.location import Place

__all__ = ["finding_row", "header", "place_row"]


def header(schema_version: int) -> dict[str, object]:
    """What a document begins with."""
    return {"schema_version": schema_version, "generator": {"name": "rosward", "version": __version__}}


def place_row(place: Place) -> dict[str, object]:
    """A place as file and line."""
    return {"file": place.file, "line": place.line}


def finding_row(finding: Finding) -> dict[str, object]:
    """What every document says of a finding; some say more."""
    return {
        "code": finding.code,
        "severity": finding.rule.severity.value,
        "message": finding.message,
        **place_row(finding.place),
    }
