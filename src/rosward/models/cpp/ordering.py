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
from rosward.models.cpp.types import argument, name_of
from rosward.models.native import Machine
from rosward.models.python.operators.compare import equal
from rosward.models.python.plain import NOT_PLAIN, plain

__all__ = ["foremost", "in_order", "unique"]

_MOST: Final = 300


def in_order(values: list[Value], cls: Value | None = None) -> list[int] | None:
    """The indices of values in the order of a container of this class, else ascending; None where it is not known, or they cannot be compared."""
    if len(values) < 2:
        return list(range(len(values)))
    reverse = False if cls is None else _is_reversed(cls)
    ranks: list[Any] = [plain(value) for value in values]
    if reverse is None or any(rank is NOT_PLAIN or rank is None for rank in ranks):
        return None
    try:
        return sorted(range(len(values)), key=lambda n: ranks[n], reverse=reverse)
    except TypeError:
        return None


def foremost(series: Series, cls: Value) -> int | None:
    """Which element of a priority queue of this class comes first; None where that is not known."""
    order = in_order(list(series.head), cls) if series.exact else None
    return order[-1] if order else None


def _is_reversed(cls: Value) -> bool | None:
    """Whether a container has what it holds in descending order; None where it is compared by something of the program."""
    compared = name_of(argument(cls, _COMPARED.get(name_of(cls), _NOWHERE)))
    return compared == "std.greater" if compared in ("auto", "std.less", "std.greater") else None


_NOWHERE: Final = 9
_COMPARED: Final = {"std.map": 2, "std.multimap": 2, "std.priority_queue": 2, "std.set": 1, "std.multiset": 1}
"""Which argument of a template says how its keys are compared."""


def unique(machine: Machine, series: Series, cls: Value, *, several: bool = False) -> Series:
    """The elements of a set of this class made of these, in order; `several`: of one that keeps equal ones."""
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
    order = in_order(kept, cls)
    if order is None:
        return Series(tuple(kept)) if len(kept) < 2 or any(_is_object(v) for v in kept) else Series((), join_all(kept))
    return Series(tuple(kept[n] for n in order))


def _varies(value: Value) -> bool:
    """Whether a value stands for several, so that it is not the same as itself."""
    return isinstance(value, (Choice, Unknown, Text)) or (isinstance(value, Tuple) and any(map(_varies, value.items)))


def _is_object(value: Value) -> bool:
    return not isinstance(value, (Const, Text, Tuple, Unknown, Choice))
