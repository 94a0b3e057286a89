# SPDX-License-Identifier: Apache-2.0
"""In which order do sets and maps have what they hold, and which of it is there but once?

std::set<std::string>{"b", "a", "b"}        'a', 'b'
std::set<std::string>{name, "b"}            any number of `name` and 'b', where it is not known whether they are the same
"""

from __future__ import annotations

from typing import Any, Final

from rosward.domain.choice import join_all
from rosward.domain.compound import Tuple
from rosward.domain.series import Series
from rosward.domain.values import Choice, Const, Text, Unknown, Value
from rosward.models.native import Machine
from rosward.models.python.operators.compare import equal
from rosward.models.python.plain import NOT_PLAIN, plain

__all__ = ["in_order", "unique"]

_MOST: Final = 300


def in_order(values: list[Value]) -> list[int] | None:
    """The indices of values in ascending order; None where it is not known, or they cannot be compared."""
    ranks: list[Any] = [plain(value) for value in values]
    if any(rank is NOT_PLAIN or rank is None for rank in ranks):
        return list(range(len(values))) if len(values) < 2 else None
    try:
        return sorted(range(len(values)), key=lambda n: ranks[n])
    except TypeError:
        return None


def unique(machine: Machine, series: Series, *, several: bool = False) -> Series:
    """The elements of a set made of these, in order; `several`: of one that keeps equal ones."""
    if series.exact and len(series.head) < 2:
        return series
    if series.middle is not None or len(series.head) > _MOST:
        return series.loose()
    kept: list[Value] = []
    for item in series.head:
        answers = {equal(machine, item, other) for other in kept} if not several else set()
        if True in answers and not _varies(item):
            continue
        if answers - {False} or _varies(item):
            return Series((), join_all(series.head))
        kept.append(item)
    order = in_order(kept)
    if order is None:
        return Series(tuple(kept)) if len(kept) < 2 or any(_is_object(v) for v in kept) else Series((), join_all(kept))
    return Series(tuple(kept[n] for n in order))


def _varies(value: Value) -> bool:
    """Whether a value stands for several, so that it is not the same as itself."""
    return isinstance(value, (Choice, Unknown, Text)) or (isinstance(value, Tuple) and any(map(_varies, value.items)))


def _is_object(value: Value) -> bool:
    return not isinstance(value, (Const, Text, Tuple, Unknown, Choice))
