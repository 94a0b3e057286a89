# SPDX-License-Identifier: Apache-2.0
"""What is a call of a method that nodes alone have, on something of which that is not known?

class Driver : public vendor::DriverNode { Driver() { create_publisher<String>("out", 10); } };      it is taken for a node: RW204
blackboard->get<Node::SharedPtr>("node")->create_publisher<String>("out", 10);                       on a node that is not known: RW208
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.compound import External
from rosward.domain.heap import Obj
from rosward.domain.slots import Overloads
from rosward.domain.values import Class, Ref, Unknown, Value
from rosward.engine.cpp import construct, names
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.values import overloads
from rosward.models.cpp.facts import ADAPTED, ASSUMED_NODE, GENERIC, TYPED
from rosward.models.interfaces import is_interface

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["method"]


def method(machine: Engine, owner: Value, name: str, types: tuple[Value, ...]) -> Overloads | None:
    """The method of what is taken for a node; None where it is no node by that."""
    if name not in GENERIC and not (name in TYPED and types and _is_interface(types[0])):
        return None
    program = linked(machine)
    *scope, last = ASSUMED_NODE
    found = names.in_namespace(machine, tuple(scope), last, "")
    cls = program.value_of(machine, found, None) if found is not None else None
    info = program.info(cls) if cls is not None else None
    functions = names.in_class(machine, info, name) if info is not None else None
    if not isinstance(cls, Class) or info is None or functions is None:
        return None
    address = machine.place_key(("assumed node", owner))
    if machine.own(address) is None:
        machine.put(address, Obj("instance", cls))
        construct.construct_in_place(machine, Ref(address), info, (owner,))
    return overloads(machine, functions, types, Ref(address))


def _is_interface(type_: Value) -> bool:
    if isinstance(type_, Class):
        return type_.dotted.startswith(ADAPTED)
    return isinstance(type_, Unknown) or (isinstance(type_, External) and is_interface(type_.name))
