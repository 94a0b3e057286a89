# SPDX-License-Identifier: Apache-2.0
"""Enumerations: the members of a class, and how they are looked up.

    class Side(Enum):
        LEFT = 'left'       Side.LEFT is an instance of Side with name 'LEFT' and value 'left'

The engine calls `enum.make_members(cls)` behind the body of a class that has `enum.Enum` among its bases,
`enum.iterate(cls)` to iterate over such a class, `enum.lookup(cls, value)` where it is called, and
`enum.item(cls, name)` where it is subscripted.
A member of a class that also derives from str or int holds that value as the `payload` of its heap record.
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Descriptor, External, Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Ref, Text, Unknown, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import int_of, text_of
from rosward.models.python.std.enum_members import hook, is_member, said
from rosward.models.python.std.enum_operations import (
    COMPARISONS,
    CONVERSIONS,
    OPERATORS,
    attach_operators,
    derives,
    is_flag,
    member_operation,
)
from rosward.models.python.std.support import bare, class_obj, exact_dict, exact_list, names_of

_COMBINED: Final = "_rosward_flags"
"""Where a class of flags keeps those of several bits that were asked for."""
_AUTO: Final = "enum.auto()"
_SEVERAL: Final = (Choice, Text, Unknown)
_MEMBERS: Final = "__members__"
_DATA_TYPES: Final = ("str", "int", "float", "bytes")


def _data_type(cls: Class) -> str:
    for name in _DATA_TYPES:
        if derives(cls, f"builtins.{name}"):
            return name
    if derives(cls, "enum.IntEnum", "enum.IntFlag"):
        return "int"
    return "str" if derives(cls, "enum.StrEnum") else ""


def _next_value(call: NativeCall, cls: Class, name: str, before: list[Value]) -> Value:
    custom = hook(call, cls, "_generate_next_value_")
    if custom is not None:
        return call.machine.call(custom, (Const(name), Const(1), Const(len(before)), call.machine.new_list(before)))
    if derives(cls, "enum.StrEnum"):
        return Const(name.lower())
    numbers = [n for n in map(int_of, before) if n is not None]
    if any(isinstance(value, _SEVERAL) for value in before):
        return call.machine.unknown(Cause.OPERATION, "enum.auto", "int")
    highest: int = max(numbers, default=0)
    if len(numbers) != len(before):  # among others than numbers, the last number counts
        highest = numbers[-1] if numbers else 0
    if is_flag(cls):
        return Const(1 << highest.bit_length())
    return Const(highest + 1 if numbers else 1)


def _is_auto(value: Value) -> bool:
    return isinstance(value, External) and value.name.startswith(_AUTO)


def _resolve(
    call: NativeCall, cls: Class, name: str, value: Value, before: list[Value], given: dict[Value, Value]
) -> Value:
    """The value of a member; `given` holds what each `auto()` has become, since another name may stand for it."""
    if isinstance(value, Tuple) and any(map(_is_auto, value.items)):
        return Tuple(tuple(_resolve(call, cls, name, v, before, given) for v in value.items))
    if _is_auto(value) and value not in given:
        given[value] = _next_value(call, cls, name, before)
    return given.get(value, value)


def _key(call: NativeCall, value: Value) -> object:
    """What equal values have in common (1 and True are equal); None where it is not known."""
    value = bare(value)
    if isinstance(value, Const):
        return "value", value.value
    if isinstance(value, Tuple):
        parts = tuple(_key(call, v) for v in value.items)
        return None if None in parts else parts
    if isinstance(value, Ref) and call.machine.obj(value).many:
        return None
    return None if isinstance(value, _SEVERAL) else value


def make_members(call: NativeCall) -> Value:
    """enum.make_members(cls): each member of the class becomes an instance of it; equal values are aliases."""
    cls = call.args[0]
    if not isinstance(cls, Class):
        return NONE
    machine = call.machine
    where = class_obj(cls)
    ignored = {"_ignore_", *_texts(call, machine.obj(where).attrs.get("_ignore_"))}
    members: dict[Value, Value] = {}
    by_value: dict[object, Value] = {}
    values: list[Value] = []
    given: dict[Value, Value] = {}
    data = _data_type(cls)
    hidden = f"_{cls.name.lstrip('_')}__"
    for name, written in tuple(machine.obj(where).attrs.items()):
        word, written = said(call, written)  # noqa: PLW2901 - what it stands for
        if word == "nonmember":
            machine.store_attr(cls, name, written)
            continue
        if name in ignored or name.startswith(hidden) or not (word or is_member(call, cls, name, written)):
            continue
        value = _resolve(call, cls, name, written, values, given)
        values.append(value)
        key = _key(call, value)
        member = None if key is None else by_value.get(key)
        if member is None:
            held, kept = _held(call, cls, data, value)
            attrs = {"_name_": Const(name), "name": Const(name), "_value_": kept, "value": kept}
            member = machine.allocate(Obj("instance", cls, attrs, payload=held), ("member", name))
            if key is not None:
                by_value[key] = member
            init = hook(call, cls, "__init__")
            if init is not None:
                machine.call(init, (member, *(value.items if isinstance(value, Tuple) else (value,))))
        members[Const(name)] = member
        machine.store_attr(cls, name, member)
    if members:
        machine.store_attr(cls, _MEMBERS, machine.new_dict(members))
        attach_operators(call, cls, data)
    return NONE


def _texts(call: NativeCall, value: Value | None) -> tuple[str, ...]:
    if value is None:
        return ()
    plain = text_of(value)
    if plain is not None:
        return tuple(plain.replace(",", " ").split())
    return names_of(call.machine.iterate(value).known)


def _held(call: NativeCall, cls: Class, data: str, value: Value) -> tuple[Value | None, Value]:
    """The str or number that a member is, if it is one, and its `_value_`: `A = True` in an IntEnum is 1."""
    machine = call.machine
    if hook(call, cls, "__new__") is not None:  # it makes the object, and sets `_value_`, in a way that is not followed
        unknown = machine.unknown(Cause.CALL, f"{cls.name}.__new__")
        return machine.unknown(Cause.CALL, f"{cls.name}.__new__", data) if data else None, unknown
    if not data:
        return None, value
    if isinstance(value, Const) and type(value.value).__name__ == data:
        return value, value
    made = machine.call(Native(f"builtins.{data}"), value.items if isinstance(value, Tuple) else (value,))
    held = value if made is UNBOUND else made
    return held, held


def _members(call: NativeCall, cls: Value) -> dict[Value, Value] | None:
    if not isinstance(cls, Class):
        return None
    found = call.machine.obj(class_obj(cls)).attrs.get(_MEMBERS)
    return None if found is None else exact_dict(call.machine, found)


def iterate(call: NativeCall) -> Value:
    """enum.iterate(cls): the members in order, aliases left out; a flag of several bits is one of them since Python 3.11, not before."""
    cls = call.args[0]
    members = _members(call, cls)
    if members is None:
        return call.machine.new_list((), call.machine.unknown(Cause.CALL, "enum.Enum"))
    sure = [m for m in dict.fromkeys(members.values()) if _is_canonical(call, cls, m)]
    others = [m for m in members.values() if m not in sure]
    return call.machine.new_list(sure, join_all(others) if others else None)


def _is_canonical(call: NativeCall, cls: Value, member: Value) -> bool:
    """Whether every Python iterates over a member: of a flag, it has one bit."""
    if not is_flag(cls) or not isinstance(member, Ref):
        return True
    number = int_of(bare(call.machine.obj(member).attrs.get("_value_", NONE)))
    return number is not None and number.bit_count() == 1


def lookup(call: NativeCall) -> Value:
    """enum.lookup(cls, value): the member of that value; any member where the value is not known.

    `Enum('Side', 'LEFT RIGHT')` makes a class that is not followed.
    """
    cls, value = call.args[0], call.arg(1, "value", NONE) or NONE
    members = _members(call, cls)
    if members is None:
        return call.machine.unknown(Cause.CALL, "enum.Enum")
    machine = call.machine
    by_value: dict[object, Value] = {}
    open_: list[Value] = []  # members whose value is not known
    for member in members.values():
        if isinstance(member, Ref):
            key = _key(call, machine.obj(member).attrs.get("_value_", NONE))
            if key is None:
                open_.append(member)
            else:
                by_value.setdefault(key, member)
    found: list[Value] = []
    for option in options(value):
        key = _key(call, option)
        if option in members.values():
            found.append(option)
        elif key is not None and key in by_value:
            found.append(by_value[key])
            found.extend(open_)
        elif isinstance(option, Const) and not (open_ and is_flag(cls)):
            maybe = [m for m in open_ if _may_have(call, m, option)]
            found += [*maybe, _missing(call, cls, option, sure=not maybe)]
        else:
            found += [*members.values(), *_may_miss(call, cls, option)]
    return join_all(found)


def _may_miss(call: NativeCall, cls: Value, value: Value) -> tuple[Value, ...]:
    """What there is besides the members for a value that is not known: what `_missing_` makes of it, or a ValueError."""
    missing = hook(call, cls, "_missing_") if isinstance(cls, Class) else None
    if missing is not None:
        return (call.machine.call(missing, (cls, value)),)
    if isinstance(cls, Class) and not is_flag(cls):
        call.machine.die("ValueError", f"not a valid {cls.qualname}")
    return ()


def _may_have(call: NativeCall, member: Value, value: Value) -> bool:
    """Whether the value of a member may be this one."""
    held = call.machine.obj(member).attrs.get("_value_", NONE) if isinstance(member, Ref) else NONE
    return call.machine.truth(call.machine.compare("==", held, value)) is not False


def _missing(call: NativeCall, cls: Value, value: Const, *, sure: bool) -> Value:
    if isinstance(cls, Class):
        missing = hook(call, cls, "_missing_")
        if missing is not None:
            return call.machine.call(missing, (cls, value))
        if is_flag(cls):
            return _several_bits(call, cls, value)
        message = f"{value.value!r} is not a valid {cls.qualname}"
        return call.machine.die("ValueError", message, (Const(message),), sure=sure and not value.origins, plain=True)
    return call.machine.unknown(Cause.CALL, "enum.Enum")


def _several_bits(call: NativeCall, cls: Class, value: Const) -> Value:
    """The flag of a value that no member has: made once, so that it is the same object each time."""
    machine = call.machine
    made = machine.obj(class_obj(cls)).attrs.get(_COMBINED)
    known = exact_dict(machine, made) if made is not None else {}
    if known is not None and value in known:
        return known[value]
    # up to Python 3.10, several bits have no name
    name = machine.unknown(Cause.LIVE, "name of a flag", "str") if int_of(value) else NONE
    attrs: dict[str, Value] = {"_value_": value, "value": value, "name": name, "_name_": name}
    flag = machine.allocate(Obj("instance", cls, attrs, payload=value), value)
    if known is not None:
        machine.store_attr(cls, _COMBINED, machine.new_dict({**known, value: flag}))
    return flag


def item(call: NativeCall) -> Value:
    """enum.item(cls, name): `Cls['NAME']`; any member where the name is not known."""
    members = _members(call, call.args[0])
    if members is None:
        return call.machine.unknown(Cause.CALL, "enum.Enum")
    found: list[Value] = []
    for option in options(call.args[1]):
        plain = text_of(option)
        if plain is None:
            found.extend(members.values())
        elif Const(plain) in members:
            found.append(members[Const(plain)])
        else:
            sure = option is call.args[1] and not (isinstance(option, Const) and option.origins)
            found.append(call.machine.die("KeyError", repr(plain), (option,), sure=sure, plain=True))
    return join_all(found)


def _make_class(call: NativeCall) -> Value:
    """enum._make_class(base, name, names): `Enum('Side', 'LEFT RIGHT')`."""
    machine, (base, name, names, kind, start) = call.machine, call.exactly(5)
    first = int_of(start)
    if not isinstance(base, Class) or names == NONE:
        return machine.unknown(Cause.CALL, "enum.Enum")
    plain = text_of(names)
    entries = exact_dict(machine, names)
    if plain is not None:
        pairs: list[tuple[Value, Value | None]] = [(Const(n), None) for n in plain.replace(",", " ").split()]
    elif entries is not None:
        pairs = list(entries.items())
    else:
        listed = [(i, exact_list(machine, i)) for i in exact_list(machine, names) or ()]
        pairs = [(p[0], p[1]) if p is not None and len(p) == 2 else (i, None) for i, p in listed]
    numbered = not derives(base, "enum.Flag", "enum.StrEnum") and hook(call, base, "_generate_next_value_") is None
    members: dict[str, Value] = {}
    for number, (key, value) in enumerate(pairs):
        text = text_of(key)
        if text is None or (value is None and numbered and first is None):
            return machine.unknown(Cause.CALL, "enum.Enum")
        automatic = Const((first or 0) + number) if numbered else External(f"{_AUTO} {number}")
        members[text] = automatic if value is None else value
    if not members:
        return machine.unknown(Cause.CALL, "enum.Enum")
    made = text_of(name) or "Enum"
    members["__module__"] = machine.unknown(Cause.CALL, "__module__", "str")  # of whoever asks for the class
    where = machine.allocate(Obj("class", Native("builtins.type"), members))
    bases: tuple[Value, ...] = (base,) if kind == NONE else (kind, base)
    kinds = kind.mro if isinstance(kind, Class) else bases[:-1]
    cls = Class(where.address, made, made, machine.place.file, bases, (*kinds, *base.mro), machine.place, False)
    make_members(NativeCall(machine, "enum.make_members", (cls,), {}))
    return cls


def _auto(call: NativeCall) -> Value:
    place = call.machine.place
    return External(f"{_AUTO} {place.line}:{place.column}")


def length(call: NativeCall) -> Value:
    """enum.length(cls): `len(Cls)`, aliases left out."""
    members = _members(call, call.args[0])
    if members is None:
        return call.machine.unknown(Cause.OPERATION, "len", "int")
    distinct = dict.fromkeys(members.values())
    if not all(_is_canonical(call, call.args[0], m) for m in distinct):
        return call.machine.unknown(Cause.OPERATION, "len", "int")
    return Const(len(distinct))


def _same(call: NativeCall) -> Value:
    return call.args[0] if call.args else Native("enum._same")


def _property(call: NativeCall) -> Value:
    return Descriptor("property", call.args[0], None, None) if call.args else NONE


def _verify(_: NativeCall) -> Value:
    return Native("enum._same")


NATIVES: Final[dict[str, NativeFunction]] = {
    "enum._make_class": _make_class,
    "enum.make_members": make_members,
    "enum.iterate": iterate,
    "enum.lookup": lookup,
    "enum.item": item,
    "enum.length": length,
    "enum._item": item,
    "enum._iterate": iterate,
    "enum._length": length,
    "enum._lookup": lookup,
    "enum.auto": _auto,
    "enum.property": _property,
    "enum.member": _same,
    "enum.nonmember": _same,
    "enum.unique": _same,
    "enum.global_enum": _same,
    "enum.verify": _verify,
    "enum._same": _same,
    **{f"enum.member.{name}": member_operation for name in (*OPERATORS, *COMPARISONS, *CONVERSIONS)},
}
