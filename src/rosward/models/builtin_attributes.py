# SPDX-License-Identifier: Apache-2.0
"""getattr, setattr, hasattr and delattr, with names that are known, partly known or not.

getattr(self, 'on_' + unknown)      any attribute of self that begins so, or something unknown
setattr(self, unknown, value)       a finding (RW203)
"""

from __future__ import annotations

import builtins
from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.text import matches
from rosward.domain.values import (
    NONE,
    UNBOUND,
    BoundMethod,
    Class,
    Const,
    Function,
    ModuleValue,
    Native,
    Range,
    Ref,
    Text,
    Tuple,
    Value,
)
from rosward.models.host import host
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.operators_compare import kind_of
from rosward.models.plain import (
    Raised,
    native,
    origins,
    spread,
    text_of,
    unknown_from,
    with_origins,
)

MAX_MATCHES: Final = 64
ANY_ATTRIBUTE: Final = "*"
"""Among the attributes of a function that may be there: a library that is not read may have set others."""


class _Plain:
    """What objects of a class have that says nothing of them."""


class _Sample:
    def method(self) -> None:
        """A method: what all of them have is asked of it."""


_METHOD: Final = _Sample().method
_FUNCTION: Final = _Sample.method


def has_attribute(machine: Machine, value: Value, name: str) -> bool | None:
    """Whether value.name exists; None where that is not known."""
    if isinstance(value, Ref) and machine.obj(value).kind == "instance":
        obj = machine.obj(value)
        own = obj.attrs.get(name)
        in_class = _in_class(machine, obj.cls, name, _Plain())
        if own is None or own is UNBOUND:
            return in_class
        return True if in_class or name not in obj.partial else None
    if isinstance(value, Class):
        return (
            True
            if name in ("__name__", "__qualname__", "__module__", "__doc__")
            else _in_class(machine, value, name, object)
        )
    if isinstance(value, ModuleValue):
        record = machine.obj(Ref(value.address))
        return True if record.attrs.get(name, UNBOUND) is not UNBOUND and name not in record.partial else None
    if isinstance(value, (Function, BoundMethod, Native)):
        return _of_callable(machine, value, name)
    if isinstance(value, (Const, Text, Tuple, Range, Ref)):
        found = getattr(builtins, kind_of(machine, value), None)
        return hasattr(None, name) if value == NONE else _objects_have(found, name) if isinstance(found, type) else None
    return None


def _objects_have(cls: type, name: str) -> bool:
    """Whether objects of a builtin class have an attribute: not what only the class itself has, as `__name__`."""
    return any(name in vars(base) for base in cls.__mro__)


def _of_callable(machine: Machine, value: Value, name: str) -> bool | None:
    """Whether a function or method has an attribute: what was set on it, or what every function has."""
    bound = isinstance(value, BoundMethod)
    while isinstance(value, BoundMethod):
        value = value.function
    if isinstance(value, Native):
        found = getattr(builtins, value.name.removeprefix("builtins."), None)
        return hasattr(len if found is None and bound else found, name) if bound or found is not None else None
    if not isinstance(value, Function):
        return None
    every = hasattr(_METHOD if bound else _FUNCTION, name)
    interpreter = host(machine)
    kept = interpreter.state.heap.get(interpreter.library.function_address(value))
    if kept is None or every:
        return every
    own = kept.attrs.get(name, UNBOUND)
    if own is UNBOUND:
        return None if ANY_ATTRIBUTE in kept.partial else False
    return None if name in kept.partial else True


def may_hide(machine: Machine, cls: Class, name: str) -> bool:
    """Whether a class of a model may have an attribute that is not declared: unless it lists all such in `_rosward_hidden`."""
    if not cls.stub or name == "__call__":
        return False
    hidden = machine.obj(Ref(cls.address)).attrs.get("_rosward_hidden")
    if not isinstance(hidden, Tuple):
        return True
    return Const(name) in hidden.items or name.startswith((f"_{cls.name.lstrip('_')}__", "_rosward"))


def _in_class(machine: Machine, cls: Value, name: str, every: object) -> bool | None:
    """Whether instances have an attribute by their class; None where a base or `__getattr__` may. `every`: what has what all of them have."""
    if not isinstance(cls, Class):
        return None
    unknown = False
    for base in cls.mro:
        if isinstance(base, Class):
            record = machine.obj(Ref(base.address))
            attrs = record.attrs
            if attrs.get(name, UNBOUND) is not UNBOUND and name not in record.partial:
                return True
            unknown = unknown or name in record.partial
            unknown = unknown or may_hide(machine, base, name) or "__getattr__" in attrs or "__getattribute__" in attrs
        elif isinstance(base, Native):
            found = getattr(builtins, base.name.removeprefix("builtins."), None)
            if isinstance(found, type) and found is not object and _objects_have(found, name):
                return True
            unknown = unknown or not isinstance(found, type)
        else:
            unknown = True
    return True if hasattr(every, name) else None if unknown else False


