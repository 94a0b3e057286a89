# SPDX-License-Identifier: Apache-2.0
"""Which type does a pattern stand for in a scope? For overloads and specialisations, which are chosen before any of their code runs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from rosward.domain.slots import TypeOf
from rosward.domain.values import NONE, Const, ModuleValue, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.types import pointer_to

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.symbols import TypePattern

__all__ = ["type_of_pattern"]

_DEPTH: Final = 12
_DIGITS: Final = 20
_CONSTANTS: Final[dict[str, Value]] = {"true": Const(True), "false": Const(False), "nullptr": NONE}
_NOTHING: Final[Mapping[str, Value]] = {}


def type_of_pattern(
    machine: Engine,
    env: ModuleValue,
    pattern: TypePattern,
    bindings: Mapping[str, Value] = _NOTHING,
    depth: int = 0,
) -> Value:
    """The type, references and `const` left out."""
    if pattern.names and len(pattern.names) == 1 and pattern.names[0] in bindings:
        found = bindings[pattern.names[0]]
    elif pattern.names and depth < _DEPTH:
        found = _named(machine, env, pattern, bindings, depth)
    elif pattern.builtin == "function" and depth < _DEPTH:
        parts = (type_of_pattern(machine, env, each, bindings, depth + 1) for each in pattern.arguments)
        found = TypeOf("function", tuple(parts))
    else:
        found = _CONSTANTS.get(pattern.builtin) or _number(pattern.builtin)
    for _ in range(pattern.pointers):
        found = pointer_to(found)
    return found


def _number(word: str) -> Value:
    """An argument that is a number; a builtin type by its words."""
    return Const(int(word)) if word.isdecimal() and len(word) < _DIGITS else TypeOf(word or "auto", ())


def _named(machine: Engine, env: ModuleValue, pattern: TypePattern, bindings: Mapping[str, Value], depth: int) -> Value:
    types = tuple(type_of_pattern(machine, env, a, bindings, depth + 1) for a in pattern.arguments)
    absolute = pattern.names[0] == ""
    words = pattern.names[1:] if absolute else pattern.names
    parts = [names.Part(name) for name in words[:-1]]
    parts.append(names.Part(words[-1], types if pattern.arguments else None))
    base = bindings.get(words[0]) if len(words) > 1 else None
    if base is not None:
        parts = parts[1:]
    found = names.resolve(machine, env, parts, base=base, absolute=absolute)
    return linked(machine).value_of(machine, found, parts[-1].types) if isinstance(found, names.Found) else found
