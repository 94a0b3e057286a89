# SPDX-License-Identifier: Apache-2.0
"""How do objects whose class inherits from a builtin type get what they hold, and when does the builtin type itself act on it?

class Names(list):
    def __init__(self): self.a = 1        never calls `list.__init__`: an empty list, which can be filled
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join
from rosward.domain.compound import BoundMethod, Native
from rosward.domain.heap import Obj, ObjKind
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Class, Ref, Value
from rosward.engine.python import members
from rosward.models.python.containers import dicts
from rosward.models.python.contents import CONTENTS, KINDS, builtin_of, contents

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_FILLED_LATER: Final[dict[str, ObjKind]] = {"list": "list", "dict": "dict", "set": "set"}
"""The kind of what is empty until `__init__`, by its builtin type."""
IN_PLACE: Final = frozenset({"__iadd__", "__imul__", "__ior__", "__iand__", "__isub__", "__ixor__"})


def give(machine: Engine, cls: Class, ref: Ref, args: tuple[Value, ...] | None, keywords: dict[str, Value]) -> None:
    """A new object holds what its builtin type makes of the arguments; what can change is empty until `__init__`."""
    name = builtin_of(cls)
    if not name:
        return
    if name in _FILLED_LATER:
        held: Value = Ref(
            machine.place_at(("contents", ref.address), Obj(_FILLED_LATER[name], Native(f"builtins.{name}")))
        )
    else:
        held = machine.call_native(f"builtins.{name}", args or (), keywords)
        if held is UNBOUND:
            held = machine.unknown(Cause.ERROR, f"{name}()", name)
    machine.update(ref, machine.obj(ref).with_attr(CONTENTS, held))


def initialiser(machine: Engine, base: Value) -> Value | None:
    """`__init__` of a builtin base whose objects are filled by it."""
    if base.__class__ is not Native or base.name.removeprefix("builtins.") not in KINDS:
        return None
    name = f"{base.name.removeprefix('builtins.')}.__init__"
    return Native(name) if machine.library.native(name) else None


def iterated(machine: Engine, value: Value, method: Value | None) -> Value | None:
    """What is iterated over where an object leaves its `__iter__` to its builtin type; None where it does not."""
    if method.__class__ is not BoundMethod or method.function.__class__ is not Native:
        return None
    found = contents(machine, value)
    return machine.unknown(Cause.OPERATION, "iteration") if found is None else found


def missing(machine: Engine, receiver: Value, held: Value, index: Value) -> Value | None:
    """`dict[index]` where a subclass has `__missing__`; None where it has none."""
    cls = machine.obj(receiver).cls if receiver.__class__ is Ref else receiver
    hook = members.lookup(machine, cls, "__missing__")
    if hook is None or held.__class__ is not Ref:
        return None
    found = dicts.look_up(machine, machine.obj(held), index)
    if found.missing is False:
        return found.value
    made = machine.call(members.bind(machine, hook, receiver, cls), (index,))
    return join(found.value, made)
