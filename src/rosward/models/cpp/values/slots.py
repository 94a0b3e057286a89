# SPDX-License-Identifier: Apache-2.0
"""What stands at a place?

    n, *p, v[2]         read(machine, slot): what stands there; of an object the object itself

An object is its own slot. An element of a string has a slot whose base is the slot of the string, or the string itself.
An iterator of a map leads to a slot of kind 'entry': the pair of a key and what stands under it.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import External, Tuple
from rosward.domain.enumerated import Whole
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Ref, Value
from rosward.models import message_fields
from rosward.models.cpp.values.typed import unknown_sequence
from rosward.models.cpp.values.types import is_reference
from rosward.models.native import Machine
from rosward.models.python.containers import dicts
from rosward.models.python.operators import items as python_items
from rosward.models.python.plain import int_of, text_of, unknown_from
from rosward.models.ros.parameter_tests import in_place

__all__ = [
    "is_structure",
    "key_of",
    "key_value",
    "new_pair",
    "plain_number",
    "read",
    "read_field",
    "referred_to",
    "stored",
    "unfolded",
]

_VALUE: Final = "value"
_DEEPEST: Final = 12


# Reading


def read(machine: Machine, value: Value) -> Value:
    """The value at a slot; what is no slot is itself. A default is another value where a test said so."""
    if value.__class__ is Slot:
        found = _read(machine, value)
        is_open = found.__class__ is Choice or (found.__class__ is Const and found.origins)
        return in_place(machine, found) if is_open else found
    if value.__class__ is Choice and any(o.__class__ is Slot for o in value.options):
        inside = [o for o in value.options if not _is_end(machine, o)]  # none goes on that reads what is behind the end
        return join_all(read(machine, option) for option in inside or value.options)
    return value


def stored(machine: Machine, slot: Slot) -> Value:
    """What was written at a slot, whatever tests have said since."""
    return _read(machine, slot)


def _is_end(machine: Machine, value: Value) -> bool:
    """Whether a slot is that to which the end of a container leads, or an element of one that has none."""
    if value.__class__ is not Slot or value.kind == "cell":
        return False
    return value.key == NONE or (value.kind not in ("field", "entry") and _is_empty(machine, value.base))


def _is_empty(machine: Machine, value: Value) -> bool:
    """Whether a container surely has no elements."""
    return isinstance(value, Ref) and machine.obj(value).kind == "list" and machine.obj(value).items == ()


def _read(machine: Machine, slot: Slot) -> Value:
    base, kind, key = slot.fields()
    if base.__class__ is Slot:
        base = read(machine, base)
    if base.__class__ is Choice:
        inside = [
            o for o in base.options if not _is_empty(machine, o)
        ]  # none goes on, either, that asks it for an element
        return join_all(_read(machine, Slot(option, kind, key)) for option in inside or base.options)
    if kind == "cell" and isinstance(base, Ref):
        return _initialised(machine, machine.obj(base).attrs.get(_VALUE, UNBOUND), "variable")
    if kind == "field" and isinstance(base, Ref) and isinstance(key, str):
        return read_field(machine, base, key)
    if not isinstance(key, Value):
        return unknown_from(machine, "reference", "", base)
    if key == NONE:
        if isinstance(base, Const) and text_of(base) is not None:  # where a text ends, its terminator stands
            return Const("\0", base.origins)
        return machine.unknown(Cause.OPERATION, "dereference of end()")
    if kind == "entry" and isinstance(base, Ref):
        found = dicts.look_up(machine, machine.obj(base), key)
        return new_pair(machine, key_value(machine, base, key), _initialised(machine, found.value, "element"))
    return _element(machine, base, key)


def referred_to(machine: Machine, slot: Slot) -> Value | None:
    """Where a `std::reference_wrapper` leads that stands at a slot: a plain reference to it leads there."""
    base, kind, key = slot.fields()
    if base.__class__ is not Ref:
        return None
    obj, held = machine.obj(base), None
    if kind in ("cell", "field"):
        held = obj.attrs.get(_VALUE if kind == "cell" else str(key))
    elif obj.kind == "list" and isinstance(key, Value):
        number = int_of(key)
        held = obj.series().element() if number is None else obj.series().at(number)
    return held.arguments[0] if held is not None and is_reference(held) else None


def _initialised(machine: Machine, value: Value, what: str) -> Value:
    return machine.unknown(Cause.OPERATION, f"{what} without a value") if value is UNBOUND else value


def read_field(machine: Machine, ref: Ref, name: str) -> Value:
    """What stands in a field of an object. No execution that is defined reads one that has no value yet, so what it may hold is what it holds."""
    obj = machine.part(ref, name)
    own = obj.attrs.get(name)
    if own is not None and own is not UNBOUND and (name not in obj.partial or not isinstance(obj.cls, External)):
        return own
    if isinstance(obj.cls, External):
        found = message_fields.load_field(machine, ref, name, own, unknown_sequence)
        return message_fields.missing(machine, machine.obj(ref), name) if found is None else found
    return machine.unknown(Cause.OPERATION, f"field `{name}` without a value")


def _element(machine: Machine, base: Value, key: Value) -> Value:
    """An element of a container, or a character of a string; undefined, so not known, where there is no such element."""
    if isinstance(base, Ref):
        obj = machine.obj(base)
        if obj.kind == "dict":
            return _initialised(machine, dicts.look_up(machine, obj, key_of(machine, key)).value, "element")
        if obj.kind in ("list", "set"):
            found = _at(machine, obj, key)
            return unfolded(machine, obj.cls, found) if is_structure(found) else found
    elif isinstance(base, Const) and text_of(base) is not None:
        text, number = str(base.value), int_of(key)
        if number is None:
            return unknown_from(machine, "[]", "str", key)
        if not 0 <= number <= len(text):
            return machine.unknown(Cause.OPERATION, "[]", "str")
        return Const(text[number] if number < len(text) else "\0", base.origins)
    elif not isinstance(base, Const):
        return python_items.load_item(machine, base, key)
    return unknown_from(machine, "[]", "", base, key)


def _at(machine: Machine, obj: Obj, key: Value) -> Value:
    """The element at an index; no execution goes on that asks for one behind the end."""
    series = obj.series()
    numbers = [int_of(option) for option in options(key)]
    found = [obj.element() if n is None else series.at(n) if n >= 0 else None for n in numbers]
    known = [element for element in found if element is not None]
    return join_all(known) if known else machine.unknown(Cause.OPERATION, "element beyond the end")


# Keys of maps


def plain_number(value: Value) -> Value:
    """A number without its type: what stands under `m[id]` is the same for all types of `id`."""
    if value.__class__ is Choice:
        return lift(plain_number, value)
    return (
        Const(int(value.value), value.origins) if isinstance(value, Const) and isinstance(value.value, Whole) else value
    )


def key_of(machine: Machine, value: Value, depth: int = 0) -> Value:
    """A value as the key of a map or element of a set: what is compared by its content is a tuple of that."""
    value = read(machine, value)
    if isinstance(value, Choice):
        return join_all(key_of(machine, option, depth) for option in value.options)
    if not isinstance(value, Ref):
        return Pointer(value.target) if isinstance(value, Pointer) else plain_number(value)
    if depth >= _DEEPEST:
        return machine.unknown(Cause.LIMIT, "key")
    obj = machine.obj(value)
    if obj.kind == "list":
        if obj.items is None:
            return unknown_from(machine, "key", "", obj.rest)
        return Tuple(tuple(key_of(machine, item, depth + 1) for item in obj.items))
    if obj.kind == "instance" and isinstance(obj.cls, TypeOf) and obj.cls.name == "std.pair":
        parts = (read_field(machine, value, "first"), read_field(machine, value, "second"))
        return Tuple(tuple(key_of(machine, part, depth + 1) for part in parts))
    if obj.kind == "instance" and isinstance(obj.cls, Class) and not obj.many:
        return _structure(machine, obj, depth + 1)
    return value


_OBJECT: Final = External("<object>")
"""What a key begins with that is an object of a class: its class, the names of its fields and what they hold follow.

