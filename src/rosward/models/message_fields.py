# SPDX-License-Identifier: Apache-2.0
"""What does a message hold? An object with the fields that its interface defines, each made when it is first asked for.

pose = PoseStamped()                     pose.header is another message, pose.header.frame_id is ''
pose.header.frame_id = 'map'             'map' from here on
def on_pose(self, pose): …               a message that arrives: pose.header.frame_id is not known, but a text

An object of a message has as payload what stands in the fields that nobody has written: None where they have their defaults, an unknown
value where it has arrived, or where code that is not known has had it in its hands. Nested messages are objects of their own, one for each
field of an object. A message without a definition has no fields that are known: they are what the program writes, else unknown.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options
from rosward.domain.compound import External, Native
from rosward.domain.heap import Obj
from rosward.domain.table import marked
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Ref, Unknown, Value
from rosward.models.interfaces import message_name
from rosward.source.definitions import FLOATS, INTEGERS, TEXTS, Definition, Field

if TYPE_CHECKING:
    from rosward.models.native import Machine

Sequence = Callable[["Machine", Ref, str, Field, Unknown], Obj]
"""Of a message, the name of a field, that field, and what is not known of it."""

_LONGEST: Final = 80
"""Of a field nested deeper than that the reason names the message around it."""
_HINTS: Final = {
    **dict.fromkeys(INTEGERS, "int"),
    **dict.fromkeys(FLOATS, "float"),
    **dict.fromkeys(TEXTS, "str"),
    "bool": "bool",
    "byte": "bytes",
}
"""The Python types of primitive fields."""
_NUMBERS: Final = INTEGERS | FLOATS
"""Sequences of these are no lists in Python: what is assigned to one is copied into it."""
_ARRAYS: Final = """
    T all any argmax argmin argpartition argsort astype base buffer_info byteswap choose clip compress conj conjugate ctypes cumprod cumsum
    data device diagonal dot dtype dump dumps fill flags flat flatten frombytes fromfile fromlist fromunicode getfield imag item itemsize mT
    max mean min nbytes ndim nonzero partition prod put ravel real repeat reshape resize round searchsorted setfield setflags shape size
    squeeze std strides sum swapaxes take to_device tobytes tofile tolist tounicode trace transpose typecode var view
