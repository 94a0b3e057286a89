# SPDX-License-Identifier: Apache-2.0
"""Calls: what a callable value of C++ does with arguments.

f(x)                   of the functions of that name those that fit; a function of another namespace by the types of its arguments
talker_node(options)   a type makes a value of it
cv::imread(path)       nothing is known of it: what it is given by reference may be another afterwards
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.slots import Overloads, Pointer, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Choice, Class, Function, Ref, Unknown, Value
from rosward.engine.arguments import ANY
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.cpp import again, construct, guessing, members, names, unaware, visitors
from rosward.engine.cpp.binding import bind
from rosward.engine.cpp.categories import class_cast_to
from rosward.engine.cpp.comparing import COMPARED, made_up
from rosward.engine.cpp.handing import decayed, hand_over, is_member
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.natives import run_native
from rosward.engine.cpp.opaque import opaque
from rosward.engine.cpp.overloading import choose, fitting
from rosward.engine.cpp.specialising import specialised
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import dotted, is_type, type_of
from rosward.engine.cpp.values import function_of, overloads, used
from rosward.engine.python import calls as python_calls
from rosward.engine.unknown import declared
from rosward.engine.unknown.escape import name_of
from rosward.ir.symbols import SymbolKind
from rosward.models.cpp.c_functions import C_FUNCTIONS
from rosward.models.cpp.values.boxes import is_box, unboxed
from rosward.models.cpp.values.contents import has_content, within
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["call", "call_function", "invoke", "unknown_call"]

Arguments = tuple[Value, ...]
_NO_KEYWORDS: Final[Mapping[str, Value]] = {}


def call(machine: Engine, function: Value, args: Arguments, keywords: Mapping[str, Value]) -> Value:
    """A call from a native, or of something that was scheduled."""
    if function.__class__ is Function and function.code.language != machine.language.name:
        return machine.languages[function.code.language].call_function(machine, function, args, dict(keywords))
    return invoke(machine, function, args, keywords=keywords)


def call_native(machine: Engine, name: str, args: Arguments, keywords: Mapping[str, Value]) -> Value:
    """A builtin of Python, or a model in code, of what stands in the arguments."""
    return python_calls.call_native(machine, name, tuple(read(machine, a) for a in args), dict(keywords))


def invoke(
    machine: Engine,
    function: Value,
    args: Arguments,
    types: Arguments = (),
    keywords: Mapping[str, Value] = _NO_KEYWORDS,
) -> Value:
    """What is called gives; UNBOUND where it never returns. Arguments are slots where they are lvalues."""
    if isinstance(function, Slot):
        function = read(machine, function)
    if isinstance(function, Function):
        return _of_one(machine, function, args, types, keywords)
    if isinstance(function, Overloads):
        return _of_several(machine, function, args, types or function.types, keywords)
    if isinstance(function, BoundMethod):
        return invoke(machine, function.function, (function.receiver, *args), types, keywords)
    if isinstance(function, Partial):
        field = members.designated(machine, function, args)
        if field is not None:
            return field
        if visitors.is_visitor(function):
            fitting = visitors.chosen(machine, function, args)
            return each_apart(machine, fitting, lambda each: invoke(machine, each, args, types, keywords))
        inner, given = function.function, (*function.arguments, *args)
        if isinstance(inner, Function) and _leads(inner):  # `std::bind(&Lamp::on, this)`
            inner = Overloads(inner.code.name, (inner,), None, ())
        return invoke(machine, inner, given, types, {**keywords, **dict(function.keywords)})
    if isinstance(function, Choice):
        callees = [o for o in function.options if o != NONE] or list(function.options)
        return each_apart(machine, callees, lambda each: invoke(machine, each, args, types, keywords))
    if isinstance(function, (External, TypeOf)):
        return _of_library(machine, function, args, keywords)
    if isinstance(function, Native):
        return call_native(machine, function.name, args, keywords)
    if isinstance(function, Class):
        if ANY in keywords:
            return construct.make_of_anything(machine, function, keywords)
        return _fresh(machine, construct.make(machine, function, args, "paren"))
    if isinstance(function, Pointer):
        return invoke(machine, read(machine, function.target), args, types, keywords)
    if is_box(machine, function):
        return invoke(machine, read(machine, unboxed(machine, function)), args, types, keywords)
    if isinstance(function, Ref):
        called = _called(machine, function)
        if called is not None:
            return invoke(machine, called, args, types, keywords)
    return unknown_call(machine, function, args, types)


def _called(machine: Engine, ref: Ref) -> Value | None:
    """What is called of an object: its operator, or the function that it has in it by its base."""
    operator = members.member(machine, ref, "operator()", (), class_cast_to(machine, ref))
    if isinstance(operator, Overloads):
        return operator
    return read(machine, within(machine, ref)) if has_content(machine, ref) else None


def _of_one(
    machine: Engine, function: Function, args: Arguments, types: Arguments, keywords: Mapping[str, Value]
) -> Value:
    overridden = _overridden(machine, function, args) if args and is_member(function) else []
    if overridden:
        return each_apart(machine, overridden, lambda each: invoke(machine, each, args[1:], types, keywords))
    return call_function(machine, function, args, keywords, types)


def _of_several(
    machine: Engine, several: Overloads, args: Arguments, types: Arguments, keywords: Mapping[str, Value]
) -> Value:
    given = args
    functions: Sequence[Function] = several.functions
    if several.receiver is None and functions:
        functions = _without_object(machine, functions, args)
    if several.receiver is None and functions and _leads(functions[0]):  # a member function without its object
        overridden = _overridden(machine, functions[0], args)
        if overridden:
            return each_apart(machine, overridden, lambda each: invoke(machine, each, args[1:], types, keywords))
        given = args[1:]
    if several.receiver is None and args:
        functions = _of_arguments(machine, several, args) or functions
        library = _of_using(machine, several)
        if library is not None and not fitting(machine, functions, args):
            return invoke(machine, library, args, types, keywords)
    chosen = choose(machine, functions, given, types)
    if not chosen:
        return unknown_call(machine, External(several.name), args, types)

    def one(function: Function, given: Arguments = args) -> Value:
        receiver = (several.receiver,) if several.receiver is not None and _leads(function) else ()
        return call_function(machine, function, (*receiver, *given), keywords, types)

    if several.receiver is None and guessing.is_guess(machine, chosen, args):
        return guessing.each(machine, several.name, chosen, args, one)
    return one(chosen[0]) if len(chosen) == 1 else each_apart(machine, list(chosen), one)


def _without_object(machine: Engine, functions: Sequence[Function], args: Arguments) -> Sequence[Function]:
    """Those that are meant where nobody gives an object, as in `C::f(a, b)`: static ones, where one takes these arguments."""
    static = [f for f in functions if not _leads(f)]
    return static if len(static) < len(functions) and fitting(machine, static, args) else functions


_NESTED: Final = 4
"""So deep are types followed that templates are made of."""


def _of_arguments(machine: Engine, several: Overloads, args: Arguments) -> list[Function]:
    """The functions of that name in the namespaces of the arguments, where none of those that were found takes them."""
    first = several.functions[0] if several.functions else None
    if first is None or linked(machine).info(first.module) is not None:
        return []
    if not any(isinstance(machine.obj(a).cls, Class) for a in args if a.__class__ is Ref):
        return []
    here, name = linked(machine).scope_of(first.module), several.name.rpartition(".")[2]
    scopes = [scope for scope in dict.fromkeys(_namespaces(machine, args)) if scope != here]
    spaces = [names.in_namespace(machine, scope, name, names.seeing(machine)) for scope in scopes]
    others = [f for found in spaces if found is not None for f in overloads(machine, found, ()).functions]
    if not others or fitting(machine, several.functions, args):
        return []
    return fitting(machine, others, args)


def _of_using(machine: Engine, several: Overloads) -> Value | None:
    """The function of a library that a namespace has under the name of functions of its own: `using std::to_string;`."""
    first = several.functions[0] if several.functions else None
    if first is None or linked(machine).info(first.module) is not None:
        return None
    here = linked(machine).scope_of(first.module)
    found = names.in_namespace(machine, here, several.name.rpartition(".")[2], first.code.file)
    if found is None:
        return None
    named = (used(machine, found, s) for s in found.symbols if s.kind is SymbolKind.USING)
    return next((each for each in named if isinstance(each, External)), None)


def _overridden(machine: Engine, function: Function, args: Arguments) -> list[Value]:
    """What a pointer to a virtual member function calls: that of the class of each object. Empty where it is not virtual."""
    info, name = linked(machine).info(function.module), function.code.name
    if info is None or not args or not members.is_virtual(machine, info, name):
        return []
    held = [o.target if isinstance(o, Pointer) else o for o in options(read(machine, args[0]))]
    objects = [members.member(machine, o, name) for o in held if isinstance(o, Ref)]
    found: list[Value] = [m for m in objects if isinstance(m, Overloads) and m.receiver is not None]
    return found if len(found) == len(held) else []


def _leads(function: Function) -> bool:
    return function.code.signature is not None and function.code.signature.leading > 0


def call_function(
    machine: Engine, function: Function, args: Arguments, keywords: Mapping[str, Value], types: Arguments = ()
) -> Value:
    """A function of the program or of a model."""
    registers = bind(machine, function, args, types, keywords)
    special = _special(machine, function, registers)
    if special is not None:
        return call_function(machine, special, args, keywords)
    if function.code.is_stub:
        if machine.watch is not None:
            machine.watch.bound(machine, function, args, registers)
        return _without_body(machine, function, registers)
    if machine.watch is not None:
        machine.watch.bound(machine, function, args, registers)
    with _seen_as(machine, function, registers):
        value = unaware.run(machine, function, registers)
    signature = function.code.signature
    if signature is None or not signature.reference:
        return _fresh(machine, value)
    if machine.frames:
        machine.frames[-1].returned = value, function
    return value


@contextmanager
def _seen_as(machine: Engine, function: Function, registers: list[Value]) -> Iterator[None]:
    """A constructor of a base may call what the class that derives from it has (`static_cast<Derived &>(*this).topic()`), or another base."""
    constructing = linked(machine).constructing
    this = registers[0] if constructing and is_member(function) else None
    if not isinstance(this, Ref):
        yield
        return
    cls = next((cls for address, cls in reversed(constructing) if address == this.address), None)
    info = linked(machine).info(function.module)
    own = info.cls if info is not None else None
    if cls is None or own is None or own in cls.mro or not (cls in own.mro or _is_beside(machine, this, own)):
        yield
        return
    constructing.append((this.address, own))
    try:
        yield
    finally:
        constructing.pop()


def _is_beside(machine: Engine, this: Ref, own: Class) -> bool:
    """Whether a class is a base of an object, beside the one that is being made."""
    whole = machine.obj(this).cls
    return isinstance(whole, Class) and own in whole.mro


def _fresh(machine: Engine, value: Value) -> Value:
    """A value that nobody but the caller has."""
    again.hand_out(machine, value)
    if machine.frames:
        machine.frames[-1].fresh = value
    return value


def _special(machine: Engine, function: Function, registers: list[Value]) -> Function | None:
    """The specialisation of a template of a function that is there for what its parameters stand for."""
    signature = function.code.signature
    program = linked(machine)
    found = program.special.get((function.code.key, function.module.address))
    if found is None or signature is None:
        return None
    given = signature.types(registers)
    for symbol in found:
        if specialised(machine, symbol, function.module, given) == {}:
            return function_of(machine, symbol, function.module)
    return None


def _without_body(machine: Engine, function: Function, registers: list[Value]) -> Value:
    """A function that is only declared: what a library's does is nothing that matters; what any other does nobody knows."""
    symbol = linked(machine).declared[function.code.key]
    if symbol.name.startswith("~") and "default" in symbol.marks:
        return NONE
    if symbol.name in COMPARED and "default" in symbol.marks:
        return made_up(machine, symbol.name, function, registers)
    values = [v for v in registers if v is not UNBOUND]
    signature = function.code.signature
    name = f"{function.module.name}.{symbol.name}"
    if declared.is_model(function):
        machine.may_call([decayed(machine, v) for v in values])
    else:
        parameters = signature.parameters if signature is not None else ()
        given = registers[len(registers) - len(parameters) :]
        changed = [
            v
            for p, v in zip(parameters, given, strict=True)
            if p.type.reference and (p.type.pointers or not p.type.const)
        ]
        hand_over(machine, values, changed, name, informed=True)
    if symbol.type is None:
        return machine.unknown(Cause.CALL, name) if not symbol.name.startswith("~") else NONE
    return opaque(machine, evaluate(machine, symbol.type, function.module), name)


