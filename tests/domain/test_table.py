# SPDX-License-Identifier: Apache-2.0
"""A table is the dict that the same writes would make, in its order; what differs between two is what differs between the dicts."""

from __future__ import annotations

from collections.abc import Mapping

from hypothesis import given
from hypothesis import strategies as st

from rosward.domain.table import Table, differing, marked, more_marks, unmarked, written

NAMES = st.integers(0, 300).map(lambda number: f"n{number}")
WRITES = st.lists(st.tuples(NAMES, st.sampled_from([object() for _ in range(4)])), max_size=200)


def all_written(values: Mapping[str, object], writes: list[tuple[str, object]]) -> Mapping[str, object]:
    for name, value in writes:
        values = written(values, name, value)
    return values


@given(WRITES, WRITES, WRITES)
def test_two_versions_are_the_dicts(
    base: list[tuple[str, object]], left: list[tuple[str, object]], right: list[tuple[str, object]]
) -> None:
    start = Table.of(dict(base))
    expected = [{**dict(base)}, {**dict(base)}]
    for values, writes in zip(expected, (left, right), strict=True):
        for name, value in writes:
            values[name] = value
    ours, theirs = all_written(start, left), all_written(start, right)
    assert list(start.items()) == list(dict(base).items())
    assert list(ours.items()) == list(expected[0].items())
    assert list(theirs.items()) == list(expected[1].items())
    assert all((name in ours) == (name in expected[0]) for name in (*expected[1], "other"))
    names = {*ours, *theirs}
    found = {name: (a, b) for name, a, b in differing(ours, theirs)}
    assert found == {
        name: (ours.get(name), theirs.get(name)) for name in names if ours.get(name) is not theirs.get(name)
    }


@given(st.lists(st.tuples(NAMES, st.booleans()), max_size=400), st.lists(NAMES, max_size=200, unique=True))
def test_marks_are_a_set(changes: list[tuple[str, bool]], start: list[str]) -> None:
    expected, marks = set[str](), marked(frozenset(), "first")
    expected.add("first")
    for name in start:
        expected.add(name)
        marks = marked(marks, name)
    before, had = marks, frozenset(expected)
    for name, there in changes:
        expected.symmetric_difference_update({name} if (name in expected) is not there else ())
        marks = marked(marks, name) if there else unmarked(marks, name)
    assert set(marks) == expected
    assert len(marks) == len(expected)
    assert set(before) == had
    assert set(more_marks(before, marks)) == expected - had
