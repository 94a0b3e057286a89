# SPDX-License-Identifier: Apache-2.0
"""Does a program put something of its own in the place of a library's method? Then the library, which calls it, gets that.

class N(Node):
    def create_publisher(self, *args): …      rclpy calls it for /parameter_events, before any line of the program does

A model asks only where the answer can be the program's: what the library's own method would do, it says itself.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.certain import text_of
from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, Descriptor, Native, Partial, Tuple
from rosward.domain.heap import KIND
from rosward.domain.values import FALSE, NONE, TRUE, Class, Const, Function, Ref, Text, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import spread


def is_own(machine: Machine, value: Value, name: str) -> bool:
    """Whether `value.name` may be something else than what a model says."""
    return any(
        isinstance(option, Ref)
        and machine.part(option, KIND).kind == "instance"
        and any(not _modelled(found) for found in options(machine.load_attr(option, name)))
        for option in options(value)
    )


def _modelled(value: Value) -> bool:
    while isinstance(value, BoundMethod):
        value = value.function
    if isinstance(value, Descriptor):
        value = value.getter
    if isinstance(value, Partial):
        return False
    return isinstance(value, Native) or (isinstance(value, Function) and value.code.file.startswith("models:"))


def _overridden(call: NativeCall) -> Value:
    """`overridden(object, 'method', …)`: whether the program overrides one of them, in a subclass, on the class or on the object."""
    return TRUE if any(is_own(call.machine, call.args[0], text_of(name)) for name in call.args[1:]) else FALSE


def does_something(method: Value) -> bool:
    """Whether a method of a model has a body: what is written to an `io.StringIO` is read again, what goes to the screen is not."""
    function = method.function if isinstance(method, BoundMethod) else method
    return isinstance(function, Function) and not function.code.is_stub


def _keeps(machine: Machine, value: Value) -> bool:
    """Whether a model keeps what is written to an object."""
    objects = [o for o in options(value) if isinstance(o, Ref) and isinstance(machine.obj(o).cls, Class)]
    return any(does_something(machine.load_attr(each, _WRITE)) for each in objects)


_WRITE: Final = "write"


def _ask(call: NativeCall) -> Value:
    """`ask(object, 'method', …)`: call it where the program overrides it, or where what is written is kept; None where not."""
    machine, name = call.machine, text_of(call.args[1])
    if not is_own(machine, call.args[0], name) and not (name == _WRITE and _keeps(machine, call.args[0])):
        return NONE
    return machine.call(machine.load_attr(call.args[0], name), call.args[2:], call.keywords)


def _taken(call: NativeCall) -> Value:
    """`taken(value)`: the value as if it were settled; a default is taken to hold."""

    def one(value: Value) -> Value:
        if isinstance(value, Const):
            return Const(value.value)
        return Text(value.parts) if isinstance(value, Text) else value

    return spread(one, call.args[0])


def _awaited(call: NativeCall) -> Value:
    """`awaited(value)`: what a coroutine comes to; any other value as it is."""
    machine = call.machine
    return join_all(
        machine.wait_for(option) if isinstance(option, Ref) and machine.obj(option).kind == "generator" else option
        for option in options(call.args[0])
    )


REGISTERED: Final = "__registered__"
"""Where a class keeps what `register` gave it, and those derived from it."""


def _register(call: NativeCall) -> Value:
    """`register(abstract, cls)`: from now on isinstance counts what is of `cls` as of `abstract`, and of the classes above it."""
    machine, given = call.machine, call.args[1]
    for option in options(call.args[0]):
        for base in option.mro if isinstance(option, Class) else ():
            if isinstance(base, Class):
                place = Ref(base.address)
                record = machine.obj(place)
                old = record.attrs.get(REGISTERED)
                known = old.items if isinstance(old, Tuple) else ()
                machine.update(place, record.with_attr(REGISTERED, Tuple((*known, given))))
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.overridden": _overridden,
    "_rosward.ask": _ask,
    "_rosward.register": _register,
    "_rosward.taken": _taken,
    "_rosward.awaited": _awaited,
}