def _of_library(machine: Engine, function: External | TypeOf, args: Arguments, keywords: Mapping[str, Value]) -> Value:
    """Something that nothing declares: a native, a type, a function found by the types of its arguments; else it is not known."""
    name = function.name
    native = machine.library.native(name)
    if native is None and "." not in name:  # what C has, `std` has too
        native = machine.library.native(f"std.{name}")
    elif native is None:
        *scope, last = name.split(".")
        declared_there = names.in_namespace(machine, tuple(scope), last, "")
        if declared_there is not None:  # a model in code names a class, or function, of a model in C++
            value = linked(machine).value_of(machine, declared_there, None)
            if value != function:  # a `using` of the library in its own namespace
                return invoke(machine, value, args, keywords=keywords)
    if native is not None:
        named = dict(keywords)
        if isinstance(function, TypeOf):
            named["types"] = Tuple(function.arguments)
        return run_native(machine, native, name, args, named)
    if is_type(machine, function):
        return construct.make(machine, function, args, "paren")
    if "." not in name:
        found = _by_arguments(machine, name, args)
        if found is not None:
            types = function.arguments if isinstance(function, TypeOf) else ()
            return invoke(machine, found, args, types, keywords)
    return unknown_call(machine, function, args)


def _by_arguments(machine: Engine, name: str, args: Arguments) -> Value | None:
    """A function of the namespace of an argument."""
    for scope in dict.fromkeys(_namespaces(machine, args)):
        found = names.in_namespace(machine, scope, name, names.seeing(machine))
        if found is not None:
            return overloads(machine, found, ())
        library = External(f"{'.'.join(scope)}.{name}")
        if machine.library.native(library.name) is not None:
            return library
    return None


