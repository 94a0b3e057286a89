# SPDX-License-Identifier: Apache-2.0
"""The methods of `list` and `tuple`, on records of all elements or, where their number is not known, of their join.

names = ['a']; names.append(unknown)        items ('a', unknown)
names.pop(unknown)                          any of the elements; each place then holds its element or the next one
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final

from rosward.domain.choice import join, join_all
from rosward.domain.compound import Slice, Tuple
from rosward.domain.heap import Obj, fields_of
from rosward.domain.series import Series, concatenated
from rosward.domain.unknown import NO_ORIGINS
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Value
from rosward.models.asked_order import by_asking
from rosward.models.native import Items, Machine, NativeCall, NativeFunction
from rosward.models.python.comparing.compare import comparable, equal
from rosward.models.python.comparing.equal_objects import compares
from rosward.models.python.containers.list_alternatives import Told, elements_apart, keep_told
from rosward.models.python.plain import (
    MAX_ITEMS,
    NOT_PLAIN,
    Raised,
    int_of,
    listed,
    native,
    origins,
    slice_of,
    unknown_from,
    with_origins,
)

ITERATOR: Final = "iterator"
"""The payload of a list that stands for an iterator: `next` takes its first element away."""
VIEW: Final = "view"
"""The payload of a list that stands for what `keys`, `values` and `items` of a dict show."""


def element(obj: Obj) -> Value | None:
    """The join of all elements; None where there are none."""
    values = [*(obj.items or ()), *(() if obj.rest is None else (obj.rest,))]
    return join_all(values) if values else None


def write(machine: Machine, ref: Ref, items: Iterable[Value] | None, rest: Value | None = None) -> None:
    """Give a list or set new elements: `items`, then any number of `rest`."""
    write_series(machine, ref, Series(() if items is None else tuple(items), rest))


def write_series(machine: Machine, ref: Ref, series: Series) -> None:
    """Give a list or set new elements."""
    obj = machine.obj(ref)
    machine.update(ref, obj.replace(**fields_of(series, obj.kind, MAX_ITEMS)))


def exhaust(machine: Machine, iterator: Value) -> None:
    """Nothing is left of an iterator over items of which all were taken: whoever has kept it sees none of them."""
    if isinstance(iterator, Ref) and machine.obj(iterator).payload == ITERATOR:
        write_series(machine, iterator, Series(()))


def add_to_rest(machine: Machine, ref: Ref, values: Iterable[Value]) -> None:
    """The number of elements is no longer known, and these may be among them."""
    obj = machine.obj(ref)
    joined = join_all([*(obj.items or ()), *(() if obj.rest is None else (obj.rest,)), *values])
    write(machine, ref, None, None if joined is UNBOUND else joined)


def _receiver(call: NativeCall) -> Ref | None:
    first = call.args[0] if call.args else None
    return first if isinstance(first, Ref) and call.machine.obj(first).kind in ("list", "set") else None


def _lost(call: NativeCall) -> Value:
    """The receiver is no list that we know."""
    return unknown_from(call.machine, call.name, "", *call.args)


def _append(call: NativeCall) -> Value:
    ref, value = _receiver(call), call.args[1]
    if ref is not None:
        _add(call.machine, ref, Series((value,)), elements_apart(call.machine, Tuple((value,))))
    return NONE


def _add(machine: Machine, ref: Ref, more: Series, apart: Told) -> None:
    """Elements come to the end of a list."""
    before = elements_apart(machine, ref)
    write_series(machine, ref, concatenated((machine.obj(ref).series(), more)))
    keep_told(machine, ref, (before, apart))


def _extend(call: NativeCall) -> Value:
    ref = _receiver(call)
    more = call.machine.series(call.args[1])
    if ref is not None:
        _add(call.machine, ref, more, elements_apart(call.machine, call.args[1]))
    return NONE


def _insert(call: NativeCall) -> Value:
    ref, index, value = _receiver(call), int_of(call.args[1]), call.args[2]
    if ref is None:
        return NONE
    items = call.machine.obj(ref).items
    if index is not None:
        write_series(call.machine, ref, call.machine.obj(ref).series().with_inserted(index, value))
    elif items is None:
        add_to_rest(call.machine, ref, (value,))
    else:
        write(call.machine, ref, (join_all((*items[max(0, n - 1) : n + 1], value)) for n in range(len(items) + 1)))
    return NONE


def _pop(call: NativeCall) -> Value:
    """list.pop(index), and `del list[index]`."""
    machine, ref = call.machine, _receiver(call)
    if ref is None:
        return _lost(call)
    obj = machine.obj(ref)
    where = call.args[1] if len(call.args) > 1 else Const(-1)
    if isinstance(where, Slice):
        return _delete_slice(machine, ref, where)
    anything = element(obj)
    if anything is None:
        raise Raised("IndexError", "pop from empty list", (Const("pop from empty list"),))
    index, series = int_of(where), obj.series()
    if index is None:
        if obj.items is None:
            write_series(machine, ref, series.loose())
        else:
            write(machine, ref, (join(a, b) for a, b in zip(obj.items, obj.items[1:], strict=False)))
        return anything
    taken = series.at(index)
    if taken is None:
        raise Raised("IndexError", "pop index out of range", (Const("pop index out of range"),))
    write_series(machine, ref, series.without_at(index))
    return with_origins(taken, origins(where))


def _delete_slice(machine: Machine, ref: Ref, where: Slice) -> Value:
    ends = slice_of(where)
    series = machine.obj(ref).series()
    write_series(machine, ref, series.loose() if ends is None else series.without_part(ends))
    return NONE


def _remove(call: NativeCall) -> Value:
    machine, ref, value = call.machine, _receiver(call), call.args[1]
    if ref is None:
        return NONE
    series = machine.obj(ref).series()
    found = _position(machine, series.head, value)
    if series.exact and found == -1:
        raise Raised("ValueError", "list.remove(x): x not in list", (Const("list.remove(x): x not in list"),))
    if found is None or found == -1:
        add_to_rest(machine, ref, ())
    else:
        write_series(machine, ref, series.without_at(found))
    return NONE


def _position(machine: Machine, items: tuple[Value, ...], value: Value) -> int | None:
    """The index of the first element that equals a value; -1 where there is none, None where it is not known."""
    for number, item in enumerate(items):
        answer = _same(machine, item, value)
        if answer is None and compares(machine, item):  # the next ones may be asked, too
            for other in items[number + 1 :]:
                _same(machine, other, value)
        if answer is not False:
            return number if answer else None
    return -1


def _same(machine: Machine, item: Value, value: Value) -> bool | None:
    """Whether an element is what is looked for, or equals it, as the program's `__eq__` says."""
    if item == value and isinstance(item, Ref) and not machine.obj(item).many:
        return True
    if compares(machine, item) or compares(machine, value):
        return machine.truth(machine.compare("==", item, value))
    return equal(machine, item, value)


