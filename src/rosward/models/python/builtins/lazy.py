# SPDX-License-Identifier: Apache-2.0
"""When is an iterator of a builtin computed item by item? Where it asks another one, or calls code of the program.

map(self.make, names)        nothing is made before somebody asks for an item
zip(words(), ['a', 'b'])     `words` is advanced twice, and no further than its third `yield`
zip(it, it)                  pairs: both columns take from one iterator
"""

from __future__ import annotations

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Partial
from rosward.domain.values import Class, Function, Ref, Value
from rosward.models.native import Machine, NativeCall
from rosward.models.python.containers.lists import ITERATOR


def stepped(call: NativeCall, values: tuple[Value, ...]) -> bool:
    """Whether one of the values is followed step by step."""
    return any(call.machine.is_stepped(v) for v in values)


def is_drained(machine: Machine, value: Value) -> bool:
    """Whether a value is an iterator over known items: what one takes from it the next one does not see."""
    if not isinstance(value, Ref):
        return False
    record = machine.obj(value)
    return record.kind == "list" and record.payload == ITERATOR and record.items is not None and not record.many


def shared(call: NativeCall, values: tuple[Value, ...]) -> bool:
    """Whether several of the values take from one iterator (an object may keep one, as a file does), or one is followed step by step."""
    twice = [v for number, v in enumerate(values) if v in values[:number]]
    return any(is_drained(call.machine, v) or _is_instance(call.machine, v) for v in twice) or stepped(call, values)


def _is_instance(machine: Machine, value: Value) -> bool:
    return isinstance(value, Ref) and machine.obj(value).kind == "instance"


def acts(machine: Machine, function: Value) -> bool:
    """Whether calling a value runs code of the program."""
    return any(_acts(machine, o) for o in options(function))


def _acts(machine: Machine, function: Value) -> bool:
    if isinstance(function, (BoundMethod, Partial)):
        return _acts(machine, function.function)
    if isinstance(function, Ref):
        return _is_instance(machine, function)
    return isinstance(function, (Function, Class))


def lazily(call: NativeCall, name: str, *args: Value, **keywords: Value) -> Value:
    """What the function of that name in stubs/_lazy.pyi gives."""
    function = call.machine.load_attr(call.machine.load_module("_lazy"), name)
    return call.machine.call(function, args, keywords)
