# SPDX-License-Identifier: Apache-2.0
"""getattr, setattr, hasattr and delattr, with names that are known, partly known or not.

getattr(self, 'on_' + unknown)      any attribute of self that begins so, or something unknown
setattr(self, unknown, value)       a finding (RW203)
"""

from __future__ import annotations

import builtins
from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import BoundMethod, Descriptor, Native, Range, Tuple
from rosward.domain.text import matches
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, ModuleValue, Ref, Text, Value
from rosward.models.message_fields import ARRAY_NAMES, has_field
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.attribute_tables import TABLE, own_attribute
from rosward.models.python.comparing.compare import kind_of
from rosward.models.python.plain import Raised, native, origins, spread, text_of, unknown_from, with_origins

MAX_MATCHES: Final = 64
ANY_ATTRIBUTE: Final = "*"
"""Among the attributes of a function or class that may be there: a library that is not read may have set others."""


class _Sample:
    def method(self) -> None:
        """A method: what all of them have is asked of it."""


_METHOD: Final = _Sample().method
_FUNCTION: Final = _Sample.method


def has_attribute(machine: Machine, value: Value, name: str) -> bool | None:
    """Whether value.name exists; None where that is not known."""
    if isinstance(value, Ref) and machine.obj(value).kind == "instance":
        obj = machine.obj(value)
        own, sure = own_attribute(machine, obj, name)
        in_class = _in_class(machine, obj.cls, name)
        if own is None or own is UNBOUND:
            return in_class
        return True if in_class or sure or (TABLE not in obj.attrs and name not in obj.partial) else None
    if isinstance(value, Class):
        if hasattr(object, name) or name == "__module__":  # what `type` gives to each class, it gives to object
            return True
        there = _in_class(machine, value, name)
        meta = machine.obj(Ref(value.address)).cls
        return _in_class(machine, meta, name) if there is False and isinstance(meta, Class) else there
    if isinstance(value, ModuleValue):
        record = machine.obj(Ref(value.address))
        return True if record.surely_has(name) else None
    if isinstance(value, (Function, BoundMethod, Native)):
        return _of_callable(machine, value, name)
    if isinstance(value, Descriptor):
        made_by = getattr(builtins, value.kind, None)
        return _has_by_class(made_by, name) if isinstance(made_by, type) else None
    if isinstance(value, (Const, Text, Tuple, Range, Ref)):
        if name in ARRAY_NAMES and kind_of(machine, value) in ("list", "tuple", "bytes"):
            return None
        found = type(None) if value == NONE else getattr(builtins, kind_of(machine, value), None)
        return _has_by_class(found, name) if isinstance(found, type) else None
    return None


def _has_by_class(cls: type, name: str) -> bool:
    """Whether instances of a class of Python have an attribute by it. What the class itself has from `type` (`__name__`) they have not."""
    return any(name in vars(base) for base in cls.__mro__)


def _of_callable(machine: Machine, value: Value, name: str) -> bool | None:
    """Whether a function or method has an attribute: what was set on it, or what every function has."""
    bound = isinstance(value, BoundMethod)
    while isinstance(value, BoundMethod):
        value = value.function
    if isinstance(value, Native):
        found = of_python(value.name)
        return hasattr(len if found is None and bound else found, name) if bound or found is not None else None
    if not isinstance(value, Function):
        return None
    every = hasattr(_METHOD if bound else _FUNCTION, name)
    kept = machine.function_record(value)
    if kept is None or every:
        return every
    own = kept.attrs.get(name, UNBOUND)
    if own is UNBOUND:
        return None if ANY_ATTRIBUTE in kept.partial else False
    return None if name in kept.partial else True


def of_python(name: str) -> object:
    """The builtin, or the method of one, that has a name (`builtins.len`, `object.__eq__`); None where Python has none."""
    if name == "builtins.NoneType":  # `type(None)`, which `builtins` does not name
        return type(None)
    found: object = builtins
    for part in name.removeprefix("builtins.").split("."):
        found = None if found is None else getattr(found, part, None)
    return found


def is_open(machine: Machine, cls: Class) -> bool:
    """Whether a decorator that is not read may have given a class, or one of its bases, more attributes."""
    return any(isinstance(b, Class) and ANY_ATTRIBUTE in machine.obj(Ref(b.address)).partial for b in cls.mro)


def may_hide(machine: Machine, cls: Class, name: str) -> bool:
    """Whether a class of a model may have an attribute that is not declared: unless it lists all such in `_rosward_hidden`."""
    if not cls.stub or name == "__call__":
        return False
    hidden = machine.obj(Ref(cls.address)).attrs.get("_rosward_hidden")
    if not isinstance(hidden, Tuple):
        return True
    return Const(name) in hidden.items or name.startswith((f"_{cls.name.lstrip('_')}__", "_rosward"))


