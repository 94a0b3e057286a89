# SPDX-License-Identifier: Apache-2.0
"""Which of several functions of one name does a call mean?

declare("a", 1), declare("a", "x")      by how many arguments, then by how well each fits its parameter
Where the values do not tell, all that fit are meant.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, External, Native, Partial, Tuple
from rosward.domain.slots import Overloads, Pointer, TypeOf, is_char_text
from rosward.domain.values import Class, Const, Function, ModuleValue, Ref, Text, Unknown, Value
from rosward.engine.cpp.binding import deduce
from rosward.engine.cpp.categories import by_category, cast_to, numbers_written, same_parameters, undominated
from rosward.engine.cpp.classes import bind_template
from rosward.engine.cpp.convertible import NUMBERS, TEXTS, converts, is_convertible
from rosward.engine.cpp.enumerations import enumeration_of, is_enumeration
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import CHARACTERS, STRING, dotted, is_pointer_pattern, pointee, type_of
from rosward.ir.arithmetic import INT, LONG, SMALL, same_type
from rosward.ir.symbols import ParameterSymbol, Signature
from rosward.models.cpp.values.number_conversions import OCTETS
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.traits import NO_TYPE
from rosward.models.cpp.values.types import NOT_OF_ONE, argument

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["choose", "fit", "fitting"]

_EXACT: Final = 5
_NEAR: Final = 4
_TEMPLATE: Final = 3
_STANDARD: Final = 2
_CONVERTED: Final = 1
_NEVER: Final = 0
_INTEGERS: Final = frozenset({"int", "long", "short", "unsigned", "size_t", "char"})
_FLOATS: Final = frozenset({"float", "double"})
_CALLABLES: Final = (Function, BoundMethod, Partial, Overloads)


def choose(
    machine: Engine, functions: Sequence[Function], args: tuple[Value, ...], types: tuple[Value, ...]
) -> list[Function]:
    """Those that are meant, of which the arguments (without those that lead) are given; all where none fits."""
    by_number = [f for f in functions if _takes(f.code.signature, len(args), len(types))]
    if len(by_number) <= 1:
        return by_number or list(functions[:1])
    values = [read(machine, a) for a in args]
    numbers, cast = numbers_written(machine, args), cast_to(machine, args)
    scores: list[tuple[Function, tuple[int, ...]]] = []
    for function in by_number:
        if (score := _score(machine, function, values, types, numbers, cast)) is not None:
            scores.append((function, score))
    if not scores:
        return by_number
    left = undominated({s for _, s in scores}, _better)
    best = _enabled(machine, [f for f, s in scores if s in left], args, types)
    best = by_category(machine, best, args) if len(best) > 1 else best
    if len(set(map(_is_template, best))) > 1:  # one takes a weak pointer, the other anything
        return [f for f in best if not f.code.is_stub] or best
    return best if any(isinstance(o, Unknown) for v in values for o in options(v)) else _versions(machine, best)


def fitting(machine: Engine, functions: Sequence[Function], args: tuple[Value, ...]) -> list[Function]:
    """Those that may be called with arguments of which something is known."""
    values = [read(machine, a) for a in args]
    by_number = [f for f in functions if _takes(f.code.signature, len(args), 0)]
    return [f for f in by_number if _score(machine, f, values, (), cast=cast_to(machine, args)) is not None]


def _versions(machine: Engine, best: list[Function]) -> list[Function]:
    """The first, and the others of which the preprocessor may leave one in its place."""
    unsure = linked(machine).unsure
    first = best[0]
    alike = all(same_parameters(f.code.signature, first.code.signature) for f in best) or any(
        map(_is_constrained, best)
    )
    if len(best) > 1 and alike and all(map(_is_template, best)):
        return best  # what tells them apart is a constraint that nobody sees
    if first.code.key not in unsure:
        return [first]
    return [
        f
        for f in best
        if f is first or (f.code.key in unsure and same_parameters(f.code.signature, first.code.signature))
    ]


def _is_template(function: Function) -> bool:
    return function.code.signature is not None and bool(function.code.signature.template)


def _is_constrained(function: Function) -> bool:
    """Whether a template has a parameter that nobody uses: `std::enable_if_t<…, int> = 0`."""
    signature = function.code.signature
    return signature is not None and any(not p.name and p.default is not None for p in signature.template)


def _enabled(
    machine: Engine, best: list[Function], args: tuple[Value, ...], types: tuple[Value, ...]
) -> list[Function]:
    """Those of several templates whose arguments, and results, are types: not those with `typename = std::enable_if_t<false>`."""
    if len(best) < 2:
        return best
    return [function for function in best if _is_enabled(machine, function, args, types)] or best


def _is_enabled(machine: Engine, function: Function, args: tuple[Value, ...], types: tuple[Value, ...]) -> bool:
    signature = function.code.signature
    if signature is None or not signature.template:
        return True
    env = ModuleValue(function.module.address, function.module.name, function.code.file)
    found = deduce(machine, signature, args, len(types))
    given: list[Value] = []
    for index, parameter in enumerate(signature.template):
        if parameter.type is not None and evaluate(machine, parameter.type, env, types=tuple(given)) == NO_TYPE:
            return False
        bound = bind_template(machine, signature.template[: index + 1], types, env, found)[parameter.name]
        if parameter.default is not None and bound == NO_TYPE:
            return False
        given.append(bound)
    symbol = linked(machine).templates.get(function.code.key)
    result = symbol.type if symbol is not None else None
    return result is None or evaluate(machine, result, env, types=tuple(given)) != NO_TYPE


def _takes(signature: Signature | None, count: int, types: int) -> bool:
    if signature is None:
        return True
    if types > len(signature.template) and not any(p.pack for p in signature.template):
        return False
    least = sum(1 for p in signature.parameters if not p.default and not p.pack)
    most = None if any(p.pack for p in signature.parameters) else len(signature.parameters)
    return count >= least and (most is None or count <= most)


def _better(one: tuple[int, ...], other: tuple[int, ...]) -> bool:
    return all(a >= b for a, b in zip(one, other, strict=True)) and one != other


def _score(
    machine: Engine,
    function: Function,
    values: Sequence[Value],
    types: tuple[Value, ...],
    numbers: tuple[str, ...] = (),
    cast: tuple[Value | None, ...] = (),
) -> tuple[int, ...] | None:
    signature = function.code.signature
    if signature is None:
        return tuple(_CONVERTED for _ in values)
    bindings = dict(zip((p.name for p in signature.template), types, strict=False))
    generic = frozenset(p.name for p in signature.template if p.name not in bindings)
    env = ModuleValue(function.module.address, function.module.name, function.code.file)
    found: list[int] = []
    for index, value in enumerate(values):
        parameter = _parameter(signature, index)
        if parameter is None:
            return None
        as_type = cast[index] if cast else None
        points = max(_fits(machine, env, parameter, o, bindings, generic, as_type) for o in options(value))
        if points == _NEVER:
            return None
        if numbers and numbers[index] and not generic.intersection(parameter.type.names):
            points = _number(dotted(type_of_pattern(machine, env, parameter.type, bindings)), numbers[index], points)
        found.append(points)
    if bool(types) != bool(signature.template):  # f<T>(x) means a template
        found = [min(p, _TEMPLATE) for p in found] if types else found
    return tuple(found)


def _number(name: str, number: str, points: int) -> int:
    """How well a number whose type is written fits a type, which other types of numbers fit so well."""
    type_ = same_type(name.removeprefix("std."))
    if not _is_number(name):
        return _NEVER if name in TEXTS else points
    if type_ == number:
        return _EXACT
    return _NEAR if type_ == ("int" if number in SMALL else "double" if number == "float" else "") else _TEMPLATE


def _parameter(signature: Signature, index: int) -> ParameterSymbol | None:
    if index < len(signature.parameters):
        return signature.parameters[index]
    last = signature.parameters[-1] if signature.parameters else None
    return last if last is not None and last.pack else None


def _fits(
    machine: Engine,
    env: ModuleValue,
    parameter: ParameterSymbol,
    value: Value,
    bindings: dict[str, Value],
    generic: frozenset[str],
    cast: Value | None,
) -> int:
    pattern = parameter.type
    if any(n in generic for n in pattern.names):
        return _TEMPLATE if pattern.names[0] in generic else _CONVERTED
    if pattern.arguments and any(n in generic for a in pattern.arguments for n in a.names):
        return _shaped(
            machine, pattern.names[-1] if pattern.names else "", is_pointer=is_pointer_pattern(pattern), value=value
        )
    type_ = type_of_pattern(machine, env, pattern, bindings)
    return fit(machine, value, type_) if cast is None else _fit_cast(machine, value, type_, cast)


def _fit_cast(machine: Engine, value: Value, type_: Value, cast: Value) -> int:
    """How well an object, or a pointer to it, fits a type that is cast to one of its bases."""
    ref, target = (value.target, pointee(cast)) if isinstance(value, Pointer) else (value, cast)
    own = type_of(machine, ref)
    if not (isinstance(ref, Ref) and isinstance(own, Class) and isinstance(target, Class) and target in own.mro):
        return fit(machine, value, type_)
    if target is cast:
        return _object(machine, cast, type_, dotted(type_))
    wanted = pointee(type_)
    if not isinstance(wanted, Class):
        return fit(machine, value, type_)
    return _EXACT if wanted == target else _NEAR if wanted in target.mro else _NEVER


def _shaped(machine: Engine, name: str, *, is_pointer: bool, value: Value) -> int:
    """How a value fits `Box<T>`, of which T is not known: by its name."""
    if isinstance(value, Unknown):
        return _CONVERTED
    if is_pointer:
        return _TEMPLATE if isinstance(value, Pointer) or value == Const(None) else _NEVER
    if isinstance(value, _CALLABLES):
        return _TEMPLATE if name == "function" else _NEVER
    own = dotted(type_of(machine, value)).rpartition(".")[2]
    if name in (own, f"{own}_"):  # `String_<A>` is what the message String is
        return _NEAR
    return _CONVERTED if isinstance(value, Tuple) else _NEVER


def fit(machine: Engine, value: Value, type_: Value) -> int:
    """How well a value fits a type: 0 not at all, 5 exactly."""
    if isinstance(value, Unknown) and not value.hint:
        return _CONVERTED
    name = dotted(type_)
    target = pointee(type_)
    if isinstance(type_, Unknown) or name == "auto":
        return _TEMPLATE
    if isinstance(value, Pointer) or value == Const(None):
        is_text = value != Const(None) and type_of(machine, value) == CHARACTERS
        return _characters(machine, value, type_, name, target) if is_text else _pointer(machine, value, target, name)
    if isinstance(value, _CALLABLES):
        return _callable(machine, type_, name)
    if isinstance(value, (Const, Text, Unknown)):
        return _plain(machine, value, type_, name, target)
    if isinstance(value, Tuple):
        return _NEVER if len(value.items) > 1 and (name == "pointer" or _is_of_one(name, value)) else _CONVERTED
    if isinstance(value, Ref):
        return _object(machine, machine.obj(value).cls, type_, name)
    return _CONVERTED if type_ != value else _EXACT


def _is_of_one(name: str, value: Tuple) -> bool:
    """Whether a type is made of a single value: a string not of several."""
    return name in _INTEGERS | _FLOATS | {"bool"} or (name in TEXTS and all(map(is_char_text, value.items)))


_TRUTHS: Final = frozenset({"bool", "nullptr", "std.nullptr_t", "void"})
_EMPTY: Final = frozenset({"function", "std.function"})
"""Types that are made of the null pointer, beside pointers."""


def _pointer(machine: Engine, value: Value, target: Value | None, name: str) -> int:
    if target is None:
        if value == Const(None) and name in {"nullptr", "std.nullptr_t"}:
            return _EXACT
        empty = _EMPTY if value == Const(None) else frozenset[str]()
        return _CONVERTED if name in _TRUTHS | empty or _is_open(machine, name) else _NEVER
    if not isinstance(value, Pointer):
        return _NEAR if name == "pointer" else _CONVERTED
    cls = type_of(machine, value.target)
    other = bool(value.owner) is not name.endswith(".shared_ptr") and name in ("pointer", "std.shared_ptr")
    if cls == target or dotted(target) == "void":
        # A weak pointer may be made of a shared one: nobody knows which of them the value is.
        return _TEMPLATE if name.endswith("weak_ptr") or other else _EXACT
    if isinstance(cls, Class) and isinstance(target, Class):
        return (
            (_TEMPLATE if other else _NEAR)
            if target in cls.mro
            else _NEVER
            if linked(machine).info(target)
            else _CONVERTED
        )
    return _CONVERTED


def _is_open(machine: Engine, name: str) -> bool:
    """Whether nothing is known of a type of that name."""
    return "." in name and not name.startswith("std.") and machine.library.native(f"{name}.new") is None


def _callable(machine: Engine, type_: Value, name: str) -> int:
    if name in {"function", "std.function"}:
        return _EXACT
    if name in _INTEGERS | _FLOATS | TEXTS | {"bool"}:
        return _NEVER
    if isinstance(type_, Class):
        return _CONVERTED if converts(machine, type_, TypeOf("function", ())) else _NEVER
    return _CONVERTED


def _plain(machine: Engine, value: Value, type_: Value, name: str, target: Value | None) -> int:
    if name in NOT_OF_ONE:
        return _NEVER
    if name == "std.optional":
        return min(fit(machine, value, argument(type_, 0)), _CONVERTED)
    own = type_of(machine, value)
    if enumeration_of(value):
        return _enumerator(own, type_, name)
    if is_char_text(value):
        return _characters(machine, value, type_, name, target)
    words = set(name.replace("std.", "").split())
    if own == STRING:
        if name in TEXTS:
            return _EXACT
        if target is not None and dotted(target) == "char":
            return _CONVERTED if isinstance(value, Const) else _EXACT
        if words & _INTEGERS:
            is_char = isinstance(value, Const) and len(str(value.value)) == 1
            return _NEVER if not is_char else _EXACT if name == "char" else _TEMPLATE if name == "int" else _STANDARD
    elif (kind := dotted(own)) in NUMBERS:
        if name == kind or OCTETS.get(name.removeprefix("std.")) == kind:
            return _EXACT
        if kind in OCTETS:
            return (
                _NEAR if name == "int" else _TEMPLATE if _is_number(name) else _NEVER if name in TEXTS else _CONVERTED
            )
        integer = bool(words & _INTEGERS) or name.endswith("_t")
        if integer and (kind in (INT, LONG) or (kind == "bool" and name == "int")):
            return _NEAR
        if integer or words & _FLOATS or name == "bool":
            return _TEMPLATE
        if name in TEXTS:
            return _NEVER
    if target is not None or (isinstance(value, Const) and is_enumeration(machine, type_)):
        return _NEVER
    if isinstance(type_, Class):
        return _CONVERTED if converts(machine, type_, own) else _NEVER
    return _CONVERTED if isinstance(type_, (External, Native)) or name.startswith("std.") else _NEVER


def _characters(machine: Engine, value: Value, type_: Value, name: str, target: Value | None) -> int:
    """A literal: rather a truth than a string, which has to be made of it."""
    if target is not None:
        return _EXACT if dotted(target) == "char" else _STANDARD if dotted(target) == "void" else _NEVER
    if name == "bool":
        return _STANDARD
    if _is_number(name) or name in {"char", "float", "double"}:
        return _NEVER
    if isinstance(type_, Class):
        return _CONVERTED if converts(machine, type_, type_of(machine, value)) else _NEVER
    return _CONVERTED


def _enumerator(own: Value, type_: Value, name: str) -> int:
    """A value of an enumeration is converted to a number, if anything."""
    if own == type_:
        return _EXACT
    if name in TEXTS or (isinstance(type_, (Class, TypeOf)) and not _is_number(name)):
        return _NEVER
    return _TEMPLATE if name == "int" else _CONVERTED


def _is_number(name: str) -> bool:
    return bool(set(name.replace("std.", "").split()) & (_INTEGERS | _FLOATS)) or name == "bool" or name.endswith("_t")


def _object(machine: Engine, cls: Value, type_: Value, name: str) -> int:
    if cls == type_:
        return _EXACT
    if isinstance(type_, Class):
        if isinstance(cls, Class) and type_ in cls.mro:
            return _NEAR
        if isinstance(cls, Class) and linked(machine).info(type_) is not None:
            return _CONVERTED if is_convertible(machine, type_, cls) else _NEVER
        return _CONVERTED
    if name.startswith("std.chrono.") and isinstance(cls, TypeOf):
        return _CONVERTED if dotted(cls).startswith("std.chrono.") else _NEVER  # a container is no time
    if isinstance(type_, TypeOf):
        own = dotted(cls)
        if own.rpartition(".")[2] == name.rpartition(".")[2] or isinstance(cls, Native):
            return _NEAR
        return _NEVER if name in _INTEGERS | _FLOATS or "." not in name or name == "pointer" else _CONVERTED
    if isinstance(cls, Class) and not any(isinstance(b, External) for b in cls.mro):
        return _CONVERTED if name in TEXTS else _NEVER if name.startswith("std.") else _CONVERTED
    return _NEVER if name in TEXTS and isinstance(cls, External) else _CONVERTED
