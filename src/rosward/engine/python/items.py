# SPDX-License-Identifier: Apache-2.0
"""Displays, subscripts, unpacking and iteration, over the values of the program and those of builtin types."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import External, Native
from rosward.domain.heap import Obj, fields_of
from rosward.domain.series import Series, concatenated
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, Ref, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.python import attributes, calls, classes, matching, members, metaclasses
from rosward.engine.python.specials import one_has
from rosward.engine.running.frame import Frame
from rosward.ir import ops
from rosward.models.native import Items
from rosward.models.python.containers.lists import new_tuple
from rosward.models.python.containers.sets import distinct
from rosward.models.python.operators import operators
from rosward.models.python.std.annotations import WRITTEN_IN

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def build(machine: Engine, op: ops.Build, frame: Frame) -> Value:
    """A list, tuple, set or dict display."""
    registers = frame.registers
    if op.kind == "dict":
        return _build_dict(machine, op, registers)
    found = concatenated(
        [
            machine.series(registers[register]) if starred else Series((registers[register],))
            for starred, register in op.items
        ]
    )
    if op.kind == "tuple":
        return new_tuple(machine, found)
    if op.kind == "set":
        return machine.new_set(found.head, found.behind_head())
    return machine.new_list(*found)


def _build_dict(machine: Engine, op: ops.Build, registers: list[Value]) -> Value:
    ref = machine.new_dict({})
    pending: Value | None = None
    for starred, register in op.items:
        value = registers[register]
        if starred:
            machine.call(attributes.load(machine, ref, "update"), (value,))
        elif pending is None:
            pending = value
        else:
            store(machine, ref, pending, value)
            pending = None
    return ref


def load(machine: Engine, value: Value, index: Value) -> Value:
    """value[index]."""
    if value.__class__ is Choice:
        several = [o for o in value.options if o != NONE] or list(value.options)
        return each_apart(machine, several, lambda option: load(machine, option, index))
    if value.__class__ is Ref:
        obj = machine.obj(value)
        if obj.kind == "instance":
            method = attributes.method(machine, value, "__getitem__")
            if method is not None:
                return calls.call(machine, method, (index,), {})
            return machine.unknown(Cause.OPERATION, "[]")
    if value.__class__ is Class:
        of_class = metaclasses.method(machine, value, "__getitem__")
        if of_class is not None:
            return calls.call(machine, of_class, (index,), {})
        if classes.is_enum(machine, value):
            return machine.call_native("enum.item", (value, index))
        method = members.lookup(machine, value, "__class_getitem__")
        return (
            value if method is None else calls.call(machine, members.bind(machine, method, value, value), (index,), {})
        )
    if value.__class__ in (External, Native, Function):
        return value  # a generic alias such as list[int]
    return operators.load_item(machine, value, index)


def store(machine: Engine, target: Value, index: Value, value: Value) -> None:
    """target[index] = value."""
    several = options(target)
    if one_has(machine, target, "__setitem__"):

        def one(option: Value) -> Value:
            store(machine, option, index, value)
            return NONE

        each_apart(machine, several, one)
        return
    for option in several:
        if option.__class__ is Ref and machine.obj(option).kind == "instance":
            method = attributes.method(machine, option, "__setitem__")
            if method is not None:
                calls.call(machine, method, (index, value), {})
        else:
            operators.store_item(machine, option, index, value, weak=len(several) > 1)


def delete(machine: Engine, target: Value, index: Value) -> None:
    """del target[index]."""

    def one(option: Value) -> Value:
        if option.__class__ is Ref:
            name = "__delitem__" if machine.obj(option).kind == "instance" else "pop"
            method = attributes.method(machine, option, name)
            if method is not None:
                calls.call(machine, method, (index,), {})
        return NONE

    each_apart(machine, options(target), one)


def unpack(machine: Engine, op: ops.Unpack, frame: Frame) -> bool:
    """a, *b, c = value; False where this raises for sure."""
    series, registers, count = machine.series(frame.registers[op.src]), frame.registers, len(op.dsts)
    told = _misfit(len(series.head), count, op.star != ops.NO_REGISTER) if series.exact else ""
    if told and machine.die("ValueError", told, (Const(told),), sure=True, plain=True) is UNBOUND:
        return False
    for number, dst in enumerate(op.dsts):
        if number == op.star:
            behind = number + 1 - count
            registers[dst] = machine.new_list(*series.part(slice(number, behind or None)))
            continue
        from_end = op.star != ops.NO_REGISTER and number > op.star
        if op.star == ops.NO_REGISTER and number >= len(series.head) and not series.exact:
            from_end = True  # there are exactly `count`
        value = series.at(number - count if from_end else number)
        registers[dst] = value if value is not None else machine.unknown(Cause.ERROR, "too few values to unpack")
    return True


def _misfit(found: int, count: int, starred: bool) -> str:
    """What Python says where so many values do not fit so many targets."""
    least = count - starred
    if found < least:
        return f"not enough values to unpack (expected {'at least ' if starred else ''}{least}, got {found})"
    return "" if starred or found == count else f"too many values to unpack (expected {count})"


def intrinsic(machine: Engine, name: str, arguments: list[Value], frame: Frame) -> Value:
    """The primitives of the language that no other operation says."""
    if name in ("append", "set_add"):
        _append(machine, arguments[0], arguments[1])
    elif name == "dict_set":
        operators.store_item(machine, arguments[0], arguments[1], arguments[2])
    elif name == "annotate":
        _annotate(machine, arguments, frame)
    elif name == "unsupported":
        machine.report("RW206", "an unsupported Python construct")
        return machine.unknown(Cause.OPERATION, "construct")
    else:
        asked = matching.ask(machine, name, arguments)
        return machine.unknown(Cause.LIVE, name) if asked is None else asked
    return NONE


def _append(machine: Engine, target: Value, value: Value) -> None:
    if not isinstance(target, Ref):
        return
    obj: Obj = machine.obj(target)
    if obj.kind == "set" and obj.items is not None:
        known, rest = distinct(machine, Items((*obj.items, value)))
        if known == obj.items:
            return
        series = Series(known, rest)
    else:
        series = concatenated((obj.series(), Series((value,))))
    longer = fields_of(series, obj.kind, machine.budget.items)
    if longer["items"] is not None or (longer["rest"], longer["ends"]) != (obj.rest, obj.ends):
        machine.update(target, obj.replace(**longer))


def _annotate(machine: Engine, arguments: list[Value], frame: Frame) -> None:
    """Keep the annotation of a class variable, in order, in `__annotations__`."""
    namespace = machine.at(frame.namespace) if frame.namespace >= 0 else None
    if namespace is None:
        return
    table = namespace.attrs.get("__annotations__")
    if table is None:
        table = machine.allocate(Obj("dict", Native("builtins.dict"), entries={}), "annotations")
        named = machine.at(frame.namespace).with_attr("__annotations__", table)
        machine.put(frame.namespace, named.with_attr(WRITTEN_IN, frame.module))
    operators.store_item(machine, table, arguments[0], arguments[1])
