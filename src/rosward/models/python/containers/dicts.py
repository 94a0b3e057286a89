# SPDX-License-Identifier: Apache-2.0
"""Dicts: entries under known keys (some of them maybe absent), and the join of what stands under unknown ones.

d['a'] = 1          entries {'a': 1}
d[unknown] = 2      entries {'a': 1 or 2}, rest 2
d.get(unknown)      1, 2 or None
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import BoundMethod, External, Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import NO_ORIGINS
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Const, Function, ModuleValue, Ref, Text, Unknown, Value
from rosward.models.interfaces import is_of_interfaces, public_name
from rosward.models.native import Items, Machine, NativeCall, NativeFunction
from rosward.models.python.comparing.compare import equal
from rosward.models.python.comparing.equal_objects import compares, is_of_many, member_value, row_of
from rosward.models.python.contents import bare, plain_data
from rosward.models.python.plain import Raised, all_of, key_shown, native, origins, unknown_from, with_origins
from rosward.records import NamedTuple

MAX_ENTRIES: Final = 2_000
_IDENTITIES: Final = (Class, External, Function, ModuleValue, Native, Ref)


def key_of(value: Value) -> Value | None:
    """The key that a value surely is, without origins; None where it may be several."""
    if isinstance(value, Const):
        return Const(value.value) if value.origins else value
    if isinstance(value, Tuple):
        items = [key_of(v) for v in value.items]
        return None if None in items else Tuple(tuple(v for v in items if v is not None))
    if isinstance(value, External) and "._" in value.name and is_of_interfaces(value.name):
        return External(public_name(value.name))
    if isinstance(value, BoundMethod):  # those of one object are equal
        return value if isinstance(value.receiver, _IDENTITIES) and isinstance(value.function, _IDENTITIES) else None
    return value if isinstance(value, _IDENTITIES) else None


def _bare(value: Value) -> Value:
    """A value without its origins."""
    if isinstance(value, Text):
        return Text(value.parts, NO_ORIGINS)
    key = key_of(value)
    return value if key is None else key


def find(machine: Machine, obj: Obj, key: Value) -> Value | None:
    """The key in a dict that equals a known key (1 is also 1.0 and True, and the member of an `IntEnum` that has this number)."""
    if key in obj.entries:
        return key
    number = member_value(machine, key)
    if number is not None:
        return find(machine, obj, number)
    if isinstance(key, Ref) and _by_content(machine, key):
        return next((k for k in obj.entries if isinstance(k, (Ref, Tuple)) and equal(machine, k, key)), None)
    if isinstance(key, Const):
        for other in obj.entries:
            if (
                isinstance(other, Ref)
                and (held := member_value(machine, other)) is not None
                and held.value == key.value
            ):
                return other
    if isinstance(key, Const) and isinstance(key.value, (bool, int, float)):
        return next(
            (k for k in obj.entries if isinstance(k, Const) and not isinstance(k.value, str) and k.value == key.value),
            None,
        )
    return None


class LookUp(NamedTuple):
    """The join of what may stand under a key (UNBOUND: nothing), and whether the key is missing (None: maybe)."""

    value: Value
    missing: bool | None


def look_up(machine: Machine, obj: Obj, index: Value) -> LookUp:
    """What stands under an index."""
    index = plain_data(machine, index)
    found = [_look_up(machine, obj, option) for option in options(index)]
    missing = {f.missing for f in found}
    value = join_all(f.value for f in found)
    return LookUp(with_origins(value, origins(index)), missing.pop() if len(missing) == 1 else None)


def _by_content(machine: Machine, key: Ref | Tuple) -> bool:
    """Whether another object may be the same key by what it holds: a tuple, a named one, a frozenset."""
    return row_of(machine, key) is not None or (isinstance(key, Ref) and machine.obj(key).kind == "set")


def _look_up(machine: Machine, obj: Obj, index: Value) -> LookUp:
    key = key_of(index)
    present = find(machine, obj, key) if key is not None else None
    if present is not None and present not in obj.maybe:
        return LookUp(obj.entries[present], False)
    candidates = [present] if present is not None else []
    if present is None and isinstance(key, (Ref, Tuple)) and _by_content(machine, key):
        alike: dict[Value, bool | None] = {
            k: equal(machine, k, key) for k in obj.entries if isinstance(k, (Ref, Tuple))
        }
        candidates = [k for k, answer in alike.items() if answer is not False]
        if len(candidates) == 1 and alike[candidates[0]] and candidates[0] not in obj.maybe:
            return LookUp(obj.entries[candidates[0]], False)
    elif key is None or (present is None and compares(machine, key)):
        candidates = [k for k in obj.entries if equal(machine, k, index) is not False]
    values = [obj.entries[k] for k in candidates]
    if obj.rest is not None and (obj.rest_key is None or equal(machine, obj.rest_key, index) is not False):
        values.append(obj.rest)
    return LookUp(join_all(values), None if values else True)


def load(machine: Machine, ref: Ref, index: Value) -> Value:
    """dict[index]."""
    found = look_up(machine, machine.obj(ref), index)
    if found.missing and found.value is UNBOUND:
        raise Raised("KeyError", key_shown(index), (index,))
    return found.value


def store(machine: Machine, ref: Ref, index: Value, value: Value, weak: bool = False) -> None:
    """dict[index] = value; `weak` where it may not happen."""
    index = plain_data(machine, index)
    several = weak or isinstance(index, Choice)
    obj = machine.obj(ref)
    if isinstance(obj.payload, Value) and not isinstance(obj.payload, Ref):
        machine.report("RW203", "the defaults of a function, or the annotations of a class, may be changed")
    for option in options(index):
        key = key_of(option)
        if key is None:
            if isinstance(obj.payload, Value):
                machine.report("RW203", "an attribute or variable with an unknown name is set")
            obj = _store_unknown(machine, obj, option, value)
        elif compares(machine, key):  # it may be equal to another key
            obj = _store_unknown(machine, obj, key, value)
        else:
            is_many = is_of_many(machine, key)
            obj = _store_known(obj, find(machine, obj, key) or key, value, several or is_many)
            if isinstance(obj.payload, Ref) and isinstance(key, Const) and isinstance(key.value, str):
                machine.keep_attr(
                    obj.payload, key.value, value, weak=several or is_many
                )  # the `__dict__` of an object, or of several
    machine.update(ref, _bounded(obj))


def _store_known(obj: Obj, key: Value, value: Value, weak: bool) -> Obj:
    old = obj.entries.get(key)
    if not weak:
        return obj.replace(entries={**obj.entries, key: value}, maybe=obj.maybe - {key})
    if old is None:
        value = value if obj.rest is None else join(value, obj.rest)
        return obj.replace(entries={**obj.entries, key: value}, maybe=obj.maybe | {key})
    return obj.replace(entries={**obj.entries, key: join(old, value)})


def _store_unknown(machine: Machine, obj: Obj, key: Value, value: Value) -> Obj:
    entries = with_possible(machine, obj.entries, key, value)
    if obj.rest is None:
        return obj.replace(entries=entries, rest=value, rest_key=_bare(key))
    rest_key = None if obj.rest_key is None else join(obj.rest_key, _bare(key))
    return obj.replace(entries=entries, rest=join(obj.rest, value), rest_key=rest_key)


def with_possible(machine: Machine, entries: Mapping[Value, Value], key: Value, value: Value) -> dict[Value, Value]:
    """Entries where a value may stand under each key that may be equal to `key`."""
    return {k: join(v, value) if equal(machine, k, key) is not False else v for k, v in entries.items()}


def _bounded(obj: Obj) -> Obj:
    """A record with a bounded number of entries."""
    if len(obj.entries) <= MAX_ENTRIES:
        return obj
    values = [*obj.entries.values(), *(() if obj.rest is None else (obj.rest,))]
    return obj.replace(entries={}, maybe=frozenset(), rest=join_all(values), rest_key=None)


def take(machine: Machine, ref: Ref, index: Value) -> LookUp:
    """Take an entry away; what stood there."""
    obj = machine.obj(ref)
    found = look_up(machine, obj, index)
    key = key_of(index)
    present = find(machine, obj, key) if key is not None else None
    if present is not None:
        entries = {k: v for k, v in obj.entries.items() if k != present}
        _gone(machine, obj, present)
        machine.update(ref, obj.replace(entries=entries, maybe=obj.maybe - {present}))
    elif key is None or compares(machine, key):
        doubtful = {k for k in obj.entries if equal(machine, k, index) is not False}
        machine.update(ref, obj.replace(maybe=obj.maybe | doubtful))
    return found


def _gone(machine: Machine, obj: Obj, key: Value) -> None:
    """What is taken out of the `__dict__` of an object is no attribute of it any more."""
    if isinstance(obj.payload, Ref) and isinstance(key, Const) and isinstance(key.value, str):
        machine.keep_attr(obj.payload, key.value, UNBOUND)


def keys(machine: Machine, obj: Obj) -> Items:
    """The keys in order, as iteration gives them."""
    return _in_order(obj, list(obj.entries), _rest_key(machine, obj))


def values(obj: Obj) -> Items:
    """The values in order."""
    return _in_order(obj, list(obj.entries.values()), obj.rest)


def pairs(machine: Machine, obj: Obj) -> Items:
    """The pairs of key and value in order."""
    key = _rest_key(machine, obj)
    rest = None if key is None or obj.rest is None else Tuple((key, obj.rest))
    return _in_order(obj, [Tuple(pair) for pair in obj.entries.items()], rest)


def _rest_key(machine: Machine, obj: Obj) -> Value | None:
    if obj.rest is None:
        return None
    return obj.rest_key or unknown_from(machine, "key", "", obj.rest)


def _in_order(obj: Obj, listed: list[Value], rest: Value | None) -> Items:
    """All of them; from the first key on that may be absent their number is not known."""
    sure = len(listed)
    for number, key in enumerate(obj.entries):
        if key in obj.maybe:
            sure = number
            break
    loose = [*listed[sure:], *(() if rest is None else (rest,))]
    return Items(tuple(listed[:sure]), join_all(loose) if loose else None)


# Methods


def receiver(call: NativeCall) -> Ref | None:
    """The dict that a method is called on; None where it is not known."""
    first = call.args[0] if call.args else None
    return first if isinstance(first, Ref) and call.machine.obj(first).kind == "dict" else None


def _get(call: NativeCall) -> Value:
    ref = receiver(call)
    if ref is None:
        return unknown_from(call.machine, call.name, "", *call.args)
    found = look_up(call.machine, call.machine.obj(ref), call.args[1])
    default = call.args[2] if len(call.args) > 2 else NONE
    return found.value if found.missing is False else join(found.value, with_origins(default, origins(call.args[1])))


def _set_default(call: NativeCall) -> Value:
    ref, default = receiver(call), call.args[2] if len(call.args) > 2 else NONE
    if ref is None:
        return unknown_from(call.machine, call.name, "", *call.args)
    found = look_up(call.machine, call.machine.obj(ref), call.args[1])
    if found.missing is not False:
        store(call.machine, ref, call.args[1], default, weak=found.missing is None)
    return found.value if found.missing is False else join(found.value, default)


def _update(call: NativeCall) -> Value:
    ref = receiver(call)
    if ref is not None:
        for source in call.args[1:2]:
            several = isinstance(source, Choice)
            for option in options(source):
                merge(call.machine, ref, option, weak=several)
        for name, value in call.keywords.items():
            store(call.machine, ref, Const(name), value)
    return NONE


def merge(machine: Machine, ref: Ref, source: Value, weak: bool = False) -> None:
    """Put the entries of a mapping, or of an iterable of pairs, into a dict."""
    source = bare(machine, source)
    if isinstance(source, Ref) and machine.obj(source).kind == "dict":
        other = machine.obj(source)
        for key, value in other.entries.items():
            store(machine, ref, key, value, weak or key in other.maybe)
        if other.rest is not None:
            anywhere = other.rest_key or unknown_from(machine, "key", "", other.rest)
            store(machine, ref, anywhere, other.rest, weak=True)
        return
    if isinstance(source, Ref) and is_mapping(machine, source):
        found = machine.iterate(machine.call(machine.load_attr(source, "keys"), ()))
        for key in all_of(found):
            store(machine, ref, key, machine.load_item(source, key), weak or key is found.rest)
        return
    known, rest = machine.iterate(source)
    for pair in known:
        _merge_pair(machine, ref, pair, weak)
    if rest is not None:
        for option in options(rest):
            _merge_pair(machine, ref, option, weak=True)


def is_mapping(machine: Machine, value: Value) -> bool:
    """Whether a value is an object of a class that is a mapping, as `dict` and `**` see it: it has a method `keys`."""
    if value.__class__ is not Ref or machine.obj(value).kind != "instance":
        return False
    cls = machine.obj(value).cls
    bases = cls.mro if isinstance(cls, Class) else ()
    return any("keys" in machine.obj(Ref(b.address)).attrs for b in bases if isinstance(b, Class))


def _merge_pair(machine: Machine, ref: Ref, pair: Value, weak: bool) -> None:
    known, rest = machine.iterate(pair)
    if len(known) == 2 and rest is None:
        store(machine, ref, known[0], known[1], weak)
    elif rest is not None or isinstance(pair, (Unknown, Choice)):
        anything = join_all((*known, *(() if rest is None else (rest,))))
        value = unknown_from(machine, "dict", "", pair) if anything is UNBOUND else anything
        store(machine, ref, Unknown(unknown_from(machine, "dict", "", pair).reasons), value, weak=True)
    else:
        raise Raised("ValueError", f"dictionary update sequence element has length {len(known)}; 2 is required")


def _pop(call: NativeCall) -> Value:
    """dict.pop(key, default), and `del dict[key]`."""
    ref = receiver(call)
    if ref is None:
        return unknown_from(call.machine, call.name, "", *call.args)
    has_default = len(call.args) > 2
    obj = call.machine.obj(ref)
    if not has_default and look_up(call.machine, obj, call.args[1]).missing:
        raise Raised("KeyError", key_shown(call.args[1]), (call.args[1],))
    found = take(call.machine, ref, call.args[1])
    return join(found.value, call.args[2]) if has_default and found.missing is not False else found.value


def _pop_item(call: NativeCall) -> Value:
    ref = receiver(call)
    if ref is None:
        return unknown_from(call.machine, call.name, "tuple", *call.args)
    obj = call.machine.obj(ref)
    if obj.entries and obj.rest is None and not obj.maybe:
        last = call.arg(1, "last")
        from_end = last is None or call.machine.truth(last) is not False
        key, value = next(reversed(obj.entries.items()) if from_end else iter(obj.entries.items()))
        take(call.machine, ref, key)
        return Tuple((key, value))
    known, rest = pairs(call.machine, obj)
    if not known and rest is None:
        raise Raised("KeyError", "popitem(): dictionary is empty", (Const("popitem(): dictionary is empty"),))
    call.machine.update(ref, obj.replace(maybe=frozenset(obj.entries)))
    return join_all((*known, *(() if rest is None else (rest,))))


def _from_keys(call: NativeCall) -> Value:
    value = call.args[1] if len(call.args) > 1 else NONE
    known, rest = call.machine.iterate(call.args[0])
    made = call.machine.allocate(Obj("dict", Native("builtins.dict")), call.name)
    for key in known:
        store(call.machine, made, key, value)
    if rest is not None:
        store(call.machine, made, rest, value, weak=True)
    return made


def _clear(call: NativeCall) -> Value:
    ref = receiver(call)
    if ref is not None:
        obj = call.machine.obj(ref)
        for key in obj.entries:
            _gone(call.machine, obj, key)
        call.machine.update(ref, obj.replace(entries={}, maybe=frozenset(), rest=None, rest_key=None))
    return NONE


def copy(machine: Machine, ref: Ref) -> Ref:
    """A new dict with the same entries."""
    return machine.allocate(
        machine.obj(ref).replace(cls=Native("builtins.dict"), attrs={}, many=False, payload=None), "copy"
    )


def _copy(call: NativeCall) -> Value:
    ref = receiver(call)
    return unknown_from(call.machine, call.name, "dict", *call.args) if ref is None else copy(call.machine, ref)


NATIVES: Final[dict[str, NativeFunction]] = {
    "dict.get": native(_get, 2),
    "dict.setdefault": native(_set_default, 2),
    "dict.update": native(_update, 1),
    "dict.pop": native(_pop, 2),
    "dict.popitem": native(_pop_item, 1),
    "dict.fromkeys": native(_from_keys, 1),
    "dict.clear": native(_clear, 1),
    "dict.copy": native(_copy, 1),
}