def attribute_names(machine: Machine, value: Value) -> list[str]:
    """The names of all attributes that we know of an instance, class or module."""
    if isinstance(value, (Class, ModuleValue)):
        places = [b.address for b in value.mro if isinstance(b, Class)] if isinstance(value, Class) else [value.address]
    elif isinstance(value, Ref) and machine.obj(value).kind == "instance":
        cls = machine.obj(value).cls
        places = [
            value.address,
            *(b.address for b in (cls.mro if isinstance(cls, Class) else ()) if isinstance(b, Class)),
        ]
    else:
        places = []
    models = {b.address for b in _bases(machine, value) if isinstance(b, Class) and b.stub}
    return list(
        dict.fromkeys(
            name
            for place in places
            for name in machine.obj(Ref(place)).attrs
            if name.isidentifier() and not (_is_private(name) and (place in models or name.startswith("_rosward")))
        )
    )


def _bases(machine: Machine, value: Value) -> tuple[Value, ...]:
    cls = machine.obj(value).cls if isinstance(value, Ref) else value
    return cls.mro if isinstance(cls, Class) else ()


def _is_private(name: str) -> bool:
    """Whether a name of a model is its own: the library has others in its place."""
    return name.startswith("_") and not name.endswith("__")


def _get(call: NativeCall) -> Value:
    return spread(lambda value, name: _get_one(call, value, name), *call.args[:2])


def _get_one(call: NativeCall, value: Value, name: Value) -> Value:
    machine, default = call.machine, call.args[2:3]
    known = text_of(name)
    if known is not None:
        there = has_attribute(machine, value, known) if default else True
        if there is False:
            return with_origins(default[0], origins(name))
        if not default:
            return with_origins(machine.load_attr(value, known), origins(name))
        found, failed = machine.guarded(lambda: machine.load_attr(value, known), "AttributeError")
        return with_origins(join(found, default[0]) if failed or not there else found, origins(name))
    if isinstance(name, Const):
        raise Raised("TypeError", "attribute name must be string")
    note_any(machine, value)
    unknown = unknown_from(machine, "getattr", "", name, value)
    if not isinstance(name, Text):
        return join_all((unknown, *default))
    fitting = [n for n in attribute_names(machine, value) if matches(name, n)][:MAX_MATCHES]
    return join_all((*(machine.load_attr(value, n) for n in fitting), unknown, *default))


def note_any(machine: Machine, value: Value) -> None:
    """An attribute of a name that is not known is read: whatever the classes of the program have there may be called unseen."""
    asked = host(machine).asked
    for option in options(value):
        cls = machine.obj(option).cls if isinstance(option, Ref) else option
        if isinstance(cls, Class):
            asked.update((b.place.file, b.qualname, "") for b in cls.mro if isinstance(b, Class) and not b.stub)
        elif isinstance(option, ModuleValue):
            asked.add((option.file, "", ""))


def _set(call: NativeCall) -> Value:
    machine, (target, name, value) = call.machine, call.args[:3]
    names = options(name)
    for option in names:
        known = text_of(option)
        if known is None:
            machine.report("RW203", "setattr with a name that is not known")
        elif len(names) == 1:
            machine.store_attr(target, known, value)
        else:
            there = has_attribute(machine, target, known)
            machine.store_attr(
                target, known, value if there is False else join(machine.load_attr(target, known), value)
            )
    return NONE


def _has_hook(machine: Machine, value: Value) -> bool:
    """Whether a class of the program answers for attributes that are not there."""
    cls = machine.obj(value).cls if isinstance(value, Ref) else None
    return isinstance(cls, Class) and any(
        isinstance(b, Class) and not b.stub and "__getattr__" in machine.obj(Ref(b.address)).attrs for b in cls.mro
    )


def _has(call: NativeCall) -> Value:
    def one(value: Value, name: Value) -> Value:
        known = text_of(name)
        there = None if known is None else has_attribute(call.machine, value, known)
        if there is None and known is not None and _has_hook(call.machine, value):
            call.machine.load_attr(value, known)  # `__getattr__` says whether it is there
        return (
            unknown_from(call.machine, "hasattr", "bool", value, name) if there is None else Const(there, origins(name))
        )

    return spread(one, *call.args[:2])


def _delete(call: NativeCall) -> Value:
    name = text_of(call.args[1])
    if name is not None:
        call.machine.delete_attr(call.args[0], name)
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    "builtins.getattr": native(_get, 2),
    "builtins.setattr": native(_set, 3),
    "builtins.hasattr": native(_has, 2),
    "builtins.delattr": native(_delete, 2),
}
