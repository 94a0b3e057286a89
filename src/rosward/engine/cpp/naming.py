# SPDX-License-Identifier: Apache-2.0
"""A name in the code of a function: the member of `this`, a variable and its slot, functions, a type."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Partial
from rosward.domain.heap import KIND
from rosward.domain.slots import Overloads, Slot, TypeOf
from rosward.domain.values import NONE, Class, ModuleValue, Ref, Unknown, Value
from rosward.engine.cpp import access, detection, members, names
from rosward.engine.cpp.categories import of_constness
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.names import Found
from rosward.engine.cpp.static_types import of_found
from rosward.engine.cpp.values import overloads, value_of, variable
from rosward.engine.running.frame import Frame
from rosward.ir import cpp, ops
from rosward.ir.cpp_names import CALLED
from rosward.ir.symbols import SymbolKind
from rosward.models.cpp.facts import GENERIC
from rosward.models.cpp.values.contents import content_base, has_content, within
from rosward.models.cpp.values.traits import NO_TYPE
from rosward.models.cpp.values.types import name_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["declared_type", "name", "note_reached", "this_of"]


def name(machine: Engine, op: cpp.Name, frame: Frame) -> Value:
    """What a name is where the code stands; of a variable its slot where that is asked for."""
    plain = op.base == ops.NO_REGISTER and all(p.arguments is None for p in op.parts)
    found, types = _remembered(machine, op, frame) if plain else _resolved(machine, op, frame)
    qualified = len(op.parts) > 1 or op.absolute or op.base != ops.NO_REGISTER
    if op.designator and isinstance(found, Found) and members.is_field(found):
        value: Value = members.designator(found.symbols[0].name)
    elif isinstance(found, Found):
        value = _declared(machine, frame, found, types, qualified=qualified)
    elif op.base != ops.NO_REGISTER and isinstance(found, External) and _is_absent(machine, op, frame):
        value = NO_TYPE
    else:
        value = _of_content(machine, frame, found) if qualified else _not_declared(machine, frame, found)
    return value if op.slot else access.value(machine, value)


def note_reached(machine: Engine, name: str, frame: Frame) -> None:
    """The operation that runs names a method: it is known to be reached if that creates entities."""
    if name in machine.library.creating or name in GENERIC:
        machine.trace.reached.add((frame.code.key, frame.op.number))


def _is_absent(machine: Engine, op: cpp.Name, frame: Frame) -> bool:
    """Whether a parameter of a template stands for a class that surely has no such member (`typename T::Config`)."""
    cls = frame.registers[op.base]
    return len(op.parts) == 1 and isinstance(cls, Class) and detection.lacks(machine, cls, op.parts[0].name)


Resolved = tuple[Found | Value, tuple[Value, ...] | None]
"""What a name stands for, and the template arguments of its last part."""


def _remembered(machine: Engine, op: cpp.Name, frame: Frame) -> Resolved:
    """A name without template arguments stands for the same each time that code of the same scope asks."""
    known = linked(machine).found
    key = (frame.module.address, frame.code.key, op.number)
    found = known.get(key)
    if found is None:
        resolved = _resolved(machine, op, frame)
        if not isinstance(resolved[0], Unknown):
            known[key] = resolved
        return resolved
    return found  # type: ignore[return-value]  # under such a key stands what this function gave


def _resolved(machine: Engine, op: cpp.Name, frame: Frame) -> Resolved:
    parts = [
        names.Part(p.name, access.types_of(frame, p.arguments) if p.arguments is not None else None) for p in op.parts
    ]
    base = frame.registers[op.base] if op.base != ops.NO_REGISTER else None
    env = ModuleValue(frame.module.address, frame.module.name, frame.code.file)
    signature = frame.code.signature
    using, called = (signature.using, signature.called) if signature is not None else ((), ())
    types = parts[-1].types
    if parts[0].name in called and parts[0].types is None and base is None and not op.absolute:
        base = _argument_around(machine, env, called.index(parts[0].name))
        if base is not None and len(parts) == 1:
            return base, types
        parts = parts if base is None else parts[1:]
    return names.resolve(machine, env, parts, base=base, absolute=op.absolute, using=using), types


def _argument_around(machine: Engine, env: ModuleValue, number: int) -> Value | None:
    """What the parameter of the class template around a place stands for, by its number."""
    here: ModuleValue | None = env
    while here is not None:
        info = linked(machine).info(here)
        if info is not None and info.bindings:
            return info.argument(number)
        here = names.outer_of(machine, here)
    return None


def declared_type(machine: Engine, name: str, frame: Frame) -> Value:
    """The type that a field or variable is declared with; none where none is written."""
    env = ModuleValue(frame.module.address, frame.module.name, frame.code.file)
    found = names.unqualified(machine, env, name.removesuffix(CALLED))
    called = name.endswith(CALLED)
    if not isinstance(found, Found) or (called and _may_be_another(machine, found, name.removesuffix(CALLED))):
        return NONE
    return of_found(machine, found, called=called)


def _may_be_another(machine: Engine, found: Found, name: str) -> bool:
    """Whether a call may mean a function of the namespace of an argument instead."""
    if found.owner is not None or not any(s.parameters for s in found.symbols):
        return False
    program = linked(machine)
    return program.symbols.is_elsewhere(program.scope_of(found.env), name)


def this_of(frame: Frame) -> tuple[Ref, ...]:
    """The object of the member function that runs, or of the one around a lambda; several where it is followed for several calls at once."""
    signature = frame.code.signature
    if signature is None or not signature.leading or frame.code.parameters.positional[0] != "this":
        return ()
    return tuple(o for o in options(frame.registers[0]) if isinstance(o, Ref))


def _declared(
    machine: Engine, frame: Frame, found: Found, types: tuple[Value, ...] | None, *, qualified: bool
) -> Value:
    first = found.symbols[0]
    owner = found.owner
    objects = [o for o in this_of(frame) if _is_of(machine, o, owner)] if owner is not None else []
    if objects:
        if first.kind is SymbolKind.FUNCTION and qualified:  # Base::f(): that one, whatever the object is
            return join_all(overloads(machine, found, types or (), o) for o in objects)
        if first.kind in {SymbolKind.FUNCTION, SymbolKind.USING} or (
            first.kind is SymbolKind.VARIABLE and not first.static
        ):
            lexical = owner if qualified else linked(machine).info(frame.module)
            signature = frame.code.signature
            constant = signature is not None and signature.constant

            def one(this: Ref) -> Value:
                member = members.member(machine, this, first.name, types or (), lexical or owner)
                return of_constness(member, constant=constant) if isinstance(member, Overloads) else member

            return join_all(map(one, objects))
    if first.kind is SymbolKind.VARIABLE:
        return variable(machine, found, types)
    return value_of(machine, found, types)


def _is_of(machine: Engine, this: Ref, owner: Info) -> bool:
    cls = machine.part(this, KIND).cls
    return isinstance(cls, Class) and owner.cls in cls.mro


def _of_content(machine: Engine, frame: Frame, found: Value) -> Value:
    """`std::vector<T>::push_back` is that of the object around, where its class derives from that; anything else as it is."""
    if not isinstance(found, (External, TypeOf)) or not found.name.startswith("std."):
        return found
    base, _, last = found.name.rpartition(".")
    objects = [o for o in this_of(frame) if has_content(machine, o)]
    own = [o for o in objects if name_of(content_base(machine.part(o, KIND).cls) or NONE) == base]
    return join_all(members.of_content(machine, within(machine, o), last) for o in own) if own else found


def _not_declared(machine: Engine, frame: Frame, found: Value) -> Value:
    """What nothing declares may come from a base that is not among the sources."""
    if not isinstance(found, (External, TypeOf)) or "." in found.name or machine.library.native(found.name):
        return found
    types = found.arguments if isinstance(found, TypeOf) else ()
    inherited = [members.member(machine, this, found.name, types) for this in this_of(frame)]
    usable = [i for i in inherited if isinstance(i, (External, Overloads, Partial, Slot))]
    return join_all(usable) if usable else found
