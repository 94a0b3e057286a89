# SPDX-License-Identifier: Apache-2.0
"""What of a result does a page get? A few numbers for the list, which is sent at each change; the page of one result gets all."""

from __future__ import annotations

from collections.abc import Mapping

from rosward.safe import encodable
from rosward.server.results import StoredResult

__all__ = ["in_short", "numbers_of"]


def in_short(result: StoredResult, *, watched: bool) -> dict[str, object]:
    """One row of the list."""
    return {
        "id": result.id,
        "title": encodable(result.source.title),
        "kind": result.source.kind,
        "settings": encodable(result.settings.words()),
        "group": result.group,
        "created": result.created,
        "state": result.state,
        "message": encodable(result.message),
        "automatic": result.automatic,
        "watched": watched,
        "step": None if result.step is None else result.step._asdict(),
        "numbers": numbers_of(result.summary) if result.state == "done" else [],
        "complete": bool(result.summary.get("complete", False)),
    }


def numbers_of(summary: Mapping[str, object]) -> list[str]:
    """`2 nodes`, `1 topic`, `3 errors`: what is not zero."""
    findings = summary.get("findings")
    weights = findings if isinstance(findings, dict) else {}
    rows = [(summary.get(f"{word}s"), word) for word in ("node", "topic", "service", "action")]
    rows += [(weights.get(word), word) for word in ("error", "warning")]
    return [
        f"{number:,} {word}{'' if number == 1 else 's'}" for number, word in rows if isinstance(number, int) and number
    ]
