# SPDX-License-Identifier: Apache-2.0
"""Does what can be called fit a type of functions, and what does it say of the parameters of a template in that?

void add(std::function<void(const Scan &)> f);      add([](const Scan &) {…}): not the one for `std::function<void(int)>`
template<class M> void add(void (C::*f)(const M &));     add(&Lidar::on_scan): M is Scan
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Final, NamedTuple

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, Partial, Tuple
from rosward.domain.slots import TypeOf
from rosward.domain.values import NONE, Class, Function, ModuleValue, Value
from rosward.engine.cpp.handing import is_member
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.special import mentions
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import dotted, is_message, match, pointee
from rosward.ir.symbols import Signature, TypePattern
from rosward.models.cpp.values.callables import function_behind, parameters, plain_callable
from rosward.models.cpp.values.number_conversions import number_named
from rosward.models.cpp.values.types import Shape, argument, shape_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["Taken", "deduce_from", "may_be", "of_pattern", "of_type"]

_NUMBERS: Final = frozenset({Shape.BOOL, Shape.FLOAT, Shape.INT})
_PLAIN: Final = _NUMBERS | {Shape.TEXT}
_AROUND: Final = frozenset({"const", "reference", "rvalue", "volatile"})
_FUNCTIONS: Final = frozenset({"function", "function_ref", "move_only_function"})


class Wanted(NamedTuple):
    """What a type of functions says: what is given, and which type comes of it. `exact`: a pointer, to which no other function converts.

    A parameter is a type, or a pattern where a parameter of a template stands in it. `open`: more may be given.
    """

    parameters: tuple[Value | TypePattern, ...]
    result: Value
    exact: bool
    open: bool = False


class Taken(NamedTuple):
    """What something that can be called takes: the types, how many have to be given and how many may be; of which class it is a member.

    `written`: the types as they are written, with references.
    """

    types: tuple[Value, ...]
    written: tuple[TypePattern, ...]
    least: int
    most: int | None
    result: Value
    cls: Value


def of_type(type_: Value) -> Wanted | None:
    """What a type says where it is one of functions of which the parameters are known; None for any other."""
    target = pointee(type_)
    exact = target is not None
    inner = target if target is not None else type_ if dotted(type_) == "function" else argument(type_, 0)
    if not (exact or dotted(type_).rpartition(".")[2] in _FUNCTIONS) or dotted(inner) != "function":
        return None
    if not isinstance(inner, TypeOf) or not inner.arguments:
        return None
    result, *given = inner.arguments
    return Wanted(tuple(given), result, exact)


def of_pattern(
    machine: Engine, env: ModuleValue, pattern: TypePattern, bindings: Mapping[str, Value], generic: frozenset[str]
) -> Wanted | None:
    """The same of a type as it is written, with parameters of a template in it."""
    inner = pattern
    if pattern.names[-1:] and pattern.names[-1] in _FUNCTIONS and len(pattern.arguments) == 1:
        inner = pattern.arguments[0]
    if inner.builtin != "function" or not inner.arguments:
        return None

    def known(each: TypePattern) -> Value | TypePattern:
        return each if mentions(each, generic) else type_of_pattern(machine, env, each, bindings)

    result, *given = inner.arguments
    written = known(result)
    return Wanted(
        tuple(known(each) for each in given if not each.pack),
        written if isinstance(written, Value) else NONE,
        exact=inner is pattern,
        open=any(each.pack for each in given),
    )


def may_be(machine: Engine, value: Value, wanted: Wanted, generic: frozenset[str] = frozenset()) -> bool | None:
    """Whether what can be called fits what a type says; None where it may."""
    found: set[bool | None] = set()
    for option in options(plain_callable(machine, value)):
        taken = _taken(machine, option)
        found.add(None if taken is None else _fits(machine, taken, wanted, generic))
    return True if found == {True} else None if found & {True, None} else False


def deduce_from(
    machine: Engine, value: Value, pattern: TypePattern, names: frozenset[str], bindings: dict[str, Value]
) -> Value:
    """Bind parameters of a template by what a function takes that is given for a function type; the class that it is a member of, NONE of none."""
    inner = pattern.arguments[0] if pattern.names and len(pattern.arguments) == 1 else pattern
    options_ = options(plain_callable(machine, value))
    taken = _taken(machine, options_[0]) if len(options_) == 1 else None
    if taken is None or inner.builtin != "function" or not inner.arguments:
        return NONE
    result, *given = inner.arguments
    for index, each in enumerate(given):
        if each.pack:
            if each.names[-1:] and each.names[0] in names and NONE not in taken.types[index:]:
                bindings.setdefault(each.names[0], Tuple(taken.types[index:]))
            break
        if index < len(taken.types) and taken.types[index] != NONE:
            match(machine, each, taken.types[index], names, bindings, written=True)
    if taken.result != NONE:
        match(machine, result, taken.result, names, bindings)
    return taken.cls


def _taken(machine: Engine, value: Value) -> Taken | None:
    patterns = parameters(machine, value)
    function = function_behind(machine, value)
    is_bound = isinstance(value, (BoundMethod, Partial))
    while isinstance(function, (BoundMethod, Partial)):
        function = function.function
    signature = function.code.signature if isinstance(function, Function) else None
    if patterns is None or signature is None or not isinstance(function, Function):
        return None
    env = ModuleValue(function.module.address, function.module.name, function.code.file)
    generic = frozenset(p.name for p in signature.template)
    types = tuple(
        NONE if mentions(each, generic) or not (each.names or each.builtin) else type_of_pattern(machine, env, each)
        for each in patterns
    )
    symbol = linked(machine).declared.get(function.code.key)  # None of a lambda
    own = is_member(function) and symbol is not None
    most = None if (own and is_bound) or _takes_any(signature) else len(types)  # what `bind` makes drops the others
    optional = sum(1 for p in signature.parameters[-len(types) :] if p.default or p.pack) if types else 0
    info = linked(machine).info(function.module) if own and not is_bound else None
    written = symbol.type if symbol is not None and not symbol.template else None
    result = evaluate(machine, written, function.module) if written is not None else NONE
    cls = info.cls if info is not None and info.cls is not None else NONE
    return Taken(types, patterns, len(types) - optional, most, result, cls)


def _takes_any(signature: Signature) -> bool:
    return any(p.pack or p.type.builtin == "..." for p in signature.parameters)


def _fits(machine: Engine, taken: Taken, wanted: Wanted, generic: frozenset[str]) -> bool | None:
    types, written = taken.types, taken.written
    count = len(wanted.parameters)
    if taken.cls != NONE and not wanted.exact:  # the object is the first that is given
        types, written, count = (taken.cls, *types), (TypePattern(), *written), count - 1
    too_many = taken.most is not None and count > taken.most
    if (count < taken.least and not wanted.open) or too_many or (wanted.exact and taken.most is None and count == 0):
        return False
    answers = set(_each(machine, types, written, wanted, generic))
    if "void" in {dotted(taken.result), dotted(wanted.result)} and taken.result != wanted.result:
        answers.add(None if NONE in {taken.result, wanted.result} else not wanted.exact and _is_void(wanted.result))
    return False if False in answers else None if None in answers else True


def _is_void(type_: Value) -> bool:
    return dotted(type_) == "void"


def _each(
    machine: Engine,
    types: tuple[Value, ...],
    written: tuple[TypePattern, ...],
    wanted: Wanted,
    generic: frozenset[str],
) -> Iterator[bool | None]:
    bindings: dict[str, Value] = {}
    for given, own, pattern in zip(wanted.parameters, types, written, strict=False):
        if own == NONE or dotted(own) == "auto":
            yield None
        elif isinstance(given, TypePattern):
            is_other = wanted.exact and _is_referred_otherwise(given, pattern)
            yield not is_other and match(machine, given, own, generic, bindings, written=True) and None
        else:
            yield _converts(_bare(given), _bare(own), exact=wanted.exact)


def _is_referred_otherwise(given: TypePattern, own: TypePattern) -> bool:
    """Whether one parameter is a reference and the other is none, or one to what is constant."""
    return given.reference != own.reference or (bool(given.reference) and given.const and not own.const)


def _converts(given: Value, own: Value, *, exact: bool) -> bool | None:
    """Whether what a function is given is, or becomes, what it takes."""
    if given == own:
        return True
    targets = pointee(given), pointee(own)
    if targets[0] is not None and targets[1] is not None:
        return _converts(_bare(targets[0]), _bare(targets[1]), exact=True)
    shapes = shape_of(given), shape_of(own)
    if shapes[0] in _NUMBERS and shapes[1] in _NUMBERS:
        return number_named(dotted(given)) == number_named(dotted(own)) or not exact
    if all(map(_is_plain, (given, own))):
        return False  # pointers, messages, texts and numbers do not become one another
    if isinstance(given, Class) and isinstance(own, Class):
        return True if own in given.mro else None
    return None


def _is_plain(type_: Value) -> bool:
    return is_message(type_) or pointee(type_) is not None or shape_of(type_) in _PLAIN


def _bare(type_: Value) -> Value:
    while isinstance(type_, TypeOf) and type_.name in _AROUND and type_.arguments:
        type_ = type_.arguments[0]
    return type_
