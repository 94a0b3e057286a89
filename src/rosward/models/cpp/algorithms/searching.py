# SPDX-License-Identifier: Apache-2.0
"""`<algorithm>`: what is found between two iterators, and what holds of the elements there?

std::find(v.begin(), v.end(), "a")          where the first one stands, or end()
std::any_of(v.begin(), v.end(), f)          whether f says so of one of them
std::max_element(v.begin(), v.end())

What a callable is asked is asked once for each element, or once for all of them where their number is not known.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.choice import join_all
from rosward.domain.slots import Slot
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Const, Ref, Value
from rosward.models.cpp.algorithms.ranges import place, places
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.arrays import decaying
from rosward.models.cpp.iteration.elements import between
from rosward.models.cpp.iteration.iterators import as_iterator, iterator, moved
from rosward.models.cpp.values.slots import new_pair, read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import unknown_from

__all__ = ["NATIVES", "anything", "tests"]

Test = Callable[[Value], "bool | None"]


def tests(call: NativeCall, index: int) -> Test:
    """The question that an algorithm asks of each element: whether it equals a value, or what a callable says."""
    machine = call.machine
    wanted = call.args[index]
    name = call.name.rpartition(".")[2]
    turned = name.endswith("_not")
    if not name.endswith(("_if", "_if_not", "_of")):
        value = read(machine, wanted)
        return lambda element: machine.truth(machine.compare("==", read(machine, element), value))
    function = read(machine, wanted)

    def ask(element: Value) -> bool | None:
        answer = machine.truth(machine.call(function, (element,)))
        return answer if answer is None or not turned else not answer

    return ask


def anything(call: NativeCall, first: int = 0) -> Value | None:
    """The join of all elements between two iterators."""
    return between(call.machine, call.args[first], call.args[first + 1]).element()


def _find(call: NativeCall) -> Value:
    machine = call.machine
    test = tests(call, 2)
    last = read(machine, call.args[1])
    where = places(machine, call.args[0], call.args[1])
    if where is None:
        element = anything(call)
        if element is None or test(element) is False:
            return last
        slot = as_iterator(read(machine, call.args[0]))
        unknown = unknown_from(machine, call.name, "int", element)
        return join_all((_somewhere(machine, slot, element) if slot else unknown, last))
    found: list[Value] = []
    for each in where:
        answer = test(place(machine, each))
        if answer is not False:
            found.append(each)
        if answer:
            return join_all(found)
    return join_all((*found, last))


def _somewhere(machine: Machine, slot: Slot, element: Value) -> Value:
    """An iterator to any element of a container."""
    if slot.kind == "entry" and isinstance(slot.base, Ref):
        keys = machine.obj(slot.base)
        known = [*keys.entries, *(() if keys.rest_key is None else (keys.rest_key,))]
        return iterator(slot.base, join_all(known) if known else NONE, "entry")
    return iterator(slot.base, unknown_from(machine, "find", "int", element), slot.kind)


def _point(call: NativeCall) -> Value:
    """partition_point: the first element that is not what is asked for."""
    return _find(call._replace(name="std.find_if_not"))


def _answers(call: NativeCall) -> list[bool | None]:
    machine = call.machine
    test = tests(call, 2)
    where = places(machine, call.args[0], call.args[1])
    if where is not None:
        return [test(place(machine, each)) for each in where]
    element = anything(call)
    if element is None:
        return []
    return [False] if test(element) is False else [None]


def _count(call: NativeCall) -> Value:
    answers = _answers(call)
    if None in answers:
        return unknown_from(call.machine, call.name, "int", anything(call))
    return Const(answers.count(True))


def _quantified(call: NativeCall) -> Value:
    """all_of, any_of, none_of."""
    answers = _answers(call)
    name = call.name.rpartition(".")[2]
    decisive, otherwise = (False, TRUE) if name == "all_of" else (True, FALSE if name == "any_of" else TRUE)
    if decisive in answers:
        return Const(name == "any_of")
    return unknown_from(call.machine, name, "bool", anything(call)) if None in answers else otherwise


def _equal(call: NativeCall) -> Value:
    machine = call.machine
    ours = between(machine, call.args[0], call.args[1])
    other = read(machine, call.args[2])
    stop = read(machine, call.args[3]) if len(call.args) > 3 else UNBOUND
    if as_iterator(stop) is None:
        stop = moved(machine, other, Const(len(ours.head))) if ours.exact else NONE
    theirs = between(machine, other, stop)
    if not ours.exact or not theirs.exact:
        return unknown_from(machine, "equal", "bool", ours.element(), theirs.element())
    if len(ours.head) != len(theirs.head):
        return FALSE
    answers = {machine.truth(machine.compare("==", a, b)) for a, b in zip(ours.head, theirs.head, strict=True)}
    return FALSE if False in answers else unknown_from(machine, "equal", "bool") if None in answers else TRUE


def _mismatch(call: NativeCall) -> Value:
    """std::mismatch(first, last, other): where the first elements stand that differ."""
    machine = call.machine
    start, other = read(machine, call.args[0]), read(machine, call.args[2])
    ours, theirs = places(machine, start, call.args[1]), None
    is_bounded = len(call.args) > 3 and as_iterator(read(machine, call.args[3])) is not None
    if ours is not None:
        theirs = places(machine, other, call.args[3] if is_bounded else moved(machine, other, Const(len(ours))))
    given = call.args[4:] if is_bounded else call.args[3:]
    if ours is None or theirs is None:
        return unknown_from(machine, "mismatch", "", anything(call))
    for one, two in zip(ours, theirs, strict=False):
        values = place(machine, one), place(machine, two)
        equal = machine.truth(
            machine.call(read(machine, given[0]), values)
            if given
            else machine.compare("==", *(read(machine, v) for v in values))
        )
        if equal is None:
            return unknown_from(machine, "mismatch", "", anything(call))
        if not equal:
            return new_pair(machine, one, two)
    common = Const(min(len(ours), len(theirs)))
    return new_pair(machine, moved(machine, start, common), moved(machine, other, common))


def _lexicographical(call: NativeCall) -> Value:
    """std::lexicographical_compare(first, last, first of the other, last of the other)."""
    machine = call.machine
    ours, theirs = (places(machine, call.args[n], call.args[n + 1]) for n in (0, 2))
    if ours is None or theirs is None:
        return unknown_from(machine, "lexicographical_compare", "bool", anything(call), anything(call, 2))
    for one, two in zip(ours, theirs, strict=False):
        for first, second in ((one, two), (two, one)):
            less = _less(call, place(machine, first), place(machine, second), 4)
            if less is None:
                return unknown_from(machine, "lexicographical_compare", "bool", anything(call))
            if less:
                return TRUE if first is one else FALSE
    return TRUE if len(ours) < len(theirs) else FALSE


def _extreme(call: NativeCall) -> Value:
    """max_element, min_element."""
    machine = call.machine
    where = places(machine, call.args[0], call.args[1])
    if where is None or not where:
        slot, element = as_iterator(read(machine, call.args[0])), anything(call)
        if element is None or slot is None:
            return read(machine, call.args[1])
        return _somewhere(machine, slot, element)
    best = where[0]
    for each in where[1:]:
        first, second = (best, each) if call.name.endswith("max_element") else (each, best)
        less = _less(call, place(machine, first), place(machine, second), 2)
        if less is None:
            return join_all(where)
        if less:
            best = each
    return best


def _both_extremes(call: NativeCall) -> Value:
    """minmax_element."""
    low, high = (_extreme(call._replace(name=f"std.{name}_element")) for name in ("min", "max"))
    return new_pair(call.machine, low, high)


def _less(call: NativeCall, left: Value, right: Value, index: int) -> bool | None:
    machine = call.machine
    if len(call.args) > index:
        return machine.truth(machine.call(read(machine, call.args[index]), (left, right)))
    return machine.truth(machine.compare("<", read(machine, left), read(machine, right)))


def _search_sorted(call: NativeCall) -> Value:
    """lower_bound, upper_bound, binary_search."""
    machine = call.machine
    where = places(machine, call.args[0], call.args[1])
    upper = call.name.endswith("upper_bound")
    for each in where if where is not None else ():
        element, value = place(machine, each), read(machine, call.args[2])
        answer = _less(call, value, element, 3) if upper else _less(call, element, value, 3)
        if answer is None:
            break
        if answer is upper:
            if call.name.endswith("binary_search"):
                return machine.compare("==", read(machine, element), value)
            return each
    else:
        if where is not None:
            return FALSE if call.name.endswith("binary_search") else read(machine, call.args[1])
    if call.name.endswith("binary_search"):
        return unknown_from(machine, call.name, "bool", anything(call))
    slot = as_iterator(read(machine, call.args[0]))
    found = _somewhere(machine, slot, anything(call) or NONE) if slot else unknown_from(machine, call.name, "")
    return join_all((found, read(machine, call.args[1])))


_FUNCTIONS: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("find", "find_if", "find_if_not"), _find),
    **dict.fromkeys(("count", "count_if"), _count),
    **dict.fromkeys(("all_of", "any_of", "none_of"), _quantified),
    "partition_point": _point,
    "equal": _equal,
    "mismatch": _mismatch,
    "lexicographical_compare": _lexicographical,
    **dict.fromkeys(("max_element", "min_element"), _extreme),
    "minmax_element": _both_extremes,
    **dict.fromkeys(("lower_bound", "upper_bound", "binary_search"), _search_sorted),
}

NATIVES: Final[dict[str, NativeFunction]] = {
    f"std.{name}": decaying(function)
    for name, function in with_least(
        _FUNCTIONS,
        3,
        {**dict.fromkeys(("max_element", "min_element", "minmax_element"), 2), "lexicographical_compare": 4},
    ).items()
}
