# SPDX-License-Identifier: Apache-2.0
"""The laws of suspended calls: a join covers both sides, whatever points they are at, and comes to rest."""

from __future__ import annotations

from typing import Final

from hypothesis import given
from hypothesis import strategies as st

from domain.strategies import LOOP, covers, values
from rosward.domain.choice import join, options, widen
from rosward.domain.heap import Obj
from rosward.domain.suspended import ANY_TURN, EACH, KEPT, NO_TURN, Point, Step, Suspension, add_points, join_suspended
from rosward.domain.values import NONE, UNBOUND, Const, Function, ModuleValue, Tuple, Value
from rosward.engine.state import join_objects
from rosward.ir.program import Code, CodeKind, Parameters

REGISTERS: Final = 2
_NOTHING: Final = Parameters((), 0, None, (), None)
CODES: Final = tuple(
    Code(CodeKind.FUNCTION, name, name, "a.py", 1, _NOTHING, [], REGISTERS, (), (), (), is_generator=True)
    for name in ("one", "two")
)
FUNCTIONS: Final = tuple(Function(code, ModuleValue(0, "m", "a.py"), (), (), ()) for code in CODES)


@st.composite
def entries(draw: st.DrawFn) -> tuple[Point, tuple[Value, ...]]:
    """A point, and what it holds: outside of loops, or in a turn of one."""
    function = draw(st.sampled_from(FUNCTIONS))
    held = tuple(draw(st.lists(values, min_size=REGISTERS, max_size=REGISTERS)))
    if draw(st.booleans()):
        return Point(function, 0, (), (Step(draw(st.integers(0, 2)), ""),)), held
    turn = draw(st.sampled_from((0, 1, ANY_TURN)))
    ahead = () if turn == ANY_TURN else tuple(draw(st.lists(values, max_size=2)))
    rest = draw(st.one_of(st.just(UNBOUND), values))
    return Point(function, 0, (), (Step(0, EACH, turn), Step(0, ""))), (*held, NONE, Tuple(ahead), rest)


@st.composite
def suspensions(draw: st.DrawFn) -> Suspension:
    """As a run makes them: where a yield may be in any turn, that is the only one of its points."""
    return Suspension(add_points({}, dict(draw(st.lists(entries(), max_size=4)))), ended=draw(st.booleans()))


def suspension_covers(above: Suspension, below: Suspension) -> bool:
    """Whether each point at which one may stand is one of the other, in the same turn or in any, with what it holds."""
    if below.ended and not above.ended:
        return False
    return all(_covered(above, point, held) for point, held in below.points.items())


def _covered(above: Suspension, point: Point, held: tuple[Value, ...]) -> bool:
    same = above.points.get(point)
    if same is not None and all(map(covers, same[:REGISTERS], held)):
        return len(held) == REGISTERS or _ahead_covers(same, held, exact=True) or _ahead_covers(same, held, exact=False)
    anyway = above.points.get(point.syntactic)
    return (
        anyway is not None and all(map(covers, anyway[:REGISTERS], held)) and _ahead_covers(anyway, held, exact=False)
    )


def _ahead_covers(above: tuple[Value, ...], below: tuple[Value, ...], *, exact: bool) -> bool:
    """Whether what one loop has ahead is among what another one may have."""
    ahead, rest = above[REGISTERS + 1 : REGISTERS + KEPT]
    known, more = below[REGISTERS + 1 : REGISTERS + KEPT]
    if exact:
        return covers(ahead, known) and (more is UNBOUND or covers(rest, more))
    items = [i for o in options(known) if isinstance(o, Tuple) for i in o.items]
    return all(covers(rest, i) for i in [*items, *(() if more is UNBOUND else (more,))])


def test_covers_tells_apart() -> None:
    """The law is not empty: what lacks a point, a value, an item ahead or the end does not cover."""
    point = Point(FUNCTIONS[0], 0, (), (Step(0, EACH, 0), Step(0, "")))
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
        point = Point(FUNCTIONS[0], 0, (), (Step(0, EACH, turn), Step(0, "", NO_TURN)))
        one = Suspension({point: (Const(turn), NONE, NONE, Tuple(()), Const("x"))})
        found = join_suspended(found, one)
        assert suspension_covers(found, one)
        assert len(found.points) <= 32
