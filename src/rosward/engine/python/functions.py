# SPDX-License-Identifier: Apache-2.0
"""Attributes of functions: what the program gave them, and what every function has.

f.topic = 'scan'                     kept in a record of the function
f.__dict__.setdefault('subs', [])    a dict of what is kept there; what is stored in it becomes an attribute
f.__get__(node)                      the method of that object
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, Native, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Const, Function, Value
from rosward.engine.python.namespaces import table_of
from rosward.models.python.builtins.attributes import ANY_ATTRIBUTE
from rosward.models.python.std.annotations import of_function as annotated

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_NOT_IN_DICT: Final = frozenset({"__module__", "__name__", "__qualname__", "__doc__"})
"""What `functools.wraps` sets on a function, and is not part of its `__dict__`."""


def record_of(machine: Engine, function: Function) -> Obj:
    """What is kept of a function. It stands for several functions where a variable that it captures does."""
    kept = machine.function_record(function) or Obj("instance", NONE)
    several = not kept.many and any(machine.at(cell).many for cell in function.cells)
    return kept.replace(many=True) if several else kept


def of_function(machine: Engine, function: Function, name: str) -> Value:
    """function.name"""
    kept = machine.function_record(function)
    found = kept.attrs.get(name, UNBOUND) if kept is not None else UNBOUND  # first: functools.wraps renames
    if found is not UNBOUND:
        return found
    if name in ("__name__", "__qualname__"):
        return Const(function.code.name if name == "__name__" else function.code.qualname)
    if name == "__module__":
        return Const(function.module.name)
    if name == "__doc__":
        return Const(function.code.doc)
    if name.startswith("__"):
        own = _of_every(machine, function, name)
        if own is not None:
            return own
    if kept is not None and ANY_ATTRIBUTE in kept.partial:
        return machine.unknown(Cause.CALL, f"{function.code.name}.{name}")
    return machine.unknown(Cause.ERROR, f"no attribute {name} of function {function.code.name}")


def _of_every(machine: Engine, function: Function, name: str) -> Value | None:
    """What every function of Python has."""
    if name == "__call__":
        return function
    if name == "__get__":
        return BoundMethod(function, Native("function.__get__"))
    if name == "__dict__":
        address, record = machine.library.function_address(function), record_of(machine, function)
        if record is not machine.own(address):
            machine.put(address, record)
        return table_of(machine, address, _NOT_IN_DICT)
    if name == "__globals__":
        return table_of(machine, function.module.address)
    if name == "__defaults__":
        return Tuple(function.defaults) if function.defaults else NONE
    if name == "__kwdefaults__":
        return kept_table(machine, function, function.kwdefaults) if function.kwdefaults else NONE
    if name == "__annotations__":
        return machine.new_dict({Const(n): v for n, v in annotated(machine, function).items()})
    if name == "__code__":
        return _code(machine, function)
    if name == "__closure__":
        shown = (
            _object(machine, ("cell", n), cell, **_content(machine, cell))
            for n, (_, cell) in enumerate(zip(function.code.free, function.cells, strict=False))
        )
        return Tuple(tuple(shown)) if function.code.free else NONE
    return None


def _content(machine: Engine, cell: int) -> dict[str, Value]:
    value = machine.at(cell).attrs.get("value", UNBOUND)
    return {} if value is UNBOUND else {"cell_contents": value}


def _object(machine: Engine, what: object, behind: object, **attrs: Value) -> Value:
    """An object that shows something of a function; `behind` is what it shows, for whoever makes a function of it."""
    return machine.allocate(Obj("instance", NONE, attrs=attrs, payload=behind), what)


def kept_table(machine: Engine, owner: Value, entries: Iterable[tuple[str, Value]]) -> Value:
    """A dict of what belongs to a value that does not change; that something is stored in it is told (`dicts.store`)."""
    record = Obj("dict", Native("builtins.dict"), entries={Const(k): v for k, v in entries}, payload=owner)
    return machine.allocate(record, "table")


def _code(machine: Engine, function: Function) -> Value:
    """What is asked of `__code__`: names and numbers of parameters."""
    code, given = function.code, function.code.parameters
    names = (*given.positional, *given.kwonly, *(n for n in (given.vararg, given.kwarg) if n is not None))
    names += tuple(n for n in code.variables if n not in names and n.isidentifier())
    return _object(
        machine,
        "code",
        function,
        co_name=Const(code.name),
        co_qualname=Const(code.qualname),
        co_firstlineno=Const(code.line),
        co_argcount=Const(len(given.positional)),
        co_posonlyargcount=Const(given.posonly),
        co_kwonlyargcount=Const(len(given.kwonly)),
        co_varnames=Tuple(tuple(map(Const, names))),
        co_freevars=Tuple(tuple(map(Const, code.free))),
    )


def of_partial(machine: Engine, value: Partial, name: str) -> Value:
    """What a `functools.partial` says of itself."""
    if name == "keywords":
        return kept_table(machine, value, value.keywords)
    if name == "__call__":
        return value
    return value.function if name == "func" else Tuple(value.arguments)
