# SPDX-License-Identifier: Apache-2.0
"""Calls of member functions, on whatever stands before the dot.

lamp.on(), this->on()        the functions of its class; a field that can be called
text.append("x")             a native of the type of the value, with its slot
pointer.reset()              of the pointer itself
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import External, Native, Partial, Tuple
from rosward.domain.heap import KIND
from rosward.domain.slots import Overloads, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Function, Ref, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.cpp import access, assigning, assumed_nodes, calls, endings, members, names, operators
from rosward.engine.cpp.categories import for_object
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.natives import run_native
from rosward.engine.cpp.types import is_message, pointee
from rosward.engine.cpp.values import overloads
from rosward.engine.cpp.variants import of_variant
from rosward.engine.running.frame import Frame
from rosward.models.cpp.receivers import OF_PLACES
from rosward.models.cpp.values.contents import content_base, has_content, is_content, within
from rosward.models.cpp.values.copies import copied, write
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import method_types, name_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["invoke", "iterated"]


def invoke(
    machine: Engine,
    frame: Frame,
    owner: Value,
    name: str,
    args: tuple[Value, ...],
    types: tuple[Value, ...],
    *,
    scope: Value | None,
    own: bool,
    constant: bool = False,
    declared: Callable[[], Value] | None = None,
    given: str = "slot",
) -> Value:
    """`owner.name<types>(args)`; `scope`: `owner.Scope::name(args)`; `own`: of `this`; `constant`: of an object that is so;
    `declared` gives the type that it, or the pointer to it, is declared with; `given`: as what the object is there."""
    is_new = given == "value" or (given == "result" and owner == frame.handed)
    receivers = _receivers(machine, owner, name)

    def one(receiver: tuple[Value, Value]) -> Value:
        slot, option = receiver
        if len(receivers) > 1 and slot is not option:
            write(machine, slot, option)  # where it is this one
        return _of_one(
            machine,
            frame,
            slot,
            option,
            name,
            args,
            types,
            scope=scope,
            own=own,
            constant=constant,
            declared=declared,
            is_new=is_new,
        )

    return each_apart(machine, receivers, one)


def _receivers(machine: Engine, owner: Value, name: str) -> list[tuple[Value, Value]]:
    """What a method is called on: each value that stands before the dot, and where it stands, as far as that matters."""
    held = _but_none(read(machine, owner))
    if isinstance(owner, Slot) and len(held) == 1:
        return [(option if isinstance(option, Ref) else owner, option) for option in held]
    if not any(_takes_place(machine, option, name) for option in held):
        return [(option, option) for option in held]
    return [
        (place if isinstance(place, Slot) and _takes_place(machine, option, name) else option, option)
        for place in options(owner)
        for option in _but_none(read(machine, place))
    ]


def _but_none(value: Value) -> Sequence[Value]:
    return [o for o in options(value) if o != NONE] or [value]


def _takes_place(machine: Engine, value: Value, name: str) -> bool:
    """Whether a method may put another value in place of this one, or lead to where it stands."""
    if isinstance(value, Ref):
        return False
    natives = [f"{t}.{name}" for t in method_types(machine, value)]
    known = [n for n in natives if machine.library.native(n) is not None]
    return not known or known[0] in OF_PLACES


def _is_apart(machine: Engine, ref: Ref) -> bool:
    """Whether the bases that nobody knows know nothing of an object but what is theirs: they are told of no class that derives from them.

    What the object overrides of them they may call from its construction on.
    """
    cls = machine.part(ref, KIND).cls
    told = (a for b in (cls.mro if isinstance(cls, Class) else ()) if isinstance(b, TypeOf) for a in b.arguments)
    return not any(isinstance(each, Class) for each in told)


_OF_VARIANTS: Final = frozenset({"index", "emplace", "has_value", "type", "valueless_by_exception"})


def _of_one(
    machine: Engine,
    frame: Frame,
    slot: Value,
    value: Value,
    name: str,
    args: tuple[Value, ...],
    types: tuple[Value, ...],
    *,
    scope: Value | None,
    own: bool,
    constant: bool,
    declared: Callable[[], Value] | None,
    is_new: bool,
) -> Value:
    if name in _OF_VARIANTS:
        found = of_variant(machine, slot, value, name, args, types, declared)
        if found is not None:
            return found
    if isinstance(value, Ref) and isinstance(machine.part(value, KIND).cls, Class):
        if scope is None and declared is not None and not own:
            scope = _hiding(machine, value, name, declared)
        function = _of_scope(machine, value, name, types, scope) if scope is not None else None
        if function is None:
            function = access.member(machine, frame, value, name, types, own=own)
        if isinstance(function, External | Unknown) and isinstance(value, Ref):
            given = args if isinstance(function, External) and _is_apart(machine, value) else (value, *args)
            return calls.unknown_call(machine, function, given, types)
        if isinstance(function, Overloads):
            function = for_object(function, constant=constant, is_new=is_new)
        return calls.invoke(machine, access.value(machine, function), args, types)
    if (
        types and name == "operator()" and isinstance(value, (Function, Partial))
    ):  # `build.template operator()<Lidar>()`
        return calls.invoke(machine, value, args, types)
    for type_name in method_types(machine, value):
        native = machine.library.native(f"{type_name}.{name}")
        if native is not None:
            keywords: dict[str, Value] = {"types": Tuple(types)} if types else {}
            if not endings.end_with(machine, f"{type_name}.{name}", value):
                return UNBOUND
            return run_native(machine, native, f"{type_name}.{name}", (slot, *args), keywords)
    if isinstance(value, Ref):
        cls = machine.obj(value).cls
        if is_message(cls) or name in machine.obj(value).attrs:  # what can be called is in a field: `entry->second()`
            field = read(machine, Slot(value, "field", name))
            return calls.invoke(machine, field, args) if not isinstance(field, Unknown) else field
        return calls.unknown_call(machine, External(f"{name_of(cls)}.{name}"), (value, *args), types)
    if isinstance(value, (Class, TypeOf, Native)):
        return calls.unknown_call(machine, External(f"{name_of(value)}.{name}"), args, types)
    of_node = assumed_nodes.method(machine, value, name, types) if isinstance(value, (Unknown, External)) else None
    if of_node is not None:
        return calls.invoke(machine, of_node, args, types)
    return calls.unknown_call(machine, value if isinstance(value, Unknown) else External(name), (slot, *args), types)


def _hiding(machine: Engine, value: Ref, name: str, declared: Callable[[], Value]) -> Value | None:
    """The base that an object is declared as, where the class that it has hides a function of it that is not virtual."""
    program = linked(machine)
    cls = program.class_of(machine, value)
    key = (cls.address, name) if isinstance(cls, Class) else None
    if key is None or not isinstance(cls, Class):
        return None
    if key not in program.hiding:
        infos = [i for base in cls.mro if (i := program.info(base)) is not None]
        with_name = [i for i in infos if program.members(i, name)]
        many = len(with_name) + (content_base(cls) is not None)
        program.hiding[key] = bool(with_name) and many > 1 and not members.is_virtual(machine, with_name[-1], name)
    if not program.hiding[key]:
        return None
    type_ = declared()
    target = pointee(type_)
    seen = target if target is not None else type_
    return seen if (isinstance(seen, Class) or is_content(seen)) and seen != cls and seen in cls.mro else None


def _of_scope(machine: Engine, value: Ref, name: str, types: tuple[Value, ...], scope: Value | None) -> Value | None:
    if scope is not None and is_content(scope) and has_content(machine, value):
        return members.of_content(machine, within(machine, value), name)
    info = linked(machine).info(scope) if scope is not None else None
    found = names.in_class(machine, info, name) if info is not None else None
    return overloads(machine, found, types, value) if found is not None else None


_TURNS: Final = 300
"""How many elements of an own kind of range are told apart."""


def iterated(machine: Engine, value: Value) -> Value:
    """What a loop runs over: of a class with `begin` and `end` what these lead into, or a tuple of what its own iterators give."""
    held = read(machine, value)
    if isinstance(held, Ref) and isinstance(machine.obj(held).cls, Class):
        begin, end = (members.member(machine, held, name) for name in ("begin", "end"))
        if isinstance(begin, Overloads):
            found = calls.invoke(machine, begin, ())
            if isinstance(found, Ref) and isinstance(machine.obj(found).cls, Class):
                return _walked(machine, copied(machine, found), calls.invoke(machine, end, ()))
            target = getattr(found, "target", None)
            return target.base if isinstance(target, Slot) else found
        return within(machine, held)
    return value


def _walked(machine: Engine, iterator: Value, end: Value) -> Value:
    """What an iterator of a class of the program gives, until it is at the end."""
    items: list[Value] = []
    for _ in range(_TURNS):
        more = operators.truth(machine, operators.compare(machine, "!=", iterator, end))
        if more is False:
            return Tuple(tuple(items))
        item = access.deref(machine, iterator)
        if more is None or item is UNBOUND:
            break
        items.append(copied(machine, item))
        if assigning.step(machine, "++", iterator, prefix=True) is UNBOUND:
            break
    return machine.unknown(Cause.LOOP, "")
