# SPDX-License-Identifier: Apache-2.0
"""Which values does an object hold: in its attributes, as a container, or where it waits in the middle of its body?"""

from __future__ import annotations

from collections.abc import Iterator

from rosward.domain.heap import Alternatives, Obj, Shuffled
from rosward.domain.suspended import Suspension
from rosward.domain.values import Value


def values_in(obj: Obj) -> Iterator[Value]:
    """All of them."""
    yield from obj.attrs.values()
    if obj.kind == "instance" and obj.payload is None:
        return
    if obj.items:
        yield from obj.items
    if obj.rest is not None:
        yield obj.rest
    if obj.entries:
        yield from obj.entries
        yield from obj.entries.values()
    if obj.rest_key is not None:
        yield obj.rest_key
    if obj.ends is not None:
        yield from obj.ends.head
        yield from obj.ends.tail
    payload = obj.payload
    if payload.__class__ is Alternatives:
        yield from (value for value, _ in payload.elements)
    elif payload.__class__ is Shuffled:
        yield from payload.items
    elif isinstance(payload, Value):
        yield payload
    elif isinstance(payload, Suspension):
        for point, values in payload.points.items():
            yield point.function
            yield from values
