# SPDX-License-Identifier: Apache-2.0
"""Assignments to attributes: what does `value.name = x` change?

self.rate = 5        `__setattr__` of the class, else the setter of a property or descriptor, else what the object itself holds
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options
from rosward.domain.compound import Descriptor, External, Native, function_behind
from rosward.domain.heap import KIND, Obj
from rosward.domain.table import marked
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, ModuleValue, Ref, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import members
from rosward.engine.python.attributes import setter_of
from rosward.engine.python.class_changes import change_class
from rosward.engine.python.functions import record_of
from rosward.engine.python.namespaces import slots_of
from rosward.engine.python.removal import HOOKS, remove
from rosward.engine.unknown.escape import name_of
from rosward.models import message_fields
from rosward.models.failures import fail
from rosward.models.python.attribute_tables import TABLE, give_table, store_in_table
from rosward.models.python.builtins.attributes import ANY_ATTRIBUTE

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_OBJECT: Final = Native("builtins.object")
_OF_A_FUNCTION: Final = frozenset({"__code__", "__defaults__", "__kwdefaults__"})
"""What decides what a call runs, and is not followed where the program sets it."""


_REPLACED: Final = "()"
"""What is partial of a function in whose place a decorator that is not read may have put something else."""


def open_up(machine: Engine, value: Value, *, replaced: bool) -> None:
    """A library that is not read may have given a function attributes; `replaced`: a decorator may have put something else in its place.

    To a class, decorators add.
    """
    if isinstance(value, Function):
        address = machine.library.function_address(value)
        record = machine.own(address) or Obj("instance", NONE)
        partial = marked(record.partial, ANY_ATTRIBUTE)
        machine.put(address, record.replace(partial=marked(partial, _REPLACED) if replaced else partial))
    elif isinstance(value, Class) and replaced:
        record = machine.at(value.address)
        machine.put(value.address, record.replace(partial=marked(record.partial, ANY_ATTRIBUTE)))


def is_replaced(machine: Engine, function: Value) -> bool:
    """Whether a decorator that is not read may have made something else of a function: what calls it with other arguments, or is not true."""
    behind = function_behind(function)
    record = machine.own(machine.library.function_address(behind)) if isinstance(behind, Function) else None
    return record is not None and _REPLACED in record.partial


def store(machine: Engine, target: Value, name: str, value: Value) -> bool:
    """target.name = value; False where this raises for sure."""
    several = target.__class__ is Choice
    if several and any(members.is_computed(machine, o, name, written=True) for o in options(target)):

        def one(option: Value) -> Value:
            return NONE if store(machine, option, name, value) else UNBOUND

        return each_apart(machine, options(target), one) is not UNBOUND
    for option in options(target):
        if option.__class__ is Ref:
            if not _store_object(machine, option, name, value, weak=several):
                return several
        elif option.__class__ in (Class, ModuleValue):
            address = option.address
            if name == "__init_subclass__":
                machine.unhooked = None
            if name == "__bases__" and option.__class__ is Class:
                machine.report("RW203", "a class may be given other bases")
            if isinstance(option, ModuleValue) and machine.library.is_model_file(option.file):
                machine.may_call((value,))  # a library may call what the program puts in its place
            record = machine.at(address)
            old = record.attrs.get(name)
            changed = record.with_attr(name, join(old, value) if several and old is not None else value)
            if several and (old is None or name in record.partial):
                changed.partial = marked(record.partial, name)
            machine.put(address, changed)
        elif option.__class__ is Function:
            if name in _OF_A_FUNCTION:
                machine.report("RW203", "a function may be given another body or other defaults")
            address, record = machine.library.function_address(option), record_of(machine, option)
            old = record.attrs.get(name)
            weak = several or record.many
            changed = record.with_attr(name, join(old, value) if weak and old is not None else value)
            if weak and (old is None or name in record.partial):
                changed.partial = marked(record.partial, name)
            machine.put(address, changed)
        elif option.__class__ in (External, Unknown):
            if option == External("builtins"):
                machine.report("RW203", f"the builtin {name} may be another one")
            machine.escape((value,), name_of(option), option)
    return True


def store_past_hook(machine: Engine, ref: Ref, name: str, value: Value, *, weak: bool) -> None:
    """What `object.__setattr__` does."""
    _store_object(machine, ref, name, value, weak=weak, hooked=False)


def _store_object(machine: Engine, ref: Ref, name: str, value: Value, *, weak: bool, hooked: bool = True) -> bool:
    obj = machine.part(ref, KIND)
    hook = members.lookup(machine, obj.cls, "__setattr__") if hooked and obj.kind == "instance" else None
    if hook is not None and all(option.__class__ in HOOKS for option in options(hook)):
        return machine.call(members.bind(machine, hook, ref, obj.cls), (Const(name), value)) is not UNBOUND
    in_class = members.lookup(machine, obj.cls, name) if obj.kind == "instance" else None
    if in_class.__class__ is Descriptor and in_class.kind == "property":
        if in_class.setter is not None:
            return machine.call(in_class.setter, (ref, value)) is not UNBOUND
        if not obj.many:
            shown = f"{obj.cls.name}.{name}" if obj.cls.__class__ is Class else name
            fail(
                machine,
                Native("builtins.AttributeError"),
                f"{shown} is a property that cannot be set: AttributeError",
                (),
            )
            return False
        return True
    setter = setter_of(machine, in_class)
    if setter is not None:
        return machine.call(setter, (in_class or NONE, ref, value)) is not UNBOUND
    if obj.kind == "instance" and _has_no_place(machine, obj.cls, name):
        shown = obj.cls.name.rpartition(".")[2] if isinstance(obj.cls, (Class, External)) else ""
        said = Const(f"'{shown}' object has no attribute '{name}'")
        if machine.die("AttributeError", f"no slot {name}", (said,), sure=True) is UNBOUND:
            return False
    if name == "__class__" and obj.kind == "instance":
        change_class(machine, ref, value, weak=weak)
        return True
    if name == TABLE and obj.kind == "instance":
        give_table(machine, ref, value if not weak else join(machine.load_attr(ref, name), value))
        return True
    if obj.cls.__class__ is External:
        value = message_fields.assigned(machine, obj.cls, name, value)
    keep(machine, ref, name, value, weak=weak)
    return True


def keep(machine: Engine, ref: Ref, name: str, value: Value, *, weak: bool) -> None:
    """`object.__dict__[name] = value` (UNBOUND: `del` of that): no `__setattr__`, property or slot has a say in it."""
    if value is UNBOUND:
        remove(machine, ref, name)
        return
    obj = machine.part(ref, KIND)
    if store_in_table(machine, obj, name, value, weak=weak):
        return
    old = obj.attrs.get(name)
    if old is not None and (weak or obj.many):
        value = join(old, value)
    # A summary tells by the records what is written, so there what is the same is written, too.
    if old is not value or name in obj.partial or machine.summaries.epoch:
        one_of_several = weak or obj.many
        absent = marked(obj.partial, name) if old is None and one_of_several else obj.partial
        changed = obj.with_attr(name, value)
        # An object of the program without the attribute would fail. A message has its default there: the mark stays.
        if name in absent and (weak or old is None or (obj.many and obj.cls.__class__ is External)):
            changed.partial = absent
        machine.put(ref.address, changed)


def _has_no_place(machine: Engine, cls: Value, name: str) -> bool:
    """Whether all classes of an object say by `__slots__` which attributes it has, or it is a message, and this is none of them."""
    if cls.__class__ is not Class:
        return message_fields.has_field(machine, cls, name) is False
    for base in cls.mro:
        if base == _OBJECT:
            continue
        slots = slots_of(machine, base)
        if slots is None or name in slots or "__dict__" in slots:
            return False
    return True
