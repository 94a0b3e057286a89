# SPDX-License-Identifier: Apache-2.0
"""What may be called from now on, and with what?

rosward::schedule(callback, "timer", timer)         what it does not take of the arguments is dropped
rosward::deliver(callback, rosward::type<M>())      a message, as the callback takes it: an object, any pointer to it, serialised
rosward::serve(callback, service, node, name, type) request and response, in the order in which a service callback may have them
"""

from __future__ import annotations

from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.choice import lift, options
from rosward.domain.compound import BoundMethod, External, Native, Partial
from rosward.domain.slots import Pointer
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Function, Ref, Value
from rosward.models.cpp.ros.handed import given, node_of, target_of
from rosward.models.cpp.ros.messages import record_sent
from rosward.models.cpp.values.callables import leading, mentions, parameters, plain_callable
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.ros.messages import message_of

_HEADER: Final = "rmw_request_id_t"


def _schedule(call: NativeCall) -> Value:
    """`schedule(callback, event, arguments…)`; nothing where the callback is empty."""
    args = tuple(read(call.machine, a) for a in call.args[2:])
    _add(call.machine, call.args[0], args, text_of(given(call, 1), "callback"))
    return NONE


def _add(machine: Machine, callback: Value, args: tuple[Value, ...], event: str, answered: Value | None = None) -> None:
    for option in options(plain_callable(machine, callback)):
        if option not in (NONE, UNBOUND):
            machine.schedule(option, args, event, answered=answered)


def _deliver(call: NativeCall) -> Value:
    """`deliver(callback, type)`: messages of a type arrive."""
    machine = call.machine
    callback, type_ = given(call, 0), given(call, 1)
    patterns = parameters(machine, callback)
    raw = bool(patterns) and mentions((patterns or ())[0], "SerializedMessage")
    message = machine.unknown(Cause.MESSAGE, "serialized message") if raw else _arrived(machine, type_)
    info = machine.unknown(Cause.MESSAGE, "message info")
    _add(machine, callback, (message, info), "message")
    return NONE


def _arrived(machine: Machine, type_: Value, kind: str = "message") -> Value:
    """A pointer to a message of a type that somebody sent."""

    def one(option: Value) -> Value:
        if not isinstance(option, External):
            return machine.unknown(Cause.MESSAGE, "message")
        found = message_of(machine, option, kind)
        return Pointer(found) if isinstance(found, Ref) else found

    return lift(one, type_)


def _serve(call: NativeCall) -> Value:
    """`serve(callback, service, node, name, type)`: requests arrive, and are answered."""
    machine = call.machine
    callback, service, name, type_ = given(call, 0), given(call, 1), given(call, 3), given(call, 4)
    node = node_of(call, call.args[2])
    request, response = _arrived(machine, type_, "request"), _arrived(machine, type_, "response")
    header = machine.unknown(Cause.MESSAGE, "header of a request")
    patterns = parameters(machine, callback)
    count = 2 if patterns is None else len(patterns)
    first_is_header = bool(patterns) and mentions((patterns or ())[0], _HEADER)
    answered: Value | None = None
    if count >= 3 and not first_is_header and patterns is not None and mentions(patterns[1], _HEADER):
        args: tuple[Value, ...] = (service, header, request, response)
    elif count >= 3:
        args = (header, request, response)
    elif first_is_header:
        args = (header, request)
    else:
        args = (request, response)
    if args[-1] is response:
        part = lift(lambda t: External(f"{t.name}.Response") if isinstance(t, External) else NONE, type_)
        answered = Partial(Native("rosward.answer"), (node, name, part, response), ())
    _add(machine, callback, args, "service", answered)
    return NONE


def _answer(call: NativeCall) -> Value:
    """`answer(node, name, type, response)`, behind the callback of a service: what it wrote into the response is sent."""
    node, name, type_, response, *_ = call.args
    record_sent(call.machine, "response", node, name, type_, target_of(call, response))
    return NONE


def _bound(call: NativeCall) -> Value:
    """`bound(callback, arguments…)`: a member function with the first of the arguments as its object; any other callable itself."""
    machine = call.machine
    callback = plain_callable(machine, given(call, 0))
    first = target_of(call, call.args[1]) if len(call.args) > 1 else NONE

    def one(option: Value) -> Value:
        is_member = isinstance(option, Function) and leading(option) == 1 and isinstance(first, Ref)
        return BoundMethod(first, option) if is_member else option

    return lift(one, callback)


def _field_among(call: NativeCall) -> Value:
    """`field_among(name, arguments…)`: that field of the first argument that has one; else null."""
    machine, name = call.machine, text_of(given(call, 0))
    for argument in call.args[1:]:
        target = target_of(call, argument)
        held = machine.obj(target).attrs.get(name) if isinstance(target, Ref) else None
        if held is not None:
            return held
    return NONE


def _takes(call: NativeCall) -> Value:
    """`takes(callback, word)`: whether the type of its first parameter is written with that word."""
    patterns = parameters(call.machine, given(call, 0))
    found = bool(patterns) and mentions((patterns or ())[0], text_of(given(call, 1)))
    return TRUE if found else FALSE


NATIVES: Final[dict[str, NativeFunction]] = {
    "rosward.answer": _answer,
    "rosward.bound": _bound,
    "rosward.deliver": _deliver,
    "rosward.field_among": _field_among,
    "rosward.schedule": _schedule,
    "rosward.serve": _serve,
    "rosward.takes": _takes,
}
