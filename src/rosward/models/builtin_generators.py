# SPDX-License-Identifier: Apache-2.0
"""The methods of generators.

g.send('a')       the next item; `yield` gives 'a'
g.throw(error)    raised where it stands
g.close()         GeneratorExit is raised where it stands
"""

from __future__ import annotations

from typing import Final

from rosward.domain.values import NONE, Class, Ref, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.plain import native, spread


def _receiver(call: NativeCall) -> Ref | None:
    first = call.args[0]
    return first if isinstance(first, Ref) and call.machine.obj(first).kind == "generator" else None


def _next(call: NativeCall) -> Value:
    return spread(lambda value: call.machine.next_of(value, "next", NONE), call.args[0])


def _send(call: NativeCall) -> Value:
    return call.machine.next_of(call.args[0], "send", call.args[1])


def _throw(call: NativeCall) -> Value:
    exception = call.args[1] if len(call.args) < 3 or call.args[2] == NONE else call.args[2]
    if isinstance(exception, Class):
        exception = call.machine.call(exception, ())
    return call.machine.next_of(call.args[0], "throw", exception)


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
