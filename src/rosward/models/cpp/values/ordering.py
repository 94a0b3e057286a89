# SPDX-License-Identifier: Apache-2.0
"""In which order do sets and maps have what they hold, and which of it is there but once?

std::set<std::string>{"b", "a", "b"}        'a', 'b'
std::set<std::string>{name, "b"}            any number of `name` and 'b', where it is not known whether they are the same
"""

from __future__ import annotations

from typing import Any, Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import External, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.slots import Overloads, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import Choice, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.models.asked_order import by_asking
from rosward.models.cpp.values.slots import is_structure, unfolded
from rosward.models.cpp.values.types import argument, name_of
from rosward.models.native import Machine
from rosward.models.python.comparing.compare import equal
from rosward.models.python.plain import NOT_PLAIN, plain

__all__ = ["MOST_ASKED", "foremost", "in_order", "is_asked", "own_key", "same_key", "unique", "without_comparison"]

_MOST: Final = 300
MOST_ASKED: Final = 30
"""So many elements are put in order by asking the program."""


def in_order(machine: Machine, values: list[Value], cls: Value | None = None) -> list[int] | None:
    """The indices of values in the order of a container of this class, else ascending; None where it is not known, or they cannot be compared."""
    if len(values) < 2:
        return list(range(len(values)))
    asked = cls is not None and is_asked(cls)
    ranks: list[Any] = [] if asked else [plain(value) for value in values]
    if asked or any(rank is NOT_PLAIN or rank is None for rank in ranks):
        known = asked or any(_has_structure(v) or _is_asked_of(machine, v) for v in values)
        if cls is None or "unordered" in name_of(cls) or not known:
            return None
        return by_asking(values, lambda a, b: _is_less(machine, cls, a, b), MOST_ASKED)
    reverse = cls is not None and name_of(_compared(cls)) == "std.greater"
    try:
        return sorted(range(len(values)), key=lambda n: ranks[n], reverse=reverse)
    except TypeError:
        return None


def foremost(machine: Machine, series: Series, cls: Value) -> int | None:
    """Which element of a priority queue of this class comes first; None where that is not known."""
    order = in_order(machine, list(series.head), cls) if series.exact else None
    return order[-1] if order else None


# By what the program says


_NOWHERE: Final = 9
_COMPARED: Final = {
    **dict.fromkeys(("std.map", "std.multimap", "std.priority_queue"), 2),
    **dict.fromkeys(("std.set", "std.multiset"), 1),
    **dict.fromkeys(("std.unordered_map", "std.unordered_multimap"), 3),
    **dict.fromkeys(("std.unordered_set", "std.unordered_multiset"), 2),
}
"""Which argument of a template says how its keys are compared."""
_PLAINLY: Final = ("auto", "std.less", "std.greater", "std.equal_to")


def _compared(cls: Value) -> Value:
    return argument(cls, _COMPARED.get(name_of(cls), _NOWHERE))


def is_asked(cls: Value) -> bool:
    """Whether something of the program says how keys are compared."""
    at = _COMPARED.get(cls.name) if isinstance(cls, TypeOf) else None
    return (
        at is not None
        and isinstance(cls, TypeOf)
        and len(cls.arguments) > at
        and name_of(cls.arguments[at]) not in _PLAINLY
    )


def _has_structure(value: Value) -> bool:
    return is_structure(value) or (isinstance(value, Tuple) and any(map(_has_structure, value.items)))


def _is_asked_of(machine: Machine, value: Value) -> bool:
    """Whether a value is an object of a class of the program, which says how such are compared, or a pair."""
    cls = machine.obj(value).cls if isinstance(value, Ref) else None
    return isinstance(cls, Class) or (cls is not None and name_of(cls) == "std.pair")


def without_comparison(machine: Machine, values: list[Value], cls: Value) -> tuple[list[Value], Value]:
    """What a container is made of but for functions that compare and hash, and its class with what compares its keys."""
    at = _COMPARED.get(name_of(cls), _NOWHERE)
    if not is_asked(cls) or not isinstance(cls, TypeOf):
        return values, cls
    functions = [value for value in values if _is_function(machine, value)]
    if functions and not isinstance(cls.arguments[at], Class):
        last = functions[-1]
        told = last if _is_stateless(last) else TypeOf("function", ())
        cls = TypeOf(cls.name, (*cls.arguments[:at], told, *cls.arguments[at + 1 :]))
    elif functions and any(isinstance(f, Ref) and machine.obj(f).attrs for f in functions):
        cls = TypeOf(cls.name, (*cls.arguments[:at], TypeOf("function", ()), *cls.arguments[at + 1 :]))
    return [value for value in values if value not in functions], cls


