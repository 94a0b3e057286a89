# SPDX-License-Identifier: Apache-2.0
"""The laws of the domain on which every fixpoint rests (docs/semantics.md, 1 to 4)."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st

from domain.covering import FILLINGS, covers, fill, object_covers, shape, state_covers
from domain.strategies import LOOP, states, string_values, text_parts, triples, two_states, unknowns, values, words
from rosward.domain.choice import MAX_OPTIONS, generalise, join, join_all, lift, lift2, options, widen
from rosward.domain.compound import External, Native, Partial, Range, Tuple
from rosward.domain.heap import Obj
from rosward.domain.memory import Heap
from rosward.domain.state import State, join_objects, join_states
from rosward.domain.text import common, concat, make, matches
from rosward.domain.values import NONE, UNBOUND, Choice, Const, Hole, Ref, Text, Unknown, Value

# Join


@given(values, values)
def test_join_covers_both(left: Value, right: Value) -> None:
    joined = join(left, right)
    assert covers(joined, left)
    assert covers(joined, right)


@given(values)
def test_join_is_idempotent(value: Value) -> None:
    assert join(value, value) == value
    assert join_all([value, value, value]) == value


@given(values, values)
def test_join_is_commutative(left: Value, right: Value) -> None:
    assert shape(join(left, right)) == shape(join(right, left))


@given(values, values, values)
def test_join_is_associative(a: Value, b: Value, c: Value) -> None:
    assert shape(join(join(a, b), c)) == shape(join(a, join(b, c)))


@given(values, values)
def test_what_a_join_covers_changes_it_no_more(left: Value, right: Value) -> None:
    """Fixpoints are seen by equality: joining a part again gives the very same value."""
    joined = join(left, right)
    assert join(joined, left) == joined
    assert join(joined, right) == joined


@given(values)
def test_unbound_is_the_least_value(value: Value) -> None:
    assert join(UNBOUND, value) == value == join(value, UNBOUND)


@given(values, values)
def test_a_choice_is_flat_and_has_one_unknown_at_most(left: Value, right: Value) -> None:
    found = options(join(left, right))
    assert not any(isinstance(o, Choice) for o in found)
    assert len({o for o in found if isinstance(o, Unknown)}) <= 1
    assert len(set(found)) == len(found)


@given(words, st.integers(MAX_OPTIONS + 1, MAX_OPTIONS + 9))
def test_too_many_alternatives_become_one_value_that_covers_them(prefix: str, count: int) -> None:
    texts = [Const(f"{prefix}{n}z") for n in range(count)]
    joined = join_all(texts)
    assert len(options(joined)) == 1
    assert all(covers(joined, text) for text in texts)
    numbers = [Const(n) for n in range(count)]
    assert shape(join_all(numbers)) == Unknown((), "int")
    assert shape(join_all([*numbers, *texts])) == Unknown((), "")


@given(st.lists(values, min_size=1, max_size=6))
def test_generalise_covers_all(several: list[Value]) -> None:
    flat = tuple(o for v in several for o in options(v))
    assert all(covers(generalise(flat), o) for o in flat)


# Widening


@given(values, values)
def test_widen_covers_the_join(old: Value, new: Value) -> None:
    widened = widen(old, new, LOOP)
    assert covers(widened, old)
    assert covers(widened, new)


@given(values, values)
def test_widen_rests_where_there_is_nothing_new(old: Value, new: Value) -> None:
    assert widen(old, old, LOOP) == old
    assert widen(join(old, new), new, LOOP) == join(old, new)


@given(st.lists(values, min_size=1, max_size=8), st.integers(0, 7))
def test_a_chain_of_widenings_comes_to_rest(several: list[Value], start: int) -> None:
    """Whatever a loop gives in turn, in any order: after some turns nothing changes."""
    value = several[start % len(several)]
    for turn, new in enumerate(itertools.islice(itertools.cycle(several), 12 * len(several))):
        wider = widen(value, new, LOOP)
        assert wider == value or turn < 8 * len(several)
        value = wider


def _turns_until_rest(step: Callable[[Value], Value], start: Value, most: int = 40) -> int:
    value = start
    for turn in range(most):
        wider = widen(value, join_all([value, step(value)]), LOOP)
        if wider == value:
            return turn
        value = wider
    return most


GROWING: dict[str, tuple[Value, Callable[[Value], Value]]] = {
    "text in front": (Const(""), lambda v: concat((Const("x/"), v))),
    "text behind": (Const("/a"), lambda v: concat((v, Const("/x")))),
    "text on both sides": (Const("b"), lambda v: concat((Const("a"), v, Const("c")))),
    "number": (Const(0), lambda v: Const(v.value + 1) if isinstance(v, Const) and isinstance(v.value, int) else v),
    "tuple": (Tuple(()), lambda v: Tuple((v,))),
    "attribute of a library": (External("lib"), lambda v: External(f"{v.name}.x") if isinstance(v, External) else v),
    "partial": (Native("f"), lambda v: Partial(v, (), ())),
    "range": (Const(0), lambda v: Range(Const(0), v, Const(1))),
}


@pytest.mark.parametrize("name", GROWING)
def test_what_grows_without_end_comes_to_rest(name: str) -> None:
    start, step = GROWING[name]
    assert _turns_until_rest(partial(lift, step), start) < 10


# Operations over alternatives


def _mark(value: Value) -> Value:
    return Tuple((value,))


def _pair(left: Value, right: Value) -> Value:
    return Tuple((left, right))


def test_objects_stay_where_texts_beside_them_are_too_many() -> None:
    """Else each turn of a recursion over nested data would find them anew."""
    objects = [Ref(number) for number in range(13)]
    parts = [join_all(Const(f"text {n}") for n in range(63)), join_all(objects), join_all(map(Const, "abcdef"))]
    value: Value = UNBOUND
    for _ in range(3):
        for part in parts:
            value = widen(value, part, LOOP)
    assert set(objects) < set(options(value))
    assert all(widen(value, part, LOOP) == value for part in parts)


@given(values)
def test_lift_covers_each_alternative(value: Value) -> None:
    lifted = lift(_mark, value)
    assert all(covers(lifted, _mark(option)) for option in options(value))


@given(values, values)
def test_lift2_covers_each_pair(left: Value, right: Value) -> None:
    lifted = lift2(_pair, left, right)
    assert all(covers(lifted, _pair(a, b)) for a in options(left) for b in options(right))


@given(st.integers(17, 60), st.integers(17, 60))
def test_lift2_over_too_many_pairs_still_covers_each(lefts: int, rights: int) -> None:
    left = join_all(Const(f"/l{n}") for n in range(lefts))
    right = join_all(Const(f"/r{n}") for n in range(rights))
    lifted = lift2(lambda a, b: concat((a, b)), left, right)
    assert all(matches(lifted, f"/l{n % lefts}/r{n % rights}") for n in range(max(lefts, rights)))


# Texts

Parts = list[str | Hole]


@given(text_parts, st.integers(0, 4095))
def test_a_text_covers_every_filling_of_its_holes(parts: Parts, choose: int) -> None:
    assert matches(make(parts), fill(parts, choose))


@given(text_parts)
def test_a_text_is_normal(parts: Parts) -> None:
    """Equal texts have equal parts: no empty part, no neighbours of one kind, no Text without text and hole."""
    value = make(parts)
    if isinstance(value, Text):
        assert "" not in value.parts
        assert all(isinstance(a, str) is not isinstance(b, str) for a, b in itertools.pairwise(value.parts))
        assert len({isinstance(p, str) for p in value.parts}) == 2
    elif isinstance(value, Const):
        assert not any(isinstance(p, Hole) for p in parts)
    else:
        assert isinstance(value, Unknown)
        assert value.hint == "str"


@given(st.lists(text_parts, max_size=4), st.integers(0, 4095))
def test_concat_covers_the_concatenation_of_fillings(several: list[Parts], choose: int) -> None:
    whole = "".join(fill(parts, choose >> number) for number, parts in enumerate(several))
    assert matches(concat(map(make, several)), whole)


@given(text_parts, text_parts, text_parts)
def test_concat_is_associative(a: Parts, b: Parts, c: Parts) -> None:
    x, y, z = make(a), make(b), make(c)
    assert shape(concat((concat((x, y)), z))) == shape(concat((x, concat((y, z))))) == shape(concat((x, y, z)))


@given(st.lists(text_parts, min_size=1, max_size=4), st.integers(0, 4095))
def test_common_covers_all_fillings_of_all(several: list[Parts], choose: int) -> None:
    value = common(tuple(map(make, several)), (LOOP,))
    assert all(matches(value, fill(parts, choose)) for parts in several)


def test_a_long_text_keeps_its_beginning_and_stays_short() -> None:
    hole = Hole((LOOP,), "word")
    many: Parts = [p for n in range(100) for p in (f"/{n}/", hole)]
    value = make(many)
    assert isinstance(value, Text)
    assert value.parts[0] == "/0/"
    assert len(value.parts) <= 32
    assert all(matches(value, fill(many, n)) for n in range(8))


def test_holes_know_their_shape() -> None:
    for name, fillings in FILLINGS.items():
        value = make(("/a", Hole((LOOP,), name), "b"))
        assert all(matches(value, f"/a{f}b") for f in fillings)
    assert not matches(make(("/a", Hole((LOOP,), "word"), "b")), "/ax/yb")
    assert not matches(make(("/a", Hole((LOOP,), "digits"), "b")), "/axb")


@given(string_values, string_values)
def test_origins_are_never_lost(left: Value, right: Value) -> None:
    """What was computed from a default stays marked so."""

    def marks(value: Value) -> set[object]:
        return {o for v in options(value) if isinstance(v, (Const, Text)) for o in v.origins}

    assert marks(join(left, right)) >= marks(left) | marks(right)
    both = lift2(lambda a, b: concat((a, b)), left, right)
    whole = not any(isinstance(o, Unknown) for v in (left, right, both) for o in options(v))
    assert not whole or marks(both) == marks(left) | marks(right)


# Objects and states


class _Versions:
    """Version numbers that no state of a test has."""

    def __init__(self) -> None:
        self.last = 1_000_000

    def __call__(self, compared: int = 0) -> int:
        assert compared >= 0
        self.last += 1
        return self.last


@given(triples)
def test_join_of_objects_covers_both(three: tuple[Obj, Obj, Obj]) -> None:
    left, right, _ = three
    joined = join_objects(left, right, join)
    assert object_covers(joined, left)
    assert object_covers(joined, right)


@given(triples)
def test_join_of_objects_is_commutative(three: tuple[Obj, Obj, Obj]) -> None:
    """Each order covers the other one."""
    left, right, _ = three
    one, other = join_objects(left, right, join), join_objects(right, left, join)
    assert object_covers(one, other)
    assert object_covers(other, one)


@given(triples)
def test_widening_of_objects_covers_both(three: tuple[Obj, Obj, Obj]) -> None:
    left, right, _ = three
    widened = join_objects(left, right, lambda a, b: widen(a, b, LOOP))
    assert object_covers(widened, left)
    assert object_covers(widened, right)


@given(triples)
def test_join_of_objects_gives_back_what_covers_already(three: tuple[Obj, Obj, Obj]) -> None:
    """`is`, not only `==`: the version of the state stays the same, and the fixpoint is seen."""
    left, right, other = three
    assert join_objects(left, left, join) is left
    joined = join_objects(join_objects(left, right, join), other, join)
    for part in three:
        assert join_objects(joined, part, join) is joined


@given(triples, st.integers(0, 2))
def test_a_chain_of_widened_objects_comes_to_rest(three: tuple[Obj, Obj, Obj], start: int) -> None:
    """Whatever turns of a loop leave at an address, in any order: after some turns the record is the very same."""
    record = three[start]
    for turn, new in enumerate(itertools.islice(itertools.cycle(three), 36)):
        wider = join_objects(record, new, lambda a, b: widen(a, b, LOOP))
        assert wider is record or turn < 24
        record = wider


@given(two_states)
def test_join_of_states_covers_both(two: tuple[State, State]) -> None:
    left, right = two
    before = left.copy()
    joined = join_states(left, right, _Versions())
    assert state_covers(joined, before)
    assert state_covers(joined, right)


@given(two_states)
def test_what_surely_happened_happened_on_both_ways(two: tuple[State, State]) -> None:
    left, right = two
    both = left.done & right.done
    assert join_states(left, right, _Versions()).done == both


@given(two_states)
def test_the_version_stays_where_left_covers_right(two: tuple[State, State]) -> None:
    left, right = two
    joined = join_states(left, right, _Versions())
    version = joined.version
    again = State(right.heap.copy(), 3, right.done)
    assert join_states(joined, again, _Versions()).version == version


@given(two_states)
def test_the_version_changes_where_the_heap_does(two: tuple[State, State]) -> None:
    left, right = two
    version, before = left.version, dict(left.heap.items())
    joined = join_states(left, right, _Versions())
    after = dict(joined.heap.items())
    same = before.keys() == after.keys() and all(after[a] is before[a] for a in before)
    assert (joined.version == version) is same


@given(states())
def test_a_copy_is_independent(state: State) -> None:
    copy = state.copy()
    records = dict(state.heap.items())
    for address in (*records, 1_000):
        copy.heap[address] = Obj("cell", NONE)
    assert copy.version == state.version
    assert dict(state.heap.items()) == records


@given(two_states)
def test_a_join_leaves_the_right_side_and_all_copies_alone(two: tuple[State, State]) -> None:
    left, right = two
    copies = [left.copy(), right.copy()]
    before = [dict(s.heap.items()) for s in (*copies, right)]
    joined = join_states(left, right, _Versions())
    for address in dict(joined.heap.items()):
        joined.heap[address] = Obj("cell", NONE)
    assert [dict(s.heap.items()) for s in (*copies, right)] == before


@given(two_states)
def test_filling_takes_over_what_is_missing_and_nothing_else(two: tuple[State, State]) -> None:
    left, right = two
    ours, theirs = dict(left.heap.items()), dict(right.heap.items())
    left.heap.fill(right.heap, lambda ours, theirs: join_objects(ours, theirs, join))
    assert dict(left.heap.items()) == {**theirs, **ours}
    assert dict(right.heap.items()) == theirs


@given(values, values)
def test_what_one_copy_writes_over_the_ground_is_joined_with_it(of_ground: Value, written: Value) -> None:
    """An object that only one of two copies changed is, in the other, as the ground has it."""
    ground = {7: Obj("cell", NONE, attrs={"value": of_ground}), 70: Obj("cell", NONE, attrs={"value": of_ground})}
    for one_way in (True, False):
        left = Heap(ground=ground.get)
        right = left.copy()
        (left if one_way else right)[7] = Obj("cell", NONE, attrs={"value": written})
        left.cover(right, lambda ours, theirs: join_objects(ours, theirs, join))
        joined = left.stands(7)
        assert joined is not None
        assert covers(joined.attrs["value"], of_ground)
        assert covers(joined.attrs["value"], written)
        assert left.stands(70) is ground[70]


@given(unknowns, values)
def test_reasons_never_run_out(unknown: Unknown, value: Value) -> None:
    """An unknown that a join keeps says why."""
    assert all(o.reasons for o in options(join(unknown, value)) if isinstance(o, Unknown))
