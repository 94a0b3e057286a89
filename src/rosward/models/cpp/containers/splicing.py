# SPDX-License-Identifier: Apache-2.0
"""Elements that go from one list to another, or to another place of it, and where a reverse iterator is in the list itself.

a.splice(a.end(), b)            all of b
a.splice(a.begin(), a, i)       one element to the front
a.splice(a.end(), b, i, j)      those from i to j
a.erase(std::next(r).base())    the element to which `r` leads
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.series import Series
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.iteration.contained import receivers
from rosward.models.cpp.iteration.iterators import as_iterator, iterator, length
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.lists import write_series
from rosward.models.python.plain import int_of, unknown_from

__all__ = ["NATIVES"]


def _number(machine: Machine, value: Value, size: int) -> int | None:
    """The number of the element to which an iterator leads."""
    slot = as_iterator(read(machine, value))
    if slot is None or slot.kind != "item" or not isinstance(slot.key, Value):
        return None
    return size if slot.key == NONE else int_of(slot.key)


def _splice(call: NativeCall) -> Value:
    """list.splice(position, other), (position, other, element), (position, other, first, last)."""
    machine = call.machine
    others = [o for o in options(read(machine, call.args[2])) if isinstance(o, Ref)]
    for ref in receivers(call):
        for other in others:
            _move(machine, ref, other, call.args[1], call.args[3:], sure=len(others) == 1)
    return NONE


def _move(machine: Machine, ref: Ref, other: Ref, where: Value, given: tuple[Value, ...], *, sure: bool) -> None:
    ours, theirs = machine.obj(ref).series(), machine.obj(other).series()
    here, size = _number(machine, where, len(ours.head)), len(theirs.head)
    numbers = [_number(machine, each, size) for each in given]
    if not given:
        numbers = [0, size]
    first, last = numbers[0], numbers[1] if len(numbers) > 1 else None if numbers[0] is None else numbers[0] + 1
    if not sure or not ours.exact or not theirs.exact or here is None or first is None or last is None:
        everything = [v for v in (ours.element(), theirs.element()) if v is not None]
        for each in {ref, other} if everything else ():
            write_series(machine, each, Series((), join_all(everything)))
        return
    taken, left = theirs.head[first:last], (*theirs.head[:first], *theirs.head[last:])
    if ref == other:
        here -= len(taken) if here >= last else max(0, here - first)
        write_series(machine, ref, Series((*left[:here], *taken, *left[here:])))
        return
    write_series(machine, ref, Series((*ours.head[:here], *taken, *ours.head[here:])))
    write_series(machine, other, Series(left))


def _base(call: NativeCall) -> Value:
    """reverse_iterator.base(): the iterator to the element behind."""
    machine = call.machine
    return join_all(_behind(machine, value) for value in options(read(machine, call.args[0])))


def _behind(machine: Machine, value: Value) -> Value:
    slot = as_iterator(value)
    if slot is None or slot.kind != "reverse" or not isinstance(slot.key, Value):
        return machine.unknown(Cause.CALL, "base")
    if slot.key == NONE:
        return iterator(slot.base, Const(0))
    at, size = int_of(slot.key), length(machine, slot.base)
    if at is None or (size is None and at >= 0):
        return iterator(slot.base, unknown_from(machine, "base", "int", slot.key))
    is_end = isinstance(slot.base, Ref) and (at < 0 or at + 1 == size)
    return iterator(slot.base, NONE if is_end else Const(at + 1))


NATIVES: Final[dict[str, NativeFunction]] = {
    **with_least({"std.vector.splice": _splice}, 3),
    "std.shared_ptr.base": _base,
}
