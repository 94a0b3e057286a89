# SPDX-License-Identifier: Apache-2.0
"""What does code that is not known do with what it gets hold of?

vendor::Bus bus(port, &handler);      `port` may be another text afterwards; what the handler holds may change, and its functions be called
connect(&Window::on_click, this);     a member function together with an object is called on that
factory.register_type<Say>("Say");    a Say may be made, with anything
vendor::Link<Say> link(say);          here it says what is given: none is made
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, External
from rosward.domain.heap import Obj
from rosward.domain.series import Series
from rosward.domain.slots import Overloads, Pointer, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import Choice, Class, Function, ModuleValue, Ref, Value
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.types import is_message
from rosward.engine.cpp.values import function_of
from rosward.engine.throwing import note_call
from rosward.engine.unknown.escape import BY_BASE, name_of
from rosward.engine.unknown.havoc import change
from rosward.ir.symbols import Symbol, SymbolKind
from rosward.models.cpp.algorithms.ranges import emit, is_inserter
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = [
    "bare",
    "decayed",
    "give_to",
    "hand_over",
    "is_a",
    "is_constant",
    "is_foreign",
    "is_member",
    "is_open",
    "may_be_written",
    "objects_of",
    "own_functions",
    "watch",
]


def hand_over(
    machine: Engine,
    values: Sequence[Value],
    changed: Sequence[Value],
    name: str,
    callee: Value | None = None,
    types: Sequence[Value] = (),
    *,
    informed: bool = False,
    throws: bool = True,
) -> None:
    """Unknown code called `name` gets values, may write to those in `changed`, and make objects of the types that it is told of.

    `informed`: it is declared among the sources, so it may know every class of the program. `throws`: it may.
    """
    if machine.watch is not None:
        machine.watch.strange(name)
    held = _bound(machine, [bare(machine, v) for v in values])
    made = [t for t in types if isinstance(t, Class) and not any(is_a(machine, o, t) for v in held for o in options(v))]
    machine.escape((*held, *made), name, callee)
    for value in held if informed else ():
        change(machine, value, name, informed=True)
    for each in (o for v in values for o in options(read(machine, v)) if is_inserter(o)):
        emit(machine, each, Series((), machine.unknown(Cause.CALL, name)))
    pointers = [o for v in values for o in options(read(machine, v)) if isinstance(o, Pointer)]
    reached = [o.target for o in pointers if isinstance(o.target, Slot)]
    for slot in (*changed, *(each for place in reached for each in _from_there(machine, place))):
        if isinstance(slot, Slot) and may_be_written(machine, read(machine, slot)) and not is_constant(machine, slot):
            write(machine, slot, machine.unknown(Cause.CALL, name), weak=True)
    if throws:
        note_call(machine)  # now, or before it wrote anything: what it may have written covers both


def is_a(machine: Engine, value: Value, cls: Class) -> bool:
    """Whether a value is an object of a class, or of one that derives from it."""
    own = machine.obj(value).cls if isinstance(value, Ref) else None
    return isinstance(own, Class) and cls in own.mro


def _from_there(machine: Engine, slot: Slot) -> Iterable[Slot]:
    """Where code may write that is given a pointer: of an element of a container, or of an array, also to the others."""
    base = slot.base
    if not isinstance(base, Ref) or slot.kind not in ("item", "entry", "reverse"):
        return (slot,)
    obj = machine.obj(base)
    if obj.kind == "dict":
        return [Slot(base, "item", key) for key in obj.entries]
    return (Slot(base, "item", machine.unknown(Cause.CALL, "element", "int")),) if obj.kind == "list" else (slot,)


def give_to(machine: Engine, args: Sequence[Value], type_: Value) -> None:
    """A type of a library gets hold of the arguments of its constructor. Those of std change none."""
    if args or isinstance(type_, TypeOf):
        name = name_of(type_)
        changed = [] if name.startswith("std.") else [a for a in args if isinstance(a, Slot)]
        hand_over(machine, args, changed, name, type_, type_.arguments if isinstance(type_, TypeOf) else ())


def may_be_written(machine: Engine, held: Value) -> bool:
    """Whether unknown code may put something else in place of a value: no object is replaced, nor a pointer to a node."""
    if isinstance(held, Ref):
        return False
    return not (isinstance(held, Pointer) and isinstance(held.target, Ref) and machine.is_node(held.target.address))


def is_constant(machine: Engine, slot: Slot) -> bool:
    """Whether nobody may write where a slot leads: to a constant of a namespace, a field that is `const`."""
    if slot.kind != "field" or not isinstance(slot.base, Ref):
        return False
    program = linked(machine)
    obj = machine.obj(slot.base)
    info = program.info(obj.cls) if obj.kind == "instance" else None
    if info is not None:
        return any(f.constant and info.keys.get(f.name) == slot.key for f in info.fields)
    return (slot.base.address, slot.key) in program.fixed


def bare(machine: Engine, value: Value) -> Value:
    """A value as whoever looks at it from outside sees it: what a slot or pointer leads to."""
    value = decayed(machine, value)
    return value.target if isinstance(value, Pointer) and isinstance(value.target, Ref) else value


def decayed(machine: Engine, value: Value) -> Value:
    """The value at a slot; functions of one name as functions that can be called."""
    value = read(machine, value)
    if isinstance(value, Overloads):
        functions: list[Value] = [
            BoundMethod(value.receiver, f) if value.receiver is not None and _leads(f) else f for f in value.functions
        ]
        return (
            functions[0]
            if len(functions) == 1
            else machine.unknown(Cause.CALL, value.name)
            if not functions
            else Choice(tuple(functions))
        )
    return value


def _leads(function: Function) -> bool:
    return function.code.signature is not None and function.code.signature.leading > 0


def is_member(function: Value) -> bool:
    """Whether a function wants the object first that it is a member of."""
    return isinstance(function, Function) and _leads(function) and function.code.parameters.positional[:1] == ("this",)


def _bound(machine: Engine, values: list[Value]) -> list[Value]:
    """The values, with each member function on the objects of its class that stand beside it."""
    if not any(is_member(o) for v in values for o in options(v)):
        return values
    objects = [o for v in values for o in options(v) if isinstance(o, Ref)]
    found: list[Value] = []
    for value in values:
        for option in options(value):
            fitting = (
                objects_of(machine, option.module, objects)
                if isinstance(option, Function) and is_member(option)
                else []
            )
            found += [BoundMethod(o, option) for o in fitting] or [option]
    return found


def objects_of(machine: Engine, scope: ModuleValue, objects: Sequence[Value]) -> list[Ref]:
    """Those that are of the class with that scope, or derive from it."""
    info = linked(machine).info(scope)
    if info is None:
        return []
    found: list[Ref] = []
    for ref in objects:
        if isinstance(ref, Ref) and info.cls is not None and is_a(machine, ref, info.cls):
            found.append(ref)
    return found


def own_functions(machine: Engine, cls: Class) -> Iterator[tuple[Symbol, Function]]:
    """The member functions that the sources define, which others may call on an object; templates need more than an object."""
    for base in cls.mro:
        info = linked(machine).info(base)
        if info is None or (isinstance(base, Class) and base.stub):
            continue
        for symbol in info.symbol.members:
            if symbol.kind is SymbolKind.FUNCTION and _is_ordinary(info, symbol):
                for whole in linked(machine).members(info, symbol.name):
                    if whole.kind is SymbolKind.FUNCTION and whole.code is not None:
                        yield whole, function_of(machine, whole, info.env)


def _is_ordinary(info: Info, symbol: Symbol) -> bool:
    name = symbol.name
    return (
        not symbol.static
        and symbol.template is None
        and name != info.symbol.name
        and name[:1] != "~"
        and not name.startswith("operator")
    )


def watch(machine: Engine, cls: Class, ref: Ref) -> None:
    """A base that is not known may call what an object overrides of it, with anything; other functions, where nothing else calls them."""
    if not any(is_foreign(base) for base in cls.mro):
        return
    machine.trace.handed.setdefault(ref, machine.place)
    for symbol, function in own_functions(machine, cls):
        if symbol.virtual:
            machine.schedule(BoundMethod(ref, function), None, BY_BASE)


def is_open(machine: Engine, obj: Obj) -> bool:
    """Whether code that knows nothing of a class may change the fields of an object: of one that has fields alone, by a template; of any
    other a library has only what it declares itself."""
    info = linked(machine).info(obj.cls)
    if info is None or (isinstance(obj.cls, Class) and obj.cls.stub):
        return True
    return not info.symbol.bases and all(s.kind is not SymbolKind.FUNCTION or s.static for s in info.symbol.members)


_HARMLESS = ("std.", "boost.noncopyable", "boost.enable_shared_from_this")
"""How the names of bases begin that call nothing of what derives from them. Nor does a message."""


def is_foreign(base: Value) -> bool:
    """Whether nothing is known of a base class."""
    if isinstance(base, Class) or is_message(base):
        return False
    return not isinstance(base, (External, TypeOf)) or not base.name.startswith(_HARMLESS)
