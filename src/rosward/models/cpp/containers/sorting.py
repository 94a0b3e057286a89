# SPDX-License-Identifier: Apache-2.0
"""In which order do values stand when they are sorted: by what they are, or by what a callable says of two of them?"""

from __future__ import annotations

from rosward.domain.choice import join_all
from rosward.domain.series import Series
from rosward.domain.values import Value
from rosward.models.asked_order import by_asking
from rosward.models.cpp.values.ordering import MOST_ASKED, in_order
from rosward.models.cpp.values.slots import key_of
from rosward.models.native import Machine

__all__ = ["sorted_values"]


def sorted_values(machine: Machine, series: Series, function: Value | None) -> Series:
    """The elements in order; each place may hold any of them where the order is not known."""
    if not series.exact:
        if function is not None and (element := series.element()) is not None:
            machine.call(function, (element, element))
        return series.loose()
    values = list(series.head)
    order = in_order(machine, [key_of(machine, value) for value in values]) if function is None else None
    if order is None:

        def less(a: Value, b: Value) -> bool | None:
            answer = machine.compare("<", a, b) if function is None else machine.call(function, (a, b))
            return machine.truth(answer)

        order = by_asking(values, less, MOST_ASKED)
    if order is None:
        return Series((join_all(values),) * len(values))
    return Series(tuple(values[n] for n in order))
