# SPDX-License-Identifier: Apache-2.0
"""What does an object hold whose class inherits from a builtin type? A value of that type, under a name that no program can write.

class Names(list): …      Names(['a']) has the contents ['a']: what `list` itself does, is done on these
class Topic(str): …       Topic('/a') has the contents '/a'
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Native
from rosward.domain.values import Choice, Class, Const, Ref, Text, Value
from rosward.models.native import Machine

CONTENTS: Final = "()"
KINDS: Final = {
    "list": "list",
    "dict": "dict",
    "set": "set",
    "frozenset": "set",
    "tuple": "tuple",
    "str": "str",
    "bytes": "bytes",
    "int": "int",
    "float": "float",
}
"""The builtin types whose subclasses hold something, and under which name their methods are modelled."""


def builtin_of(cls: Value) -> str:
    """The builtin type that a class inherits from, and whose value its objects hold; '' where there is none."""
    if not isinstance(cls, Class):
        return ""
    names = (b.name.removeprefix("builtins.") for b in cls.mro if isinstance(b, Native))
    return next((n for n in names if n in KINDS), "")


def contents(machine: Machine, value: Value) -> Value | None:
    """What an object of such a class holds; None for any other value."""
    if value.__class__ is not Ref:
        return None
    obj = machine.obj(value)
    return obj.attrs.get(CONTENTS) if obj.kind == "instance" else None


def bare(machine: Machine, value: Value) -> Value:
    """What an object of such a class holds; any other value itself."""
    if value.__class__ is Choice:
        return join_all(bare(machine, o) for o in options(value))
    found = contents(machine, value)
    return value if found is None else found


def plain_data(machine: Machine, value: Value) -> Value:
    """The same for what cannot change: texts, numbers, tuples."""
    if value.__class__ is Choice:
        return join_all(plain_data(machine, o) for o in options(value))
    found = contents(machine, value)
    return value if found is None or any(o.__class__ is Ref for o in options(found)) else found


def text_data(machine: Machine, value: Value) -> Value:
    """The same, and of a member of an enumeration of texts (`StrEnum`) its text: as what takes texts alone sees them."""
    if value.__class__ is Choice:
        return join_all(text_data(machine, o) for o in options(value))
    payload = machine.obj(value).payload if isinstance(value, Ref) else None
    if isinstance(payload, Text) or (isinstance(payload, Const) and isinstance(payload.value, str)):
        return payload
    return plain_data(machine, value)
