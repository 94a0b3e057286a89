# SPDX-License-Identifier: Apache-2.0
"""Pages of which one is known to cover the other are not looked at again, unless somebody writes to one of them."""

from __future__ import annotations

from rosward.domain.choice import join
from rosward.domain.heap import Obj
from rosward.domain.memory import Heap
from rosward.domain.state import join_objects
from rosward.domain.values import Const


def cell(value: int) -> Obj:
    """A cell that holds a number."""
    return Obj("cell", Const(None), {"value": Const(value)})


def covers(left: Heap, right: Heap, asked: list[Obj]) -> tuple[int, bool]:
    """Join the right one into the left one; what is compared is noted."""

    def merge(ours: Obj, theirs: Obj) -> Obj:
        asked.append(theirs)
        return join_objects(ours, theirs, join)

    return left.cover(right, merge)


def test_a_known_page_counts_as_before_and_is_not_compared() -> None:
    """The number of differing objects is the same; nothing is merged."""
    left = Heap([(0, cell(1)), (1, cell(2))])
    right = left.copy()
    left[0], right[0] = cell(1), cell(1)
    asked: list[Obj] = []
    assert covers(left, right, asked) == (1, False)
    assert len(asked) == 1
    assert covers(left, right, asked) == (1, False)
    assert len(asked) == 1


def test_who_writes_to_a_known_page_is_seen() -> None:
    """On either side."""
    left = Heap([(0, cell(1)), (1, cell(2))])
    right = left.copy()
    left[0], right[0] = cell(1), cell(1)
    covers(left, right, [])
    right[1] = cell(3)
    assert covers(left, right, []) == (2, True)
    assert left.get(1) is not None
    left[0] = cell(4)
    assert covers(left, right, [])[1]
