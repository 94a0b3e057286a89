# SPDX-License-Identifier: Apache-2.0
"""How do the arguments of a call come into the registers of a function?

void f(const std::string & a, int b = 2);   f("x")      a is 'x', b is left to the `Default` in the body
[this, n](const Msg & m) {…}                called with a message: this, n and m
A callback may take its message by value, by reference or by any pointer: what arrives is given as it asks for it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, lift, options
from rosward.domain.compound import Tuple
from rosward.domain.heap import Obj
from rosward.domain.slots import Pointer, Slot, TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Function, ModuleValue, Ref, Unknown, Value
from rosward.engine.arguments import ANY
from rosward.engine.cpp.categories import cast_to, numbers_written
from rosward.engine.cpp.classes import bind_template
from rosward.engine.cpp.function_types import deduce_from
from rosward.engine.cpp.handing import is_member, objects_of
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.special import is_of_functions, mentions
from rosward.engine.cpp.static_types import number_at
from rosward.engine.cpp.types import is_message, is_pointer_pattern, match, pointee, type_of
from rosward.ir.symbols import ParameterSymbol, Signature, TypePattern
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.typed import Declared, typed
from rosward.models.cpp.values.types import Shape, shape_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.engine.running.frame import Frame
    from rosward.ir.program import Code

__all__ = ["bind", "deduce", "instance"]

_NO_SIGNATURE: Final = Signature()
_NUMBERS: Final = frozenset({Shape.FLOAT, Shape.INT})


def bind(
    machine: Engine,
    function: Function,
    args: tuple[Value, ...],
    types: tuple[Value, ...],
    keywords: Mapping[str, Value],
) -> list[Value]:
    """The registers of a call. `args` begin with those that lead; what is too many is dropped, what is missing is unbound, or any value."""
    signature = function.code.signature or _NO_SIGNATURE
    leading = [*args[: signature.leading], *[UNBOUND] * (signature.leading - len(args))]
    if ANY in keywords and leading[:1] == [UNBOUND] and is_member(function):
        leading[0] = _any_object(machine, function)
    if leading and leading[0].__class__ is not Ref and function.code.parameters.positional[:1] == ("this",):
        leading[0] = _object(machine, leading[0])
    given = args[signature.leading :]
    env = ModuleValue(function.module.address, function.module.name, function.code.file)
    bindings = (
        bind_template(machine, signature.template, types, env, deduce(machine, signature, given, len(types)))
        if signature.template
        else {}
    )
    registers = [*leading, *(bindings[p.name] for p in signature.template)]
    for index, parameter in enumerate(signature.parameters):
        if parameter.pack:
            registers.append(Tuple(given[index:]))
        elif index < len(given):
            value = (
                given[index] if not types else _told(machine, signature, len(types), parameter, given[index], bindings)
            )
            registers.append(_fitted(machine, function.code, env, parameter, value, bindings))
        else:
            missing = not parameter.default and ANY in keywords
            registers.append(_any(machine, env, parameter, bindings, keywords[ANY]) if missing else UNBOUND)
    return registers


def _told(
    machine: Engine,
    signature: Signature,
    explicit: int,
    parameter: ParameterSymbol,
    value: Value,
    bindings: Mapping[str, Value],
) -> Value:
    """A number for a parameter of a type that the call says: `half<double>(3)`. What a call does not say is that of the argument."""
    pattern = parameter.type
    told = {p.name for p in signature.template[:explicit]}
    if len(pattern.names) != 1 or pattern.names[0] not in told or pattern.pointers:
        return value
    held, type_ = read(machine, value), bindings[pattern.names[0]]
    if not isinstance(held, Const) or not isinstance(held.value, int | float) or shape_of(type_) not in _NUMBERS:
        return value
    is_other = isinstance(held.value, float) is not (shape_of(type_) is Shape.FLOAT)
    is_new = not pattern.reference or (pattern.const and is_other)
    return convert(machine, held, type_) if is_new else value


def instance(frame: Frame) -> tuple[object, ...]:
    """What the parameters of a function template stand for in a call: each instance has static variables of its own."""
    signature = frame.code.signature
    types = signature.types(frame.registers) if signature is not None else ()
    return tuple(each.value if isinstance(each, Const) else each for each in types)


def _object(machine: Engine, value: Value) -> Value:
    """The object that a member function is called on, of a pointer to it as well (`std::bind(&C::m, this)`)."""
    return lift(lambda v: v.target if isinstance(v, Pointer) else v, read(machine, value))


def deduce(machine: Engine, signature: Signature, given: tuple[Value, ...], explicit: int) -> dict[str, Value]:
    """What the parameters of a template must be for these arguments."""
    wanted = frozenset(p.name for p in signature.template[explicit:])
    bindings: dict[str, Value] = {}
    if not wanted:
        return bindings
    cast, numbers = cast_to(machine, given), numbers_written(machine, given)
    of_class: Value = NONE
    for index, parameter in enumerate(signature.parameters):
        pattern = parameter.type
        if parameter.pack:
            name = pattern.names[0] if len(pattern.names) == 1 else ""
            if name in wanted:
                bindings[name] = Tuple(tuple(type_of(machine, v) for v in given[index:]))
            elif pattern.arguments:  # const std::shared_ptr<Args> &…
                several = [_matched(machine, pattern._replace(pack=False), v, wanted) for v in given[index:]]
                for key in dict.fromkeys(k for found in several for k in found):
                    bindings[key] = Tuple(tuple(found.get(key, NONE) for found in several))
        elif index < len(given) and pattern.size and pattern.size in wanted:
            bindings |= _of_array(machine, pattern, given[index], wanted)
        elif index < len(given) and is_of_functions(pattern):
            of_class = deduce_from(machine, read(machine, given[index]), pattern, wanted, bindings)
        elif index < len(given) and (pattern.names or pattern.pointers or pattern.arguments):
            seen = cast[index] if cast and not pattern.pointers else None
            if seen is None and not pattern.pointers:
                seen = TypeOf(numbers[index], ()) if numbers and numbers[index] else number_at(machine, given[index])
            match(machine, pattern, _seen(machine, given[index]) if seen is None else seen, wanted, bindings)
            for name in _packs(pattern):  # it is none of nothing: `std::integer_sequence<T, Ns...>` of something else
                if name in wanted and name not in bindings:
                    bindings[name] = machine.unknown(Cause.CALL, f"parameter pack {name}")
    if of_class != NONE:  # `void (C::*f)(M)` is kept as `void (*f)(M)`
        bindings |= dict.fromkeys(_unmentioned(signature, wanted), of_class)
    return bindings


def _seen(machine: Engine, value: Value) -> Value:
    """The type of an argument, as far as it shows: of a null pointer that a variable holds, it does not."""
    is_null = isinstance(value, Slot) and read(machine, value) == NONE
    return machine.unknown(Cause.CALL, "type of a null pointer") if is_null else type_of(machine, value)


def _unmentioned(signature: Signature, wanted: frozenset[str]) -> list[str]:
    """The only parameter of a template that no parameter of the function is written with, if there is one."""
    open_ = [p.name for p in signature.template if p.name in wanted and p.default is None and not p.pack]
    found = [n for n in open_ if not any(mentions(p.type, frozenset({n})) for p in signature.parameters)]
    return found if len(found) == 1 else []


def _packs(pattern: TypePattern) -> Iterator[str]:
    """The packs that are arguments of a type."""
    for each in pattern.arguments:
        if each.pack and len(each.names) == 1:
            yield each.names[0]
        yield from _packs(each)


def _of_array(machine: Engine, pattern: TypePattern, value: Value, wanted: frozenset[str]) -> dict[str, Value]:
    """`T (&items)[N]`, given an array, or a literal, which ends with a zero."""
    found: dict[str, Value] = {}
    held = read(machine, value)
    count: int | None = None
    if isinstance(held, Const) and isinstance(held.value, str):
        count = len(held.value.encode()) + 1
    elif isinstance(held, Ref) and (items := machine.obj(held).items) is not None:
        count = len(items)
        cls = machine.obj(held).cls
        if isinstance(cls, TypeOf) and cls.arguments:
            inner = pattern._replace(pointers=pattern.pointers - 1, size="", reference="")
            match(machine, inner, cls.arguments[0], wanted, found)
    found[pattern.size] = machine.unknown(Cause.CALL, pattern.size, "int") if count is None else Const(count)
    return found


def _matched(machine: Engine, pattern: object, value: Value, wanted: frozenset[str]) -> dict[str, Value]:
    found: dict[str, Value] = {}
    match(machine, pattern, type_of(machine, value), wanted, found)  # type: ignore[arg-type]  # it is one of its own fields
    return found


def _fitted(
    machine: Engine,
    code: Code,
    env: ModuleValue,
    parameter: ParameterSymbol,
    value: Value,
    bindings: Mapping[str, Value],
) -> Value:
    """An argument as a parameter takes it: of its type, where it is not known.

    Messages alone arrive otherwise than they are asked for: a library hands them over."""
    held = read(machine, value)
    if _only_read(parameter.type) and any(o.__class__ is Unknown and not o.hint for o in options(held)):
        type_ = type_of_pattern(machine, env, parameter.type, bindings)
        shown = typed(machine, held, type_, Declared((code.key, parameter.name)))
        if shown != held:
            return shown
    if not any(isinstance(o, (Pointer, Ref)) for o in options(held)):
        return value
    if parameter.type.builtin.startswith("auto") or not (parameter.type.names or parameter.type.pointers):
        return value

    def one(option: Value) -> Value:
        target = option.target if isinstance(option, Pointer) else option
        if not isinstance(target, Ref) or not is_message(machine.obj(target).cls):
            return option
        if isinstance(option, Pointer):
            return option if _takes_pointer(machine, env, parameter, bindings) else target
        return Pointer(target) if is_pointer_pattern(parameter.type) else option

    fitted = lift(one, held)
    return value if fitted == held else fitted


def _only_read(pattern: TypePattern) -> bool:
    """Whether what a function writes to a parameter of a type is not seen by who calls it."""
    last = pattern.names[-1] if pattern.names else ""
    if pattern.pointers:
        return False
    if is_pointer_pattern(pattern):
        return last.startswith("Const") or bool(pattern.arguments and pattern.arguments[0].const)
    return not pattern.reference or (pattern.reference == "&" and pattern.const)


def _takes_pointer(
    machine: Engine, env: ModuleValue, parameter: ParameterSymbol, bindings: Mapping[str, Value]
) -> bool:
    if is_pointer_pattern(parameter.type):
        return True
    return pointee(type_of_pattern(machine, env, parameter.type, bindings)) is not None


def _any(
    machine: Engine, env: ModuleValue, parameter: ParameterSymbol, bindings: Mapping[str, Value], anything: Value
) -> Value:
    """An argument that nobody knows, of the type of the parameter where that is a message."""
    type_ = type_of_pattern(machine, env, parameter.type, bindings)
    target = pointee(type_)
    if is_message(target if target is not None else type_):
        message = machine.call(target if target is not None else type_, ())
        return Pointer(message) if target is not None and isinstance(message, Ref) else message
    handed = _handed(machine, target if target is not None else type_)
    if handed:  # it knows of these; RW202 tells that it may have nodes of its own
        known: list[Value] = [Pointer(ref) for ref in handed] if target is not None else list(handed)
        return join_all(known if all(machine.is_node(ref.address) for ref in handed) else [*known, anything])
    return anything if not isinstance(anything, Const) else machine.unknown(Cause.CALL, parameter.name)


def _handed(machine: Engine, cls: Value) -> list[Ref]:
    """The objects of a class that unknown code was given."""
    given = [v for v in machine.trace.handed if isinstance(v, Ref)]
    return [ref for ref in given if isinstance(c := machine.obj(ref).cls, Class) and cls in c.mro]


def _any_object(machine: Engine, function: Function) -> Value:
    """The object on which unknown code calls a member function."""
    known = objects_of(machine, function.module, [v for v in machine.trace.handed if isinstance(v, Ref)])
    info = linked(machine).info(function.module)
    if known or info is None or info.cls is None:
        return join_all(known) if known else UNBOUND
    return machine.allocate(Obj("instance", info.cls), "opaque")
