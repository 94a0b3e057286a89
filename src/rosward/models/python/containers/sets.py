# SPDX-License-Identifier: Apache-2.0
"""The methods of `set` and `frozenset`. Elements are exact where each is one known value, in order of insertion.

{'a', 'b'} & {'b'}          {'b'}
{'a', unknown}              any number of 'a' or unknown: the two may be one
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join, join_all
from rosward.domain.compound import Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.values import NONE, Const, Ref, Value
from rosward.models.native import Items, Machine, NativeCall, NativeFunction
from rosward.models.python.comparing.equal_objects import compares, member_value, row_of
from rosward.models.python.containers.dicts import key_of
from rosward.models.python.containers.lists import add_to_rest, element, write
from rosward.models.python.plain import Raised, key_shown, listed, native, unknown_from

FROZEN: Final = Native("builtins.frozenset")
_OPERATORS: Final = {"union": "|", "intersection": "&", "difference": "-", "symmetric_difference": "^"}


def distinct(machine: Machine, items: Items) -> Items:
    """The elements of a set made of items: each once; their number is not known where two may be equal."""
    found: dict[Value, Value] = {}
    loose: list[Value] = [] if items.rest is None else [items.rest]
    for item in items.known:
        key = _key(machine, item)
        if key is None:
            loose.append(item)
        else:  # of two that are equal, Python keeps the first
            before = found.get(key)
            found[key] = item if before is None else join(before, item) if key_of(before) == key_of(item) else before
    if not loose:
        return Items(tuple(found.values()))
    if not found and len(items.known) == 1 and items.rest is None:
        return items
    return Items((), join_all((*found.values(), *loose)))


def _key(machine: Machine, item: Value) -> Value | None:
    """The key of an element, one for all that Python takes for equal: 1, True, 1.0, in tuples, too, and a member that is 1.

    None where its class says what is equal.
    """
    held = member_value(machine, item)
    if held is not None:
        return _as_integer(Const(held.value))
    if isinstance(item, Ref) and machine.obj(item).kind == "set":
        return _of_frozen(machine, machine.obj(item))
    row = row_of(machine, item) if isinstance(item, Ref) else None
    key = None if compares(machine, item) else key_of(item if row is None else row)
    return None if key is None else _as_integer(key)


def _of_frozen(machine: Machine, obj: Obj) -> Value | None:
    """The key of a frozenset of which everything is known: it is equal to another one that holds the same."""
    keys = None if obj.items is None or obj.rest is not None else [_key(machine, item) for item in obj.items]
    if keys is None or not all(isinstance(key, Const) for key in keys):
        return None
    return Tuple((FROZEN, *sorted((key for key in keys if key is not None), key=repr)))


def _as_integer(key: Value) -> Value:
    if isinstance(key, Tuple):
        return Tuple(tuple(map(_as_integer, key.items)))
    number = key.value if isinstance(key, Const) else None
    if isinstance(number, bool) or (isinstance(number, float) and number.is_integer()):
        return Const(int(number))
    return key


def new_set(machine: Machine, items: Items, frozen: bool = False) -> Ref:
    """A set of items."""
    return listed(machine, "set", *distinct(machine, items), kind="set", cls="frozenset" if frozen else "set")


def combine(machine: Machine, op: str, left: Items, right: Items) -> Items:
    """The elements of `left | right` and its like."""
    if op == "|":
        rests = [r for r in (left.rest, right.rest) if r is not None]
        return distinct(machine, Items((*left.known, *right.known), join_all(rests) if rests else None))
    if op == "^":
        first, second = combine(machine, "-", left, right), combine(machine, "-", right, left)
        return combine(machine, "|", first, second)
    ours, theirs = distinct(machine, left), distinct(machine, right)
    keys = _keys(machine, theirs)
    if _keys(machine, ours) is None or keys is None:
        if not ours.known and ours.rest is None:
            return ours
        return Items((), join_all((*ours.known, *(() if ours.rest is None else (ours.rest,)))))
    return Items(tuple(v for v in ours.known if (_key(machine, v) in keys) is (op == "&")))


def _keys(machine: Machine, items: Items) -> set[Value] | None:
    """The keys of elements that are all known, else None."""
    keys = {_key(machine, v) for v in items.known}
    return None if items.rest is not None or None in keys else {k for k in keys if k is not None}


def _combined(call: NativeCall) -> Value:
    """union, intersection, difference and symmetric_difference of any number of iterables."""
    machine = call.machine
    items = machine.iterate(call.args[0])
    for other in call.args[1:]:
        items = combine(machine, _OPERATORS[call.name.rpartition(".")[2]], items, machine.iterate(other))
    first = call.args[0]
    return new_set(machine, items, isinstance(first, Ref) and machine.obj(first).cls == FROZEN)


def _changed(call: NativeCall) -> Value:
    """update, intersection_update and so on."""
    machine, ref = call.machine, _receiver(call)
    name = call.name.rpartition(".")[2]
    op = _OPERATORS[name.removesuffix("_update")] if name != "update" else "|"
    if ref is not None:
        for other in call.args[1:]:
            obj = machine.obj(ref)
            write(
                machine, ref, *_elements(combine(machine, op, Items(obj.items or (), obj.rest), machine.iterate(other)))
            )
    return NONE


def _elements(items: Items) -> tuple[tuple[Value, ...] | None, Value | None]:
    return (items.known, None) if items.rest is None else (None, join_all((*items.known, items.rest)))


def _receiver(call: NativeCall) -> Ref | None:
    first = call.args[0] if call.args else None
    return first if isinstance(first, Ref) and call.machine.obj(first).kind == "set" else None


def _add(call: NativeCall) -> Value:
    ref = _receiver(call)
    if ref is not None:
        obj = call.machine.obj(ref)
        if obj.items is None:
            add_to_rest(call.machine, ref, (call.args[1],))
        else:
            write(call.machine, ref, *_elements(distinct(call.machine, Items((*obj.items, call.args[1])))))
    return NONE


def _discard(call: NativeCall) -> Value:
    """discard and remove."""
    machine, ref = call.machine, _receiver(call)
    if ref is None:
        return NONE
    items, key = machine.obj(ref).items, _key(machine, call.args[1])
    if items is None or key is None or _keys(machine, Items(items)) is None:
        add_to_rest(machine, ref, ())
        return NONE
    left = [v for v in items if _key(machine, v) != key]
    if len(left) == len(items) and call.name.endswith("remove"):
        raise Raised("KeyError", key_shown(call.args[1]), (call.args[1],))
    write(machine, ref, left)
    return NONE


def _pop(call: NativeCall) -> Value:
    ref = _receiver(call)
    if ref is None:
        return unknown_from(call.machine, call.name, "", *call.args)
    obj = call.machine.obj(ref)
    found = element(obj)
    if found is None:
        raise Raised("KeyError", "pop from an empty set", (Const("pop from an empty set"),))
    if obj.items is not None and len(obj.items) == 1:
        write(call.machine, ref, ())
    else:
        add_to_rest(call.machine, ref, ())
    return found


def _clear(call: NativeCall) -> Value:
    ref = _receiver(call)
    if ref is not None:
        write(call.machine, ref, ())
    return NONE


def _copy(call: NativeCall) -> Value:
    first = call.args[0]
    frozen = isinstance(first, Ref) and call.machine.obj(first).cls == FROZEN
    return new_set(call.machine, call.machine.iterate(first), frozen)


def subset(machine: Machine, left: Value, right: Value) -> bool | None:
    """Whether all elements of left are in right; None where it is not known."""
    ours, theirs = _keys(machine, machine.iterate(left)), _keys(machine, machine.iterate(right))
    if ours is not None and not ours:
        return True
    return None if ours is None or theirs is None else ours <= theirs


def _question(call: NativeCall) -> Value:
    """issubset, issuperset and isdisjoint."""
    machine, name = call.machine, call.name.rpartition(".")[2]
    left, right = call.args[0], call.args[1]
    if name == "isdisjoint":
        known, rest = combine(machine, "&", machine.iterate(left), machine.iterate(right))
        answer = None if rest is not None else not known
    else:
        answer = subset(machine, *((left, right) if name == "issubset" else (right, left)))
    return unknown_from(machine, call.name, "bool", left, right) if answer is None else Const(answer)


NATIVES: Final[dict[str, NativeFunction]] = {
    "set.add": native(_add, 2),
    "set.discard": native(_discard, 2),
    "set.remove": native(_discard, 2),
    "set.pop": native(_pop, 1),
    "set.clear": native(_clear, 1),
    "set.copy": native(_copy, 1),
    **{f"set.{name}": native(_combined, 1) for name in _OPERATORS},
    **{f"set.{name}": native(_changed) for name in ("update", *(f"{n}_update" for n in _OPERATORS if n != "union"))},
    **{f"set.{name}": native(_question, 2) for name in ("issubset", "issuperset", "isdisjoint")},
}
