# SPDX-License-Identifier: Apache-2.0
"""What may a library do with the classes and objects that it was handed, besides what the program does with them itself?

    rpc.serve(Api(node))               calls methods of the Api that nothing else calls
    webserver.Application([Handler])   makes a Handler, and has that in its hands too
    @tasks.register('stop')            calls the method below where nothing else does

What the program itself calls is followed with its own values: there it is taken that the library calls nothing else. So this is asked
when all else has come to rest.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, External
from rosward.domain.values import Class, Function, Ref, Unknown, Value
from rosward.engine.unknown import named
from rosward.engine.unknown.escape import BY_LIBRARY, BY_PYTHON
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_ROUNDS: Final = 10
"""How often a library may be handed something by what it called itself."""


def follow(machine: Engine) -> None:
    """Run what libraries may do with what they hold, until that gives them nothing new."""
    met: set[str] = set()
    for _ in range(_ROUNDS):
        before = len(machine.schedule_book.entries) + len(machine.schedule_book.named)
        for text, naming in list(machine.schedule_book.named.items()):
            if text not in met:
                met.add(text)
                for value in named.called(machine, naming):
                    if isinstance(value, Class):
                        machine.trace.handed.setdefault(value, naming.place)
                    else:
                        machine.schedule(value, None, BY_LIBRARY, naming.place)
        for value, place in list(machine.trace.handed.items()):
            for callback in _not_called(machine, value):
                machine.schedule(callback, None, BY_LIBRARY, place)
        handed = len(machine.trace.handed)
        for callback in machine.language.implicit_calls(machine):
            machine.schedule(callback, None, BY_PYTHON, _place(callback))
        after = len(machine.schedule_book.entries) + len(machine.schedule_book.named)
        if after == before and len(machine.trace.handed) == handed:
            return
        machine.spin()
    machine.report("RW201", "ever more objects are passed to libraries; what they do with the last ones may be missing")


def _not_called(machine: Engine, value: Value) -> Iterator[Value]:
    """Of a class, the class itself, and a function that was decorated itself; of an object, its methods: where nothing else calls them."""
    if isinstance(value, Class):
        if value.place not in machine.trace.instantiated:
            yield value
    elif isinstance(value, Function):
        if value.code.key not in machine.trace.entered:
            yield value
    elif isinstance(value, Ref):
        cls = machine.obj(value).cls
        if isinstance(cls, Class) and (not machine.is_node(value.address) or _has_unknown_base(cls)):
            for name, method in machine.language.own_methods(machine, cls, value):
                if not _called(machine, name, method):
                    yield method


def _has_unknown_base(cls: Class) -> bool:
    return any(isinstance(base, (External, Unknown)) for base in cls.mro)


def _called(machine: Engine, name: str, method: Value) -> bool:
    """Whether a method was run. One that a decorator replaced is another function, which may stand for many."""
    function = method.function if isinstance(method, BoundMethod) else method
    return isinstance(function, Function) and function.code.name == name and function.code.key in machine.trace.entered


def _place(callback: Value) -> Place:
    """Where a method is written."""
    function = callback.function if isinstance(callback, BoundMethod) else callback
    return Place(function.code.file, function.code.line) if isinstance(function, Function) else Place("", 0)
