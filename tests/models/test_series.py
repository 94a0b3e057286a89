# SPDX-License-Identifier: Apache-2.0
"""Lists of which only the beginning and the end are known: whatever the middle is, what Python makes of the list is covered."""

from __future__ import annotations

from typing import Any

from hypothesis import example, given
from hypothesis import strategies as st

from models.fake import REASON, FakeMachine, abstract, covers, series_covers
from rosward.domain.choice import join
from rosward.domain.compound import Native, Slice
from rosward.domain.heap import Obj, fields_of
from rosward.domain.series import Series, concatenated, joined
from rosward.domain.state import join_objects
from rosward.domain.values import NONE, Const, Ref, Unknown, Value
from rosward.models.python.operators import operators

numbers = st.lists(st.integers(0, 3), max_size=3)
ANY = Unknown((REASON,), "int")
index = st.integers(-5, 5)
ends = st.one_of(st.none(), index)
slices = st.builds(slice, ends, ends, st.sampled_from((None, 1, -1, 2)))
deletions = st.builds(slice, ends, ends, st.sampled_from((None, 1)))
Both = tuple[Series, list[int]]


@st.composite
def pairs(draw: st.DrawFn) -> Both:
    """A series, and a list that it covers."""
    head, middle, tail = draw(numbers), draw(numbers), draw(numbers)
    if draw(st.booleans()):
        return Series(tuple(map(Const, head))), head
    return Series(tuple(map(Const, head)), ANY, tuple(map(Const, tail))), head + middle + tail


def check(series: Series, concrete: list[int]) -> None:
    assert series_covers(FakeMachine(), series, concrete), (series, concrete)


@given(pairs(), pairs())
def test_concatenation(one: Both, other: Both) -> None:
    check(concatenated((one[0], other[0])), one[1] + other[1])
    check(concatenated((one[0], other[0], one[0])), one[1] + other[1] + one[1])


@given(pairs(), slices)
def test_slices(both: Both, where: slice) -> None:
    series, concrete = both
    check(series.part(where), concrete[where])


@given(pairs(), deletions)
@example((Series((), ANY, (Const(0), Const(1))), [0, 1]), slice(-1, -2))
def test_deleted_slices(both: Both, where: slice) -> None:
    series, concrete = both
    left = list(concrete)
    del left[where]
    check(series.without_part(where), left)


@given(pairs(), index)
def test_indices(both: Both, at: int) -> None:
    series, concrete = both
    if not -len(concrete) <= at < len(concrete):
        return
    found = series.at(at)
    assert found is not None
    assert covers(FakeMachine(), found, concrete[at])
    check(series.without_at(at), concrete[: at % len(concrete)] + concrete[at % len(concrete) + 1 :])
    changed = list(concrete)
    changed[at] = 9
    check(series.with_at(at, Const(9)), changed)


@given(pairs(), index)
def test_insertion(both: Both, at: int) -> None:
    series, concrete = both
    changed = list(concrete)
    changed.insert(at, 9)
    check(series.with_inserted(at, Const(9)), changed)


@given(pairs())
def test_reversal_and_looseness(both: Both) -> None:
    series, concrete = both
    check(series.reversed(), concrete[::-1])
    check(series.loose(), concrete)
    assert series.reversed().reversed() == series


@given(pairs(), pairs())
def test_a_join_covers_both_and_is_stable(one: Both, other: Both) -> None:
    together = joined(one[0], other[0], join)
    check(together, one[1])
    check(together, other[1])
    assert joined(together, one[0], join) == together
    assert joined(together, other[0], join) == together


@given(pairs(), pairs(), pairs())
def test_chains_of_joins_end(one: Both, other: Both, third: Both) -> None:
    """Each join that changes something makes an end shorter or an element larger."""
    found = one[0]
    for each in (other[0], third[0], other[0], one[0], third[0]):
        larger = joined(found, each, join)
        assert larger.exact or larger.least <= max(found.least, each.least)
        found = larger
    assert all(joined(found, each, join) == found for each in (one[0], other[0], third[0]))


@given(pairs(), pairs())
def test_records_join_as_their_elements(one: Both, other: Both) -> None:
    records = [Obj("list", Native("builtins.list"), **fields_of(series)) for series in (one[0], other[0])]
    together = join_objects(records[0], records[1], join)
    check(together.series(), one[1])
    check(together.series(), other[1])
    assert join_objects(together, records[1], join) is together
    rest = together.rest
    assert together.items is not None or all(rest is not None and covers(FakeMachine(), rest, v) for v in one[1])


Step = tuple[Any, ...]
steps = st.lists(
    st.one_of(
        st.tuples(st.just("append"), st.integers(4, 6)),
        st.tuples(st.just("extend"), numbers),
        st.tuples(st.just("insert"), index, st.integers(4, 6)),
        st.tuples(st.just("pop"), index),
        st.tuples(st.just("reverse")),
        st.tuples(st.just("sort")),
        st.tuples(st.just("store"), index, st.integers(4, 6)),
        st.tuples(st.just("delete"), deletions),
        st.tuples(st.just("put"), st.builds(slice, st.one_of(st.none(), st.integers(0, 4)), ends), numbers),
    ),
    max_size=5,
)


def _slice(where: slice) -> Value:
    parts = [NONE if e is None else Const(e) for e in (where.start, where.stop, where.step)]
    return Slice(*parts)


def _perform(machine: FakeMachine, ref: Ref, concrete: list[int], step: Step) -> bool:
    """Do a step on both; whether the real one did not fail."""
    name, *args = step
    try:
        if name == "store":
            concrete[args[0]] = args[1]
        elif name == "delete":
            del concrete[args[0]]
        elif name == "put":
            concrete[args[0]] = args[1]
        else:
            getattr(concrete, name)(*args)
    except IndexError:
        return False
    if name in ("store", "put"):
        where = _slice(args[0]) if name == "put" else Const(args[0])
        operators.store_item(machine, ref, where, abstract(machine, args[1]))
    elif name == "delete":
        machine.native("list.pop", ref, _slice(args[0]))
    else:
        machine.native(f"list.{name}", ref, *(abstract(machine, a) for a in args))
    return True


@given(pairs(), steps, numbers)
def test_methods(both: Both, sequence: list[Step], other: list[int]) -> None:
    machine = FakeMachine()
    series, concrete = both[0], list(both[1])
    ref = machine.new_list(*series)
    for step in sequence:
        if not _perform(machine, ref, concrete, step):
            return
        assert covers(machine, ref, concrete), (step, machine.obj(ref), concrete)
    exact = abstract(machine, concrete)
    assert operators.equal(machine, ref, exact) is not False
    for value in range(7):
        answer = operators.contains(machine, ref, Const(value))[0]
        assert answer is None or answer is (value in concrete)
    assert operators.truth(machine, ref) in (None, bool(concrete))
    for made in (machine.native("builtins.list", ref), machine.native("list.copy", ref)):
        assert covers(machine, made, concrete)
    assert covers(machine, machine.native("builtins.tuple", ref), tuple(concrete))
    assert covers(machine, machine.native("builtins.sorted", ref), sorted(concrete))
    assert covers(machine, machine.binary("+", ref, abstract(machine, other)), concrete + other)
    assert covers(machine, machine.binary("+", abstract(machine, other), ref), other + concrete)
    assert covers(machine, machine.binary("*", ref, Const(2)), concrete * 2)
    items = machine.iterate(ref)
    assert len(items.known) <= len(concrete)
