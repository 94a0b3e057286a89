# SPDX-License-Identifier: Apache-2.0
"""Attributes that are deleted: what `del value.name` calls, and what is gone then."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import Descriptor, Native, Partial
from rosward.domain.table import marked
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, ModuleValue, Ref, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import members
from rosward.models.python.attribute_tables import remove_from_table

if TYPE_CHECKING:
    from rosward.domain.heap import Obj
    from rosward.engine.machine import Engine


HOOKS: Final = (Function, Native, Partial)
"""What may stand for `__setattr__` and `__delattr__`: a function of the program, `dict.__setitem__`."""


def delete(machine: Engine, target: Value, name: str) -> None:
    """del target.name."""

    def one(option: Value) -> Value:
        if option.__class__ is Ref and machine.obj(option).kind == "instance":
            cls = machine.obj(option).cls
            hook = members.lookup(machine, cls, "__delattr__")
            if hook is not None and all(each.__class__ in HOOKS for each in options(hook)):
                return machine.call(members.bind(machine, hook, option, cls), (Const(name),))
            found = members.lookup(machine, cls, name)
            if found.__class__ is Descriptor and found.deleter is not None:
                return machine.call(found.deleter, (option,))
            if found.__class__ is Ref and machine.obj(found).kind == "instance":
                deleter = members.lookup(machine, machine.obj(found).cls, "__delete__")
                if deleter is not None:
                    return machine.call(deleter, (found, option))
        remove(machine, option, name)
        return NONE

    several = options(target)
    if len(several) == 1:
        one(target)
    else:
        each_apart(machine, several, one)


def remove(machine: Engine, target: Value, name: str) -> None:
    """What an object, class, module or function holds under a name is gone."""
    if target.__class__ is Ref or target.__class__ is Class or target.__class__ is ModuleValue:
        record = machine.at(target.address)
        if target.__class__ is Ref and remove_from_table(machine, record, name):
            return
        if name in record.attrs:
            machine.put(target.address, without(record, name))
    elif target.__class__ is Function:
        kept = machine.function_record(target)
        if kept is not None and name in kept.attrs:
            machine.put(machine.library.function_address(target), without(kept, name))


def without(record: Obj, name: str) -> Obj:
    """Of several objects one has it no more."""
    return record.replace(partial=marked(record.partial, name)) if record.many else record.with_attr(name, UNBOUND)
