# SPDX-License-Identifier: Apache-2.0
"""What reaches code that is not known: it may call what is callable, change what can be changed, and use any node that it can get hold of.

lib.on_key(self.stop)         stop may be called from now on, with anything
lib.fill(self.buf)            self.buf holds what it held or something unknown (havoc.py)
lib.run(self)                 RW202: on this node the library may create what it likes
lib.run(App(node=self))       RW202 too: it has the node by an attribute
lib.Bridge(String, 'chatter')  RW202: with a type and a name it may create an entity on a node of its own
lib.serve(Handler)            it may make a Handler, and call what nothing else calls of it
lib.serve('demo.web:Handler') it may import it, then the same (named.py)
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, External, Partial, Tuple, function_behind
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer
from rosward.domain.values import Class, Const, Function, Ref, Text, Unknown, Value
from rosward.engine.unknown import declared, named
from rosward.engine.unknown.havoc import change, contents, holds_node
from rosward.engine.unknown.wrapped import calls_program, leads_to_program
from rosward.models.python.contents import CONTENTS
from rosward.models.readers import creates_nothing, knows_no_types, only_reads

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

BY_LIBRARY: Final = "call by a library"
BY_PYTHON: Final = "call by Python itself"
BY_BASE: Final = "call by the base class"
BY_WINDOW: Final = "call by a base class of a library without nodes"
"""Events whose callbacks give their results to code that is not known."""

_SPINS: Final = Tuple((Const("spins"),))
_DEPTH: Final = 4
"""How many containers deep callables and nodes are looked for."""


def escape(machine: Engine, values: Iterable[Value], library: str, callee: Value | None = None) -> None:
    """Values reach `library`: callables may be called with anything, later, any number of times; a node may get entities.

    What can be changed may come back changed, unless it is known of `callee` that it only reads. `library` is '' in what follows where it
    is known of it that it creates nothing on a node.
    """
    seen: set[int] = set()
    values = tuple(values)
    tell_type(machine, values, library, callee)
    foreign = callee is not None and creates_nothing(callee)
    reads = callee is not None and only_reads(callee)
    for value in values:
        _reach(machine, value, "" if foreign else library, callee, 0, seen)
        if not reads:
            change(machine, value, library or "a library")


def tell_type(machine: Engine, values: tuple[Value, ...], library: str, callee: Value | None) -> None:
    """An interface type and a text, for a name, reach a library: what a node is asked for, so it may be one, or have one."""
    if not isinstance(callee, (External, Unknown)) or knows_no_types(callee):
        return
    given = [option for value in values for option in options(value)]
    types = [option.name for option in given if option.__class__ is External and _TYPE.fullmatch(option.name)]
    if types and any(isinstance(o, Text) or (isinstance(o, Const) and isinstance(o.value, str)) for o in given):
        machine.report(
            "RW202",
            f"the type {types[0].replace('.', '/')} and a text are passed to {library}; what that creates is unknown",
            (_cause(library, callee),),
        )


_TYPE: Final = re.compile(r"\w+\.(?:msg|srv|action)\.[A-Z]\w*")


def may_call(machine: Engine, values: Iterable[Value]) -> None:
    """Functions of the program reach a library that is described: it may call them, later, with anything."""
    for value in values:
        for option in options(value):
            if isinstance(option, (Function, BoundMethod, Partial)) and _runs_program(machine, option):
                machine.schedule(option, None, BY_LIBRARY)


def name_of(value: Value) -> str:
    """What stands behind a value that is not known, for a finding."""
    if value.__class__ is Unknown and value.reasons:
        reason = value.reasons[0]
        return f"something unknown ({reason.cause.value}{': ' if reason.subject else ''}{reason.subject})"
    return getattr(value, "name", "") or "something unknown"


def _cause(library: str, callee: Value | None) -> str:
    """By what findings about one library, or one object that is not known, are put together: what settles one settles them all."""
    if isinstance(callee, Unknown) and callee.reasons:
        return f"passed to {callee.reasons[0]}"
    return f"passed to {library.partition('.')[0]}"


def _reach(machine: Engine, value: Value, library: str, callee: Value | None, depth: int, seen: set[int]) -> None:
    for option in options(value):
        option = option.target if isinstance(option, Pointer) else option  # noqa: PLW2901 - what a pointer leads to
        if isinstance(option, (Function, BoundMethod, Partial)):
            machine.schedule_book.parallel |= _spins(option)
            if _runs_program(machine, option):
                machine.schedule(option, None, BY_LIBRARY)
            elif library and _creates_on_node(machine, option):
                machine.report(
                    "RW202",
                    f"a method that creates entities is passed to {library}; what that creates is unknown",
                    (_cause(library, callee),),
                )
        elif isinstance(option, Class):
            if not option.stub:
                machine.trace.handed.setdefault(option, machine.place)
        elif isinstance(option, Const):
            named.note(machine, option)
        elif isinstance(option, Tuple):
            if depth < _DEPTH:
                for item in option.items:
                    _reach(machine, item, library, callee, depth + 1, seen)
        elif isinstance(option, Ref) and option.address not in seen:
            seen.add(option.address)
            _reach_object(machine, option, library, callee, depth, seen)


def _is_library(value: Value) -> bool:
    function = function_behind(value)
    return function is None or declared.is_model(function)


def _runs_program(machine: Engine, value: Value) -> bool:
    return not _is_library(value) or leads_to_program(machine, value)


def _spins(value: Value) -> bool:
    """Whether a value is a function of the client library by which nodes work."""
    function = function_behind(value)
    return isinstance(function, Function) and _SPINS in function.effects


def _lets_work(machine: Engine, obj: Obj) -> bool:
    """Whether an object has a method by which nodes work: an executor, to which they may be added later."""
    classes = obj.cls.mro if isinstance(obj.cls, Class) else ()
    models = [c for c in classes if isinstance(c, Class) and c.stub]
    return any(_spins(value) for c in models for value in machine.at(c.address).attrs.values())


def _creates_on_node(machine: Engine, value: Value) -> bool:
    """Whether a value is a method of a node by which entities are created."""
    while isinstance(value, Partial):
        value = value.function
    return (
        isinstance(value, BoundMethod)
        and isinstance(value.function, Function)
        and value.function.code.name in machine.library.facts.creating
        and any(isinstance(one, Ref) and machine.is_node(one.address) for one in options(value.receiver))
    )


def _reach_object(machine: Engine, ref: Ref, library: str, callee: Value | None, depth: int, seen: set[int]) -> None:
    obj = machine.obj(ref)
    if obj.kind == "generator":
        machine.schedule(ref, (), BY_LIBRARY)
    elif obj.kind == "instance":
        machine.trace.handed.setdefault(ref, machine.place)
        _reach_wrapper(machine, ref, obj)
        if not library:
            return  # it knows nothing of ROS
        is_node = machine.is_node(ref.address)
        machine.schedule_book.parallel |= _lets_work(machine, obj)
        if is_node or holds_node(machine, ref):
            machine.schedule_book.parallel = True  # it may let the node work, in threads
            what = "a node" if is_node else "an object that holds a node"
            machine.report(
                "RW202", f"{what} is passed to {library}; what that creates is unknown", (_cause(library, callee),)
            )
        held = obj.attrs.get(CONTENTS)
        if held is not None and depth < _DEPTH:
            _reach(machine, held, library, callee, depth + 1, seen)
    elif depth < _DEPTH:
        for item in contents(obj):
            _reach(machine, item, library, callee, depth + 1, seen)


def _reach_wrapper(machine: Engine, ref: Ref, obj: Obj) -> None:
    """An object of a model may be called where that runs the program, and what stands still in one (`contextmanager`) may go on."""
    if not isinstance(obj.cls, Class) or not obj.cls.stub:
        return
    if calls_program(machine, obj):
        machine.schedule(ref, None, BY_LIBRARY)
    for held in obj.attrs.values():
        if isinstance(held, Ref) and machine.obj(held).kind == "generator":
            machine.schedule(held, (), BY_LIBRARY)
