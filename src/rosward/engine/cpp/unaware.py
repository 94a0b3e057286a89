# SPDX-License-Identifier: Apache-2.0
"""Which functions need not be followed to the end, because they know nothing of ROS?

    nlohmann::json::patch(…)     of a library that lies among the sources: it takes a million steps, and creates nothing

What a function does that stands in a file that knows nothing of ROS, and is handed nothing but data, shows in its result and in that data.
Such functions are followed as any others, until they have taken many steps in all; from then on, those of them that take many are not: their
results, and what they were given, may be anything.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, External, Partial, Tuple, function_behind
from rosward.domain.slots import Pointer, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import TRUE, UNBOUND, Class, Const, Function, Ref, Text, Unknown, Value
from rosward.engine.calls import activation
from rosward.engine.cpp.enumerations import enumeration_of, scope_of
from rosward.engine.cpp.handing import is_a, is_constant, may_be_written
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.opaque import opaque
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import pointee
from rosward.engine.throwing import note_sources
from rosward.engine.unknown.escape import BY_LIBRARY
from rosward.engine.unknown.havoc import change_each
from rosward.engine.unknown.held import values_in
from rosward.ir.program import MODEL_PREFIX
from rosward.models.cpp.values.copies import LEFT, write
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.symbols import Scope, Symbol

_MANY: Final = 500
"""A call of fewer is always followed."""
_REACHED: Final = 3_000
"""So many objects may be handed to one that is not followed."""
_STD: Final = f"{MODEL_PREFIX}std/"
_PLAIN: Final = (Const, Text, Unknown)


def run(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """What a call gives: of its body, unless that is not followed."""
    program = linked(machine)
    precision, begun, most = machine.precision, machine.precision.steps, machine.budget.unaware
    if begun < most or machine.watch is not None or function.code.file not in program.symbols.unaware:
        return activation.invoke(machine, function, registers)
    effort, key = program.effort, function.code.key
    if key in effort.large and effort.spent(begun) >= most and _is_ordinary(machine, function):
        handed = _Handed(machine, program.symbols.unaware[function.code.file])
        if handed.is_data([*registers, *_types(machine, function.module)]):
            return _anything(machine, function, handed)
        effort.large.discard(key)  # it is asked again once it has taken many steps again
    outermost = effort.since is None
    if outermost:
        effort.since = begun
    try:
        return activation.invoke(machine, function, registers)
    finally:
        if precision.steps - begun > _MANY:
            effort.large.add(key)
        if outermost:
            effort.before, effort.since = effort.spent(precision.steps), None


def _types(machine: Engine, scope: Value) -> Iterator[Value]:
    """What the parameters of a class template stand for, and those of the templates that it is written in."""
    info = linked(machine).info(scope)
    while info is not None:
        yield from info.types
        info = linked(machine).info(info.outer)


def _is_ordinary(machine: Engine, function: Function) -> bool:
    """Whether it is no constructor, destructor or lambda."""
    symbol = linked(machine).declared.get(function.code.key)
    info = linked(machine).info(function.module)
    return symbol is not None and symbol.name[:1] != "~" and (info is None or symbol.name != info.symbol.name)


def _anything(machine: Engine, function: Function, handed: _Handed) -> Value:
    """What a call gives that is not followed; it may have written to whatever it was handed."""
    symbol = linked(machine).declared[function.code.key]
    name = f"{function.module.name}.{symbol.name}".removeprefix(".")
    change_each(machine, handed.objects, name)
    for slot in handed.slots:
        if may_be_written(machine, read(machine, slot)) and not is_constant(machine, slot):
            write(machine, slot, machine.unknown(Cause.CALL, name), weak=True)
            if isinstance(slot.base, Ref):
                _stay_open(machine, slot.base)
    for each in handed.objects:
        _stay_open(machine, each)
    note_sources(machine)
    if symbol.type is None:
        return machine.unknown(Cause.CALL, name)
    type_ = evaluate(machine, symbol.type, function.module)
    value = opaque(machine, type_, name)
    made = value.target if isinstance(value, Pointer) else value
    left = linked(machine).effort.left
    for ref in (*handed.objects, *((made,) if isinstance(made, Ref) else ())):
        left.setdefault(ref, machine.place)
    found = [value, *_led_to(machine, symbol, type_, handed)]
    if isinstance(made, Ref) and (symbol.reference or made is not value) and _has_virtual(machine, made):
        found.append(machine.unknown(Cause.CALL, name))  # one of a class that is derived from it
    return join_all(found)


def _stay_open(machine: Engine, ref: Ref) -> None:
    """From now on writes only add to what something holds: the call may have made others lead to it, which write to it by ways that nobody sees."""
    obj = machine.obj(ref)
    machine.update(ref, obj.with_attr(LEFT, TRUE) if obj.kind == "cell" else obj.replace(many=True))


def _has_virtual(machine: Engine, ref: Ref) -> bool:
    """Whether an object is of a class that others are derived from to be used as it."""
    cls = machine.obj(ref).cls
    infos = [linked(machine).info(base) for base in cls.mro] if isinstance(cls, Class) else []
    return any(member.virtual for info in infos if info is not None for member in info.symbol.members)


def follow_left(machine: Engine) -> None:
    """Run the functions that a program put into what was left to calls that were not followed, and that nothing else calls.

    Such a call may have made one object lead to another, so that the program comes to them by ways that nobody sees. Objects that are no
    data count as handed to code that is not known.
    """
    effort, entered, reached = linked(machine).effort, machine.trace.entered, _Handed(machine)
    for first, place in list(effort.left.items()):
        for value in reached.others(first):
            if isinstance(value, Ref):
                machine.trace.handed.setdefault(value, place)
            else:
                function = function_behind(value)
                if function is None or function.code.key not in entered:
                    machine.schedule(value, None, BY_LIBRARY, place)


def _led_to(machine: Engine, symbol: Symbol, type_: Value, handed: _Handed) -> Iterator[Value]:
    """The objects that a call was handed, where it may return a reference or pointer to them."""
    target = pointee(type_)
    cls = type_ if target is None else target
    if isinstance(cls, Class) and (symbol.reference or target is not None):
        for ref in handed.objects:
            if is_a(machine, ref, cls):
                yield ref if target is None else Pointer(ref)


class _Handed:
    """What a call can get hold of: objects, and places of single values."""

    def __init__(self, machine: Engine, foreign: frozenset[Scope] = frozenset()) -> None:
        self._machine = machine
        self._unaware = linked(machine).symbols.unaware
        self._foreign = set(foreign)  # what is of these namespaces leads to functions of theirs
        self._spaces: set[Scope] = set()  # of the classes and enumerations
        self.objects: dict[Ref, None] = {}
        self.slots: dict[Slot, None] = {}

    def is_data(self, values: Sequence[Value]) -> bool:
        """Whether nothing but data is reached from some values: no function, and no object whose class may know of ROS."""
        waiting = list(values)
        while waiting:
            for option in options(waiting.pop()):
                inner = self._inner(option)
                if inner is None or len(self.objects) > _REACHED:
                    return False
                waiting += inner
        return not any(scope[: len(space)] == space for space in self._foreign for scope in self._spaces)

    def others(self, first: Value) -> Iterator[Value]:
        """The functions that something leads to, and the objects that may know of ROS."""
        waiting = [first]
        while waiting:
            for option in options(waiting.pop()):
                inner = self._inner(option)
                if inner is not None:
                    waiting += inner
                elif isinstance(option, (Function, BoundMethod, Partial, Ref)):
                    yield option

    def _inner(self, value: Value) -> Iterable[Value] | None:
        """What a value leads to; None where it is not data."""
        if value is UNBOUND or isinstance(value, _PLAIN):
            self._spaces.add(scope_of(enumeration_of(value)))
            return ()
        if isinstance(value, (Class, External)):
            return self._inner_of_class(value)
        if isinstance(value, TypeOf):
            return value.arguments
        if isinstance(value, Tuple):
            return value.items
        if isinstance(value, Pointer):
            return (value.target,)
        if isinstance(value, Slot):
            return self._inner_of_slot(value)
        if not isinstance(value, Ref):
            return None
        if value in self.objects:
            return ()
        self.objects[value] = None
        obj = self._machine.obj(value)
        if obj.kind == "generator" or (obj.kind == "instance" and not self._is_unaware(obj.cls)):
            return None
        types = obj.cls.arguments if isinstance(obj.cls, TypeOf) else self._inner_of_class(obj.cls) or ()
        return (*values_in(obj), *types)

    def _inner_of_slot(self, slot: Slot) -> Iterable[Value]:
        if slot.kind in ("item", "entry", "reverse"):  # from there it may come to the others
            return (slot.base,)
        if slot in self.slots:
            return ()
        self.slots[slot] = None
        return (read(self._machine, slot),)

    def _inner_of_class(self, cls: Value) -> Iterable[Value] | None:
        """What the parameters of the templates stand for that a class is made of."""
        if not self._is_unaware(cls):
            return None
        return [type_ for base in cls.mro for type_ in _types(self._machine, base)] if isinstance(cls, Class) else ()

    def _is_unaware(self, cls: Value) -> bool:
        """Whether an object of a class knows nothing of ROS."""
        if not isinstance(cls, Class):
            self._spaces.add(tuple(cls.name.split(".")) if isinstance(cls, External) else ())
            return isinstance(cls, External) and not cls.name.startswith("rcl")
        for base in cls.mro:
            if not isinstance(base, Class):
                if not self._is_unaware(base):
                    return False
                continue
            file, info = base.place.file, linked(self._machine).info(base)
            if file not in self._unaware and not file.startswith(_STD):
                return False
            self._foreign |= self._unaware.get(file, frozenset())
            self._spaces.add(() if info is None else tuple(filter(None, info.scope)))
        return True
