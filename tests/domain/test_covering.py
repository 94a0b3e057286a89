# SPDX-License-Identifier: Apache-2.0
"""`covers` tells apart: each pair differs in one thing that is told of a record, and only one side of it covers the other."""

from __future__ import annotations

from typing import Final

import pytest
from hypothesis import given

from domain.covering import object_covers, state_covers
from domain.strategies import CLASS, FUNCTIONS, REASONS, triples
from rosward.domain.choice import join
from rosward.domain.compound import Tuple
from rosward.domain.heap import Alternatives, Obj, ObjKind, fields_of
from rosward.domain.memory import Heap
from rosward.domain.series import Series
from rosward.domain.state import State
from rosward.domain.suspended import EACH, PathStep, Point, Suspension
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Unknown, Value

A, B = Const("a"), Const("b")
AB = join(A, B)
ONE, TWO = Ref(1), Ref(2)


def _list(*items: Const | Ref) -> Obj:
    return Obj("list", CLASS, items=items)


def _bag(*series: object) -> Obj:
    return Obj("list", CLASS, **fields_of(Series(*series)))  # type: ignore[arg-type]


def _told(*elements: tuple[Ref, bool]) -> Obj:
    return Obj("list", CLASS, items=None, rest=join(ONE, TWO), payload=Alternatives(elements))


def _dict(*keys: Const, maybe: tuple[Const, ...] = (), rest: bool = False, key: Unknown | None = None) -> Obj:
    rest_value = NONE if rest else None
    entries: dict[Value, Value] = dict.fromkeys(keys, NONE)
    return Obj("dict", CLASS, entries=entries, maybe=frozenset(maybe), rest=rest_value, rest_key=key)


def _generator(turn: int | None, *ahead: Const, ended: bool = False) -> Obj:
    path = () if turn is None else (PathStep(0, EACH, turn), PathStep(0, ""))
    kept = () if turn is None else (NONE, Tuple(ahead), UNBOUND)
    point = Point(FUNCTIONS[0], 0, (), path)
    return Obj("generator", NONE, payload=Suspension({point: (NONE, NONE, *kept)}, ended=ended))


def _instance(kind: ObjKind = "instance", partial: str = "", payload: object = None, **attrs: Const | Ref) -> Obj:
    return Obj(kind, CLASS, attrs=dict(attrs), partial=frozenset(partial), payload=payload)


TEXT: Final = Unknown(REASONS[:1], "str")
APART: Final[dict[str, tuple[Obj, Obj]]] = {
    "an attribute that may be absent": (_instance(x=A, partial="x"), _instance()),
    "an attribute that is there": (_instance(x=A, partial="x"), _instance(x=A)),
    "a variable of a class": (_instance("class", x=A, partial="x"), _instance("class", x=A)),
    "several objects": (_instance().replace(many=True), _instance()),
    "data of an exception": (_instance(args=join(Tuple((A,)), Tuple((B,)))), _instance(args=Tuple((A,)))),  # type: ignore[arg-type]
    "what a member is": (_instance(payload=AB), _instance(payload=A)),
    "a bag": (_bag((), A), _list(A, A)),
    "a bag of more": (_bag((), AB), _bag((), A)),
    "how a list begins": (_bag((), AB), _bag((A,), AB)),
    "how a list ends": (_bag((A,), AB), _bag((A,), AB, (B,))),
    "how long it is": (_bag((A,), A), _bag((A, A), A)),
    "what it holds": (_told((ONE, True), (TWO, False)), _list(ONE)),
    "what it surely holds": (_told((ONE, False), (TWO, True)), _told((ONE, True), (TWO, True))),
    "elements that are told": (_bag((), join(ONE, TWO)), _told((ONE, False), (TWO, True))),
    "a key that may be absent": (_dict(A, B, maybe=(B,)), _dict(A)),
    "a key that is there": (_dict(A, maybe=(A,)), _dict(A)),
    "other keys": (_dict(rest=True, key=TEXT), _dict()),
    "any keys": (_dict(rest=True), _dict(rest=True, key=TEXT)),
    "the end of a generator": (_generator(0, A, ended=True), _generator(0, A)),
    "generators at their beginning": (
        _generator(None).replace(
            payload=Suspension(_generator(None).payload.points | _generator(0, A).payload.points)  # type: ignore[attr-defined]
        ),
        _generator(0, A),
    ),
}


@pytest.mark.parametrize("name", APART)
def test_one_side_covers(name: str) -> None:
    above, below = APART[name]
    assert object_covers(above, below)
    assert not object_covers(below, above)


NEITHER: Final[dict[str, tuple[Obj, Obj]]] = {
    "what is ahead": (_generator(0, A, B), _generator(1, B)),
    "more is ahead": (_generator(0, A, B), _generator(0, B)),
    "the order of keys": (_dict(A, B), _dict(B, A)),
    "the order of elements": (_list(A, B), _list(B, A)),
    "the length": (_list(A), _list(A, A)),
    "an iterator": (_list(A), _list(A).replace(payload="iterator")),
    "whose variables": (_dict(A).replace(payload=ONE), _dict(A).replace(payload=TWO)),
    "the kind": (_list(), _dict()),
    "another attribute": (_instance(x=A), _instance(y=A)),
}


@pytest.mark.parametrize("name", NEITHER)
def test_neither_covers(name: str) -> None:
    one, other = NEITHER[name]
    assert not object_covers(one, other)
    assert not object_covers(other, one)


@given(triples)
def test_each_covers_itself(three: tuple[Obj, Obj, Obj]) -> None:
    assert all(object_covers(record, record) for record in three)


@given(triples)
def test_covering_is_transitive(three: tuple[Obj, Obj, Obj]) -> None:
    a, b, c = three
    assert object_covers(a, c) or not (object_covers(a, b) and object_covers(b, c))


def test_states() -> None:
    done = frozenset({("node", 1)})
    more = State(Heap([(1, _bag((), A)), (2, _list())]), 1, frozenset())
    less = State(Heap([(1, _list(A))]), 2, done)
    assert state_covers(more, less)
    assert not state_covers(less, more)
    assert not state_covers(State(more.heap, 1, frozenset({("node", 2)})), less)
    assert not state_covers(State(Heap([(2, _list())]), 1, frozenset()), less)
