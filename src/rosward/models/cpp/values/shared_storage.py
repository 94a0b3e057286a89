# SPDX-License-Identifier: Apache-2.0
"""Which fields of an object share their storage, and what are the others by where one is written?

union Word { int whole; char parts[4]; };      word.whole = 7: nobody knows what the parts are by then
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Ref, Value
from rosward.models.native import Machine

UNION: Final = "<union>"
"""The attribute of a class with the names of its fields that share their storage, as those of a union do: a tuple."""
_NONE: Final = frozenset[str]()


def overlapping(cls: Obj | None, name: str) -> frozenset[str]:
    """By the record of a class, the fields of its objects that are written with this one."""
    rule = None if cls is None else cls.attrs.get(UNION)
    if not isinstance(rule, Tuple):
        return _NONE
    names = frozenset(str(each.value) for each in rule.items if isinstance(each, Const))
    return names - {name} if name in names else _NONE


def written(machine: Machine, obj: Obj, others: frozenset[str], name: str, value: Value) -> tuple[Value, Obj]:
    """What a member of a union is that is written, and the object with the others, of which nobody knows what they are by then; nor what it is
    itself where others are written in parts."""
    unknown = machine.unknown(Cause.OPERATION, f"member of a union: {name}")
    attrs = {key: unknown if key in others and not isinstance(old, Ref) else old for key, old in obj.attrs.items()}
    parts = any(isinstance(obj.attrs[key], Ref) for key in others)
    return unknown if parts else value, obj.replace(attrs=attrs)
