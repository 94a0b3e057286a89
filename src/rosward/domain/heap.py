# SPDX-License-Identifier: Apache-2.0
"""Objects on the heap: immutable records, replaced when the program writes to one.

self.items.append(x)    heap[a] = heap[a].with_items(items + (x,))
"""

from __future__ import annotations

from typing import Final, NamedTuple, final

from rosward.domain.values import Value

NO_ATTRS: Final[dict[str, Value]] = {}


class Alternatives(NamedTuple):
    """The payload of a list of unknown length: its elements in order, and whether each is surely there. Any write to the list drops it."""

    elements: tuple[tuple[Value, bool], ...]


@final
class Obj:
    """One object: its class and what it holds. Fields are never changed in place; `replace` makes a new record.

    kind is 'instance', 'list', 'set', 'dict', 'class', 'module', 'cell' or 'generator'.
    attrs: attributes (variables of a module, `value` of a cell), by name; `partial` holds those that may be absent.
    items: the elements of a list or set in order, exactly, or None where the length is not known; then `rest` joins all elements (None: empty).
    entries: the items of a dict whose keys are known, in order, key value to value; `maybe` holds the keys that may be absent;
    `rest` joins the values under keys that are not known (None: there are none), `rest_key` those keys.
    many: the record stands for several objects of the program (made in a loop or a callback that runs again): writes only add.
    payload: what the kind needs beyond (the suspended call of a generator, say).
    """

    __slots__ = ("attrs", "cls", "entries", "items", "kind", "many", "maybe", "partial", "payload", "rest", "rest_key")

    def __init__(
        self,
        kind: str,
        cls: Value,
        attrs: dict[str, Value] = NO_ATTRS,
        items: tuple[Value, ...] | None = (),
        rest: Value | None = None,
        entries: dict[Value, Value] | None = None,
        maybe: frozenset[Value] = frozenset(),
        rest_key: Value | None = None,
        many: bool = False,
        payload: object = None,
        partial: frozenset[str] = frozenset(),
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

    def replace(self, **changes: object) -> Obj:
        """A copy with some fields changed."""
        copy = Obj.__new__(Obj)
        for name in Obj.__slots__:
            setattr(copy, name, changes[name] if name in changes else getattr(self, name))
        if (
            copy.payload.__class__ is Alternatives
            and "payload" not in changes
            and ("items" in changes or "rest" in changes)
        ):
            copy.payload = None
        return copy

    def with_attr(self, name: str, value: Value) -> Obj:
        """A copy in which one attribute differs."""
        copy = self.copy()
        copy.attrs = {**self.attrs, name: value}
        if name in self.partial:
            copy.partial = self.partial - {name}
        return copy

    def copy(self) -> Obj:
        """A copy (the fields are shared)."""
        copy = Obj.__new__(Obj)
        copy.kind = self.kind
        copy.cls = self.cls
        copy.attrs = self.attrs
        copy.items = self.items
        copy.rest = self.rest
        copy.entries = self.entries
        copy.maybe = self.maybe
        copy.rest_key = self.rest_key
        copy.many = self.many
        copy.payload = self.payload
        copy.partial = self.partial
        return copy

    def __repr__(self) -> str:
        return f"Obj({self.kind}, {self.cls}, attrs={list(self.attrs)}, items={self.items}, rest={self.rest})"
