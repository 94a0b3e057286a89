# SPDX-License-Identifier: Apache-2.0
"""Is a specialisation of a template for these arguments?

template <class T> struct Box<std::vector<T>>                                        for Box<std::vector<int>>, with T = int
template <class T> struct Box<T, std::enable_if_t<std::is_integral_v<T>>>            what is written is evaluated
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import Tuple
from rosward.domain.slots import TypeOf
from rosward.domain.unknown import Cause
from rosward.domain.values import Choice, ModuleValue, Unknown, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.types import flat, match
from rosward.ir.symbols import Symbol, SymbolKind
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.program import Code
    from rosward.ir.symbols import TypePattern

__all__ = ["meant_for", "specialised"]


def specialised(machine: Engine, symbol: Symbol, env: ModuleValue, given: tuple[Value, ...]) -> dict[str, Value] | None:
    """What the parameters of a partial specialisation are for these arguments; None where it is not, or may not be, for them."""
    found = meant_for(machine, symbol, env, given)
    return None if isinstance(found, Unknown) else found


def meant_for(
    machine: Engine, symbol: Symbol, env: ModuleValue, given: tuple[Value, ...]
) -> dict[str, Value] | Unknown | None:
    """The same; something unknown where it may be for them."""
    patterns, tested = symbol.specialises or (), symbol.tested
    env = ModuleValue(env.address, env.name, symbol.place.file)  # it is written with the names of its file
    given = flat(given)
    wanted = frozenset(p.name for p in symbol.template or ())
    bindings: dict[str, Value] = {}
    asked: list[tuple[Code, Value]] = []
    open_ = False
    for index, pattern in enumerate(patterns):
        if pattern.pack and len(pattern.names) == 1 and pattern.names[0] in wanted:
            bindings[pattern.names[0]] = Tuple(given[index:])
            break
        if index >= len(given):
            return None
        code = tested[index] if index < len(tested) else None
        if code is not None and _is_asked(machine, env, pattern, wanted):
            asked.append((code, given[index]))
        elif not _mentions(pattern, wanted):
            if type_of_pattern(machine, env, pattern) != given[index]:
                if not _is_open(given[index]):
                    return None
                open_ = True
        elif not match(machine, pattern, given[index], wanted, bindings, sure=True):
            if not _is_open(given[index]) or not match(machine, pattern, given[index], wanted, bindings):
                return None
            open_ = True
    else:
        if len(patterns) < len(given):
            return None
    for parameter in symbol.template or ():  # of a pattern that says more than can be matched
        if parameter.name not in bindings:
            bindings[parameter.name] = machine.unknown(Cause.CALL, f"template argument {parameter.name}")
    if open_:
        return machine.unknown(Cause.CALL, f"whether {symbol.name} is specialised for this")
    return _answered(machine, symbol, env, bindings, asked)


def _is_open(type_: Value) -> bool:
    """Whether a template argument is not known, or not all of it."""
    if isinstance(type_, (TypeOf, Tuple)):
        return any(map(_is_open, type_.arguments if isinstance(type_, TypeOf) else type_.items))
    return isinstance(type_, (Choice, Unknown))


def _is_asked(machine: Engine, env: ModuleValue, pattern: TypePattern, wanted: frozenset[str]) -> bool:
    """Whether an argument of a specialisation is something to evaluate: `decltype(…)`, `typename T::x`, `std::enable_if_t<…>`, an alias."""
    names_ = pattern.names
    if not names_:
        return bool(pattern.builtin) and pattern.builtin != "function"
    if not _mentions(pattern, wanted):
        return False
    if (len(names_) > 1 and names_[0] in wanted) or (names_[-1] in wanted and pattern.arguments):
        return True
    words = names_[1:] if names_[0] == "" else names_
    found = names.resolve(machine, env, [names.Part(word) for word in words], absolute=names_[0] == "")
    if isinstance(found, names.Found):
        return found.symbols[0].kind is SymbolKind.ALIAS
    return names_[-1].endswith("_t") and bool(pattern.arguments)


def _answered(
    machine: Engine, symbol: Symbol, env: ModuleValue, bindings: dict[str, Value], asked: list[tuple[Code, Value]]
) -> dict[str, Value] | Unknown | None:
    types = tuple(bindings[p.name] for p in symbol.template or ())
    applied = any(_applies(pattern, frozenset(bindings)) for pattern in symbol.specialises or ())
    open_ = machine.unknown(Cause.CALL, f"{symbol.name} of a template") if applied and asked else None
    for code, wanted in asked:
        found = read(machine, evaluate(machine, code, env, types=types))
        if isinstance(found, (Unknown, Choice)) or isinstance(wanted, (Unknown, Choice)):
            open_ = machine.unknown(Cause.CALL, f"whether {symbol.name} is specialised for this")
        elif found != wanted:
            return None
    return open_ or bindings


def _mentions(pattern: object, wanted: frozenset[str]) -> bool:
    written: tuple[str, ...] = getattr(pattern, "names", ())
    arguments: tuple[object, ...] = getattr(pattern, "arguments", ())
    words: list[str] = _WORD.findall(getattr(pattern, "builtin", ""))
    return any(n in wanted for n in (*written, *words)) or any(_mentions(a, wanted) for a in arguments)


def _applies(pattern: TypePattern, wanted: frozenset[str]) -> bool:
    """Whether a pattern says what a template that is a parameter makes of something: `Op<T>`."""
    own = pattern.names[-1:] and pattern.names[-1] in wanted and bool(pattern.arguments)
    return bool(own) or any(_applies(each, wanted) for each in pattern.arguments)


_WORD: Final = re.compile(r"[A-Za-z_]\w*")
