# SPDX-License-Identifier: Apache-2.0
"""What is written at a place, and what is a copy of what stands there?

n = 5               write(machine, slot of n, Const(5))
Lamp b = a;         copied(machine, Ref(7)): another object, and other ones for what it holds by value
b = a;              assigned(machine, Ref(8), Ref(7)): the object stays where it is, and holds the same
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Final

from rosward.domain.choice import join, join_all, lift, options
from rosward.domain.compound import External, Partial, Tuple
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.slots import Overloads, Slot, is_char_text
from rosward.domain.state import join_objects
from rosward.domain.table import marked
from rosward.domain.unknown import NO_ORIGINS, Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, Ref, Unknown, Value
from rosward.ir.core import CharText
from rosward.models.cpp.values.captures import with_own_cells
from rosward.models.cpp.values.characters import character_of
from rosward.models.cpp.values.owners import give_away
from rosward.models.cpp.values.shared_storage import overlapping, written
from rosward.models.cpp.values.slots import key_of, read, referred_to
from rosward.models.cpp.values.types import is_reference
from rosward.models.native import Machine
from rosward.models.python.containers import dicts
from rosward.models.python.operators import items as python_items
from rosward.models.python.plain import int_of, text_of, unknown_from

__all__ = [
    "ASSIGN",
    "COPY",
    "REFERENCES",
    "assigned",
    "copied",
    "for_each",
    "is_copied",
    "opened",
    "several",
    "write",
]

COPY: Final = "<copy>"
"""The attribute of a class that makes a copy of an object of it: a callable of the object; NONE where objects of it are never copied."""
ASSIGN: Final = "<assign>"
"""The attribute of a class that says itself how another object is assigned to one of it: the functions, and the names of all its fields."""
REFERENCES: Final = "<references>"
"""The attribute of a class with the names of its fields that are references: a tuple. What they lead to is no part of an object."""
_VALUE: Final = "value"
_DEEPEST: Final = 12
LEFT: Final = "left"
"""Attribute of a cell: others may lead to it, by ways that nobody sees, so that writes only add."""
_APART: Final = 4
"""So many alternatives of an object are copied one by one; those of what an object holds become one."""
_COPIED: Final = ("instance", "list", "set", "dict")


def write(machine: Machine, slot: Value, value: Value, *, weak: bool = False) -> None:
    """The value stands at the slot from now on; `weak` where that may not happen. What is no slot keeps what it has."""
    several, value = options(slot), read(machine, value)
    if len(several) > 1 and len(options(value)) > _APART and any(isinstance(o, Ref) for o in several):
        value = copied(machine, value)  # one object for all that are assigned
    for option in several:
        if option.__class__ is Slot:
            referred = None if is_reference(value) else referred_to(machine, option)
            if referred is None:
                _write(machine, option, value, weak=weak or len(several) > 1)
            else:
                write(machine, referred, value, weak=weak or len(several) > 1)
        elif isinstance(option, Ref):
            assigned(machine, option, value, weak=weak or len(several) > 1)
        elif isinstance(option, Unknown):
            machine.escape((value,), "a reference that is not known", option)


def _write(machine: Machine, slot: Slot, value: Value, *, weak: bool) -> None:
    base, kind, key = slot.fields()
    if not isinstance(base, Ref):
        _write_character(machine, slot, value, weak=weak)
    elif kind == "cell":
        obj = machine.obj(base)
        weak = weak or LEFT in obj.attrs
        machine.update(base, obj.with_attr(_VALUE, join(obj.attrs.get(_VALUE, UNBOUND), value) if weak else value))
    elif kind == "field" and isinstance(key, str):
        _write_field(machine, base, key, value, weak=weak)
    elif isinstance(key, Value) and key != NONE and kind in ("item", "reverse"):
        if machine.obj(base).kind == "dict":
            dicts.store(machine, base, key_of(machine, key), value, weak)
        else:
            _write_item(machine, base, key, value, weak=weak)


def _write_field(machine: Machine, ref: Ref, name: str, value: Value, *, weak: bool) -> None:
    obj = machine.obj(ref)
    cls = machine.obj(Ref(obj.cls.address)) if isinstance(obj.cls, Class) else None
    others = overlapping(cls, name).intersection(obj.attrs)
    if others:
        value, obj = written(machine, obj, others, name, value)
    old = obj.attrs.get(name)
    if old is not None and (weak or obj.many):
        value = join(old, value)
    changed = obj.with_attr(name, value)
    message = isinstance(obj.cls, External)
    if (old is None and (weak or (obj.many and message))) or (name in obj.partial and (weak or (obj.many and message))):
        changed.partial = marked(obj.partial, name)
    machine.update(ref, changed)


def _write_item(machine: Machine, ref: Ref, key: Value, value: Value, *, weak: bool) -> None:
    obj = machine.obj(ref)
    series = obj.series()
    for option in options(key):
        number = int_of(option)
        if number is not None and (number < 0 or (series.exact and number >= len(series.head))):
            continue  # undefined: what it does is not known, but it is no element
        python_items.store_item(machine, ref, option, value, weak or isinstance(key, Choice))


def _write_character(machine: Machine, slot: Slot, value: Value, *, weak: bool) -> None:
    """`s[i] = c`: the string is a value, so another one stands in its slot."""
    if slot.base.__class__ is not Slot or not isinstance(slot.key, Value):
        return
    index, number, char = slot.key, int_of(slot.key), character_of(value)

    def one(old: Value) -> Value:
        text = text_of(old)
        source = old.origins if isinstance(old, Const) else NO_ORIGINS
        kind = CharText if is_char_text(old) else str
        if text is not None and char == "\0" and number is not None and 0 <= number <= len(text):
            return Const(kind(text[:number]), source)  # an array of characters ends there
        if text is None or number is None or char is None or len(char) != 1 or not 0 <= number <= len(text):
            return unknown_from(machine, "[]", "str", old, index, value)
        return Const(kind(text[:number] + char + text[number + 1 :]), source)

    write(machine, slot.base, lift(one, read(machine, slot.base)), weak=weak)


# Copying


def copied(machine: Machine, value: Value) -> Value:
    """A copy of the value at a slot, for a variable of its own: objects by value are copied, pointers are not followed."""
    return _copied(machine, read(machine, value), {}, 0)


def _copied(machine: Machine, value: Value, known: dict[int, Value], depth: int) -> Value:
    if value.__class__ is Ref:
        return _copy_of(machine, value, known, depth)
    if value.__class__ is Choice and any(o.__class__ in (Ref, Tuple, Slot) for o in value.options):
        found = dict.fromkeys(o for option in value.options for o in options(read(machine, option)))
        most = _APART if depth == 0 else 1
        copies: list[Value] = []
        for alike in _alike(machine, found):
            too_many = most < len(alike) and depth < _DEEPEST
            one = _copy_of_several(machine, alike, known, depth) if too_many else None
            copies += [_copied(machine, option, known, depth) for option in alike] if one is None else [one]
        return join_all(copies)
    if value.__class__ is Tuple:
        return Tuple(tuple(_copied(machine, read(machine, item), known, depth) for item in value.items))
    if value.__class__ is Function and value.code.signature is not None and value.code.signature.owned:
        return with_own_cells(machine, value, copied)
    if value.__class__ is Partial and value.function.__class__ is Function:
        return Partial(_copied(machine, value.function, known, depth), value.arguments, value.keywords)
    return value


def _copy_of(machine: Machine, ref: Ref, known: dict[int, Value], depth: int) -> Value:
    """A copy of an object; `known` has those that are made already."""
    made = known.get(ref.address)
    if made is not None:
        return made
    obj = machine.obj(ref)
    if not is_copied(machine, obj):
        return ref
    own = _own(machine, obj.cls, COPY)
    if own is not None:
        return machine.call(own, (ref,))
    if depth >= _DEEPEST:
        return machine.unknown(Cause.LIMIT, "copy of an object")
    fresh = machine.allocate(obj.replace(many=False), ("copy", ref.address))
    known[ref.address] = fresh
    made = _filled(machine, fresh, obj, known, depth)
    give_away(machine, ref)
    return made


def _copy_of_several(machine: Machine, alike: list[Value], known: dict[int, Value], depth: int) -> Value | None:
    """One copy for all of these objects of one class: else copies of copies are ever more. None where they are not copied."""
    cls = machine.obj(alike[0]).cls if isinstance(alike[0], Ref) else NONE
    own = _own(machine, cls, COPY)
    if own is not None and not _never_copied(machine, cls):
        return machine.call(own, (join_all(alike),))
    merged = _merged(machine, alike)
    return merged and _filled(machine, machine.allocate(merged, "copy of several"), merged, known, depth)


def _filled(machine: Machine, fresh: Ref, obj: Obj, known: dict[int, Value], depth: int) -> Ref:
    """A new object that holds copies of what another holds."""
    contents = _contents(machine, obj, known, depth + 1)
    if contents is not obj:
        machine.update(fresh, contents.replace(many=machine.obj(fresh).many))
    return fresh


def _alike(machine: Machine, found: Iterable[Value]) -> Iterable[list[Value]]:
    """The objects of one class together, each other value alone."""
    groups: dict[object, list[Value]] = {}
    for value in found:
        obj = machine.obj(value) if isinstance(value, Ref) else None
        groups.setdefault(value if obj is None else (obj.kind, obj.cls), []).append(value)
    return groups.values()


def _merged(machine: Machine, found: list[Value]) -> Obj | None:
    """One record for many objects of one class that are copied alike; None where they are not."""
    records = [machine.obj(o) for o in found if isinstance(o, Ref)]
    first = records[0] if len(records) == len(found) else None
    if first is None or any(r.cls != first.cls or r.kind != first.kind for r in records):
        return None
    cls = first.cls
    if first.kind not in _COPIED or _never_copied(machine, cls) or _own(machine, cls, COPY) is not None:
        return None
    merged = first.replace(many=False)
    for record in records[1:]:
        merged = join_objects(merged, record.replace(many=False) if record.many else record, join)
    return merged


def _contents(machine: Machine, obj: Obj, known: dict[int, Value], depth: int) -> Obj:
    """The record of a copy: what it holds by value is copied too."""

    def one(value: Value) -> Value:
        return _copied(machine, value, known, depth)

    def each(rest: Value) -> Value:
        """Elements of which the number is not known: where one stands for several, or for the copies of several, it is many."""
        made = one(rest)
        before, after = ([o for o in options(v) if isinstance(o, Ref)] for v in (rest, made))
        shared = len(after) < len(before) or any(machine.obj(o).many for o in before)
        return several(machine, made) if shared else made

    changes: dict[str, object] = {}
    references = _references(machine, obj.cls)
    attrs = {name: value if name in references else one(value) for name, value in obj.attrs.items()}
    if any(value is not obj.attrs[name] for name, value in attrs.items()):
        changes["attrs"] = attrs
    if obj.kind == "list" and obj.items is None:
        changes["rest"] = None if obj.rest is None else each(obj.rest)
        changes["ends"] = None if obj.ends is None else obj.ends.mapped(one)
    elif obj.items and any(v.__class__ in (Ref, Choice, Tuple) for v in obj.items):
        changes["items"] = tuple(map(one, obj.items))
    if obj.kind == "dict":
        changes["entries"] = {key: one(value) for key, value in obj.entries.items()}
        changes["rest"] = None if obj.rest is None else each(obj.rest)
    return obj.replace(**changes) if changes else obj


def several(machine: Machine, value: Value) -> Value:
    """What was made once stands for any number of them, and so does what it holds by value: `std::vector<Lamp>(n)` of an unknown `n`."""
    waiting = [value]
    while waiting:
        for option in options(waiting.pop()):
            obj = machine.obj(option) if isinstance(option, Ref) else None
            if isinstance(option, Ref) and obj is not None and not obj.many and obj.kind in _COPIED:
                machine.update(option, obj.replace(many=True))
                references = _references(machine, obj.cls)
                waiting += (held for name, held in obj.attrs.items() if name not in references)
                waiting += (*(obj.items or ()), *obj.entries.values(), *(() if obj.rest is None else (obj.rest,)))
    return value


def for_each(machine: Machine, series: Series, make: Callable[[Value], Value]) -> Series:
    """What is made for each element; for those of which the number is not known it is made once."""
    made = series.mapped(make)
    if made.middle is not None:
        several(machine, made.middle)
    return made


def _own(machine: Machine, cls: Value, name: str) -> Value | None:
    """What a class itself says."""
    return machine.obj(Ref(cls.address)).attrs.get(name) if isinstance(cls, Class) else None


def is_copied(machine: Machine, obj: Obj) -> bool:
    """Whether handing on an object makes another one."""
    return obj.kind in _COPIED and not _never_copied(machine, obj.cls)


def _never_copied(machine: Machine, cls: Value) -> bool:
    """Whether a class, or a base of it, cannot be copied."""
    return isinstance(cls, Class) and any(_own(machine, base, COPY) == NONE for base in cls.mro)


def _references(machine: Machine, cls: Value) -> frozenset[str]:
    found = [_own(machine, base, REFERENCES) for base in cls.mro] if isinstance(cls, Class) else []
    return frozenset(
        str(name.value) for each in found if isinstance(each, Tuple) for name in each.items if isinstance(name, Const)
    )


def assigned(machine: Machine, ref: Ref, value: Value, *, weak: bool = False, depth: int = 1) -> None:
    """`object = value`: the object stays where it is, and so do those in it; it holds a copy of what the other one holds."""
    several = [o for o in options(read(machine, value)) if o != ref] or [ref]
    weak = weak or machine.obj(ref).many
    stays = frozenset[str]() if weak else _assigned_by_program(machine, ref, value)
    if stays is None:
        return
    merged = _merged(machine, several) if len(several) > _APART else None
    if merged is not None:
        several = several[:1]
    weak = weak or len(several) > 1 or ref in options(value)
    for option in several:
        if option == ref:
            continue
        old = machine.obj(ref)
        if not isinstance(option, Ref) or machine.obj(option).kind != old.kind:
            opened(machine, ref, option)
            continue
        source = merged or machine.obj(option)
        fixed = stays | _references(machine, old.cls)
        inside = _assigned_inside(machine, old, source, fixed, weak=weak, depth=depth)
        rest = source.replace(attrs={n: v for n, v in source.attrs.items() if n not in inside}) if inside else source
        contents = _contents(machine, rest, {option.address: ref}, depth)
        if inside:
            contents = contents.replace(
                attrs={n: inside.get(n, contents.attrs.get(n, v)) for n, v in source.attrs.items()}
            )
        changed = contents.replace(cls=old.cls, many=old.many)
        kept = {name: old.attrs[name] for name in fixed if name in old.attrs}
        if kept:
            changed = changed.replace(attrs={**changed.attrs, **kept})
        machine.update(ref, join_objects(old, changed, join) if weak else changed)
        give_away(machine, option)


def _assigned_by_program(machine: Machine, ref: Ref, value: Value) -> frozenset[str] | None:
    """The names of the fields that operators of the bases have assigned; None where one of the class itself has done it all."""
    cls = machine.obj(ref).cls
    done: set[Value] = set()
    names: set[str] = set()
    for each in cls.mro if isinstance(cls, Class) else ():
        rule = _own(machine, each, ASSIGN)
        if each in done or not isinstance(rule, Tuple):
            continue
        function, fields = rule.items
        assert isinstance(each, Class)
        if isinstance(function, Overloads) and isinstance(fields, Tuple):
            machine.call(function.of(ref), (value,))
            if each == cls:
                return None
            names.update(str(name.value) for name in fields.items if isinstance(name, Const))
        done.update(each.mro)
    return frozenset(names)


def _assigned_inside(
    machine: Machine, old: Obj, source: Obj, fixed: frozenset[str], *, weak: bool, depth: int
) -> dict[str, Value]:
    """The objects that an object holds by value, after those of another one were assigned to them; those of `fixed` names stay what they are."""
    inside: dict[str, Value] = {}
    for name, value in source.attrs.items():
        held = old.attrs.get(name)
        if not isinstance(held, Ref) or name in fixed or depth >= _DEEPEST or value == held:
            continue
        merged = _merged(machine, [held, *options(read(machine, value))])
        if merged is not None and merged.kind == "instance":
            assigned(machine, held, value, weak=weak or name in old.partial, depth=depth + 1)
            inside[name] = held
    return inside


def opened(machine: Machine, ref: Ref, value: Value) -> None:
    """Something of which nothing is known is assigned to an object: it may hold anything now."""
    obj = machine.obj(ref)
    unknown = unknown_from(machine, "=", "", value)
    if obj.kind in ("list", "set"):
        machine.update(ref, obj.replace(items=None, rest=unknown))
    elif obj.kind == "dict":
        entries = {key: join(held, unknown) for key, held in obj.entries.items()}
        machine.update(ref, obj.replace(entries=entries, maybe=frozenset(entries), rest=unknown, rest_key=None))
    elif isinstance(obj.cls, External):
        machine.update(ref, obj.replace(attrs={}, payload=unknown, partial=frozenset()))
    else:
        attrs = {
            name: unknown if not isinstance(held, Ref) else join(held, unknown) for name, held in obj.attrs.items()
        }
        machine.update(ref, obj.replace(attrs=attrs))
