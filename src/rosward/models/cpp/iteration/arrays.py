# SPDX-License-Identifier: Apache-2.0
"""Arrays of C, where a function wants iterators: `std::sort(values, values + 3)` gets pointers to elements."""

from __future__ import annotations

from rosward.domain.choice import lift
from rosward.domain.slots import TypeOf
from rosward.domain.values import Const, Ref, Value
from rosward.models.cpp.iteration.iterators import iterator
from rosward.models.native import Machine, NativeCall, NativeFunction

__all__ = ["decaying"]


def decaying(function: NativeFunction) -> NativeFunction:
    """A function of iterators, which is given arrays as pointers to their first elements."""

    def given(call: NativeCall) -> Value:
        return function(call._replace(args=tuple([lift(lambda o: _decayed(call.machine, o), a) for a in call.args])))

    return given


def _decayed(machine: Machine, value: Value) -> Value:
    cls = machine.obj(value).cls if isinstance(value, Ref) else None
    return iterator(value, Const(0)) if isinstance(cls, TypeOf) and cls.name == "array" else value
