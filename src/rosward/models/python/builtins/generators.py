# SPDX-License-Identifier: Apache-2.0
"""The methods of generators.

g.send('a')       the next item; `yield` gives 'a'
g.throw(error)    raised where it stands
g.close()         GeneratorExit is raised where it stands
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import Native, Tuple
from rosward.domain.values import NONE, UNBOUND, Class, Ref, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.exceptions import builtin_base
from rosward.models.python.plain import native, spread


def _receiver(call: NativeCall) -> Ref | None:
    first = call.args[0]
    return first if isinstance(first, Ref) and call.machine.obj(first).kind == "generator" else None


def _next(call: NativeCall) -> Value:
    return spread(lambda value: call.machine.next_of(value, "next", NONE), call.args[0])


def _send(call: NativeCall) -> Value:
    return call.machine.next_of(call.args[0], "send", call.args[1])


def _throw(call: NativeCall) -> Value:
    """`throw(exception)`, or as older programs do: `throw(cls, value, traceback)`."""
    machine, exception = call.machine, call.args[1]
    value = call.args[2] if len(call.args) > 2 else NONE
    if isinstance(exception, Class) or (isinstance(exception, Native) and builtin_base(exception) is not None):
        if isinstance(value, Ref) and machine.is_instance(value, exception):
            exception = value
        else:
            given = value.items if isinstance(value, Tuple) else () if value == NONE else (value,)
            exception = machine.call(exception, given)
    return UNBOUND if exception is UNBOUND else machine.next_of(call.args[0], "throw", exception)


def _close(call: NativeCall) -> Value:
    ref = _receiver(call)
    if ref is not None:
        call.machine.close_generator(ref)
    return NONE


def _itself(call: NativeCall) -> Value:
    return call.args[0]


NATIVES: Final[dict[str, NativeFunction]] = {
    "generator.__next__": native(_next, 1),
    "generator.__iter__": native(_itself, 1),
    "generator.__aiter__": native(_itself, 1),
    "generator.send": native(_send, 2),
    "generator.throw": native(_throw, 2),
    "generator.close": native(_close, 1),
}
