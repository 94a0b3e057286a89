# SPDX-License-Identifier: Apache-2.0
"""Where a suspended generator may go on, and with which values.

    def names():                 before the first `next`: one point with an empty path
        for n in ('a', 'b'):     behind the first `yield`: the point (0 'item' turn 0)(0), its values the registers
            yield n              and what the loop still has ahead: ('b',)

A path leads through the structured blocks of the body to a `yield`, with the turn of each loop on the way. So a generator goes on where it
stands by running the rest of each block, from the inside out, and nothing has to be run a second time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Tuple
from rosward.domain.values import UNBOUND, Function, Value
from rosward.records import NamedTuple

Merge = Callable[[Value, Value], Value]

NO_TURN: Final = -1
ANY_TURN: Final = -2
"""Any number of turns has gone before."""

EACH: Final = "item"
"""The part of a loop over items; with `YIELD`, those parts of which values of their own are kept."""
YIELD: Final = "yield"
KEPT: Final = 3
"""How many values a loop over items, and a `yield from`, keep: what it runs over, the known items ahead, the join of all others."""

_MOST_TURNS: Final = 32
"""So many turns of one `yield` are told apart where it is not known which of them comes next."""


class PathStep(NamedTuple):
    """One step of a path: the operation number `number` of a block, in that the block `part`, in a loop its turn."""

    number: int
    part: str
    turn: int = NO_TURN


Path = tuple[PathStep, ...]


class Point(NamedTuple):
    """One place where a generator may go on: a call of a function in a context, its cells, and the path; empty: at its beginning."""

    function: Function
    context: int
    cells: tuple[int, ...]
    path: Path

    @property
    def syntactic(self) -> Point:
        """The same place after any number of turns."""
        return self._replace(path=tuple(s if s.turn == NO_TURN else s._replace(turn=ANY_TURN) for s in self.path))


@final
class Suspension:
    """A suspended call: each point at which it may stand, with the values that it holds there. `ended`: it may be at its end.

    The values are the registers, then `KEPT` ones for each step of a loop over items or a `yield from`, outermost first.
    `lineage`: the keys of the bodies of the generators in which it was made, and its own. `shared`: it stands for all calls that are nested too deep.
    """

    __slots__ = ("ended", "lineage", "points", "shared")

    def __init__(
        self,
        points: dict[Point, tuple[Value, ...]],
        *,
        ended: bool = False,
        lineage: tuple[str, ...] = (),
        shared: bool = False,
    ) -> None:
        self.points = points
        self.ended = ended
        self.lineage = lineage
        self.shared = shared

    def at(self, points: dict[Point, tuple[Value, ...]], *, ended: bool) -> Suspension:
        """The same call at other points."""
        return Suspension(points, ended=ended, lineage=self.lineage, shared=self.shared)

    @property
    def is_over(self) -> bool:
        """Whether it is surely at its end."""
        return self.ended and not self.points

    def __eq__(self, other: object) -> bool:
        return self is other or (
            other.__class__ is Suspension and self.ended == other.ended and self.points == other.points
        )

    def __hash__(self) -> int:
        return hash((self.ended, frozenset(self.points)))

    def __repr__(self) -> str:
        return f"Suspension({list(self.points)}, ended={self.ended})"


def join_suspended(left: Suspension, right: Suspension, merge: Merge = join) -> Suspension:
    """What covers both; `left` itself where it already does. Too many turns of one yield become any turn."""
    points = add_points(left.points, right.points, merge)
    if points is left.points and left.ended >= right.ended and left.shared >= right.shared:
        return left
    lineage = left.lineage if len(left.lineage) >= len(right.lineage) else right.lineage
    return Suspension(points, ended=left.ended or right.ended, lineage=lineage, shared=left.shared or right.shared)


def add_points(
    ours: dict[Point, tuple[Value, ...]], theirs: dict[Point, tuple[Value, ...]], merge: Merge = join
) -> dict[Point, tuple[Value, ...]]:
    """The points of both; `ours` itself where it has all of them."""
    result = ours
    for point, values in theirs.items():
        key, new = point, values
        if key not in ours and point.syntactic in result:
            key, new = any_turn(point, values)
        old = result.get(key)
        joined = new if old is None else join_values(old, new, merge)
        if joined is not old:
            if result is ours:
                result = ours.copy()
            result[key] = joined
    return result if result is ours else _bounded(result, merge)


def join_values(left: tuple[Value, ...], right: tuple[Value, ...], merge: Merge = join) -> tuple[Value, ...]:
    """Values of one point, each joined; `left` itself where it already covers."""
    if left is right:
        return left
    joined = tuple([_covering(a, b, merge) for a, b in zip(left, right, strict=True)])
    return left if all(a is b for a, b in zip(left, joined, strict=True)) else joined


def _covering(left: Value, right: Value, merge: Merge) -> Value:
    if left is right or right is UNBOUND:
        return left
    merged = right if left is UNBOUND else merge(left, right)
    return left if merged == left else merged


def _bounded(points: dict[Point, tuple[Value, ...]], merge: Merge) -> dict[Point, tuple[Value, ...]]:
    """Where a yield has too many turns, or any turn already, all its turns as one."""
    groups: dict[Point, list[Point]] = {}
    for point in points:
        groups.setdefault(point.syntactic, []).append(point)
    if all(len(g) == 1 or (len(g) <= _MOST_TURNS and place not in points) for place, g in groups.items()):
        return points
    result: dict[Point, tuple[Value, ...]] = {}
    for place, group in groups.items():
        if len(group) == 1 or (len(group) <= _MOST_TURNS and place not in points):
            result.update((p, points[p]) for p in group)
            continue
        values: tuple[Value, ...] | None = None
        for point in sorted(group, key=lambda p: p is not place and p != place):
            more = any_turn(point, points[point])[1]
            values = more if values is None else join_values(values, more, merge)
        assert values is not None
        result[place] = values
    return result


def any_turn(point: Point, values: tuple[Value, ...]) -> tuple[Point, tuple[Value, ...]]:
    """The point after any number of turns, and the values there: of what is ahead, anything may come next, any number of times."""
    found, place = list(values), point.function.code.registers
    for step in point.path:
        if step.part in (EACH, YIELD) and place < len(found):
            if step.turn != ANY_TURN:
                items = [i for o in options(found[place + 1]) if isinstance(o, Tuple) for i in o.items]
                found[place + 1 : place + KEPT] = [Tuple(()), join_all([*items, found[place + 2]])]
            place += KEPT
    return point.syntactic, tuple(found)
