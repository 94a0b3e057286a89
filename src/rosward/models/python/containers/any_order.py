# SPDX-License-Identifier: Apache-2.0
"""The order of what a set holds: nobody knows it, as texts get another hash at each start. Numbers are where Python puts them.

list({'a', 'b'})        two places, each of which holds 'a' or 'b'
for n in {'a', 'b'}:    'a', then 'b': in which order, the loop does not tell apart
"""

from __future__ import annotations

from itertools import permutations
from typing import Final

from rosward.domain.choice import join_all
from rosward.domain.heap import Obj, Shuffled
from rosward.domain.series import Series
from rosward.domain.values import Const, Ref, Value
from rosward.models.native import Items, Machine

_FEW: Final = 3
"""So many elements are put together in each order that they may have."""


def unordered(record: Obj) -> tuple[Value, ...]:
    """What a set holds, or a list that was made of one, if its order is not known; else nothing."""
    if record.payload.__class__ is Shuffled:
        return record.payload.items
    items = record.items if record.kind == "set" else None
    return () if items is None or len(items) < 2 or _numbers(items) is not None else items


def places(record: Obj) -> Series:
    """What stands where in a set, or a list."""
    items = unordered(record) if record.kind == "set" else ()
    if items:
        return Series((join_all(items),) * len(items))
    return record.series() if record.payload.__class__ is Shuffled else once(record)


def once(record: Obj) -> Series:
    """What a set holds, or a list: each element once, where the order is not known in that in which they came."""
    if record.payload.__class__ is Shuffled:
        return Series(record.payload.items)
    numbers = _numbers(record.items) if record.kind == "set" and record.items is not None else None
    return record.series() if numbers is None else Series(numbers)


def _numbers(items: tuple[Value, ...]) -> tuple[Value, ...] | None:
    """Numbers as they stand in a set; None for others, and where their order depends on how the set came to be."""
    found = {i.value: i for i in items if isinstance(i, Const) and isinstance(i.value, (int, float))}
    if len(found) != len(items):
        return None
    at_once, one_by_one, backwards = set(found), set[float](), set[float]()
    for number in found:
        one_by_one.add(number)
    for number in reversed(found):
        backwards.add(number)
    orders = {tuple(each) for each in (at_once, one_by_one, backwards, {*frozenset(found)})}
    return tuple(found[number] for number in at_once) if len(orders) == 1 else None


def keep_unordered(machine: Machine, made: Value, source: Value) -> None:
    """A list was made of a set, or of a list of unknown order: what it holds is known apart from where."""
    items = unordered(machine.obj(source)) if isinstance(source, Ref) else ()
    if items and isinstance(made, Ref):
        record = machine.obj(made)
        if record.kind == "list" and record.items is not None and not record.many:
            machine.update(made, record.replace(payload=Shuffled(items)))


def in_places(machine: Machine, value: Value) -> Items:
    """What iterating over a value yields, for who asks at which place each element stands."""
    if isinstance(value, Ref) and unordered(machine.obj(value)):
        return Items(places(machine.obj(value)).head)
    return machine.iterate(value)


def each_order(machine: Machine, value: Value) -> list[Items] | None:
    """The elements of a value in each order that they may have; None where these are too many."""
    items = unordered(machine.obj(value)) if isinstance(value, Ref) else ()
    if not items:
        return [machine.iterate(value)]
    return [Items(each) for each in permutations(items)] if len(items) <= _FEW else None
