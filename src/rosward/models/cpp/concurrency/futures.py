# SPDX-License-Identifier: Apache-2.0
"""Futures: what was promised, or what a task gives, to whoever asks for it and however often.

std::async(f).get()                     what f gives, which is called once
promise.set_value(5); future.get()      5
promise.set_exception(p); future.get()  throws what p leads to
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Partial
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, TRUE, UNBOUND, Ref, Value
from rosward.models.cpp.functional import kept
from rosward.models.cpp.values.copies import copied
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import name_of
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import EXCEPTION_HINT

__all__ = ["NATIVES"]

_TASK: Final = "task"
_VALUE: Final = "value"
_ERROR: Final = "error"
_PROMISE: Final = "promise"
"""Of a future: where its value is kept, which its copies share. A pointer to a promise."""
_HAS_FUTURE: Final = "has future"
"""A promise of which there is a future; one that is assigned in its place has none."""
_FUTURES: Final = ("future", "shared_future")


def _promise(machine: Machine, **attrs: Value) -> Ref:
    return machine.allocate(Obj("instance", External("std.promise"), attrs), "promise")


def _future(machine: Machine, promise: Ref) -> Ref:
    return machine.allocate(Obj("instance", External("std.future"), {_PROMISE: Pointer(promise)}), "future")


def _async(call: NativeCall) -> Value:
    """std::async(policy, callable, arguments…): a future, which knows what to call."""
    machine, args = call.machine, list(call.args)
    if args and name_of(read(machine, args[0])).startswith("std.launch"):
        args.pop(0)
    promise = _promise(machine)
    if args:
        function, given = read(machine, args[0]), tuple(kept(machine, arg) for arg in args[1:])
        machine.schedule(function, given, "thread")
        task = {_TASK: Partial(function, given, ()), _HAS_FUTURE: TRUE}
        machine.update(promise, machine.obj(promise).replace(attrs=task))
    return _future(machine, promise)


def _future_of(call: NativeCall) -> Value:
    """promise.get_future(): an object that knows the promise, which keeps the value; so do its copies."""
    machine, held = call.machine, read(call.machine, call.args[0])
    if not isinstance(held, Ref):
        return machine.unknown(Cause.LIVE, "std.future")
    machine.update(held, machine.obj(held).with_attr(_HAS_FUTURE, TRUE))
    return _future(machine, held)


def _set_value(call: NativeCall) -> Value:
    return _set(call, _VALUE, copied(call.machine, call.args[1]) if len(call.args) > 1 else NONE)


def _set_exception(call: NativeCall) -> Value:
    return _set(call, _ERROR, read(call.machine, call.args[1]))


def _set(call: NativeCall, name: str, value: Value) -> Value:
    for held in options(read(call.machine, call.args[0])):
        if isinstance(held, Ref):
            call.machine.update(held, call.machine.obj(held).with_attr(name, value))
    return NONE


def _get(call: NativeCall) -> Value:
    """future.get(): what was set, or what the callable gives, which has run by now."""
    machine = call.machine
    machine.waits(others=True)
    found: list[Value] = []
    for held in options(read(machine, call.args[0])):
        attrs = machine.obj(held).attrs if isinstance(held, Ref) else {}
        found += [_promised(machine, option) for option in options(attrs.get(_PROMISE, NONE))]
    return join_all(found)


def _promised(machine: Machine, promise: Value) -> Value:
    """What was set, or will be by the time that somebody asks for it."""
    target = promise.target if isinstance(promise, Pointer) else None
    if not isinstance(target, Ref) or _HAS_FUTURE not in machine.obj(target).attrs:
        return machine.unknown(Cause.LIVE, "std.future")
    obj = machine.obj(target)
    if _VALUE not in obj.attrs and _TASK in obj.attrs:
        result = machine.call(obj.attrs[_TASK], ())
        if result is UNBOUND:
            return UNBOUND
        machine.update(target, machine.obj(target).with_attr(_VALUE, copied(machine, result)))
        obj = machine.obj(target)
    if _ERROR in obj.attrs:
        surely = _ERROR not in obj.partial and _VALUE not in obj.attrs
        if surely or machine.is_tried:
            _throw(machine, obj.attrs[_ERROR])
        if surely:
            return UNBOUND
    return obj.attrs.get(_VALUE) or machine.unknown(Cause.LIVE, "std.future")


def _new_future(call: NativeCall) -> Value:
    """A future is made of another one, which it takes the place of."""
    if len(call.args) > 1:
        return copied(call.machine, call.args[1])
    return call.machine.allocate(Obj("instance", External(name_of(call.args[0]))), "future")


def _waited(call: NativeCall) -> Value:
    call.machine.waits(others=True)
    return call.machine.unknown(Cause.LIVE, call.name)


# Exceptions that are handed over: pointers to them


def _throw(machine: Machine, pointer: Value) -> None:
    for option in options(pointer):
        thrown = option.target if isinstance(option, Pointer) else None
        machine.throw(thrown if isinstance(thrown, Ref) else machine.unknown(Cause.LIVE, "exception", EXCEPTION_HINT))


def _make_exception_ptr(call: NativeCall) -> Value:
    held = copied(call.machine, call.args[0])
    return join_all(Pointer(o) if isinstance(o, Ref) else _unseen(call) for o in options(held))


def _current_exception(call: NativeCall) -> Value:
    handled = [o for o in options(call.machine.handled) if o is not UNBOUND]
    return join_all(Pointer(o) if isinstance(o, Ref) else _unseen(call) for o in handled) if handled else _unseen(call)


def _unseen(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.LIVE, call.name)


def _rethrow_exception(call: NativeCall) -> Value:
    _throw(call.machine, read(call.machine, call.args[0]))
    return UNBOUND


NATIVES: Final[dict[str, NativeFunction]] = {
    "std.async": _async,
    "std.promise.new": lambda call: _promise(call.machine),
    "std.promise.get_future": _future_of,
    **{f"std.promise.{name}": _set_value for name in ("set_value", "set_value_at_thread_exit")},
    **{f"std.promise.{name}": _set_exception for name in ("set_exception", "set_exception_at_thread_exit")},
    **{f"std.{kind}.{name}": _waited for kind in _FUTURES for name in ("wait", "wait_for", "wait_until", "valid")},
    **{f"std.{kind}.get": _get for kind in _FUTURES},
    **{f"std.{kind}.share": lambda call: copied(call.machine, call.args[0]) for kind in _FUTURES},
    **{f"std.{kind}.new": _new_future for kind in _FUTURES},
    "std.exception_ptr.new": lambda call: read(call.machine, call.args[1]) if len(call.args) > 1 else NONE,
    "std.make_exception_ptr": _make_exception_ptr,
    "std.current_exception": _current_exception,
    "std.rethrow_exception": _rethrow_exception,
}
