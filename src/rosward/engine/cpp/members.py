# SPDX-License-Identifier: Apache-2.0
"""What has an object under a name: a field and where it stands, the functions of its class?

lamp.state        Slot(Ref(7), 'field', 'state')
lamp.on           the functions `on` of the class that the object has now, with the object
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Partial
from rosward.domain.slots import Overloads, Pointer, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Class, Const, Ref, Unknown, Value
from rosward.engine.cpp import assumed_nodes, names
from rosward.engine.cpp.handing import is_foreign
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.types import dotted, is_message, type_of
from rosward.engine.cpp.values import overloads, value_of, variable
from rosward.ir.symbols import SymbolKind
from rosward.models.cpp.constants import known_name
from rosward.models.cpp.values.contents import has_content, within
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import method_types
from rosward.models.cpp.values.unions import take_member

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["designated", "designator", "is_field", "is_virtual", "member", "members", "of_content"]


def members(
    machine: Engine, owner: Value, name: str, types: tuple[Value, ...] = (), lexical: Info | None = None
) -> Value:
    """`owner.name` for each object that `owner` may be: slots, objects, functions; `owner` is a slot or object."""
    found = [member(machine, option, name, types, lexical) for option in options(read(machine, owner))]
    return join_all(found)


def member(
    machine: Engine, owner: Value, name: str, types: tuple[Value, ...] = (), lexical: Info | None = None
) -> Value:
    """`owner.name`, its slot where it is a field. `lexical`: seen from inside of that class."""
    if isinstance(owner, Pointer) and isinstance(
        owner.target, Ref
    ):  # a method of the object by mistake, or of a pointer that is none
        owner = owner.target
    if not isinstance(owner, Ref):
        known = known_name(f"{dotted(type_of(machine, owner))}.{name}", None)  # `text.npos`
        return known or (owner if isinstance(owner, Unknown) else machine.unknown(Cause.OPERATION, f"member {name}"))
    program = linked(machine)
    cls = program.class_of(machine, owner)
    info = program.info(cls)
    if info is None:
        return Slot(owner, "field", name)
    seen = info
    if lexical is not None and lexical.cls is not None and isinstance(cls, Class) and lexical.cls in cls.mro:
        seen = lexical
    of = seen if name in seen.keys else info
    key = of.keys.get(name)
    if key is not None:
        if program.clashes:
            key = program.key_in(machine, owner, of, name) or key
        return _field(machine, owner, key, info)
    found = names.in_class(machine, seen, name)
    if (
        found is not None
        and seen is not info
        and found.symbols[0].kind is SymbolKind.FUNCTION
        and is_virtual(machine, seen, name)
    ):
        found = names.in_class(machine, info, name) or found
    if found is None:
        found = names.in_class(machine, info, name)
    if found is None:
        whole = program.info(machine.obj(owner).cls)
        derived = names.in_class(machine, whole, name) if whole is not None and whole is not info else None
        if derived is None:
            return _from_outside(machine, owner, cls, name, types)
        found = derived  # a base sees what derives from it by a cast
    kind = found.symbols[0].kind
    if kind in {SymbolKind.FUNCTION, SymbolKind.USING}:
        functions = overloads(machine, found, types, owner)
        if functions.functions:
            return functions
        native = _native_of(machine, within(machine, owner), name) if has_content(machine, owner) else None
        if native is not None:  # `using std::vector<T>::push_back`
            return native
    if kind is SymbolKind.VARIABLE:
        return variable(machine, found)
    value = value_of(machine, found, types or None)
    return value.of(owner) if isinstance(value, Overloads) else value


_DESIGNATOR: Final = External("<field>")


def is_field(found: names.Found) -> bool:
    """Whether a declaration is that of a field, of which each object has one."""
    first = found.symbols[0]
    return found.owner is not None and first.kind is SymbolKind.VARIABLE and not first.static


def designator(name: str) -> Partial:
    """`&Lamp::on` of a field: called with an object, it gives the field of that."""
    return Partial(_DESIGNATOR, (Const(name),), ())


def designated(machine: Engine, value: Partial, args: tuple[Value, ...]) -> Value | None:
    """The field that such a designator and an object give; None for what is none."""
    if value.function != _DESIGNATOR or not args:
        return None
    held = read(machine, args[0])
    objects = join_all(o.target if isinstance(o, Pointer) else o for o in options(held))
    name = value.arguments[0]
    return members(machine, objects, str(name.value) if isinstance(name, Const) else "")


def _field(machine: Engine, owner: Ref, key: str, info: Info) -> Value:
    """The slot of a field; an object that stands there itself; where a reference leads."""
    if key in info.doubled:
        return machine.unknown(Cause.OPERATION, f"field `{key}` of several bases")
    if info.shares:
        take_member(machine, owner, key)
    held = machine.part(owner, key).attrs.get(key, UNBOUND)
    if held is not UNBOUND and all(isinstance(o, (Ref, Slot)) for o in options(held)):
        return held
    return Slot(owner, "field", key)


def is_virtual(machine: Engine, info: Info, name: str) -> bool:
    """Whether a member function is virtual, in a class or a base of it."""
    program = linked(machine)
    for cls in info.cls.mro if info.cls is not None else ():
        own = program.info(cls)
        if own is not None and any(s.virtual for s in program.members(own, name)):
            return True
    return False


def of_content(machine: Engine, place: Value, name: str) -> Value:
    """What the content of an object has under a name: a native, with where that stands."""
    native = _native_of(machine, place, name)
    if native is not None:
        return native
    return member(machine, place, name) if isinstance(place, Ref) else machine.unknown(Cause.ERROR, f"member {name}")


def _native_of(machine: Engine, place: Value, name: str) -> Value | None:
    for type_ in (t for option in options(read(machine, place)) for t in method_types(machine, option)):
        if machine.library.native(f"{type_}.{name}") is not None:
            return Partial(External(f"{type_}.{name}"), (place,), ())
    return None


def _from_outside(machine: Engine, owner: Ref, cls: Value, name: str, types: tuple[Value, ...]) -> Value:
    """What no class of the program has, a base from elsewhere may: a native, with the object, where there is one."""
    outside = [b for b in cls.mro if not isinstance(b, Class)] if isinstance(cls, Class) else []
    if any(map(is_message, outside)):
        return Slot(owner, "field", name)
    if has_content(machine, owner):
        return of_content(machine, within(machine, owner), name)
    libraries = [External(f"{b.name}.{name}") for b in outside if isinstance(b, (External, TypeOf))]
    for function in libraries:
        if machine.library.native(function.name) is not None:
            return Partial(function, (owner,), ())
    of_node = assumed_nodes.method(machine, owner, name, types) if any(map(is_foreign, outside)) else None
    if of_node is not None:
        return of_node
    if libraries:
        return libraries[0]
    unknown = next((b for b in outside if isinstance(b, Unknown)), None)
    if unknown is not None:
        return unknown
    subject = f"{cls.name}.{name}" if isinstance(cls, Class) else name
    return machine.unknown(Cause.ERROR, f"member {subject}")
