# SPDX-License-Identifier: Apache-2.0
"""What may Python or a modelled library call on the program's own objects, where no line of the program says so?

class Job:
    def __lt__(self, other): …                  heapq calls it, sorted, min, …
    def __del__(self): …                        whenever nothing holds the object any more
class Mine(logging.Filter):
    def filter(self, record): …                 declared in the model, which does not call it: the library does

Where Python's call is followed (`FOLLOWED`), what was run is known. All else may run at any time, with anything: when the rest has come
to rest it is run so, and what it creates is conditional. `docs/special-methods.md` has the table.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, Descriptor
from rosward.domain.heap import CLASSES
from rosward.domain.values import Class, Function, Ref, Value
from rosward.engine.python.metaclass_of import metaclass_of
from rosward.engine.python.own_methods import AT_MAKING
from rosward.engine.unknown.declared import is_model

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

FOLLOWED: Final = frozenset(
    {
        "__init__", "__new__", "__init_subclass__", "__set_name__", "__class_getitem__", "__prepare__",
        "__mro_entries__", "__instancecheck__", "__subclasscheck__", "__subclasshook__",
        "__getattr__", "__getattribute__", "__setattr__", "__delattr__", "__get__", "__set__", "__delete__",
        "__call__", "__enter__", "__exit__", "__aenter__", "__aexit__", "__await__", "__aiter__", "__anext__",
        "__iter__", "__next__", "__getitem__", "__setitem__", "__delitem__", "__missing__", "__contains__",
        "__bool__", "__copy__", "__deepcopy__", "__format__", "__abs__", "__round__", "__divmod__", "__neg__", "__pos__", "__invert__",
        "__post_init__", "__attrs_post_init__",  # of dataclasses and attrs: their models call them where an object is made
        *(f"__{p}{n}__" for n in (
            "add", "sub", "mul", "truediv", "floordiv", "mod", "pow", "matmul", "and", "or", "xor", "lshift", "rshift",
        ) for p in ("", "i", "r")),
    }
)  # fmt: skip
"""Special methods that the engine calls wherever Python does: one that was never run is called by nothing that is read."""


def callbacks(machine: Engine) -> Iterator[Value]:
    """Methods of objects that there are, bound, that something may call at any time."""
    for cls, objects in _objects(machine).items():
        receiver = join_all(objects)
        for function in _uncalled(machine, cls):
            if function.code.name == "__del__":  # it may find what a callback has left that was interrupted
                machine.schedule_book.parallel = True
            yield BoundMethod(receiver, function)


def _objects(machine: Engine) -> dict[Class, list[Value]]:
    """The objects of classes of the program, classes with a metaclass among them."""
    found: dict[Class, list[Value]] = {}
    for address, obj in machine.state.heap.items():
        if isinstance(obj.cls, Class) and not obj.cls.stub and obj.kind not in ("class", "module", "cell"):
            for cls in options(obj.attrs[CLASSES]) if CLASSES in obj.attrs else (obj.cls,):
                if isinstance(cls, Class):
                    found.setdefault(cls, []).append(Ref(address))
    for cls in machine.log.classes:
        meta = metaclass_of(machine, cls)
        if isinstance(meta, Class) and not meta.stub:
            found.setdefault(meta, []).append(cls)
    return found


def _uncalled(machine: Engine, cls: Class) -> Iterator[Function]:
    seen: set[str] = set()
    for number, base in enumerate(cls.mro):
        if not isinstance(base, Class) or base.stub:
            continue
        for name, value in machine.at(base.address).attrs.items():
            if name in seen:
                continue
            seen.add(name)
            function = value.getter if isinstance(value, Descriptor) and value.kind == "property" else value
            if not isinstance(function, Function) or is_model(function):
                continue
            run = function.code.key in machine.trace.entered
            special = name.startswith("__") and name.endswith("__") and name not in AT_MAKING
            if (special and not (run and name in FOLLOWED)) or (
                not special and not run and _is_declared(machine, cls.mro[number + 1 :], name)
            ):
                yield function


def _is_declared(machine: Engine, bases: tuple[Value, ...], name: str) -> bool:
    """Whether the next class that has a method is a model that says nothing of what it does: then the library may call it."""
    for base in bases:
        found = machine.at(base.address).attrs.get(name) if isinstance(base, Class) else None
        if isinstance(found, Function):
            return is_model(found) and found.code.is_stub and not _asks(machine, found.module.name)
    return False


def _asks(machine: Engine, module: str) -> bool:
    """Whether the model of a library says itself what it calls."""
    return module.partition(".")[0] in machine.library.facts.asking