def is_computed(machine: Machine, value: Value, name: str) -> bool:
    """Whether code of the program is run to find value.name: a property, a descriptor, `__getattr__`, `__getattribute__`."""
    if isinstance(value, ModuleValue):
        attrs = machine.obj(Ref(value.address)).attrs
        return attrs.get(name, UNBOUND) is UNBOUND and _is_own(attrs.get("__getattr__"))
    if isinstance(value, Class):
        above = machine.obj(Ref(value.address)).cls
        own = _class_attribute(machine, value, name)
        there = own is not None
        if there and _gives(machine, own):
            return True
    elif isinstance(value, Ref) and machine.obj(value).kind == "instance":
        above = machine.obj(value).cls
        there = machine.obj(value).attrs.get(name, UNBOUND) is not UNBOUND
    else:
        return False
    found = _class_attribute(machine, above, name)
    if isinstance(found, Descriptor):
        return _is_own(found.getter) and (found.kind == "property" or (found.kind == "cached_property" and not there))
    if _gives(machine, found) or _is_own(_class_attribute(machine, above, "__getattribute__")):
        return True
    return not there and found is None and _is_own(_class_attribute(machine, above, "__getattr__"))


def _class_attribute(machine: Machine, cls: Value, name: str) -> Value | None:
    """What the classes that are read have under a name."""
    for base in cls.mro if isinstance(cls, Class) else ():
        found = machine.obj(Ref(base.address)).attrs.get(name, UNBOUND) if isinstance(base, Class) else UNBOUND
        if found is not UNBOUND:
            return found
    return None


def _gives(machine: Machine, value: Value | None) -> bool:
    """Whether a value is a descriptor: an object with `__get__`."""
    if not isinstance(value, Ref) or machine.obj(value).kind != "instance":
        return False
    return _class_attribute(machine, machine.obj(value).cls, "__get__") is not None


def _is_own(value: Value | None) -> bool:
    """Whether a function is the program's."""
    return isinstance(value, Function) and not value.code.file.startswith("models:")


def _in_class(machine: Machine, cls: Value, name: str) -> bool | None:
    """Whether instances have an attribute by their class; None where a base or `__getattr__` may."""
    if not isinstance(cls, Class):
        return has_field(machine, cls, name)
    unknown, slots = is_open(machine, cls), False
    for base in cls.mro:
        if isinstance(base, Class):
            record = machine.obj(Ref(base.address))
            attrs = record.attrs
            if record.surely_has(name):
                return True
            slots = slots or "__slots__" in attrs
            unknown = unknown or name in record.partial
            unknown = unknown or may_hide(machine, base, name) or "__getattr__" in attrs or "__getattribute__" in attrs
        elif isinstance(base, Native):
            found = getattr(builtins, base.name.removeprefix("builtins."), None)
            if isinstance(found, type) and _has_by_class(found, name):
                return True
            unknown = unknown or not isinstance(found, type)
        else:
            unknown = True
    if _has_by_class(object, name) or name == "__module__" or (name in _WITHOUT_SLOTS and not slots):
        return True
    return None if unknown or name in (*_WITHOUT_SLOTS, "__annotations__") else False


_WITHOUT_SLOTS: Final = ("__dict__", "__weakref__")
"""What instances have unless their class has `__slots__`."""


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
        if not default:
            return with_origins(machine.load_attr(value, known), origins(name))
        computed = is_computed(machine, value, known)
        there = True if computed else has_attribute(machine, value, known)
        if there is False:
            return with_origins(default[0], origins(name))
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
    asked = machine.asked
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
            machine.report("RW203", "setattr with an unknown name")
        elif len(names) == 1:
            machine.store_attr(target, known, value)
        else:
            there = has_attribute(machine, target, known)
            machine.store_attr(
                target, known, value if there is False else join(machine.load_attr(target, known), value)
            )
    return NONE


def _has(call: NativeCall) -> Value:
    machine = call.machine

    def one(value: Value, name: Value) -> Value:
        known = text_of(name)
        if known is None:
            there = None
        elif is_computed(machine, value, known):
            found, failed = machine.guarded(lambda: machine.load_attr(value, known), "AttributeError")
            if found is UNBOUND and not failed:
                return UNBOUND
            there = None if failed and found is not UNBOUND else not failed
        else:
            there = has_attribute(machine, value, known)
        return unknown_from(machine, "hasattr", "bool", value, name) if there is None else Const(there, origins(name))

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
