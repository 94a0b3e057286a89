# SPDX-License-Identifier: Apache-2.0
"""What if an object gets another class?

self.__class__ = Busy      where this surely runs, it is one of that class from here on; else, it has the methods of either
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import join, options
from rosward.domain.compound import Descriptor
from rosward.domain.heap import CLASSES
from rosward.domain.unknown import Cause
from rosward.domain.values import Class, Ref, Value
from rosward.engine.python import members
from rosward.engine.unknown.escape import BY_PYTHON

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def change_class(machine: Engine, ref: Ref, cls: Value, *, weak: bool) -> None:
    """`object.__class__ = cls`."""
    obj = machine.obj(ref)
    classes = [option for option in options(cls) if isinstance(option, Class)]
    machine.trace.instantiated.update(option.place for option in classes)
    if not (weak or obj.many) and classes == [cls] and machine.is_sure and not machine.precision.apart:
        attrs = {name: value for name, value in obj.attrs.items() if name != CLASSES}
        machine.put(ref.address, obj.replace(cls=cls, attrs=attrs) if CLASSES in obj.attrs else obj.replace(cls=cls))
        return
    if len(classes) == 1 and classes[0] == obj.cls and classes == [cls]:
        return
    said = "its methods are those of either, what its properties give is not known"
    machine.report("RW203", f"an object may be given another class: {said}")
    if obj.cls.__class__ is Class:
        for option in classes:
            _give_methods(machine, ref, option)


def _give_methods(machine: Engine, ref: Ref, cls: Class) -> None:
    """What the object has of either class, as attributes of its own: they go before what its class has."""
    obj = machine.obj(ref)
    for name in dict.fromkeys(
        n
        for base in cls.mro
        if base.__class__ is Class
        for n in machine.at(base.address).attrs
        if not n.startswith("__")
    ):
        before, after = (members.lookup(machine, c, name) for c in (obj.cls, cls))
        if after is None or after == before:
            continue
        if not all(_is_plain(v) for v in (before, after)):
            if after.__class__ is Descriptor and after.kind == "property":  # whoever asks for it runs it
                machine.schedule(after.getter, (ref,), BY_PYTHON)
                if after.setter is not None:
                    machine.schedule(
                        after.setter, (ref, machine.unknown(Cause.CALL, f"new value of {name}")), BY_PYTHON
                    )
                obj = obj.with_attr(
                    name, machine.unknown(Cause.CALL, f"property of an object of another class: {name}")
                )
            continue
        there = obj.attrs.get(name)
        if there is None and before is not None:
            there = members.bind(machine, before, ref, obj.cls)
        new = members.bind(machine, after, ref, cls)
        obj = obj.with_attr(name, new if there is None else join(there, new))
    machine.put(ref.address, obj.with_attr(CLASSES, join(obj.attrs.get(CLASSES, obj.cls), cls)))


def _is_plain(value: Value | None) -> bool:
    """Whether a value in a class is a method, or something that is no descriptor."""
    return value is None or not any(
        o.__class__ is Ref or (isinstance(o, Descriptor) and o.kind not in ("staticmethod", "classmethod"))
        for o in options(value)
    )
