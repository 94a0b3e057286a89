# SPDX-License-Identifier: Apache-2.0
"""Objects on the heap: immutable records, replaced when the program writes to one.

self.items.append(x)    heap[a] = heap[a].replace(items=(*items, x))
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from typing import Any, Final, Literal, TypedDict, final

from rosward.domain.series import Series
from rosward.domain.table import NO_MARKS, Table, unmarked, written
from rosward.domain.values import UNBOUND, Value
from rosward.records import NamedTuple

NO_ATTRS: Final[dict[str, Value]] = {}


KIND: Final = ""
"""No attribute has this name: who asks for it alone asks of what kind and class an object is, and whether it stands for several."""


CLASSES: Final = "__class__"
"""The classes of an object that may have been given another one, as an attribute."""


class Alternatives(NamedTuple):
    """The payload of a list of unknown length: its elements in order, and whether each is surely there. Any write to the list drops it."""

    elements: tuple[tuple[Value, bool], ...]


class Shuffled(NamedTuple):
    """The payload of a list whose order is not known: what it holds, in some order. Each of its places holds any. Any write to the list drops it."""

    items: tuple[Value, ...]


MAX_ENDS: Final = 100
"""So many elements at both ends of a list of unknown length are kept in order."""


class Elements(TypedDict):
    """The fields of a record that hold the elements of a list or set."""

    items: tuple[Value, ...] | None
    rest: Value | None
    ends: Series | None


_OF_ELEMENTS: Final = (Alternatives, Shuffled)
"""The payloads that tell of the elements of a list."""

ObjKind = Literal["instance", "list", "set", "dict", "class", "module", "cell", "generator"]
"""What an object of the heap is."""


def fields_of(series: Series, kind: ObjKind = "list", most: int | None = None) -> Elements:
    """How a record holds a series: exactly, up to `most` elements."""
    if series.exact and (most is None or len(series.head) <= most):
        return {"items": series.head, "rest": None, "ends": None}
    kept = kind == "list" and not series.exact and 0 < series.least <= MAX_ENDS
    return {"items": None, "rest": series.element(), "ends": series if kept else None}


@final
class Obj:
    """One object: its class and what it holds. Fields are never changed in place; `replace` makes a new record.

    kind is 'instance', 'list', 'set', 'dict', 'class', 'module', 'cell' or 'generator'.
    attrs: attributes (variables of a module, `value` of a cell), by name; `partial` holds those that may be absent.
    items: the elements of a list or set in order, exactly, or None where the length is not known; then `rest` joins all elements (None: empty),
    and `ends` tells how a list begins and ends, where that is known. A write that does not say how drops it.
    entries: the items of a dict whose keys are known, in order, key value to value; `maybe` holds the keys that may be absent;
    `rest` joins the values under keys that are not known (None: there are none), `rest_key` those keys.
    many: the record stands for several objects of the program (made in a loop or a callback that runs again): writes only add.
    payload: what the kind needs beyond (the suspended call of a generator, say).
    joined: the join of all elements, once somebody has asked for it (`element`); nothing that the program sees.
    """

    __slots__ = (
        "attrs",
        "cls",
        "ends",
        "entries",
        "items",
        "joined",
        "kind",
        "many",
        "maybe",
        "partial",
        "payload",
        "rest",
        "rest_key",
    )

    def __init__(
        self,
        kind: ObjKind,
        cls: Value,
        attrs: Mapping[str, Value] = NO_ATTRS,
        items: tuple[Value, ...] | None = (),
        rest: Value | None = None,
        entries: dict[Value, Value] | None = None,
        maybe: frozenset[Value] = frozenset(),
        rest_key: Value | None = None,
        many: bool = False,
        payload: object = None,
        partial: Set[str] = NO_MARKS,
        ends: Series | None = None,
    ) -> None:
        self.kind = kind
        self.cls = cls
        self.attrs = attrs
        self.items = items
        self.rest = rest
        self.entries: dict[Value, Value] = {} if entries is None else entries
        self.maybe = maybe
        self.rest_key = rest_key
        self.many = many
        self.payload = payload
        self.partial = partial
        self.ends = ends
        self.joined: Value | None = None

    def replace(self, **changes: object) -> Obj:
        """A copy with some fields changed."""
        copy = self.copy()
        for name, value in changes.items():
            setattr(copy, name, value)
        if "items" in changes or "rest" in changes:
            if copy.payload.__class__ in _OF_ELEMENTS and "payload" not in changes:
                copy.payload = None
            if "ends" not in changes:
                copy.ends = None
        return copy

    def series(self) -> Series:
        """The elements of a list or set, as far as their order is known."""
        if self.items is not None:
            return Series(self.items)
        return self.ends if self.ends is not None else Series((), self.rest)

    def element(self) -> Value | None:
        """The join of all elements of a list or set; None where there are none. Of long lists it is asked again and again."""
        if self.joined is None:
            self.joined = self.series().element()
        return self.joined

    def surely_has(self, name: str) -> bool:
        """Whether an attribute is there, on each way that leads here."""
        return self.attrs.get(name, UNBOUND) is not UNBOUND and name not in self.partial

    def with_attr(self, name: str, value: Value) -> Obj:
        """A copy in which one attribute differs."""
        copy = self.copy()
        copy.attrs = written(self.attrs, name, value)
        if name in self.partial:
            copy.partial = unmarked(self.partial, name)
        return copy

    def copy(self) -> Obj:
        """A copy (the fields are shared)."""
        return Obj(
            self.kind,
            self.cls,
            self.attrs,
            self.items,
            self.rest,
            self.entries,
            self.maybe,
            self.rest_key,
            self.many,
            self.payload,
            self.partial,
            self.ends,
        )

    def __repr__(self) -> str:
        return f"Obj({self.kind}, {self.cls}, attrs={list(self.attrs)}, items={self.items}, rest={self.rest})"


def alike(one: Obj, other: Obj) -> bool:
    """Whether two records say the same, in the same order."""
    return (
        one.kind == other.kind
        and one.many == other.many
        and one.cls == other.cls
        and one.items == other.items
        and one.rest == other.rest
        and one.payload == other.payload
        and _same(one.attrs, other.attrs)
        and one.partial == other.partial
        and one.ends == other.ends
        and _same(one.entries, other.entries)
        and one.maybe == other.maybe
        and one.rest_key == other.rest_key
    )


def _same(one: Mapping[Any, Value], other: Mapping[Any, Value]) -> bool:
    """Whether two mappings hold the same in the same order."""
    if one is other:
        return True
    if len(one) != len(other):
        return False
    if one.__class__ is Table and other.__class__ is Table:
        return not any(a != b for _, a, b in one.differing(other))
    return one == other and list(one) == list(other)
