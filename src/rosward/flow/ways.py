# SPDX-License-Identifier: Apache-2.0
"""Several ways on from one place, of which one is taken: the bodies a call may run, the calls a body may have.

law->law(x);     each class that the object may have is a way, from the same state
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from rosward.flow.marks import Mark

if TYPE_CHECKING:
    from rosward.flow.walker import Walker

Way = Callable[[], Mark]


def joined_marks(several: Sequence[list[Mark]]) -> list[Mark]:
    """The marks of the parameters of several calls, taken together; the longest list gives the length."""
    found = list(several[0])
    for each in several[1:]:
        for number, mark in enumerate(each):
            if number < len(found):
                found[number] = found[number].joined(mark)
            else:
                found.append(mark)
    return found


def each_way(walker: Walker, ways: Sequence[Way]) -> Mark | None:
    """Each way from the same state: what they return, joined; None without any. Behind it stands what any of them left."""
    if not ways:
        return None
    if len(ways) == 1:
        return ways[0]()
    before, after, result = walker.memory, None, None
    for way in ways:
        walker.memory = before.copy()
        given = way()
        result = given if result is None else result.joined(given)
        if after is None:
            after = walker.memory
        else:
            after.join(walker.memory)
    assert after is not None
    walker.memory = after.current()
    return result


def either(one: Mark | None, other: Mark | None) -> Mark | None:
    """Both, where there are both."""
    if one is None or other is None:
        return one if other is None else other
    return one.joined(other)
