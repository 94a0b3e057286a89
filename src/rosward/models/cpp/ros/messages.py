# SPDX-License-Identifier: Apache-2.0
"""Types of messages, messages that arrive, messages that are sent.

rosward::type<M>()                              the type itself, as a value
rosward::type_named("std_msgs/msg/String")      the type of that name
rosward::arrived<M>()                           a pointer to a message that somebody sent
rosward::send("publication", node, topic, rosward::type<M>(), message)
"""

from __future__ import annotations

from typing import Final, cast

from rosward.domain.certain import text_of
from rosward.domain.choice import lift
from rosward.domain.compound import External
from rosward.domain.slots import Pointer, Slot
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, Class, Const, Ref, Value
from rosward.effects.sent import Sending, SentEffect
from rosward.models.cpp.ros.handed import given, node_of, target_of, types_of, unknown_type
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.ros.messages import message_of
from rosward.source.definitions import PARTS

_LOANED: Final = "_message"
_NAME_PARTS: Final = 3


def _type(call: NativeCall) -> Value:
    """`type<T>()`."""
    types = types_of(call)
    return types[0] if types else unknown_type(call)


def _type_named(call: NativeCall) -> Value:
    """`type_named(text)`: the interface that is written `package/msg/Name`."""
    machine = call.machine

    def one(option: Value) -> Value:
        parts = text_of(option).split("/")
        if isinstance(option, Const) and len(parts) == _NAME_PARTS and parts[1] in PARTS and all(parts):
            return External(".".join(parts))
        return machine.unknown(Cause.CALL, "name of a type")

    return lift(one, given(call, 0))


def _is_adapted(call: NativeCall) -> Value:
    """`is_adapted<T>()`: whether a class of the program stands for a message."""
    return TRUE if any(isinstance(t, Class) for t in types_of(call)) else FALSE


def sent_by_somebody(machine: Machine, type_: Value) -> Value:
    """A message of a type."""

    def one(option: Value) -> Value:
        if isinstance(option, External):
            return message_of(machine, option)
        return machine.unknown(Cause.MESSAGE, "message")

    return lift(one, type_)


def _message(call: NativeCall) -> Value:
    """`message<M>()`: the object."""
    return sent_by_somebody(call.machine, _type(call))


def _arrived(call: NativeCall) -> Value:
    """`arrived<M>()`: a pointer to it."""
    found = sent_by_somebody(call.machine, _type(call))
    return lift(lambda option: Pointer(option) if isinstance(option, Ref) else option, found)


def _fill(call: NativeCall) -> Value:
    """`fill(variable)`: what comes from outside is written into a variable, or into what a pointer leads to."""
    machine = call.machine
    target = target_of(call, call.args[0])
    if isinstance(target, Ref):
        obj = machine.obj(target)
        machine.update(target, obj.replace(payload=machine.unknown(Cause.MESSAGE, "message"), attrs={}))
    elif isinstance(call.args[0], Slot):
        write(machine, call.args[0], machine.unknown(Cause.MESSAGE, "message"))
    return NONE


def _send(call: NativeCall) -> Value:
    """`send(kind, node, name, type, value)`."""
    machine = call.machine
    kind, name, type_ = cast("Sending", text_of(given(call, 0))), given(call, 2), given(call, 3)
    record_sent(machine, kind, node_of(call, call.args[1]), name, type_, _loaned(call, call.args[4]))
    return NONE


def record_sent(machine: Machine, kind: Sending, node: Value, name: Value, type_: Value, value: Value) -> None:
    """Something is sent; that it is of the right type a compiler has seen to."""
    effect = SentEffect(kind, node, name, type_, value, machine.place, machine.via)
    machine.log.add_sent(machine, effect)


def _loaned(call: NativeCall, value: Value) -> Value:
    """The message itself, of one that is lent by the middleware as well."""

    def one(option: Value) -> Value:
        held = call.machine.obj(option).attrs.get(_LOANED) if isinstance(option, Ref) else None
        return option if held is None else target_of(call, read(call.machine, held))

    return lift(one, target_of(call, value))


NATIVES: Final[dict[str, NativeFunction]] = {
    "rosward.arrived": _arrived,
    "rosward.fill": _fill,
    "rosward.is_adapted": _is_adapted,
    "rosward.message": _message,
    "rosward.send": _send,
    "rosward.type": _type,
    "rosward.type_named": _type_named,
}
