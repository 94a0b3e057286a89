# SPDX-License-Identifier: Apache-2.0
"""In which order do values stand when they are sorted: by what they are, or by what a callable says of two of them?"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all
from rosward.domain.series import Series
from rosward.domain.values import Value
from rosward.models.cpp.ordering import in_order
from rosward.models.cpp.slots import key_of
from rosward.models.native import Machine

__all__ = ["sorted_values"]

_MOST_ASKED: Final = 30


def sorted_values(machine: Machine, series: Series, function: Value | None) -> Series:
    """The elements in order; each place may hold any of them where the order is not known."""
    if not series.exact:
        if function is not None and (element := series.element()) is not None:
            machine.call(function, (element, element))
        return series.loose()
    values = list(series.head)
    order = in_order([key_of(machine, value) for value in values]) if function is None else None
    if order is None:
        order = _by_asking(machine, values, function)
    if order is None:
        return Series((join_all(values),) * len(values))
    return Series(tuple(values[n] for n in order))


def _by_asking(machine: Machine, values: list[Value], function: Value | None) -> list[int] | None:
    """The indices in order, asked of each pair that decides; None where one answer is not known."""
    if len(values) > _MOST_ASKED:
        return None
    placed: list[int] = []
    for number, value in enumerate(values):
        at = len(placed)
        while at:
            other = values[placed[at - 1]]
            answer = machine.compare("<", value, other) if function is None else machine.call(function, (value, other))
            less = machine.truth(answer)
            if less is None:
                return None
            if not less:
                break
            at -= 1
        placed.insert(at, number)
    return placed
