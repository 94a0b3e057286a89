# SPDX-License-Identifier: Apache-2.0
"""Callbacks that run the same function with other arguments: where there are many and they compute much, one stands for all.

for topic in topics:
    create_subscription(topic, bind(&Filter::odometry, this, _1, topic, settings))      fifty of them: any topic, any settings

Each alone would come to rest soon, but each changes what the others read. So all are followed as one, with the join of their arguments. What
creates something of ROS stays apart, as it is told by its arguments what; so does what writes something of which that is made, if that can
be followed anew (`haste.py`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join
from rosward.domain.compound import BoundMethod, Partial, Tuple, function_behind
from rosward.domain.slots import Overloads
from rosward.domain.values import Value

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.scheduled import Scheduled

_MANY: Final = 3
"""So many that are alike are followed one by one, however much they compute."""


def code_key(callback: Value) -> str:
    """What tells the function that a callback runs from others; empty where that is one of a library."""
    if callback.__class__ is Overloads:
        return " ".join(function.code.key for function in callback.functions)
    function = function_behind(callback)
    if function is None and callback.__class__ is Partial:  # a library calls what it was given (`std::bind`)
        given = (a for outer in callback.arguments for a in (outer.items if outer.__class__ is Tuple else (outer,)))
        function = next(filter(None, map(function_behind, given)), None)
    return "" if function is None else function.code.key


def standing_for(machine: Engine, entry: Scheduled) -> Scheduled | None:
    """What is to run for a callback: itself, or what stands for it; None where that runs at its own turn."""
    if entry.taken_in:
        return None
    key, book = code_key(entry.callback), machine.schedule_book
    if machine.watch is not None or not key or book.taken.get(key, 0) <= machine.budget.entry_coarse:
        return entry
    standing = book.standing.get((key, entry.event))
    if standing is entry or key in machine.trace.creating or key in machine.precision.haste.careful:
        return entry
    if standing is not None:
        return standing if not standing.exhausted and _take_in(standing, entry) else entry
    alike = [e for e in book.entries.values() if e.event == entry.event and code_key(e.callback) == key]
    if len(alike) > _MANY:
        book.standing[key, entry.event] = entry
        for other in alike:
            if other is not entry and not other.exhausted:
                _take_in(entry, other)
    return entry


def _take_in(standing: Scheduled, entry: Scheduled) -> bool:
    """Let one callback stand for another, too; not where the two have no join that can be called."""
    callback = _generalised(standing.callback, entry.callback)
    args = _each_given(standing.args or (), entry.args or ())
    anything = standing.args is None, entry.args is None
    if callback is None or args is None or anything[0] != anything[1] or standing.answered is not entry.answered:
        return False
    standing.callback = callback
    standing.args = None if anything[0] else args
    standing.others.append(entry)
    standing.doubted |= entry.doubted
    standing.coarse = True
    standing.runs = 0
    entry.taken_in = True
    return True


def _generalised(left: Value, right: Value) -> Value | None:
    """What is called as both are, with the join of what was given to them; None where they differ in more."""
    if left == right:
        return left
    if isinstance(left, BoundMethod) and isinstance(right, BoundMethod) and left.function == right.function:
        return BoundMethod(join(left.receiver, right.receiver), left.function)
    if isinstance(left, Partial) and isinstance(right, Partial) and left.keywords == right.keywords:
        function, arguments = _generalised(left.function, right.function), _each_given(left.arguments, right.arguments)
        return None if function is None or arguments is None else Partial(function, arguments, left.keywords)
    return None


def _each_given(left: Sequence[Value], right: Sequence[Value]) -> tuple[Value, ...] | None:
    """What was given to one call or the other, place by place."""
    found = [_given(*pair) for pair in zip(left, right, strict=False)]
    known = tuple(value for value in found if value is not None)
    return known if len(known) == len(left) == len(right) else None


def _given(left: Value, right: Value) -> Value | None:
    """What was given to one call or the other; None where that is another function."""
    if isinstance(left, Tuple) and isinstance(right, Tuple):
        items = _each_given(left.items, right.items)
        return None if items is None else Tuple(items)
    if function_behind(left) is not None or function_behind(right) is not None:
        return _generalised(left, right)
    return join(left, right)
