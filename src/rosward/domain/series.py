# SPDX-License-Identifier: Apache-2.0
"""Sequences of which the length is not known, but how they begin and end.

sys.argv + ['-r', 'a:=b']           [program, …any number of words…, '-r', 'a:=b']
(sys.argv + ['-r', 'a:=b'])[-2:]    ['-r', 'a:=b']
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from rosward.domain.choice import join_all
from rosward.domain.values import Value
from rosward.records import NamedTuple

Merge = Callable[[Value, Value], Value]


class Series(NamedTuple):
    """`head` in order, then any number of `middle`, then `tail` in order. Without `middle` the head is all there is."""

    head: tuple[Value, ...] = ()
    middle: Value | None = None
    tail: tuple[Value, ...] = ()

    @property
    def exact(self) -> bool:
        """Whether the length is known."""
        return self.middle is None

    @property
    def least(self) -> int:
        """How many elements there are at least."""
        return len(self.head) + len(self.tail)

    def reversed(self) -> Series:
        """The same, back to front."""
        if self.middle is None:
            return Series(self.head[::-1])
        return Series(self.tail[::-1], self.middle, self.head[::-1])

    def element(self) -> Value | None:
        """The join of all elements; None where there are none."""
        return _join(self.head, self.middle, self.tail)

    def loose(self) -> Series:
        """Any number of the elements, in any order."""
        return Series((), self.element())

    def behind_head(self) -> Value | None:
        """The join of all behind the head; None where there is nothing."""
        return _join((), self.middle, self.tail)

    def without(self, number: int) -> Series:
        """Without the first elements, so many of them."""
        if self.middle is None or number <= len(self.head):
            return self._replace(head=self.head[number:])
        more = number - len(self.head)  # of the middle, or, where that is shorter, of the tail
        return Series((), _join((), self.middle, self.tail[:more]), self.tail[more:])

    def last(self, number: int) -> Series:
        """The last elements, so many of them (all, where there are fewer)."""
        if self.middle is None:
            return Series(self.head[max(0, len(self.head) - number) :])
        if number <= len(self.tail):
            return Series(self.tail[len(self.tail) - number :])
        more = number - len(self.tail)
        return Series((), _join(self.head[max(0, len(self.head) - more) :], self.middle, ()), self.tail)

    def part(self, where: slice) -> Series:
        """series[where]."""
        begin, end, step = where.start, where.stop, where.step
        if self.middle is None:
            return Series(self.head[where])
        if step == -1 and begin is None and end is None:
            return self.reversed()
        if step not in (None, 1) or (begin is not None and begin < 0 and end is not None and end >= 0):
            return self.loose()
        found = self
        if end is not None:
            back = found.reversed()
            cut = back.last(end) if end >= 0 else back.without(-end)
            if begin is not None and begin < 0:
                return self.last(-begin).reversed().without(-end).reversed()
            found = cut.reversed()
        if begin is not None:
            found = found.without(begin) if begin >= 0 else found.last(-begin)
        return found

    def at(self, index: int) -> Value | None:
        """series[index]; None where there surely is no such element."""
        if index < 0:
            return self.reversed().at(-index - 1)
        if index < len(self.head):
            return self.head[index]
        return _join((), self.middle, self.tail[: index - len(self.head) + 1]) if self.middle is not None else None

    def with_at(self, index: int, value: Value) -> Series:
        """Behind `series[index] = value`, which does not fail."""
        if index < 0:
            return self.reversed().with_at(-index - 1, value).reversed()
        if index < len(self.head):
            return self._replace(head=(*self.head[:index], value, *self.head[index + 1 :]))
        reached = index - len(self.head) + 1
        tail = tuple(join_all((v, value)) if n < reached else v for n, v in enumerate(self.tail))
        return Series(self.head, _join((value,), self.middle, ()), tail)

    def with_inserted(self, index: int, value: Value) -> Series:
        """Behind `series.insert(index, value)`."""
        if self.middle is None:
            items = list(self.head)
            items.insert(index, value)
            return Series(tuple(items))
        if 0 <= index <= len(self.head):
            return self._replace(head=(*self.head[:index], value, *self.head[index:]))
        if index > 0:
            return Series(self.head, _join((value,), self.middle, self.tail))
        place = len(self.tail) + index
        if place >= 0:
            return self._replace(tail=(*self.tail[:place], value, *self.tail[place:]))
        kept = max(0, len(self.head) + place)
        return Series(self.head[:kept], _join((*self.head[kept:], value), self.middle, ()), self.tail)

    def without_at(self, index: int) -> Series:
        """Behind `del series[index]`, which does not fail."""
        if index < 0:
            return self.reversed().without_at(-index - 1).reversed()
        if self.middle is None or index < len(self.head):
            return self._replace(head=(*self.head[:index], *self.head[index + 1 :]))
        reached = index - len(self.head) + 1
        return Series(self.head, _join((), self.middle, self.tail[:reached]), self.tail[reached:])

    def without_part(self, where: slice) -> Series:
        """Behind `del series[where]`."""
        begin, end, step = where.start or 0, where.stop, where.step
        if self.middle is None:
            items = list(self.head)
            del items[where]
            return Series(tuple(items))
        if step not in (None, 1):
            return self.loose()
        if end is None:
            return self.part(slice(None, begin))
        if begin == 0:
            return self.part(slice(end, None))
        if end <= begin < 0:  # nothing lies between them
            return self
        if begin <= len(self.head) and end < 0 and -end <= len(self.tail):
            return concatenated((self.part(slice(None, begin)), self.part(slice(end, None))))
        if 0 <= begin <= end <= len(self.head):
            return concatenated((self.part(slice(None, begin)), self.part(slice(end, None))))
        return self.loose()

    def mapped(self, function: Callable[[Value], Value]) -> Series:
        """Each element replaced."""
        middle = None if self.middle is None else function(self.middle)
        return Series(tuple(map(function, self.head)), middle, tuple(map(function, self.tail)))


def _join(first: Iterable[Value], middle: Value | None, last: Iterable[Value]) -> Value | None:
    values = [*first, *(() if middle is None else (middle,)), *last]
    return join_all(values) if len(values) > 1 else values[0] if values else None


def concatenated(several: Iterable[Series]) -> Series:
    """One behind the other."""
    head: tuple[Value, ...] = ()
    middle: list[Value] = []
    tail: tuple[Value, ...] = ()
    for each in several:
        if not middle:
            head += each.head
        elif each.middle is None:
            tail += each.head
        else:
            middle += (*tail, *each.head)
        if each.middle is not None:
            middle.append(each.middle)
            tail = each.tail
    return Series(head, join_all(middle), tail) if middle else Series(head)


def joined(left: Series, right: Series, merge: Merge) -> Series:
    """A series that covers both, `left` itself where that does."""
    if left.middle is None and right.middle is None:
        if len(left.head) == len(right.head):
            return Series(tuple(merge(a, b) for a, b in zip(left.head, right.head, strict=True)))
        begin = _alike(left.head, right.head)
        shorter = min(len(left.head), len(right.head)) - begin
        end = min(shorter, _alike(left.head[::-1], right.head[::-1]))
    else:
        begin = min(_longest(left, left.head), _longest(right, right.head))
        end = min(_longest(left, left.tail), _longest(right, right.tail))
        for each in (left, right):
            if each.middle is None:  # its elements make the beginning first, then the end
                end = min(end, len(each.head) - begin)
    ours, theirs = _cut(left, begin, end), _cut(right, begin, end)
    middles = [m for m in (ours.middle, theirs.middle) if m is not None]
    middle = merge(*middles) if len(middles) > 1 else middles[0]
    return Series(
        tuple(merge(a, b) for a, b in zip(ours.head, theirs.head, strict=True)),
        middle,
        tuple(merge(a, b) for a, b in zip(ours.tail, theirs.tail, strict=True)),
    )


def _alike(one: tuple[Value, ...], other: tuple[Value, ...]) -> int:
    """How many elements both begin with."""
    return next((n for n, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))


def _longest(series: Series, end: tuple[Value, ...]) -> int:
    return len(series.head if series.middle is None else end)


def _cut(series: Series, begin: int, end: int) -> Series:
    """The same with a head and a tail of these lengths; what is over goes to the middle."""
    if series.middle is None:
        middle, tail = series.head[begin : len(series.head) - end], series.head[len(series.head) - end :]
        return Series(series.head[:begin], _join(middle, None, ()), tail)
    over = len(series.tail) - end
    return Series(
        series.head[:begin], _join(series.head[begin:], series.middle, series.tail[:over]), series.tail[over:]
    )
