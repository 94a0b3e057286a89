# SPDX-License-Identifier: Apache-2.0
"""What may code that is not known change of what it gets hold of?

bus.readinto(self.buf)        self.buf holds what it held or something unknown, and any number of it
lib.fill(self.state)          plain values in attributes of the state may be others; containers in it may hold others

A name, a number or None in an attribute may be replaced; an object that is referred to stays, and what is in it may change. Functions,
classes and nodes stay as they are: what a library does with a node is RW202.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options
from rosward.domain.compound import External, Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer
from rosward.domain.state import element
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Class, Const, Ref, Text, Unknown, Value
from rosward.models import message_fields

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_PLAIN: Final = (Const, Text, Tuple)
_DEPTH: Final = 4
"""How many containers and objects deep something may change."""


def change(machine: Engine, value: Value, library: str, *, informed: bool = False) -> None:
    """A value is handed to a library: what it refers to may hold something else when the call returns.

    `informed`: the code that gets it may know every class of the program; otherwise the language says what it can see of one.
    """
    _change(machine, value, machine.unknown(Cause.CALL, library), 0, set(), informed)


def _change(machine: Engine, value: Value, unknown: Value, depth: int, seen: set[int], informed: bool) -> None:
    for option in options(value):
        option = option.target if isinstance(option, Pointer) else option  # noqa: PLW2901 - what a pointer leads to
        if isinstance(option, Tuple):
            inner: list[Value] = list(option.items)
        elif isinstance(option, Ref) and option.address not in seen:
            seen.add(option.address)
            obj = machine.obj(option)
            if obj.kind in ("list", "set", "dict"):
                inner = contents(obj)
            elif obj.kind == "instance" and not informed and not machine.language.is_open(machine, obj):
                continue
            elif obj.kind == "instance" and not holds_node(machine, option):
                inner = [v for n, v in obj.attrs.items() if not n.startswith("__")]
            else:
                continue
            changed = _changed(machine, obj, unknown)
            if changed is not obj:
                machine.update(option, changed)
        else:
            continue
        if depth < _DEPTH:
            for each in inner:
                _change(machine, each, unknown, depth + 1, seen, informed)


def change_each(machine: Engine, refs: Iterable[Ref], library: str) -> None:
    """The same for objects of which no other is reached: each for itself, whatever class it is of."""
    unknown = machine.unknown(Cause.CALL, library)
    for ref in refs:
        obj = machine.obj(ref)
        changed = _changed(machine, obj, unknown)
        if changed is not obj:
            machine.update(ref, changed)


def _changed(machine: Engine, obj: Obj, unknown: Value) -> Obj:
    if obj.kind == "dict":
        return _changed_dict(obj, unknown)
    if obj.kind == "instance":
        return message_fields.opened(machine, _changed_object(machine, obj, unknown))
    return _changed_list(obj, unknown) if obj.kind in ("list", "set") else obj


def contents(obj: Obj) -> list[Value]:
    """The elements of a list, set or dict."""
    return [*(obj.items or ()), *obj.entries.values(), *([obj.rest] if obj.rest is not None else [])]


_ATTRIBUTES: Final = 2
"""How many objects deep a node is looked for by attributes."""


def holds_node(machine: Engine, ref: Ref) -> bool:
    """Whether an object is a node, or has one by its attributes, or in what they hold."""
    return machine.is_node(ref.address) or _holds_node(machine, machine.obj(ref), _ATTRIBUTES, {ref.address})


def _holds_node(machine: Engine, obj: Obj, depth: int, seen: set[int]) -> bool:
    work = list(obj.attrs.values()) if obj.kind == "instance" else contents(obj)
    for value in work:
        for option in options(value):
            option = option.target if isinstance(option, Pointer) else option  # noqa: PLW2901
            if isinstance(option, Tuple):
                work.extend(option.items)
            elif isinstance(option, Ref) and option.address not in seen:
                seen.add(option.address)
                if machine.is_node(option.address):
                    return True
                if depth > 0 and _holds_node(machine, machine.obj(option), depth - 1, seen):
                    return True
    return False


_FILLED: Final = "_filled"
"""The attribute of a class in a stub of which the objects are there to be filled: a file in memory."""


def _changed_object(machine: Engine, obj: Obj, unknown: Value) -> Obj:
    """Plain values in the attributes of an object of the program may be others; a library's own objects keep theirs, but for what is filled."""
    if not isinstance(obj.cls, (Class, External)):
        return obj
    if isinstance(obj.cls, Class) and obj.cls.stub and not _is_filled(machine, obj.cls):
        return obj
    attrs = {n: join(v, unknown) for n, v in obj.attrs.items() if not n.startswith("__") and _may_change(v)}
    return obj.replace(attrs={**obj.attrs, **attrs}) if attrs else obj


def _is_filled(machine: Engine, cls: Class) -> bool:
    return any(_FILLED in machine.obj(Ref(base.address)).attrs for base in cls.mro if isinstance(base, Class))


def _may_change(value: Value) -> bool:
    """Whether a value is, or may be, plain; and not already anything."""
    found = options(value)
    return any(isinstance(o, _PLAIN) for o in found) and not any(isinstance(o, Unknown) and not o.hint for o in found)


def _changed_list(obj: Obj, unknown: Value) -> Obj:
    old = element(obj)
    if obj.items is None and _is_anything(old):
        return obj
    return obj.replace(items=None, rest=join(UNBOUND if old is None else old, unknown))


def _changed_dict(obj: Obj, unknown: Value) -> Obj:
    if obj.rest_key is None and _is_anything(obj.rest) and len(obj.maybe) == len(obj.entries):
        if all(_is_anything(v) for v in obj.entries.values()):
            return obj
    entries = {k: join(v, unknown) for k, v in obj.entries.items()}
    rest = unknown if obj.rest is None else join(obj.rest, unknown)
    return obj.replace(entries=entries, maybe=frozenset(entries), rest=rest, rest_key=None)


def _is_anything(value: Value | None) -> bool:
    return value is not None and any(isinstance(o, Unknown) and not o.hint for o in options(value))
