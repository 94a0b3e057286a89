# SPDX-License-Identifier: Apache-2.0
"""What does the class of a class do? It may prepare the names of a class body, make the class, and make its instances.

class Single(type):
    def __call__(cls): …         Single decides what `C()` gives, for each class C that has it as metaclass
type(name, bases, names)         a class without a class statement
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Descriptor
from rosward.domain.values import UNBOUND, Class, Const, Function, Ref, Value
from rosward.engine.python import members
from rosward.engine.python.metaclass_of import TYPE, in_metaclass, metaclass_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def chosen(machine: Engine, written: Value | None, bases: tuple[Value, ...]) -> Value:
    """The metaclass of a class to be made: the one that is written, or the most derived one of its bases."""
    best: Value = next((o for o in options(written) if o.__class__ is Class), TYPE) if written is not None else TYPE
    for base in bases:
        meta = metaclass_of(machine, base)
        if isinstance(meta, Class) and (not isinstance(best, Class) or best in meta.mro):
            best = meta
    return best


def method(machine: Engine, cls: Value, name: str) -> Value | None:
    """What the program's metaclass of a class has under a name, bound to the class; None where it has no such thing."""
    found = in_metaclass(machine, cls, name)
    return None if found is None else members.bind(machine, found, cls, metaclass_of(machine, cls))


def prepare(machine: Engine, meta: Value, name: str, bases: Value, keywords: dict[str, Value]) -> dict[str, Value]:
    """What `__prepare__` puts into a class body before its first line."""
    hook = members.lookup(machine, meta, "__prepare__")
    if hook is None or hook.__class__ not in (Function, Descriptor):
        return {}
    function = hook.getter if isinstance(hook, Descriptor) else hook
    made = machine.call(BoundMethod(meta, function), (Const(name), bases), keywords)
    found: dict[str, Value] = {}
    for option in options(made):
        if isinstance(option, Ref) and machine.obj(option).kind == "instance":  # an OrderedDict
            option = machine.call_native("builtins.dict", (option,))  # noqa: PLW2901
        if isinstance(option, Ref) and machine.obj(option).kind == "dict":
            entries = machine.obj(option).entries.items()
            found.update({k.value: v for k, v in entries if isinstance(k, Const) and isinstance(k.value, str)})
    return found


Complete = Callable[["Engine", Class, dict[str, Value]], Class]


def finish(
    machine: Engine, cls: Class, meta: Class, bases: Value, keywords: dict[str, Value], complete: Complete
) -> Value:
    """Run `__new__` and `__init__` of the metaclass over a class whose body has been run; what becomes of it."""
    record = machine.at(cls.address)
    machine.put(cls.address, record.replace(cls=meta))
    maker, starter = (members.lookup(machine, meta, n) for n in ("__new__", "__init__"))
    maker = maker.getter if isinstance(maker, Descriptor) else maker
    if maker.__class__ is not Function:
        complete(machine, cls, {} if starter.__class__ is Function else keywords)
        if starter.__class__ is not Function:
            return cls
    names = machine.new_dict({Const(k): v for k, v in machine.at(cls.address).attrs.items() if v is not UNBOUND})
    arguments = (Const(cls.name), bases, names)
    made: Value = cls
    if maker.__class__ is Function:
        machine.making.append(cls)
        try:
            made = machine.call(maker, (meta, *arguments), keywords)
        finally:
            machine.making.pop()
    return start(machine, meta, made, arguments, keywords)


def start(machine: Engine, meta: Class, made: Value, args: tuple[Value, ...], keywords: dict[str, Value]) -> Value:
    """Run `__init__` of a metaclass over what a call of it has made, if that is a class of it; what was made."""
    for option in options(made):
        own = metaclass_of(machine, option) if isinstance(option, Class) else None
        starter = members.lookup(machine, own, "__init__") if isinstance(own, Class) and meta in own.mro else None
        if starter.__class__ is Function:
            machine.call(BoundMethod(option, starter), args, keywords)
    return made


def fill(machine: Engine, cls: Class, names: Value) -> None:
    """Give a class the names of a namespace: what `type.__new__` does."""
    sure = len(options(names)) == 1
    for option in options(names):
        if not (isinstance(option, Ref) and machine.obj(option).kind == "dict"):
            machine.report("RW203", "a class is created from unknown names")
            continue
        table = machine.obj(option)
        record = machine.at(cls.address)
        attrs = dict(record.attrs)
        for key, value in table.entries.items():
            if isinstance(key, Const) and isinstance(key.value, str):
                attrs[key.value] = value
        if sure and table.rest is None:  # what the metaclass took away is gone
            attrs = {n: v for n, v in attrs.items() if Const(n) in table.entries or n.startswith("__")}
        if table.rest is not None:
            machine.report("RW203", "a class is created from names that are not all known")
        machine.put(cls.address, record.replace(attrs=attrs))