Which of them are one key to a container says the operator of the class (`ordering.py`).
"""


def _structure(machine: Machine, obj: Obj, depth: int) -> Value:
    held = [key_of(machine, field, depth) for field in obj.attrs.values()]
    if obj.partial or any(isinstance(each, (Tuple, Choice)) and not is_structure(each) for each in held):
        return machine.unknown(Cause.OPERATION, "key that is an object")
    return Tuple((_OBJECT, obj.cls, Tuple(tuple(map(Const, obj.attrs))), Tuple(tuple(held))))


def is_structure(value: Value) -> bool:
    """Whether a key is an object of a class."""
    return isinstance(value, Tuple) and value.items[:1] == (_OBJECT,)


def key_value(machine: Machine, ref: Ref, key: Value) -> Value:
    """The value that a key of a map stands for: a pair or sequence again, where it is one."""
    return unfolded(machine, machine.obj(ref).cls, key)


def unfolded(machine: Machine, cls: Value, key: Value) -> Value:
    """The same by the class of the map or set."""
    return _unfolded(machine, key, cls.arguments[0] if isinstance(cls, TypeOf) and cls.arguments else NONE)


def _unfolded(machine: Machine, key: Value, type_: Value) -> Value:
    if not isinstance(key, Tuple):
        return key
    if is_structure(key):
        _, cls, names, held = key.items
        assert isinstance(names, Tuple)
        assert isinstance(held, Tuple)
        fields = {
            str(name.value): _unfolded(machine, each, NONE)
            for name, each in zip(names.items, held.items, strict=True)
            if isinstance(name, Const)
        }
        return machine.allocate(Obj("instance", cls, fields), ("key", key))
    inner = type_.arguments if isinstance(type_, TypeOf) else ()
    if isinstance(type_, TypeOf) and type_.name == "std.pair" and len(key.items) == 2:
        first, second = (
            _unfolded(machine, item, wanted) for item, wanted in zip(key.items, (*inner, NONE, NONE)[:2], strict=True)
        )
        return new_pair(machine, first, second, inner)
    each = inner if len(inner) == len(key.items) and type_ != NONE else (*inner[:1], NONE)[:1] * len(key.items)
    items = tuple(_unfolded(machine, item, wanted) for item, wanted in zip(key.items, each, strict=True))
    cls = type_ if isinstance(type_, TypeOf) else TypeOf("std.vector", ())
    return machine.allocate(Obj("list", cls, items=items), ("key", key))


def new_pair(machine: Machine, first: Value, second: Value, types: tuple[Value, ...] = ()) -> Ref:
    """A new `std::pair`."""
    attrs = {"first": first, "second": second}
    return machine.allocate(Obj("instance", TypeOf("std.pair", types), attrs), ("pair", first))
