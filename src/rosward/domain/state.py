# SPDX-License-Identifier: Apache-2.0
"""The state of an interpretation at one point: the heap, and what has surely happened. And how two states join.

if unknown: self.t = 'a'      heap 1: self.t 'a'    joined: self.t 'a' | 'b'
else:       self.t = 'b'      heap 2: self.t 'b'
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import compress
from operator import is_not
from typing import Final, final

from rosward.domain.choice import join, join_all
from rosward.domain.heap import Alternatives, Obj, Shuffled, fields_of
from rosward.domain.memory import Heap
from rosward.domain.series import Series
from rosward.domain.series import joined as joined_series
from rosward.domain.suspended import Suspension, join_suspended
from rosward.domain.table import differing, marked, more_marks, written
from rosward.domain.values import UNBOUND, Ref, Unknown, Value

Merge = Callable[[Value, Value], Value]
EventKey = tuple[object, ...]
_PARTIAL: Final = ("instance", "class", "module", "cell")
NOTHING_DONE: Final[frozenset[EventKey]] = frozenset()


@final
class State:
    """The heap; `version` changes with every write, so equal versions mean equal heaps; `done`: effects that happened on every path here."""

    __slots__ = ("done", "heap", "version")

    def __init__(self, heap: Heap, version: int, done: frozenset[EventKey]) -> None:
        self.heap = heap
        self.version = version
        self.done = done

    def copy(self) -> State:
        """An independent copy."""
        return State(self.heap.copy(), self.version, self.done)


def join_states(
    left: State, right: State, fresh: Callable[[int], int], merge: Merge = join, known: Heap | None = None
) -> State:
    """The least state that covers both (`merge` may widen instead: left is then the older one). Reuses `left` in place.

    The version of the result is left's where left already covers right: so a fixpoint shows by its version. `fresh` gives a new one, and is
    told how many objects were looked at. `known`: a heap that left surely covers: the one that it was joined with last.
    """
    left.done &= right.done
    if left.version == right.version:
        return left
    compared, changed = left.heap.cover(
        right.heap, lambda ours, theirs: join_objects(ours, theirs, merge), widens=merge is not join, known=known
    )
    version = fresh(compared)
    if changed:
        left.version = version
    return left


def join_objects(left: Obj, right: Obj, merge: Merge) -> Obj:
    """An object record that covers both; `left` itself where it already does."""
    result = left
    if left.attrs is not right.attrs:
        attrs, one_sided = _join_attrs(left.attrs, right.attrs, merge)
        if attrs is not left.attrs:
            result = left.copy()
            result.attrs = attrs
        if left.kind in _PARTIAL:
            absent = left.partial
            for name in (*more_marks(left.partial, right.partial), *one_sided):
                absent = marked(absent, name)
            if absent is not left.partial:
                result = result.copy() if result is left else result
                result.partial = absent
    if right.many and not left.many:
        result = result.copy() if result is left else result
        result.many = True
    if left.payload is right.payload and not isinstance(left.payload, Suspension):
        pass
    elif isinstance(left.payload, Suspension) and isinstance(right.payload, Suspension):
        suspension = join_suspended(left.payload, right.payload, merge)
        result = result if suspension is left.payload else result.replace(payload=suspension)
    elif isinstance(left.payload, Value) and isinstance(right.payload, Value):
        payload = merge(left.payload, right.payload)
        result = result if payload == left.payload else result.replace(payload=payload)
    elif left.payload is None and right.payload.__class__ is Unknown:  # a message that may have been in unknown hands
        result = result.replace(payload=right.payload)
    if left.kind in ("list", "set"):
        result = _join_elements(result, left, right, merge)
    elif left.kind == "dict":
        result = _join_entries(result, left, right, merge)
    return result


def _join_attrs(
    left: Mapping[str, Value], right: Mapping[str, Value], merge: Merge
) -> tuple[Mapping[str, Value], list[str]]:
    """The attributes that cover both, and the names that only one of them has."""
    result, one_sided = left, []
    for name, ours, theirs in differing(left, right):
        if ours is None or theirs is None or ours is UNBOUND or theirs is UNBOUND:
            one_sided.append(name)
        if theirs is None:
            continue
        merged = theirs if ours is None else merge(ours, theirs)
        if ours is None or merged != ours:
            result = written(result, name, merged)
    return result, one_sided


def _join_elements(result: Obj, left: Obj, right: Obj, merge: Merge) -> Obj:
    if (
        left.items == right.items
        and left.rest == right.rest
        and left.payload == right.payload
        and left.ends == right.ends
    ):
        return result
    if left.payload.__class__ is Shuffled and left.payload != right.payload:
        left, result = left.replace(payload=None), result.replace(payload=None)
    if (
        left.items is not None
        and right.items is not None
        and len(left.items) == len(right.items)
        and left.rest == right.rest
    ):
        items = tuple(merge(a, b) for a, b in zip(left.items, right.items, strict=True))
        if items == left.items:
            return result
        return result.replace(items=items)
    ours, theirs = element(left), element(right)
    ways = _alternatives(left, right)
    payload = ways if ways is not None or left.payload.__class__ is Alternatives else left.payload
    ends = _join_ends(left, right, merge)
    if left.items is None and (theirs is None or (ours is not None and merge(ours, theirs) == ours)):
        if ends == left.ends:
            return result if payload == left.payload else result.replace(payload=payload)
        return result.replace(items=None, rest=ours, payload=payload, ends=ends)
    both = merge(ours if ours is not None else UNBOUND, theirs if theirs is not None else UNBOUND)
    return result.replace(items=None, rest=None if both is UNBOUND else both, payload=payload, ends=ends)


def _join_ends(left: Obj, right: Obj, merge: Merge) -> Series | None:
    """How both lists begin and end, of lists that differ in length; None where nothing is known of it."""
    if left.kind != "list":
        return None
    ours, theirs = left.series(), right.series()
    if not (ours.least or ours.exact) or not (theirs.least or theirs.exact):
        return None
    return fields_of(joined_series(ours, theirs, merge))["ends"]


_MOST_ALTERNATIVES: Final = 200


def _alternatives(left: Obj, right: Obj) -> Alternatives | None:
    """Which elements two lists of objects have in common, and which may be there; None where that is not known or not worth it."""
    ours, theirs = _elements_apart(left), _elements_apart(right)
    if ours is None or theirs is None:
        return None
    found = dict(ours)
    for value, sure in theirs.items():
        found[value] = sure and found.get(value, False)
    for value in ours.keys() - theirs.keys():
        found[value] = False
    return Alternatives(tuple(found.items())) if len(found) <= _MOST_ALTERNATIVES else None


def _elements_apart(obj: Obj) -> dict[Value, bool] | None:
    """The elements of a list that are told apart, and whether each is surely there."""
    if obj.kind != "list" or not (obj.payload is None or isinstance(obj.payload, (Alternatives, str))):
        return None
    if obj.items is not None:
        told = dict.fromkeys(obj.items, True)
        return told if len(told) == len(obj.items) and all(v.__class__ is Ref for v in told) else None
    return dict(obj.payload.elements) if isinstance(obj.payload, Alternatives) else None


def element(obj: Obj) -> Value | None:
    """The join of all elements of a list or set; None where it is surely empty."""
    if not obj.items:
        return obj.rest
    return join_all(obj.items if obj.rest is None else (*obj.items, obj.rest))


def _join_entries(result: Obj, left: Obj, right: Obj, merge: Merge) -> Obj:
    if (
        left.entries == right.entries
        and list(left.entries) == list(right.entries)
        and left.maybe == right.maybe
        and left.rest == right.rest
        and left.rest_key == right.rest_key
    ):
        return result
    entries = dict(left.entries)
    maybe = set(left.maybe | right.maybe)
    for key, theirs in right.entries.items():
        ours = entries.get(key)
        if ours is None:
            entries[key] = theirs
            maybe.add(key)
        elif ours != theirs:
            entries[key] = merge(ours, theirs)
    maybe.update(key for key in left.entries if key not in right.entries)
    maybe.update(_out_of_order(left, right, maybe))
    rest = _merge_optional(left.rest, right.rest, merge)
    rest_key = _merge_keys(left, right, merge)
    if entries == left.entries and maybe == left.maybe and rest == left.rest and rest_key == left.rest_key:
        return result
    return result.replace(entries=entries, maybe=frozenset(maybe), rest=rest, rest_key=rest_key)


def _out_of_order(left: Obj, right: Obj, maybe: set[Value]) -> list[Value]:
    """The keys that both have, where they come in different orders: none of them is surely the first."""
    ours = [key for key in left.entries if key not in maybe]
    theirs = [key for key in right.entries if key not in maybe]
    return [] if ours == theirs else [a for a, b in zip(ours, theirs, strict=True) if a != b]


def _merge_keys(left: Obj, right: Obj, merge: Merge) -> Value | None:
    """The keys that are not known; None where they may be any."""
    if left.rest is None or right.rest is None:
        return right.rest_key if left.rest is None else left.rest_key
    if left.rest_key is None or right.rest_key is None:
        return None
    return merge(left.rest_key, right.rest_key)


def _merge_optional(left: Value | None, right: Value | None, merge: Merge) -> Value | None:
    if left is None or right is None or left == right:
        return right if left is None else left
    return merge(left, right)


def join_registers(left: list[Value], right: list[Value], merge: Merge = join) -> list[Value]:
    """The registers that cover both; `left` itself where it already does."""
    result = left
    differ = map(is_not, left, right)
    for number in compress(range(len(right)), differ):
        ours, theirs = left[number], right[number]
        if theirs is UNBOUND:
            continue
        merged = theirs if ours is UNBOUND else merge(ours, theirs)
        if merged is not ours and merged != ours:
            if result is left:
                result = left.copy()
            result[number] = merged
    return result
