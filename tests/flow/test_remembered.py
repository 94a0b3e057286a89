# SPDX-License-Identifier: Apache-2.0
"""Promise: a walk that is remembered is forgotten where something that it asked for has changed, and only there."""

from __future__ import annotations

import pytest

from rosward.flow.marks import NOTHING, Mark, unrolled
from rosward.flow.stored.remembered import News, Remembered, gather
from rosward.flow.stored.tracker import Tracker


def _remembered(news: News, *asked: object) -> Remembered:
    tracker = Tracker()
    tracker.asked.update(asked)
    return Remembered((), tracker, (), NOTHING, 0, 0, news.told, 0)


def test_what_changed_later_is_not_held() -> None:
    news = News()
    news.tell(["a"])
    one, other, neither = _remembered(news, "a", "b"), _remembered(news, "b"), _remembered(news)
    assert all(map(news.holds, (one, other, neither)))
    news.tell(["a", "c"])
    assert [news.holds(each) for each in (one, other, neither)] == [False, True, True]
    assert news.holds(_remembered(news, "a"))


def test_a_walk_depends_on_what_those_inside_asked_for() -> None:
    outer, inner, again = Tracker(), Tracker(), Tracker()
    inner.asked.add("a")
    outer.absorb(inner, (), None)  # type: ignore[arg-type]  # nothing was written
    again.repeat(inner, (), None)  # type: ignore[arg-type]  # nothing was read
    assert outer.asked == again.asked == {"a"}


def test_arguments_are_more_where_one_of_them_is() -> None:
    known: dict[object, list[Mark]] = {}
    assert not gather(known, "body", [Mark(1)])  # type: ignore[arg-type]  # any name will do
    assert not gather(known, "body", [Mark(1)])  # type: ignore[arg-type]
    assert gather(known, "body", [Mark(2)])  # type: ignore[arg-type]
    assert gather(known, "body", [Mark(1), Mark(4)])  # type: ignore[arg-type]
    assert known["body"] == [Mark(3), Mark(4)]


@pytest.mark.parametrize(
    ("name", "one"),
    [
        ("tqdm.tqdm", "tqdm.tqdm"),
        ("acme.node.next.next", "acme.node.next.next"),
        ("acme.node.next.next.next", "acme.node.next.next"),
        ("acme.tree.left.right.left.right.left", "acme.tree.left.right.left"),
        ("acme.nexts.next.nexts.next.nexts", "acme.nexts.next.nexts"),
    ],
)
def test_what_repeats_itself_is_one(name: str, one: str) -> None:
    """Else what `node = node.next` finds has a new name in each turn of a loop."""
    assert unrolled(name) == one
