# SPDX-License-Identifier: Apache-2.0
"""The order of things that say themselves which of two goes first: `__lt__`, `operator<`, a comparison that is handed along."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rosward.domain.values import Value


def by_asking(values: Sequence[Value], less: Callable[[Value, Value], bool | None], most: int) -> list[int] | None:
    """The indices in order, asked of each pair that decides; None where one answer is not known, or there are more than `most` values."""
    if len(values) > most:
        return None
    placed: list[int] = []
    for number, value in enumerate(values):
        at = len(placed)
        while at:
            answer = less(value, values[placed[at - 1]])
            if answer is None:
                return None
            if not answer:
                break
            at -= 1
        placed.insert(at, number)
    return placed
