# SPDX-License-Identifier: Apache-2.0
"""What is the thing that a declaration declares: a class, a variable and where it stands, functions to choose from, a type?"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all
from rosward.domain.compound import External
from rosward.domain.slots import Overloads, Slot
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Function, ModuleValue, Ref, Unknown, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.classes import bind_template, class_of, is_text_array
from rosward.engine.cpp.enumerations import of_enumeration
from rosward.engine.cpp.linked import Info, linked, record
from rosward.engine.cpp.names import Found
from rosward.engine.cpp.specialising import meant_for
from rosward.engine.cpp.thunks import evaluate
from rosward.ir.program import CPP, Code, CodeKind, Parameters
from rosward.ir.symbols import Signature, Symbol, SymbolKind
from rosward.models.cpp.values.conversions import default_value

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["constant", "function_of", "overloads", "used", "value_of", "variable", "versions"]

_DEPTH: Final = 20


def value_of(machine: Engine, found: Found | Value, types: tuple[Value, ...] | None) -> Value:
    """The value of what was found; of a variable, what it holds."""
    if not isinstance(found, Found):
        return found
    first = found.symbols[0]
    if first.kind is SymbolKind.CLASS:
        return class_of(machine, found, types)
    if first.kind is SymbolKind.FUNCTION or (first.kind is SymbolKind.USING and _has_functions(found)):
        return overloads(machine, found, types or ())
    if first.kind is SymbolKind.VARIABLE:
        slot = variable(machine, found, types)
        if isinstance(slot, Slot) and isinstance(slot.base, Ref):
            return record(machine, slot.base.address).attrs.get(str(slot.key), NONE)
        return slot
    if first.kind is SymbolKind.ENUMERATOR:
        return constant(machine, first, found.env)
    if first.kind is SymbolKind.ENUM:
        return External(".".join(n for n in (*first.scope, first.name)))
    if first.kind is SymbolKind.ALIAS:
        return join_all(_alias(machine, symbol, found.env, types) for symbol in versions(found.symbols, first))
    return _using(machine, found, first, types)


def _has_functions(found: Found) -> bool:
    """Whether there are functions beside those that a `using lib::f;` or `using Base::f;` names."""
    return any(s.kind is SymbolKind.FUNCTION for s in found.symbols)


def versions(symbols: Sequence[Symbol], first: Symbol) -> list[Symbol]:
    """A declaration, and the others of which the preprocessor may leave one in its place."""
    if first.sure:
        return [first]
    return [s for s in symbols if s is first or (s.name == first.name and s.kind is first.kind and not s.sure)]


def _alias(machine: Engine, symbol: Symbol, env: ModuleValue, types: tuple[Value, ...] | None) -> Value:
    if symbol.code is None:
        return machine.unknown(Cause.ERROR, symbol.name)
    if symbol.template:
        bindings = bind_template(machine, symbol.template, types or (), env)
        return evaluate(machine, symbol.code, env, types=tuple(bindings[p.name] for p in symbol.template))
    return constant(machine, symbol, env)


def constant(machine: Engine, symbol: Symbol, env: ModuleValue) -> Value:
    """A type or number that never changes: computed once."""
    program = linked(machine)
    key = (symbol.key, env.address)
    if key not in program.constants:
        if symbol.code is None:
            return machine.unknown(Cause.ERROR, symbol.name)
        program.constants[key] = of_enumeration(machine, evaluate(machine, symbol.code, env), symbol.enumeration)
    return program.constants[key]


def _using(machine: Engine, found: Found, symbol: Symbol, types: tuple[Value, ...] | None) -> Value:
    """What a `using a::b` names."""
    return value_of(machine, used(machine, found, symbol, types), types)


def used(machine: Engine, found: Found, symbol: Symbol, types: tuple[Value, ...] | None = None) -> Found | Value:
    """What is declared under the name of a `using a::b`; External where nothing is."""
    target = symbol.target
    absolute = target[:1] == ("",)
    words = target[1:] if absolute else target
    if found.owner is not None and symbol.code is not None:
        base = linked(machine).info(evaluate(machine, symbol.code, found.env))
        inherited = names.in_class(machine, base, symbol.name) if base is not None else None
        if inherited is not None:
            return inherited
    outer = names.outer_of(machine, found.env) if len(words) == 1 else found.env
    parts = [names.Part(w) for w in words[:-1]] + [names.Part(words[-1], types)]
    resolved = names.resolve(machine, outer or found.env, parts, absolute=absolute)
    is_itself = isinstance(resolved, Found) and symbol in resolved.symbols
    return External(".".join(words)) if is_itself else resolved


def variable(machine: Engine, found: Found, types: tuple[Value, ...] | None = None) -> Value:
    """The slot of a variable of a namespace or class, with its first value in it; an object itself; the value of a template."""
    program = linked(machine)
    general = [s for s in found.symbols if s.specialises is None] or found.symbols
    symbol = next((s for s in general if s.code is not None), general[0])
    env = found.env
    if (symbol.template and found.owner is None) or (symbol.template and types):
        return _of_template(machine, found, symbol, types or ())
    key = f"{symbol.name}@{symbol.unit}" if symbol.unit else symbol.name
    if symbol.constant:
        program.fixed.add((env.address, key))
    elif is_text_array(symbol):
        program.buffers.add((env.address, key))
    obj = record(machine, env.address)
    held = obj.attrs.get(key, UNBOUND)
    if held is UNBOUND or key in obj.partial:  # nobody, or not every execution up to here, has asked for it yet
        if (symbol.key, env.address) in program.evaluating:
            return machine.unknown(Cause.ERROR, f"{symbol.name} before it has a value")
        held = join_all((held, *(_first(machine, each, env) for each in versions(general, symbol))))
        machine.put(env.address, record(machine, env.address).with_attr(key, held))
    if held.__class__ is Ref or (symbol.reference and isinstance(held, Slot)):
        return held
    return Slot(Ref(env.address), "field", key)


def _of_template(machine: Engine, found: Found, symbol: Symbol, types: tuple[Value, ...]) -> Value:
    """The value of a template of a variable for these arguments."""
    parameters = symbol.template or ()
    bindings = bind_template(machine, parameters, types, found.env)
    given = tuple(bindings[p.name] for p in parameters)
    for special in found.symbols:
        inner = meant_for(machine, special, found.env, given) if special.specialises is not None else None
        if isinstance(inner, Unknown):
            return inner
        if inner is not None and special.code is not None:
            values = tuple(inner[p.name] for p in special.template or ())
            return evaluate(machine, special.code, found.env, types=values)
    if symbol.code is None:
        return machine.unknown(Cause.ERROR, symbol.name)
    return evaluate(machine, symbol.code, found.env, types=given)


def _first(machine: Engine, symbol: Symbol, env: ModuleValue) -> Value:
    """What a variable holds at first. A constant is computed once, whoever asks: its objects are there where it is."""
    if not symbol.constant:
        return first_value(machine, symbol, env)
    firsts, key = linked(machine).firsts, (symbol.key, env.address)
    if key in firsts:
        value, made = firsts[key]
        for address, obj in made:
            if machine.own(address) is None:
                machine.put(address, obj)
        return value
    before = machine.state.heap.copy()
    value = first_value(machine, symbol, env)
    changed = machine.state.heap.changed_since(before)
    firsts[key] = value, tuple((address, obj) for address, obj in changed if address not in before)
    return value


def first_value(machine: Engine, symbol: Symbol, env: ModuleValue) -> Value:
    """What a variable holds before anything is assigned to it."""
    if symbol.code is not None:
        return evaluate(machine, symbol.code, env)
    if symbol.type is not None:
        type_ = evaluate(machine, symbol.type, env)
        return default_value(machine, type_)
    return machine.unknown(Cause.ERROR, f"{symbol.name}, which has no value here")


def overloads(machine: Engine, found: Found, types: tuple[Value, ...], receiver: Value | None = None) -> Overloads:
    """The functions of one name: with their receiver where they are members."""
    several = list(_functions(machine, found))
    general = [(s, env) for s, env in several if s.specialises is None] or several
    functions = tuple(function_of(machine, s, env) for s, env in general)
    special = tuple(s for s, _ in several if s.specialises is not None)
    if special:
        linked(machine).special.update(((f.code.key, found.env.address), special) for f in functions)
    owner: Info | None = found.owner
    name = f"{found.env.name}.{found.symbols[0].name}" if found.env.name else found.symbols[0].name
    if receiver is not None and owner is not None and all(s.static for s, _ in several):
        receiver = None
    return Overloads(name, functions, receiver, types)


def _functions(machine: Engine, found: Found, depth: int = 0) -> Iterator[tuple[Symbol, ModuleValue]]:
    """The functions of a name with their scopes: also those that it has by `using Base::name` and `using lib::name`."""
    for symbol in found.symbols:
        if symbol.kind is SymbolKind.FUNCTION:
            yield symbol, found.env
        elif symbol.kind is SymbolKind.USING and depth < _DEPTH and (found.owner is None or symbol.code is not None):
            named = used(machine, found, symbol)
            if isinstance(named, Found):
                yield from (each for each in _functions(machine, named, depth + 1) if not _is_hidden(found, each[0]))


def _is_hidden(found: Found, used: Symbol) -> bool:
    """Whether a class has a function of its own in place of one that it names of a base."""
    taken = [p.type for p in used.parameters]
    return found.owner is not None and any(
        s.kind is SymbolKind.FUNCTION and s.constant == used.constant and [p.type for p in s.parameters] == taken
        for s in found.symbols
    )


def function_of(machine: Engine, symbol: Symbol, env: ModuleValue) -> Function:
    """The function of a symbol, in the scope of its class or namespace. One without a body stands for what is not known of it."""
    program = linked(machine)
    key = (symbol.key, env.address)
    made = program.functions.get(key)
    if made is None:
        code = symbol.code
        if code is None:
            code = _stub(symbol, is_member=program.info(env) is not None)
        program.declared[code.key] = symbol
        if not symbol.sure:
            program.unsure.add(code.key)
        if symbol.template:
            program.templates[code.key] = symbol
        scope = ModuleValue(env.address, env.name, code.file)
        made = program.functions[key] = Function(code, scope, (), (), ())
    return made


_NOTHING = Parameters((), 0, None, (), None)


def _stub(symbol: Symbol, *, is_member: bool) -> Code:
    """What stands for a function whose body is not there."""
    leading = int(is_member and not symbol.static)
    count = leading + len(symbol.template or ()) + len(symbol.parameters)
    constant = symbol.constant and bool(leading)
    signature = Signature(symbol.parameters, leading, symbol.template or (), symbol.reference, constant=constant)
    return Code(
        CodeKind.FUNCTION, symbol.name, symbol.name, symbol.place.file, symbol.place.line, _NOTHING, [], count, (), (), (),
        is_stub=True, language=CPP, unit=f"{symbol.key} without body", signature=signature,
    )  # fmt: skip