def _namespaces(machine: Engine, args: Arguments) -> Iterator[tuple[str, ...]]:
    """The namespaces of arguments, of their bases, and of what templates are made of: of M for a `std::vector<M>`."""
    for arg in args:
        for option in options(read(machine, arg)):
            yield from _namespaces_of(
                machine, type_of(machine, option.target if isinstance(option, Pointer) else option)
            )


def _namespaces_of(machine: Engine, type_: Value, depth: int = 0) -> Iterator[tuple[str, ...]]:
    for each in type_.mro if isinstance(type_, Class) else ():
        info = linked(machine).info(each)
        if info is not None:
            yield info.symbol.scope
    if not isinstance(type_, Class) and "." in dotted(type_):
        yield tuple(dotted(type_).split(".")[:-1])
    for inner in type_.arguments if isinstance(type_, TypeOf) and depth < _NESTED else ():
        yield from _namespaces_of(machine, inner, depth + 1)


def unknown_call(machine: Engine, function: Value, args: Arguments, types: Arguments = ()) -> Value:
    """Code that is not known gets hold of the arguments."""
    name = name_of(function)
    if isinstance(function, TypeOf):
        types = (*types, *function.arguments)
    changed = [a for a in args if isinstance(a, Slot)]
    hand_over(machine, args, changed, name, function, types, throws=name.removeprefix("std.") not in C_FUNCTIONS)
    return Unknown(function.reasons) if isinstance(function, Unknown) else machine.unknown(Cause.CALL, name)