def _is_function(machine: Machine, value: Value) -> bool:
    """Whether a value compares or hashes; keys that are objects come in braces, or between iterators."""
    if isinstance(value, Ref):
        return isinstance(machine.obj(value).cls, Class)
    return isinstance(value, (Function, Overloads, Partial))


def _is_stateless(value: Value) -> bool:
    """Whether a function has captured nothing but types."""
    if isinstance(value, Partial):
        return _is_stateless(value.function) and all(isinstance(a, (Class, External, TypeOf)) for a in value.arguments)
    return isinstance(value, Function) and not value.cells


def _answer(machine: Machine, cls: Value, a: Value, b: Value) -> bool | None:
    """What a comparison of the program says of two keys; None where that is not known."""
    told = _compared(cls)
    if not isinstance(told, (Class, Function, Partial)):
        return None
    function = machine.call(told, ()) if isinstance(told, Class) else told
    return machine.truth(machine.call(function, (unfolded(machine, cls, a), unfolded(machine, cls, b))))


def _is_less(machine: Machine, cls: Value, a: Value, b: Value) -> bool | None:
    if is_asked(cls):
        return _answer(machine, cls, a, b)
    operator = ">" if name_of(_compared(cls)) == "std.greater" else "<"
    return machine.truth(machine.compare(operator, unfolded(machine, cls, a), unfolded(machine, cls, b)))


def same_key(machine: Machine, cls: Value, a: Value, b: Value) -> bool | None:
    """Whether two keys are one to a container of this class."""
    if not is_asked(cls) and not (_has_structure(a) and _has_structure(b)):
        return equal(machine, a, b)
    if "unordered" in name_of(cls):
        if is_asked(cls):
            return _answer(machine, cls, a, b)
        return machine.truth(machine.compare("==", unfolded(machine, cls, a), unfolded(machine, cls, b)))
    answers = {_is_less(machine, cls, a, b), _is_less(machine, cls, b, a)}
    return False if True in answers else None if None in answers else True


def own_key(machine: Machine, obj: Obj, value: Value) -> Value:
    """The key that a container has which is the same to it as another one: that one where it has none; unknown where nobody knows."""
    if not is_asked(obj.cls) and (value.__class__ is Const or not any(map(_has_structure, options(value)))):
        return value
    unknown = machine.unknown(Cause.OPERATION, "key that the program compares")

    def one(key: Value) -> Value:
        keys = obj.entries if obj.kind == "dict" else obj.series().head
        answers = {other: True if other == key else same_key(machine, obj.cls, other, key) for other in keys}
        same = [other for other, answer in answers.items() if answer is not False]
        if not same:
            return key if not open_ else unknown
        other = same[0]
        sure = len(same) == 1 and answers[other] and (other == key or other not in obj.maybe)
        return other if sure and (other == key or not open_) else unknown

    open_ = obj.rest is not None if obj.kind == "dict" else not obj.series().exact
    return lift(one, value)


def unique(machine: Machine, series: Series, cls: Value, *, several: bool = False) -> Series:
    """The elements of a set of this class made of these, in order; `several`: of one that keeps equal ones."""
    if series.exact and len(series.head) < 2:
        return series
    if series.middle is not None or len(series.head) > _MOST:
        return series.loose()
    kept: list[Value] = []
    asked = is_asked(cls) or any(map(_has_structure, series.head))
    for item in series.head:
        others = kept if not several else []
        answers = {same_key(machine, cls, item, o) if asked else equal(machine, item, o) for o in others}
        if True in answers and not _varies(item):
            continue
        if answers - {False} or _varies(item):
            return Series((), join_all(series.head))
        kept.append(item)
    order = in_order(machine, kept, cls)
    if order is None:
        return Series(tuple(kept)) if len(kept) < 2 or any(_is_object(v) for v in kept) else Series((), join_all(kept))
    return Series(tuple(kept[n] for n in order))


def _varies(value: Value) -> bool:
    """Whether a value stands for several, so that it is not the same as itself."""
    return isinstance(value, (Choice, Unknown, Text)) or (isinstance(value, Tuple) and any(map(_varies, value.items)))


def _is_object(value: Value) -> bool:
    return not isinstance(value, (Const, Text, Tuple, Unknown, Choice))
