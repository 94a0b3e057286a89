# SPDX-License-Identifier: Apache-2.0
"""The laws of suspended calls: a join covers both sides, whatever points they are at, and comes to rest."""

from __future__ import annotations

from hypothesis import given

from domain.covering import suspension_covers
from domain.strategies import FUNCTIONS, LOOP, suspensions
from rosward.domain.choice import join, widen
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.state import join_objects
from rosward.domain.suspended import EACH, NO_TURN, PathStep, Point, Suspension, join_suspended
from rosward.domain.values import NONE, UNBOUND, Const


def test_covers_tells_apart() -> None:
    """The law is not empty: what lacks a point, a value, an item ahead or the end does not cover."""
    point = Point(FUNCTIONS[0], 0, (), (PathStep(0, EACH, 0), PathStep(0, "")))
    held = (Const(1), Const(2), NONE, Tuple((Const("a"),)), UNBOUND)
    one = Suspension({point: held})
    assert suspension_covers(one, one)
    assert not suspension_covers(Suspension({}), one)
    assert not suspension_covers(one, Suspension({}, ended=True))
    assert not suspension_covers(Suspension({point: (Const(0), *held[1:])}), one)
    assert not suspension_covers(Suspension({point: (*held[:3], Tuple(()), UNBOUND)}), one)
    assert not suspension_covers(Suspension({point._replace(function=FUNCTIONS[1]): held}), one)
    anyway = Suspension({point.syntactic: (*held[:3], Tuple(()), Const("a"))})
    assert suspension_covers(anyway, one)
    assert not suspension_covers(one, anyway)


@given(suspensions(), suspensions())
def test_join_covers_both(left: Suspension, right: Suspension) -> None:
    joined = join_suspended(left, right)
    assert suspension_covers(joined, left)
    assert suspension_covers(joined, right)


@given(suspensions(), suspensions())
def test_widening_covers_both(left: Suspension, right: Suspension) -> None:
    widened = join_suspended(left, right, lambda a, b: widen(a, b, LOOP))
    assert suspension_covers(widened, left)
    assert suspension_covers(widened, right)


@given(suspensions(), suspensions())
def test_join_gives_back_what_covers_already(left: Suspension, right: Suspension) -> None:
    joined = join_suspended(left, right)
    assert join_suspended(left, left) is left
    assert join_suspended(joined, right) is joined
    assert join_suspended(joined, left) is joined


@given(suspensions(), suspensions())
def test_join_is_commutative(left: Suspension, right: Suspension) -> None:
    """Each order covers the other one."""
    one, other = join_suspended(left, right), join_suspended(right, left)
    assert suspension_covers(one, other)
    assert suspension_covers(other, one)


@given(suspensions(), suspensions())
def test_records_are_joined_by_their_points(left: Suspension, right: Suspension) -> None:
    joined = join_objects(Obj("generator", NONE, payload=left), Obj("generator", NONE, payload=right), join)
    assert isinstance(joined.payload, Suspension)
    assert suspension_covers(joined.payload, left)
    assert suspension_covers(joined.payload, right)


def test_too_many_turns_become_any_turn() -> None:
    """A generator that is advanced without end has finitely many points."""
    found = Suspension({})
    for turn in range(200):
        point = Point(FUNCTIONS[0], 0, (), (PathStep(0, EACH, turn), PathStep(0, "", NO_TURN)))
        one = Suspension({point: (Const(turn), NONE, NONE, Tuple(()), Const("x"))})
        found = join_suspended(found, one)
        assert suspension_covers(found, one)
        assert len(found.points) <= 32
