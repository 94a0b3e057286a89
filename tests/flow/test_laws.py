# SPDX-License-Identifier: Apache-2.0
"""Promise: joining what is known never forgets anything, and what is written surely replaces what stood there.

On these laws rests that the analysis is complete: marks (what a value depends on), contents (what stands in an object), and memory.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, Final

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosward.effects.flows import Source
from rosward.flow.marks import NOTHING, Mark, Root, Sources, demoted, triggering
from rosward.flow.stored import standing
from rosward.flow.stored.beside import Beside
from rosward.flow.stored.content import EMPTY, Content, both
from rosward.flow.stored.memory import Memory
from rosward.flow.stored.remembered import Remembered, Written
from rosward.flow.stored.store import Numbers
from rosward.flow.stored.tracker import Tracker

masks = st.integers(0, 2**12 - 1)
keys = st.sampled_from(["a", "b", 0, 1])
ONE: Final = 1
MANY: Final = 2
ALL: Final[tuple[Root, ...]] = (ONE, MANY, ("made", "here", 0, ""))
roots = st.sampled_from(ALL)
marks = st.builds(Mark, masks, st.frozensets(roots))
contents = st.builds(Content, masks, marks, masks, st.dictionaries(keys, marks))


def covers(large: Mark, small: Mark) -> bool:
    return large.mask | small.mask == large.mask and small.roots <= large.roots


def same(ours: Content, theirs: Content) -> bool:
    """Whether nobody who reads can tell them apart."""
    alike = all(ours.read(key) == theirs.read(key) for key in {*ours.slots, *theirs.slots, "never written"})
    return alike and ours.size == theirs.size and ours.whole == theirs.whole


# Marks


@given(marks, marks)
def test_what_is_joined_covers_both(one: Mark, other: Mark) -> None:
    joined = one.joined(other)
    assert covers(joined, one)
    assert covers(joined, other)
    assert joined == other.joined(one)
    assert joined.joined(other) is joined


@given(marks, marks, marks)
def test_the_order_of_joining_does_not_matter(a: Mark, b: Mark, c: Mark) -> None:
    assert a.joined(b).joined(c) == a.joined(b.joined(c))
    assert a.joined(NOTHING) == a


@given(masks, masks)
def test_demoting_keeps_every_source(mask: int, other: int) -> None:
    sources = Sources()
    all_of_them = [Source("topic", f"/{n}") for n in range(4)]
    for source in all_of_them:
        sources.data(source)
    for weaker in (demoted(mask), triggering(mask), demoted(demoted(mask))):
        assert frozenset().union(*sources.apart(weaker)) == frozenset().union(*sources.apart(mask))
        assert not sources.apart(weaker)[0]
    assert not sources.apart(triggering(mask))[1]
    assert demoted(mask | other) == demoted(mask) | demoted(other)
    assert triggering(mask | other) == triggering(mask) | triggering(other)


@given(masks)
def test_a_source_is_named_in_its_strongest_role_only(mask: int) -> None:
    sources = Sources()
    for n in range(4):
        sources.data(Source("topic", f"/{n}"))
    data, control, trigger = sources.apart(mask)
    assert not data & control
    assert not (data | control) & trigger
    again = 0
    for source in data:
        again |= sources.data(source)
    for source in control:
        again |= demoted(sources.data(source))
    for source in trigger:
        again |= sources.trigger(source)
    assert sources.apart(again) == (data, control, trigger)


def test_every_source_is_data_at_most() -> None:
    sources = Sources()
    arrived = sources.trigger(Source("topic", "/in"))
    only, none = frozenset((Source("topic", "/in"),)), frozenset[Source]()
    assert sources.apart(arrived) == (none, none, only)
    assert sources.apart(sources.all) == (only, none, none)


# Contents


@given(contents, contents, keys)
def test_what_covers_two_contents_reads_as_both(ours: Content, theirs: Content, key: Any) -> None:
    merged = both(ours, theirs)
    for each in (ours, theirs):
        assert covers(merged.read(key), each.read(key))
        assert covers(merged.whole, each.whole)
        assert merged.size | each.size == merged.size


@given(contents, contents, contents)
def test_contents_are_joined_in_any_order(a: Content, b: Content, c: Content) -> None:
    assert both(a, a) == a
    assert same(both(a, b), both(b, a))
    assert same(both(both(a, b), c), both(a, both(b, c)))
    assert same(both(both(a, b), b), both(a, b))


@given(contents, keys)
def test_the_whole_covers_each_slot(content: Content, key: Any) -> None:
    assert covers(content.whole, content.read(key))


# Memory


def memory(*, merges_objects: bool = True) -> Memory:
    """One object that is surely one, and one that stands for several."""
    shape: Any = SimpleNamespace(
        many={MANY},
        inner={},
        numbers=Numbers(bool),
        is_set=lambda _: False,
        few=48,
        merges_objects=merges_objects,
        tracker=None,
        trail=None,
        spent=0,
        nodes=set(),
        placed=set(),
        several=set(),
        kind=lambda _: "instance",
        part=lambda _, __: None,
        held=lambda _: (),
        parts=lambda _: (),
    )
    return Memory(shape)


writes = st.lists(st.tuples(roots, keys, marks), max_size=6)


def written(several: list[tuple[Root, Any, Mark]]) -> Memory:
    made = memory()
    for root, key, mark in several:
        made.write(frozenset((root,)), key, mark)
    return made


@given(writes, keys, marks)
def test_one_object_forgets_what_is_overwritten(before: list[Any], key: Any, mark: Mark) -> None:
    made = written(before)
    made.write(frozenset((ONE,)), key, mark)
    assert made.read([ONE], key) == mark


@given(writes, keys, marks)
def test_of_several_objects_each_may_have_been_meant(before: list[Any], key: Any, mark: Mark) -> None:
    made = written(before)
    old = [made.read([root], key) for root in (ONE, MANY)]
    made.write(frozenset((ONE, MANY)), key, mark)
    for root, known in zip((ONE, MANY), old, strict=True):
        assert covers(made.read([root], key), known)
        assert covers(made.read([root], key), mark)


@given(writes, keys, marks)
def test_what_is_added_somewhere_may_stand_under_every_key(before: list[Any], key: Any, mark: Mark) -> None:
    made = written(before)
    old = made.read([ONE], key)
    made.write_any([ONE], mark, mark.mask)
    assert covers(made.read([ONE], key), old.joined(mark))
    assert made.size([ONE]) | mark.mask == made.size([ONE])


@given(writes, writes)
def test_a_copy_goes_its_own_way(first: list[Any], second: list[Any]) -> None:
    original = written(first)
    kept = dict(original.items())
    copy = original.copy()
    assert dict(copy.items()) == kept
    for root, key, mark in second:
        copy.write(frozenset((root,)), key, mark)
    assert dict(original.items()) == kept
    original.write(frozenset((ONE,)), "a", Mark(1))
    assert copy.read([ONE], "a") == written([*first, *second]).read([ONE], "a")


@given(writes, writes, writes, keys, roots)
def test_memories_that_meet_again_cover_each_way(
    first: list[Any], one: list[Any], other: list[Any], key: Any, root: Any
) -> None:
    left = written(first)
    right = left.copy()
    for here, several in ((left, one), (right, other)):
        for each, name, mark in several:
            here.write(frozenset((each,)), name, mark)
    ways = [left.copy(), right.copy()]
    turned = right.copy()
    turned.join(left)
    changed = left.join(right)
    for way in ways:
        assert covers(left.read([root], key), way.read([root], key))
    assert same(left.of(root), turned.of(root))
    assert changed or same(left.of(root), ways[0].of(root))
    assert not left.join(right)


@given(writes, marks)
def test_all_that_a_value_leads_to_counts(before: list[Any], mark: Mark) -> None:
    made = written(before)
    found = made.deep(mark)
    assert found | mark.mask == found
    for root in mark.roots:
        assert found | made.of(root).whole.mask == found


further = st.sampled_from(
    [*ALL, ("external", "lib"), ("of", ONE, "a"), ("of", ("of", ONE, "a"), "b"), ("slot", ONE, "a", "one")]
)
ROOTS: tuple[Root, ...] = (*ALL, ("of", ONE, "a"), ("of", ("of", ONE, "a"), "b"))
leading = st.builds(Mark, masks, st.frozensets(further))
acts = st.tuples(
    st.sampled_from(["write", "add", "fork", "other", "join", "merge"]), further, keys, leading, st.frozensets(further)
)


@pytest.mark.parametrize("merges_objects", [True, False], ids=["Python", "C++"])
@pytest.mark.parametrize("worth", [1, 1000], ids=["continued", "anew"])
@given(several=st.lists(acts, max_size=12))
def test_a_look_that_is_kept_finds_what_a_new_one_finds(merges_objects: bool, worth: int, several: list[Any]) -> None:
    """Also where looks go on from what is known of some of the objects."""
    here = memory(merges_objects=merges_objects)
    there = Memory(here.shape)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(standing, "_WORTH", worth)
        patched.setattr(standing, "_SHORT", worth)
        for act, root, key, mark, looked in several:
            if act == "write":
                here.write(frozenset((root,)), key, mark)
            elif act == "add":
                here.write_any([root], mark, mark.mask)
            elif act == "fork":
                there = here.copy()
            elif act == "other":
                here, there = there.current(), here
            elif act == "merge":
                here.merge({root, *looked})
            else:
                here.join(there)
                here.take_looks(there)
            fresh = Memory(here.shape)
            fresh.replay([Written(root, None, content) for root, content in here.items()], set())
            for each in (looked, frozenset((root,)), mark.roots):
                assert here.deep(Mark(0, each)) == fresh.deep(Mark(0, each))
                one = here.numbers.one
                assert set(map(one, here.reached(Mark(0, each)))) == set(map(one, fresh.reached(Mark(0, each))))


def test_a_look_through_a_part_is_forgotten_where_its_owner_is_one_of_several_that_are_merged() -> None:
    here, part = memory(), frozenset[Root]((("of", ONE, "a"),))
    here.merge({ONE, MANY})
    here.write(frozenset((ONE,)), "b", NOTHING)
    assert here.deep(Mark(0, part)) == 0
    here.write(frozenset((MANY,)), "a", Mark(1))
    assert here.deep(Mark(0, part)) == 1


steps = st.tuples(st.sampled_from(["write", "add", "grow", "meet", "fork", "go"]), further, keys, leading)


@given(st.lists(steps, max_size=14))
def test_what_was_met_before_is_met_again_where_it_was_written_since(several: list[Any]) -> None:
    """Whoever looks at what was written since alone finds what one finds that looks at everything."""
    beside, state = memory(), 0
    here, whole = Memory(beside.shape), Memory(beside.shape)
    kept = here.copy(), whole.copy()
    for act, root, key, mark in several:
        if act == "grow":
            other = Memory(beside.shape)
            other.write(frozenset((root,)), key, mark)
            state += beside.join(other)
        elif act == "meet":
            here.meet(beside, state)
            whole.join(beside)
        elif act == "fork":
            kept = here.copy(), whole.copy()
        elif act == "go":
            (here, whole), kept = kept, (here.copy(), whole.copy())
        else:
            for each in (here, whole):
                if act == "write":
                    each.write(frozenset((root,)), key, mark)
                else:
                    each.write_any([root], mark, mark.mask)
        for known in ROOTS:
            assert same(here.of(known), whole.of(known))


@given(writes, writes, keys)
def test_objects_that_are_merged_hold_what_each_of_them_held(first: list[Any], second: list[Any], key: Any) -> None:
    """Here, and in a copy that was made before, as soon as that is looked at again."""
    here = written(first)
    there = here.copy()
    for root, name, mark in second:
        there.write(frozenset((root,)), name, mark)
    before = [
        (each, root, each.read([root], key), each.deep(Mark(0, frozenset((root,)))))
        for each in (here, there)
        for root in ALL
    ]
    here.merge(ALL)
    there.current()
    for each, root, known, deep in before:
        assert each.read([root], key).mask | known.mask == each.read([root], key).mask
        assert each.deep(Mark(0, frozenset((root,)))) | deep == each.deep(Mark(0, frozenset((root,))))
        assert not each.is_one([root])


def test_nothing_stands_where_nothing_was_written() -> None:
    made = memory()
    assert made.of(ONE) == EMPTY
    assert made.read([ONE], "a") == NOTHING
    assert made.deep(Mark(0, frozenset((ONE,)))) == 0


bodies = st.lists(
    st.tuples(st.sampled_from(["write", "add", "carry", "look", "meet"]), further, keys, leading, further),
    min_size=1,
    max_size=8,
)


def _walked(here: Memory, beside: Beside, body: list[Any]) -> list[int]:
    """What a body does, beside others; what it has read."""
    found = []
    for act, root, key, mark, other in body:
        if act == "write":
            here.write(frozenset((root,)), key, mark)
        elif act == "add":
            here.write_any([root], mark, mark.mask)
        elif act == "carry":
            here.write(frozenset((other,)), key, here.read([root], key))
        elif act == "look":
            found.append(here.deep(Mark(0, frozenset((root,)))) | here.read([other], key).mask)
        else:
            assert here.shape.tracker is not None
            here.shape.tracker.beside = True
            beside.meet(here)
    return found


@given(writes, bodies, st.lists(st.tuples(further, keys, leading), max_size=3), st.booleans(), st.frozensets(further))
def test_a_walk_that_holds_beside_others_finds_and_leaves_what_a_new_one_does(
    before: list[Any], body: list[Any], more: list[Any], begun: bool, merged: frozenset[Root]
) -> None:
    """Whatever callbacks have written since: what the walk does not touch changes nothing. `begun`: they do so once it stands before the call."""
    start = written(before)
    shape: Any = start.shape
    beside = Beside(shape)
    beside.take(start)
    state, here = beside.state, beside.memory.copy()
    shape.tracker = Tracker()
    found = _walked(here, beside, body)
    tracker, shape.tracker = shape.tracker, None
    left = here.left(tracker, {})
    tracker.ended()
    each = Remembered((), tracker, left, NOTHING, 0, state, 0, 0)
    again, callback = beside.memory.copy(), beside.memory.copy()
    beside.memory.merge(merged)
    for root, key, mark in more:
        callback.current()
        callback.write(frozenset((root,)), key, mark)
    beside.take(callback)
    again = again.current() if begun else beside.memory.copy()
    anew = again.copy()
    if not (again.finds(tracker) and beside.holds(each)):
        return
    if tracker.beside:
        beside.meet(again)
    again.replay(left, set())
    shape.tracker = Tracker()
    assert _walked(anew, beside, body) == found
    shape.tracker = None
    for root in ROOTS:
        assert same(again.of(root), anew.of(root))
