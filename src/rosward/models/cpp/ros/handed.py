# SPDX-License-Identifier: Apache-2.0
"""What does a native of the namespace `rosward` get: values instead of slots, the node behind whatever stands for one?

A model hands over `this`, a smart pointer, a node interface or a sub-node: `node_of` gives the object of the node in the graph.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import Tuple
from rosward.domain.slots import Pointer
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Const, Ref, Unknown, Value
from rosward.models.cpp.values.characters import text_behind
from rosward.models.cpp.values.slots import read
from rosward.models.native import NativeCall

__all__ = ["NODE", "NOTHING", "given", "node_of", "target_of", "types_of", "unknown_type"]

NODE: Final = "_node"
"""The field in which the models keep the node that an object belongs to."""
NOTHING: Final = "rosward.nothing"
"""The function by which a header says that an argument is not given."""


def given(call: NativeCall, index: int, default: Value = NONE) -> Value:
    """The value of an argument; that of a variable where it is one."""
    return text_behind(call.machine, read(call.machine, call.args[index])) if index < len(call.args) else default


def types_of(call: NativeCall) -> tuple[Value, ...]:
    """The template arguments that a native is called with."""
    found = call.keywords.get("types")
    return found.items if isinstance(found, Tuple) else ()


def unknown_type(call: NativeCall) -> Value:
    """What stands for a template argument that is not there."""
    return call.machine.unknown(Cause.CALL, f"template argument of {call.name}")


def target_of(call: NativeCall, value: Value) -> Value:
    """The object that a value is, or that it points to."""
    machine = call.machine

    def one(option: Value) -> Value:
        for _ in range(4):
            if not isinstance(option, Pointer):
                break
            option = read(machine, option.target)
        return option

    held = read(machine, value)
    return join_all(one(o) for o in options(held)) if len(options(held)) > 1 else one(held)


def node_of(call: NativeCall, value: Value) -> Value:
    """The node in the graph that an object is, or belongs to."""

    def one(option: Value) -> Value:
        if isinstance(option, Ref):
            found = call.machine.part(option, NODE).attrs.get(NODE, UNBOUND)
            if found is not UNBOUND and found != NONE and not isinstance(found, (Unknown, Const)):
                return target_of(call, found)
        return option

    return lift(one, target_of(call, value))
