# SPDX-License-Identifier: Apache-2.0
"""Promise: a walk is remembered exactly as long as what it read stands there, slot by slot.

def on_timer(self): self.pub.publish(self.last)     runs again where `last` has grown, not where another slot of the node has
"""

from __future__ import annotations

from typing import Final

from hypothesis import given
from hypothesis import strategies as st

from rosward.flow.marks import Mark, Root
from rosward.flow.stored.memory import Memory
from rosward.flow.stored.tracker import Tracker

from .test_laws import ALL, ONE, keys, marks, memory, roots

NODE: Final = frozenset[Root]((ONE,))
acts = st.lists(st.tuples(st.sampled_from(["write", "add", "read", "all"]), roots, keys, marks), max_size=6)


def walk(here: Memory, several: list[tuple[str, Root, object, Mark]], *, ends: bool = True) -> Tracker:
    """Do these things one after the other; what is read goes into what is written next."""
    tracker = here.shape.tracker = Tracker()
    found = Mark(1)
    for act, root, key, mark in several:
        if act == "write":
            here.write(frozenset((root,)), key, mark.joined(found))
        elif act == "add":
            here.write_any([root], mark.joined(found))
        elif act == "read":
            found = found.joined(here.read([root], key))
        else:
            found = found.joined(here.of(root).whole)
    here.shape.tracker = None
    if ends:
        tracker.ended()
    return tracker


def test_another_slot_is_of_no_interest() -> None:
    here = memory()
    here.write(NODE, "last", Mark(1))
    tracker = walk(here.copy(), [("read", ONE, "last", Mark()), ("write", ONE, "count", Mark())])
    here.write(NODE, "other", Mark(8))
    assert here.finds(tracker)
    here.write(NODE, "last", Mark(8))
    assert not here.finds(tracker)


def test_what_the_walk_wrote_itself_is_not_read() -> None:
    here = memory()
    tracker = walk(here.copy(), [("write", ONE, "a", Mark(2)), ("read", ONE, "a", Mark())])
    here.write(NODE, "b", Mark(8))
    assert here.finds(tracker)


def test_everything_is_read_where_something_is_added_anywhere() -> None:
    here = memory()
    tracker = walk(here.copy(), [("write", ONE, "a", Mark(2)), ("add", ONE, "", Mark(4))])
    here.write(NODE, "b", Mark(8))
    assert not here.finds(tracker)


@given(acts, acts, acts)
def test_what_is_repeated_leaves_what_the_walk_would_leave(first: list, several: list, later: list) -> None:  # type: ignore[type-arg]
    """From whatever stands there later, as long as it finds what it read."""
    here = memory()
    walk(here, first)
    then = here.copy()
    tracker = walk(then, several, ends=False)
    writes = then.left(tracker, {})
    tracker.ended()
    walk(here, later)
    if here.finds(tracker):
        walked = here.copy()
        walk(walked, several)
        here.replay(writes, set())
        for root in ALL:
            assert here.of(root) == walked.of(root)
