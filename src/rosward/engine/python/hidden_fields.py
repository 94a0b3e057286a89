# SPDX-License-Identifier: Apache-2.0
"""What does an object hold that a constructor made which nobody knows? For each annotation of its class anything, beside what is written.

    @library.record                    Topic('/scan').name: what the class says, or another text
    class Topic:                       Topic(name='/scan').name: '/scan', what the class says, or another text
        name: str = '/odom'

Such a constructor is that of a base class that is not known, or one that a decorator or metaclass gives the class.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from rosward.domain.choice import join
from rosward.domain.compound import External
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Class, Const, Ref, Unknown, Value

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["give"]


def give(machine: Engine, cls: Class, ref: Ref, args: tuple[Value, ...], keywords: Mapping[str, Value]) -> None:
    """Note what the arguments of such a constructor may have become. Without arguments the class says what there is."""
    if cls.stub or not (args or keywords):
        return
    for name, written in _annotated(machine, cls):
        known = keywords.get(name, UNBOUND) if written is UNBOUND else join(written, keywords.get(name, UNBOUND))
        hidden = machine.unknown(Cause.CALL, f"{_maker(cls)}.{name}")
        machine.update(ref, machine.obj(ref).with_attr(name, join(known, hidden)))


def _annotated(machine: Engine, cls: Class) -> Iterator[tuple[str, Value]]:
    """The variables that class bodies annotate, with what is assigned to them there."""
    for base in reversed(cls.mro):
        if isinstance(base, Class) and not base.stub:
            attrs = machine.at(base.address).attrs
            table = attrs.get("__annotations__")
            for key in machine.obj(table).entries if isinstance(table, Ref) else ():
                if isinstance(key, Const):
                    yield str(key.value), attrs.get(str(key.value), UNBOUND)


def _maker(cls: Class) -> str:
    """Who makes the object, as a reason says it."""
    outside = [b for b in cls.mro if isinstance(b, (External, Unknown))]
    return outside[0].name if outside and isinstance(outside[0], External) else cls.dotted
