# SPDX-License-Identifier: Apache-2.0
"""Named tuples: the class that `namedtuple('Pose', 'x y')` makes, and what an instance of it holds.

    Pose = namedtuple('Pose', 'x y')
    Pose(1, y=2)                        an instance with x = 1, y = 2, that unpacks and indexes as (1, 2)

The methods stand in stubs/collections/__init__.pyi (`_NamedTuple`, also the base of `typing.NamedTuple`);
here is what needs code.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Class, Const, Ref, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import text_of
from rosward.models.python.std.records import annotations_of
from rosward.models.python.std.support import class_obj, exact_dict, exact_list, names_of


def _names(machine: Machine, value: Value) -> tuple[str, ...] | None:
    plain = text_of(value)
    if plain is not None:
        return tuple(plain.replace(",", " ").split())
    items = exact_list(machine, value)
    if items is None:
        return None
    pairs = [exact_list(machine, i) for i in items]
    names = names_of(p[0] if p else i for i, p in zip(items, pairs, strict=True))
    return names if len(names) == len(items) else None


def _make(call: NativeCall) -> Value:
    """collections._make_named_tuple(base, typename, field_names, defaults): the class."""
    machine = call.machine
    base, typename, field_names, defaults = call.exactly(4)
    names = _names(machine, field_names)
    if names is None or not isinstance(base, Class):
        return machine.unknown(Cause.CALL, "collections.namedtuple")
    given = exact_list(machine, defaults) or ()
    attrs: dict[str, Value] = {
        "__module__": machine.unknown(Cause.CALL, "__module__", "str"),  # of whoever asks for the class
        "_fields": Tuple(tuple(map(Const, names))),
        "__match_args__": Tuple(tuple(map(Const, names))),
        "_field_defaults": machine.new_dict(
            {Const(n): v for n, v in zip(names[len(names) - len(given) :], given, strict=False)}
        ),
    }
    name = text_of(typename) or "namedtuple"
    where = machine.allocate(Obj("class", Native("builtins.type"), attrs))
    return Class(where.address, name, name, machine.place.file, (base,), base.mro, machine.place, False)


def _declare(call: NativeCall) -> Value:
    """collections._name_fields(cls): what a class derived from `typing.NamedTuple` says of its fields."""
    machine, cls = call.machine, call.args[0]
    found = _fields(machine, cls)
    if found is not None and isinstance(cls, Class):
        names = Tuple(tuple(map(Const, found[0])))
        machine.store_attr(cls, "_field_defaults", machine.new_dict(found[1]))
        machine.store_attr(cls, "_fields", names)
        machine.store_attr(cls, "__match_args__", names)
    return NONE


def _fields(machine: Machine, instance: Value) -> tuple[tuple[str, ...], dict[Value, Value]] | None:
    cls = machine.obj(instance).cls if isinstance(instance, Ref) else instance
    for base in cls.mro if isinstance(cls, Class) else ():
        if not isinstance(base, Class) or base.stub:
            continue
        attrs = machine.obj(class_obj(base)).attrs
        if "_fields" in attrs:
            return _names(machine, attrs["_fields"]) or (), exact_dict(machine, attrs["_field_defaults"]) or {}
        if "__annotations__" in attrs:
            names = tuple(annotations_of(machine, base))
            return names, {Const(n): attrs[n] for n in names if n in attrs}
    return None


def _init(call: NativeCall) -> Value:
    """collections._fill(self, args, keywords): the fields of an instance."""
    machine, (instance, args, keywords) = call.machine, call.exactly(3)
    found = _fields(machine, instance)
    if found is None or not isinstance(instance, Ref):
        return NONE
    names, defaults = found
    known, rest = machine.iterate(args)
    named = exact_dict(machine, keywords)
    if len(known) > len(names) or any(text_of(k) not in names for k in named or ()):
        return machine.die("TypeError", "__new__() got arguments that are no fields")
    values: dict[str, Value] = dict(zip(names, known, strict=False))
    values.update({text_of(k) or "": v for k, v in (named or {}).items()})
    open_end = rest if rest is not None else machine.unknown(Cause.OPERATION, "**") if named is None else None
    for name in names:
        value = values.get(name, open_end if open_end is not None else defaults.get(Const(name)))
        if value is None:
            return machine.die("TypeError", f"__new__() missing 1 required positional argument: '{name}'")
        machine.update(instance, machine.obj(instance).with_attr(name, value))
    return NONE


def _items(call: NativeCall) -> Value:
    """collections._items(self): the fields as a tuple."""
    machine, instance = call.machine, call.args[0]
    found = _fields(machine, instance)
    if found is None:
        return machine.unknown(Cause.CALL, "collections.namedtuple", "tuple")
    return Tuple(tuple(machine.load_attr(instance, n) for n in found[0]))


def _keys(call: NativeCall) -> Value:
    """collections._keys(self): the names of the fields."""
    found = _fields(call.machine, call.args[0])
    return (
        Tuple(tuple(map(Const, found[0])))
        if found
        else call.machine.unknown(Cause.CALL, "collections.namedtuple", "tuple")
    )


NATIVES: Final[dict[str, NativeFunction]] = {
    "collections._make_named_tuple": _make,
    "collections._name_fields": _declare,
    "collections._fill": _init,
    "collections._items": _items,
    "collections._keys": _keys,
}
