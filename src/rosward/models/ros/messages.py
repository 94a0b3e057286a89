# SPDX-License-Identifier: Apache-2.0
"""Which messages arrive, and which are sent? An object for each that arrives at one place; an effect for each that is sent."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.certain import text_of
from rosward.domain.choice import options
from rosward.domain.compound import External, Native, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Text, Unknown, Value
from rosward.effects.sent import SentEffect
from rosward.models.interfaces import MessageName, message_name
from rosward.models.message_fields import arrived
from rosward.models.native import NativeCall, NativeFunction
from rosward.naming.options import interface_type

if TYPE_CHECKING:
    from rosward.models.native import Machine


def message_of(machine: Machine, type_: Value, kind: str = "message", *, many: bool = True) -> Value:
    """A message of a type (or the request, response, goal of one) that somebody sent."""
    found = interface_type(type_)
    subject = found.rpartition("/")[2] if found else "message"
    if kind == "response" and isinstance(type_, External):
        return machine.allocate(Obj("instance", External(f"{type_.name}.Response")), "response")
    part = {"request": "request", "goal": "goal"}.get(kind, "")
    unknown = machine.unknown(Cause.MESSAGE, f"{subject} {part}".strip())
    if not isinstance(type_, External):
        return unknown
    return arrived(machine, External(f"{type_.name}.{part.capitalize()}") if part else type_, unknown, kind, many=many)


_ONCE: Final = frozenset({"response", "result", "outcome", "serialized message"})
"""What comes once for each call that asks for it; all else may come any number of times."""


def _message(call: NativeCall) -> Value:
    """`message(type, what)`: one that somebody sent."""
    return message_of(call.machine, call.args[0], many=text_of(call.arg(1, "what", NONE)) not in _ONCE)


def send(machine: Machine, kind: str, node: Value, name: Value, type_: Value, value: Value) -> None:
    """Record that a value is sent, where a message of that type belongs."""
    effect = SentEffect(kind, node, name, type_, value, machine.place, machine.via)  # type: ignore[arg-type]  # the kind is a word of a stub
    machine.log.add_sent(machine, effect)
    wanted = message_name(type_.name) if isinstance(type_, External) else None
    if wanted is None or value is UNBOUND or kind not in _TAKES:
        return
    if kind == "publication" and any(isinstance(o, Const) and isinstance(o.value, bytes) for o in options(value)):
        return  # a message that is serialised already
    others = [_other(machine, option, wanted) for option in options(value)]
    if all(others) and not machine.choosing:  # one of several publishers may take it
        machine.report(
            "RW213", f"{_TAKES[kind]} {_full_name(wanted)}, not {' or '.join(dict.fromkeys(others))}: TypeError"
        )


_TAKES: Final = {
    "publication": "`publish` of this publisher takes",
    "request": "this service client takes",
    "response": "the callback of this service must return",
    "goal": "this action client takes",
}
"""What rclpy checks. It looks neither at feedback nor at results."""


def _full_name(name: MessageName) -> str:
    part = f".{name.part}" if name.part else ""
    return f"{name.package}/{name.kind}/{name.name}{part}"


def _other(machine: Machine, value: Value, wanted: MessageName) -> str:
    """What a value surely is instead of a message of that type; '' where it is, or may be, one."""
    if isinstance(value, (Const, Text, Tuple)):
        kind = (
            type(value.value).__name__ if isinstance(value, Const) else "tuple" if isinstance(value, Tuple) else "str"
        )
        return "" if isinstance(value, Const) and value.origins else "None" if value == NONE else kind
    if isinstance(value, External):
        return "a class" if interface_type(value) is not None else ""
    if not isinstance(value, Ref):
        return ""
    obj = machine.obj(value)
    if obj.kind in ("list", "dict", "set"):
        return obj.kind
    cls = obj.cls
    if isinstance(cls, External):
        found = message_name(cls.name)
        return "" if found is None or found == wanted else _full_name(found)
    if not isinstance(cls, Class) or cls.stub or any(isinstance(b, (External, Unknown)) for b in cls.mro):
        return ""
    return cls.name


def _send(call: NativeCall) -> Value:
    kind, node, name, type_, value = call.exactly(5)
    send(call.machine, text_of(kind), node, name, type_, value)
    return NONE


def _sender(call: NativeCall) -> Value:
    """`sender(kind, node, name, type)`: a function that sends what it is given."""
    return Partial(Native("_rosward.send"), call.exactly(4), ())


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.message": _message,
    "_rosward.send": _send,
    "_rosward.sender": _sender,
}
