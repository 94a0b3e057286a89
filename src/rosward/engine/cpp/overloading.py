# SPDX-License-Identifier: Apache-2.0
"""Which of several functions of one name does a call mean?

declare("a", 1), declare("a", "x")      by how many arguments, then by how well each fits its parameter
Where the values do not tell, all that fit are meant.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.slots import Pointer, is_char_text
from rosward.domain.values import NONE, Class, Const, Function, ModuleValue, Ref, Unknown, Value
from rosward.engine.cpp.binding import deduce
from rosward.engine.cpp.categories import (
    Category,
    by_category,
    cast_to,
    forwards,
    numbers_written,
    same_parameters,
    undominated,
    ways,
)
from rosward.engine.cpp.classes import bind_template
from rosward.engine.cpp.convertible import TEXTS
from rosward.engine.cpp.fit import (
    CALLABLES,
    CONVERTED,
    DEDUCED,
    EXACT,
    FORWARDED,
    NEAR,
    NEVER,
    TEMPLATE,
    as_base,
    fit,
    fit_object,
    is_number,
)
from rosward.engine.cpp.function_types import may_be, of_pattern
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.special import mentions, most_special
from rosward.engine.cpp.static_types import number_at
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import dotted, is_pointer_pattern, pointee, type_of
from rosward.ir.arithmetic import SMALL
from rosward.ir.symbols import ParameterSymbol, Signature, TypePattern
from rosward.models.cpp.values.number_conversions import number_named
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.traits import NO_TYPE

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["choose", "fitting"]


def choose(
    machine: Engine, functions: Sequence[Function], args: tuple[Value, ...], types: tuple[Value, ...]
) -> list[Function]:
    """Those that are meant, of which the arguments (without those that lead) are given; all where none fits."""
    by_number = [f for f in functions if _takes(f.code.signature, len(args), len(types))]
    if len(by_number) <= 1:
        return by_number or list(functions[:1])
    several = ways(machine, by_number, args) or [()]
    return list(dict.fromkeys(f for each in several for f in _chosen(machine, by_number, args, types, each)))


def _chosen(
    machine: Engine,
    by_number: Sequence[Function],
    args: tuple[Value, ...],
    types: tuple[Value, ...],
    categories: tuple[Category, ...],
) -> list[Function]:
    """Those that are meant, where it is known what the arguments are, or does not count."""
    values = [read(machine, a) for a in args]
    numbers, cast = _numbers(machine, args), cast_to(machine, args)
    scores: list[tuple[Function, tuple[int, ...]]] = []
    is_any = bool(categories) and any(forwards(f, n) for f in by_number for n in range(len(args)))
    for function in by_number:
        score = _score(machine, function, values, types, numbers, cast)
        is_enabled = _is_enabled(machine, function, args, types) if score is not None and is_any else None
        if score is not None and is_enabled is not False:
            scores.append((function, _forwarded(function, score, categories) if is_enabled else score))
    if not scores:
        return list(by_number)
    left = undominated({s for _, s in scores}, _better)
    best = _enabled(machine, [f for f, s in scores if s in left], args, types)
    best = by_category(machine, best, args, categories) if len(best) > 1 else best
    if len(set(map(_is_template, best))) > 1:  # one takes a weak pointer, the other anything
        return [f for f in best if not f.code.is_stub] or best
    if any(isinstance(o, Unknown) for v in values for o in options(v)):
        return best
    return _versions(machine, most_special(machine, best, values))


def _numbers(machine: Engine, args: tuple[Value, ...]) -> tuple[str, ...]:
    """The types of numbers that the arguments are written or declared with; none where there are none."""
    written = numbers_written(machine, args)
    declared = [number_at(machine, a) for a in args]
    if all(each is None for each in declared):
        return written
    names = ["" if each is None else number_named(dotted(each)) for each in declared]
    return tuple(w or n for w, n in zip(written or [""] * len(names), names, strict=True))


def fitting(machine: Engine, functions: Sequence[Function], args: tuple[Value, ...]) -> list[Function]:
    """Those that may be called with arguments of which something is known."""
    values = [read(machine, a) for a in args]
    by_number = [f for f in functions if _takes(f.code.signature, len(args), 0)]
    return [f for f in by_number if _score(machine, f, values, (), cast=cast_to(machine, args)) is not None]


def _forwarded(function: Function, score: tuple[int, ...], categories: tuple[Category, ...]) -> tuple[int, ...]:
    """`T &&` fits whatever is given as it is; a reference to what is constant fits so well only what is that."""
    signature = function.code.signature
    found = list(score)
    for number, category in enumerate(categories):
        parameter = _parameter(signature, number) if signature is not None else None
        if parameter is None or signature is None:
            continue
        if forwards(function, number):
            found[number] = max(found[number], FORWARDED)
        elif parameter.type.const and parameter.type.reference and not parameter.type.pointers:
            is_any = len(parameter.type.names) == 1 and parameter.type.names[0] in {p.name for p in signature.template}
            if category != "constant":
                found[number] = min(found[number], FORWARDED - 1)
            elif is_any:  # `const T &` takes what is constant as well as `T &&` does, and is preferred then
                found[number] = max(found[number], FORWARDED)
    return tuple(found)


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
    return [function for function in best if _is_enabled(machine, function, args, types) is not False] or best


def _is_enabled(machine: Engine, function: Function, args: tuple[Value, ...], types: tuple[Value, ...]) -> bool | None:
    """Whether the arguments of a template, and its result, are types; None where that is not known."""
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
    if symbol is None or symbol.type is None:
        return True
    result = evaluate(machine, symbol.type, env, types=tuple(given))
    return None if isinstance(result, Unknown) else result != NO_TYPE


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
        return tuple(CONVERTED for _ in values)
    bindings = dict(zip((p.name for p in signature.template), types, strict=False))
    generic = frozenset(p.name for p in signature.template if p.name not in bindings)
    env = ModuleValue(function.module.address, function.module.name, function.code.file)
    found: list[int] = []
    for index, value in enumerate(values):
        parameter = _parameter(signature, index)
        if parameter is None:
            return None
        as_type = cast[index] if cast else None
        led = [o for o in options(value) if o != NONE] or [value]  # what a pointer is tells, not that it may be null
        points = max(_fits(machine, env, parameter, o, bindings, generic, as_type) for o in led)
        if points == NEVER:
            return None
        if numbers and numbers[index]:
            points = _written(machine, env, parameter.type, numbers[index], points, bindings, generic)
        found.append(points)
    if bool(types) != bool(signature.template):  # f<T>(x) means a template
        found = [min(p, TEMPLATE) for p in found] if types else found
    return tuple(found)


def _written(
    machine: Engine,
    env: ModuleValue,
    pattern: TypePattern,
    number: str,
    points: int,
    bindings: dict[str, Value],
    generic: frozenset[str],
) -> int:
    if generic.intersection(pattern.names):
        return DEDUCED if pattern.names[0] in generic and not pattern.pointers else points
    return _number(dotted(type_of_pattern(machine, env, pattern, bindings)), number, points)


def _number(name: str, number: str, points: int) -> int:
    """How well a number whose type is written fits a type, which other types of numbers fit so well."""
    type_ = number_named(name)
    if not is_number(name):
        return NEVER if name in TEXTS else points
    if type_ == number_named(number):
        return EXACT
    return NEAR if type_ == ("int" if number in SMALL else "double" if number == "float" else "") else TEMPLATE


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
    if len(pattern.names) == 1 and pattern.names[0] in generic and pattern.pointers and not pattern.size:
        return TEMPLATE if _may_point(machine, value) else CONVERTED
    if any(n in generic for n in pattern.names):
        is_whole = (
            pattern.names[0] in generic and (not pattern.pointers or bool(pattern.size)) and isinstance(value, Ref)
        )
        return DEDUCED if is_whole else TEMPLATE if pattern.names[0] in generic else CONVERTED
    if any(mentions(a, generic) for a in pattern.arguments):
        wanted = of_pattern(machine, env, pattern, bindings, generic) if isinstance(value, CALLABLES) else None
        if wanted is not None:
            return NEVER if may_be(machine, value, wanted, generic) is False else TEMPLATE
        return _shaped(machine, pattern, value)
    type_ = type_of_pattern(machine, env, pattern, bindings)
    return fit(machine, value, type_) if cast is None else _fit_cast(machine, value, type_, cast)


def _fit_cast(machine: Engine, value: Value, type_: Value, cast: Value) -> int:
    """How well an object, or a pointer to it, fits a type that is cast to one of its bases."""
    ref, target = (value.target, pointee(cast)) if isinstance(value, Pointer) else (value, cast)
    own = type_of(machine, ref)
    if not (isinstance(ref, Ref) and isinstance(own, Class) and isinstance(target, Class) and target in own.mro):
        return fit(machine, value, type_)
    if target is cast:
        return fit_object(machine, cast, type_, dotted(type_))
    wanted = pointee(type_)
    if not isinstance(wanted, Class):
        return fit(machine, value, type_)
    if dotted(type_) != dotted(cast):
        return fit(machine, value, type_)
    return EXACT if wanted == target else as_base(target, wanted) if wanted in target.mro else NEVER


def _may_point(machine: Engine, value: Value) -> bool:
    """Whether a value may be given for `T *`: a pointer that owns nothing, an array."""
    if isinstance(value, Pointer):
        return not value.owner
    if isinstance(value, Ref):
        return dotted(type_of(machine, value)) == "array"
    return not isinstance(value, Const) or value.value is None or is_char_text(value)


def _owns(pattern: TypePattern, value: Pointer) -> bool:
    """Whether a pointer is known to own what it leads to as a type says it does."""
    last = pattern.names[-1] if pattern.names and not pattern.pointers else ""
    return value.owner == {"shared_ptr": "shared", "unique_ptr": "unique"}.get(last, "") or last == "weak_ptr"


def _shaped(machine: Engine, pattern: TypePattern, value: Value) -> int:
    """How a value fits `Box<T>`, of which T is not known: by its name."""
    name = pattern.names[-1] if pattern.names else ""
    if isinstance(value, Unknown):
        return CONVERTED
    if is_pointer_pattern(pattern):
        if isinstance(value, Pointer):
            return TEMPLATE if _owns(pattern, value) else CONVERTED
        return TEMPLATE if value == Const(None) else NEVER
    if isinstance(value, CALLABLES):
        return TEMPLATE if name == "function" else NEVER
    own = dotted(type_of(machine, value)).rpartition(".")[2]
    if name in (own, f"{own}_"):  # `String_<A>` is what the message String is
        return DEDUCED
    return CONVERTED if isinstance(value, Tuple) else NEVER