"""
ARRAY_NAMES: Final = frozenset(_ARRAYS.split())
"""What arrays of `array` and numpy have, and lists lack: a list that is in a message or parameter is such an array in Python."""
_DEFAULT: Final = "__DEFAULT"
_OF_EACH: Final = frozenset({"get_fields_and_field_types", "SLOT_TYPES"})
"""What the class of each message has besides fields and constants."""


def definition_of(machine: Machine, cls: Value) -> Definition | None:
    """The fields of a message, by its class; None where they are not known, and for any other class."""
    return machine.interface_definition(cls.name) if isinstance(cls, External) else None


def constant(machine: Machine, cls: External, name: str) -> Const | None:
    """`Message.NAME` where the interface defines a constant of that name, or has the default of a field by it."""
    definition = definition_of(machine, cls)
    if definition is None:
        return None
    value = definition.constants.get(name)
    if value is None and name.endswith(_DEFAULT):
        field = definition.fields.get(name.removesuffix(_DEFAULT).lower())
        value = None if field is None else field.default
    return None if value is None else Const(value)


def has_field(machine: Machine, cls: Value, name: str) -> bool | None:
    """Whether a message has an attribute; None where that is not known."""
    definition = definition_of(machine, cls)
    if definition is None:
        return None
    if name in definition.fields:
        return True if definition.fields[name].sure else None
    if name in definition.constants or name in _OF_EACH or hasattr(object, name):
        return True
    return False if definition.closed and not name.startswith("_") else None


def load_field(
    machine: Machine, ref: Ref, name: str, own: Value | None, unknown_sequence: Sequence | None = None
) -> Value | None:
    """The field of a message, of which some writes are known to be `own`; None where the definition has no such field.

    `unknown_sequence`: what a field holds that is one, in a language where that can be said.
    """
    obj = machine.obj(ref)
    cls = obj.cls
    definition = definition_of(machine, cls)
    if definition is None or not isinstance(cls, External):
        return own
    field = definition.fields.get(name)
    if field is None:
        return own if own is not None else constant(machine, cls, name)
    if field.array and isinstance(obj.payload, Unknown):
        fresh = (
            None if unknown_sequence is None else unknown_sequence(machine, ref, name, field, about(obj.payload, name))
        )
    else:
        fresh = _fresh(machine, obj, name, field)
    if fresh is not None:
        return _inner(machine, ref, obj, name, fresh, own)
    value = _unwritten(machine, obj, cls, name, field)
    return value if own is None else join(own, value)


def missing(machine: Machine, obj: Obj, name: str) -> Value:
    """What a message holds under a name of which nothing is known: not a field, or one of an interface without a definition."""
    if isinstance(obj.payload, Unknown):
        return about(obj.payload, name)
    return machine.unknown(Cause.MESSAGE, f"{_name(obj)}.{name}")


def about(message: Unknown, name: str, hint: str = "") -> Unknown:
    """Something of a message that is not known: the reason names the field."""
    reasons = tuple(
        r._replace(subject=f"{r.subject}.{name}") if r.cause is Cause.MESSAGE and len(r.subject) < _LONGEST else r
        for r in message.reasons
    )
    return Unknown(reasons, hint)


def _unwritten(machine: Machine, obj: Obj, cls: External, name: str, field: Field) -> Value:
    """A field that nobody has written."""
    if isinstance(obj.payload, Unknown):
        return about(obj.payload, name, "" if field.array else _HINTS.get(field.type, ""))
    if field.default is not None and not field.array:
        return Const(field.default)
    return machine.unknown(Cause.MESSAGE, f"{cls.name}.{name}")


def _fresh(machine: Machine, obj: Obj, name: str, field: Field) -> Obj | None:
    """The nested message, or the empty sequence, that a field holds until something is assigned to it; None for any other."""
    if field.array:
        return (
            Obj("list", Native("builtins.list"), many=obj.many) if field.empty and field.type not in _NUMBERS else None
        )
    inner = External(field.type.replace("/", ".msg."))
    if not field.is_message or definition_of(machine, inner) is None:
        return None
    payload = about(obj.payload, name) if isinstance(obj.payload, Unknown) else None
    return Obj("instance", inner, many=obj.many, payload=payload)


def _inner(machine: Machine, ref: Ref, obj: Obj, name: str, fresh: Obj, own: Value | None) -> Value:
    """The object of a field that nobody has written; `fresh` where it was not asked for before."""
    several = own is None or obj.many or fresh.kind == "list"
    made = machine.place_inner(ref, name, fresh, again=several)
    if (
        own is not None and not several and made in options(own)
    ):  # on some paths here it was not asked for: there it is as new
        old = machine.obj(made)
        unsure = old.replace(partial=frozenset(old.attrs))
        if unsure.partial != old.partial:
            machine.update(made, unsure)
    value = made if own is None else join(own, made)
    changed = obj.with_attr(name, value)
    if obj.many:
        changed.partial = marked(obj.partial, name)
    if value != own or changed.partial != obj.partial:
        machine.update(ref, changed)
    return value


def assigned(machine: Machine, cls: Value, name: str, value: Value) -> Value:
    """What a field holds after an assignment: sequences of numbers copy what they are given."""
    definition = definition_of(machine, cls)
    field = None if definition is None else definition.fields.get(name)
    if field is None or not field.array or field.type not in _NUMBERS | {"*"}:
        return value
    if not any(isinstance(o, Ref) and machine.obj(o).kind == "list" for o in options(value)):
        return value
    series = machine.series(value)
    return machine.new_list(series.head, series.middle, series.tail)


def opened(machine: Machine, obj: Obj) -> Obj:
    """A message that code which is not known has had in its hands: any field may hold something else."""
    if isinstance(obj.payload, Unknown) or definition_of(machine, obj.cls) is None:
        return obj
    return obj.replace(payload=machine.unknown(Cause.MESSAGE, _name(obj)))


def made_all(machine: Machine, ref: Ref) -> None:
    """Make all that a message holds, so that a copy of it shares that."""
    definition = definition_of(machine, machine.obj(ref).cls)
    for name, field in definition.fields.items() if definition is not None else ():
        if field.is_message or field.array:
            machine.load_attr(ref, name)


def arrived(machine: Machine, cls: External, unknown: Unknown, site: str, *, many: bool) -> Value:
    """A message that somebody sent: what is in it is not known, but what its fields are; one object, or one for `many` that arrive."""
    named = message_name(cls.name)
    if named is None or definition_of(machine, cls) is None:
        return unknown
    return machine.allocate(Obj("instance", External(named.dotted), many=many, payload=unknown), site)


def _name(obj: Obj) -> str:
    """The dotted name of the class of a message."""
    assert isinstance(obj.cls, External)
    return obj.cls.name