def _clear(call: NativeCall) -> Value:
    ref = _receiver(call)
    if ref is not None:
        write(call.machine, ref, ())
    return NONE


def _index(call: NativeCall) -> Value:
    places = call.machine.series(call.args[0])
    known, rest = places.head, places.behind_head()
    bounds = [int_of(bound) for bound in call.args[2:]]
    if rest is not None or None in bounds:
        return unknown_from(call.machine, call.name, "int", *call.args)
    low, high = (*bounds, None, None)[:2]
    within = range(len(known))[low:high]
    found = _position(call.machine, known[within.start : within.stop], call.args[1])
    if found is None:
        return unknown_from(call.machine, call.name, "int", *call.args)
    if found == -1:
        raise Raised("ValueError", "value is not in list")
    return Const(within.start + found, origins(*call.args[1:]))


def _count(call: NativeCall) -> Value:
    known, rest = call.machine.iterate(call.args[0])
    answers = [_same(call.machine, item, call.args[1]) for item in known]
    if None in answers or rest is not None:
        return unknown_from(call.machine, call.name, "int", *call.args)
    return Const(answers.count(True), origins(call.args[1]))


def order(machine: Machine, items: Items, key: Value | None, reverse: Value | None) -> Items:
    """Sorted items: in order where all keys are known, else each place holds any of them."""
    known, rest = items
    keys = list(known) if key is None or key == NONE else [machine.call(key, (item,)) for item in known]
    if rest is not None and key is not None:
        machine.call(key, (rest,))
    if rest is not None:
        return Items((), join_all((*known, rest)))
    if len(known) < 2:
        return items
    decided = False if reverse is None else machine.truth(reverse)
    ranks: list[Any] = [comparable(machine, k) for k in keys]  # Python says which of them it can order
    if any(k is NOT_PLAIN for k in ranks) or decided is None:
        placed = None if decided is None else _by_asking(machine, keys, reverse=decided)
        if placed is not None:
            return Items(tuple(known[n] for n in placed))
        return Items((join_all(known),) * len(known))
    try:
        ranked = sorted(range(len(known)), key=lambda n: ranks[n], reverse=decided)
    except TypeError as error:
        raise Raised("TypeError", str(error)) from error
    source = origins(*keys) if any(origins(k) for k in keys) else NO_ORIGINS
    return Items(tuple(with_origins(known[n], source) for n in ranked))


_MOST_ASKED: Final = 20


def _by_asking(machine: Machine, keys: list[Value], *, reverse: bool) -> list[int] | None:
    """The order of keys that say themselves which of two goes first (`__lt__`); None where one does not know."""
    given = keys[::-1] if reverse else keys
    placed = by_asking(given, lambda a, b: machine.truth(machine.compare("<", a, b)), _MOST_ASKED)
    return [len(keys) - 1 - n for n in reversed(placed)] if placed is not None and reverse else placed


def _sort(call: NativeCall) -> Value:
    ref = _receiver(call)
    if ref is not None:
        obj = call.machine.obj(ref)
        if obj.items is not None:
            ordered = order(
                call.machine, call.machine.iterate(ref), call.keywords.get("key"), call.keywords.get("reverse")
            )
            write(call.machine, ref, ordered.known)
        elif obj.rest is not None:
            order(call.machine, Items((), obj.rest), call.keywords.get("key"), None)
            write_series(call.machine, ref, obj.series().loose())
    return NONE


def _reverse(call: NativeCall) -> Value:
    ref = _receiver(call)
    if ref is not None:
        write_series(call.machine, ref, call.machine.obj(ref).series().reversed())
    return NONE


def _copy(call: NativeCall) -> Value:
    return listed(call.machine, call.name, *call.machine.series(call.args[0]))


def new_tuple(machine: Machine, series: Series) -> Value:
    """A tuple; one of unknown length lives on the heap like a list."""
    if series.exact and len(series.head) <= MAX_ITEMS:
        return Tuple(series.head)
    return listed(machine, "tuple", *series, cls="tuple")


NATIVES: Final[dict[str, NativeFunction]] = {
    "list.append": native(_append, 2),
    "list.extend": native(_extend, 2),
    "list.insert": native(_insert, 3),
    "list.pop": native(_pop, 1),
    "list.remove": native(_remove, 2),
    "list.clear": native(_clear, 1),
    "list.index": native(_index, 2),
    "list.count": native(_count, 2),
    "list.sort": native(_sort, 1),
    "list.reverse": native(_reverse, 1),
    "list.copy": native(_copy, 1),
    "tuple.index": native(_index, 2),
    "tuple.count": native(_count, 2),
}
