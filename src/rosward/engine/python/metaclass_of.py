# SPDX-License-Identifier: Apache-2.0
"""Which class has a class, and what does that say of it?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.compound import Native
from rosward.domain.values import UNBOUND, Class, Value

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

TYPE: Final = Native("builtins.type")


def metaclass_of(machine: Engine, cls: Value) -> Value:
    """The class of a class."""
    found = machine.at(cls.address).cls if isinstance(cls, Class) else TYPE
    return found if found.__class__ is Class else TYPE


def in_metaclass(machine: Engine, cls: Value, name: str) -> Value | None:
    """What the program's metaclass of a class has under a name; None where it has no such thing, or there is none.

    What the metaclass of enumerations says of items, calls and elements, the engine asks the models itself.
    """
    meta = metaclass_of(machine, cls)
    if not isinstance(meta, Class):
        return None
    for base in meta.mro:
        if isinstance(base, Class) and not (base.stub and name.startswith("__")):
            found = machine.at(base.address).attrs.get(name)
            if found is not None and found is not UNBOUND:
                return found
    return None
