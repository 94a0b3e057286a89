# SPDX-License-Identifier: Apache-2.0
"""How the models of the standard library go from abstract values to plain ones and back.

apply_plain(call, math.hypot, (Const(3), Const(4)), "float")   Const(5.0)
apply_plain(call, math.hypot, (Const(3), unknown), "float")    Unknown('float'), for the reasons of `unknown`
from_plain(machine, {"topics": ["/a"]})                        a dict on the heap that holds a list
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.text import origins_of
from rosward.domain.unknown import NO_ORIGINS, Cause, Origins
from rosward.domain.values import Class, Const, Ref, Unknown, Value
from rosward.models.native import Machine, NativeCall
from rosward.models.python import plain
from rosward.models.python.contents import bare as bare_value
from rosward.ros.distro import DISTROS, Distro

MAX_COMBINATIONS: Final = 64
MAX_NODES: Final = 10_000
MAX_DEPTH: Final = 40
_FAILURES: Final = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
_PLAIN: Final = (type(None), bool, int, float, complex, str, bytes)


class NotKnown(Exception):  # noqa: N818 - a signal inside this package, no error of the program
    """The value (or a part of it) is not one constant."""


def names_of(values: Iterable[Value]) -> tuple[str, ...]:
    """The texts among values."""
    return tuple(t for t in map(plain.text_of, values) if t is not None)


def class_obj(cls: Class) -> Ref:
    """Where the attributes of a class live."""
    return Ref(cls.address)


def is_since(machine: Machine, distro: Distro) -> bool | None:
    """Whether the analysis is for a distribution, or for a later one; None where nobody knows for which."""
    known = machine.environment.get("ROS_DISTRO")
    name = None if known is None else plain.text_of(known)
    return Distro(name).has(distro) if name in DISTROS else None


def exact_list(machine: Machine, value: Value) -> tuple[Value, ...] | None:
    """The elements of a list or tuple of known length, else None."""
    value = bare_value(machine, value)
    if isinstance(value, Tuple):
        return value.items
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if obj.kind == "list" and obj.items is not None and obj.rest is None and not obj.many:
            return obj.items
    return None


def exact_dict(machine: Machine, value: Value) -> dict[Value, Value] | None:
    """The entries of a dict all of whose keys are known, else None."""
    value = bare_value(machine, value)
    if isinstance(value, Ref):
        obj = machine.obj(value)
        if obj.kind == "dict" and obj.rest is None and not obj.maybe and not obj.many:
            return dict(obj.entries)
    return None


def bare(key: Value) -> Value:
    """A key without the origins that it may carry, as dicts of a model are asked by it."""
    return Const(key.value) if isinstance(key, Const) else key


def place_list(machine: Machine, items: Iterable[Value] | None, site: object, rest: Value | None = None) -> Ref:
    """A new list among several that one call makes (of unknown length where items is None)."""
    known = None if items is None else tuple(items)
    return machine.allocate(Obj("list", Native("builtins.list"), items=known, rest=rest), site)


def place_dict(machine: Machine, entries: Mapping[Value, Value], site: object) -> Ref:
    """A new dict among several that one call makes."""
    return machine.allocate(Obj("dict", Native("builtins.dict"), entries=dict(entries)), site)


class _Reader:
    """Makes plain values of abstract ones, within a bound, and collects the origins of what it reads."""

    __slots__ = ("left", "machine", "origins")

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.left = MAX_NODES
        self.origins: Origins = NO_ORIGINS

    def read(self, value: Value, depth: int = 0) -> object:
        self.left -= 1
        if self.left < 0 or depth > MAX_DEPTH:
            raise NotKnown
        if isinstance(value, Const):
            self.origins |= value.origins
            return value.value
        if isinstance(value, Tuple):
            return tuple(self.read(v, depth + 1) for v in value.items)
        items = exact_list(self.machine, value)
        if items is not None:
            return [self.read(v, depth + 1) for v in items]
        entries = exact_dict(self.machine, value)
        if entries is not None:
            return {self._key(k, depth): self.read(v, depth + 1) for k, v in entries.items()}
        raise NotKnown

    def _key(self, key: Value, depth: int) -> object:
        found = self.read(key, depth + 1)
        try:
            hash(found)
        except TypeError as error:
            raise NotKnown from error
        return found


def to_plain(machine: Machine, value: Value) -> tuple[object, Origins]:
    """The plain object that a value surely is, with the origins of its parts; raises `NotKnown`."""
    reader = _Reader(machine)
    return reader.read(value), reader.origins


def from_plain(machine: Machine, value: object, origins: Origins = NO_ORIGINS) -> Value:
    """The abstract value of a plain object, its containers on the heap; bounded in size and depth."""
    left = [MAX_NODES]

    def build(part: object, path: tuple[object, ...]) -> Value:
        left[0] -= 1
        if left[0] < 0 or len(path) > MAX_DEPTH:
            return machine.unknown(Cause.LIMIT, "size of a literal value")
        if isinstance(part, _PLAIN):
            return Const(part, origins)
        if isinstance(part, tuple):
            return Tuple(tuple(build(p, (*path, i)) for i, p in enumerate(part)))
        if isinstance(part, dict):
            built = {build(k, (*path, "key", i)): build(v, (*path, i)) for i, (k, v) in enumerate(part.items())}
            return place_dict(machine, {bare(k): v for k, v in built.items()}, path)
        if isinstance(part, list):
            return place_list(machine, [build(p, (*path, i)) for i, p in enumerate(part)], path)
        if isinstance(part, (set, frozenset)):
            members = tuple(build(p, (*path, i)) for i, p in enumerate(sorted(part, key=repr)))
            return machine.allocate(Obj("set", Native("builtins.set"), items=members), path)
        return machine.unknown(Cause.CALL, part.__class__.__name__)

    return build(value, ("data",))


def unknown_from(call: NativeCall, hint: str, values: Iterable[Value]) -> Unknown:
    """An unknown for the reasons of the operands, or because of the operation where these have none."""
    return plain.unknown_from(call.machine, call.name, hint, *values)


def apply_plain(call: NativeCall, function: Callable[..., object], values: Sequence[Value], hint: str = "") -> Value:
    """A pure function applied to every combination of its operands' alternatives; unknown where one is not known."""
    alternatives = [options(v) for v in values]
    count = 1
    for one in alternatives:
        count *= len(one)
    if count > MAX_COMBINATIONS:
        return unknown_from(call, hint, values)
    results: list[Value] = []
    failure: Exception | None = None
    for combination in itertools.product(*alternatives):
        try:
            reader = _Reader(call.machine)
            operands = [reader.read(v) for v in combination]
            if not plain.affordable(call.machine, call.name, operands):
                raise NotKnown
            results.append(from_plain(call.machine, function(*operands), reader.origins))
        except NotKnown:  # noqa: PERF203 - each combination fails for itself
            results.append(unknown_from(call, hint, combination))
        except (*_FAILURES, RecursionError) as error:
            failure = error
    if not results and failure is not None:
        return call.machine.die(failure.__class__.__name__, str(failure))
    return join_all(results)


def joined_elements(call: NativeCall, iterable: Value) -> Value:
    """One value that covers all elements (`UNBOUND` where there are none)."""
    return join_all(plain.all_of(call.machine.iterate(iterable)))


def origins_in(values: Iterable[Value]) -> Origins:
    """The origins of all constants and texts among values."""
    found: Origins = NO_ORIGINS
    for value in values:
        for option in options(value):
            found |= origins_of(option)
    return found
