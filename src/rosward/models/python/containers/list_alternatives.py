# SPDX-License-Identifier: Apache-2.0
"""Lists of objects whose length is not known, though it is known which of them may be there.

nodes = [a]
if unknown: nodes.append(b)
nodes.append(c)                 elements: a and c for sure, b perhaps
"""

from __future__ import annotations

from collections.abc import Iterable

from rosward.domain.compound import Tuple
from rosward.domain.heap import Alternatives
from rosward.domain.values import Ref, Value
from rosward.models.native import Machine
from rosward.models.python.plain import MAX_ITEMS

Told = tuple[tuple[Value, bool], ...] | None


def elements_apart(machine: Machine, value: Value) -> Told:
    """The elements of a list or tuple of objects in order, and whether each is surely there; None where they are not told apart."""
    items: tuple[Value, ...] | None = None
    if isinstance(value, Tuple):
        items = value.items
    elif isinstance(value, Ref) and machine.obj(value).kind == "list":
        obj = machine.obj(value)
        if obj.items is None:
            return obj.payload.elements if isinstance(obj.payload, Alternatives) else None
        items = obj.items
    if items is None or not all(isinstance(i, Ref) for i in items):
        return None
    return tuple((i, True) for i in items)


def keep_told(machine: Machine, ref: Ref, parts: Iterable[Told]) -> None:
    """A list of unknown length was made of `parts`: where the elements of all are told apart, they stay so."""
    found: dict[Value, bool] = {}
    for part in parts:
        if part is None or any(value in found for value, _ in part):
            return
        found.update(part)
    obj = machine.obj(ref)
    if found and obj.kind == "list" and obj.items is None and len(found) <= MAX_ITEMS:
        machine.update(ref, obj.replace(payload=Alternatives(tuple(found.items()))))
