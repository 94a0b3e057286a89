# SPDX-License-Identifier: Apache-2.0
"""What does a name stand for, seen from where the code stands?

namespace lamp { const char * TOPIC = "state"; class Lamp { void on() { advertise(TOPIC); } }; }
TOPIC       block, then Lamp and its bases, then lamp with what it uses, then the global namespace
a::b::c     a like that, b and c in what stands before them; what is declared nowhere belongs to a library: External("a.b.c")
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final, TypeVar

from rosward.domain.compound import External
from rosward.domain.slots import TypeOf
from rosward.domain.values import Class, ModuleValue, Unknown, Value
from rosward.engine.cpp.linked import Info, Linked, linked
from rosward.engine.cpp.types import dotted
from rosward.ir.symbols import Scope, Symbol, SymbolKind
from rosward.models.cpp.constants import known_member, known_name
from rosward.models.interfaces import message_name
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["Found", "Part", "in_class", "in_namespace", "outer_of", "resolve", "seeing", "unqualified"]

_SOURCES: Final = (".cpp", ".cc", ".cxx", ".C", ".c++")
_DEPTH: Final = 30


class Found(NamedTuple):
    """What is declared under a name, and the scope that has it."""

    symbols: tuple[Symbol, ...]
    env: ModuleValue
    owner: Info | None = None


class Part(NamedTuple):
    """One part of a qualified name with its template arguments; None where none are written."""

    name: str
    types: tuple[Value, ...] | None = None


class Namespace(NamedTuple):
    """A namespace on the way through a qualified name."""

    scope: Scope


Step = Namespace | Found | Value
"""Where the way through a qualified name has led."""


def outer_of(machine: Engine, env: ModuleValue) -> ModuleValue | None:
    """The scope around a scope."""
    program = linked(machine)
    info = program.info(env)
    if info is not None:
        return info.outer
    scope = program.scope_of(env)
    return program.namespace(machine, scope[:-1], env.file) if scope else None


def unqualified(machine: Engine, env: ModuleValue, name: str, using: tuple[Scope, ...] = ()) -> Found | Value | None:
    """What a name stands for at a place: declarations, or the argument of a template; None where nothing is declared."""
    program = linked(machine)
    key = (env.address, name, env.file)
    if not using and key in program.found:
        return program.found[key]  # type: ignore[return-value]  # it holds what this function gave
    result = _unqualified(machine, program, env, name, using)
    program.found[key] = result
    return result


def _unqualified(
    machine: Engine, program: Linked, env: ModuleValue, name: str, using: tuple[Scope, ...]
) -> Found | Value | None:
    here: ModuleValue | None = env
    elsewhere: Value | None = None
    while here is not None:
        info = program.info(here)
        if info is not None:
            if name in info.bindings:
                return info.bindings[name]
            elsewhere = elsewhere or info.elsewhere.get(name)
            named = _injected(machine, info, name)
            if named is not None:
                return named
            found = in_class(machine, info, name)
            if found is None and name in info.around:
                return info.around[name]
        else:
            found = in_namespace(machine, program.scope_of(here), name, env.file)
            if found is None and not program.scope_of(here):
                for target in using:
                    scope = namespace_of(machine, env, target)
                    found = found or (None if scope is None else in_namespace(machine, scope, name, env.file))
        if found is not None:
            return found
        here = outer_of(machine, here)
    return elsewhere


def _injected(machine: Engine, info: Info, name: str) -> Value | None:
    """The class itself, or a base of it, by the name that it has in its own scope."""
    for each in info.cls.mro if info.cls is not None else ():
        own = linked(machine).info(each)
        if own is not None and own.symbol.name == name:
            return each
    return None


_Any = TypeVar("_Any")


def _of_template(machine: Engine, found: _Any, part: Part, file: str) -> _Any | Found:
    """In `Box<T>`, the name `Box` is the class; with arguments it is the template again."""
    if part.types is None or not isinstance(found, Class):
        return found
    program = linked(machine)
    info = program.info(found)
    if info is None or not info.types or info.symbol.name != part.name:
        return found
    outer = program.info(info.outer)
    if outer is not None:
        return in_class(machine, outer, part.name) or found
    return in_namespace(machine, program.scope_of(info.outer), part.name, file) or found


def in_class(machine: Engine, info: Info, name: str) -> Found | None:
    """The member of a class or of one of its bases."""
    program = linked(machine)
    for each in info.cls.mro if info.cls is not None else ():
        own = program.info(each)
        if own is None:
            continue
        symbols = own.special.get(name) or [s for s in program.members(own, name) if not _names_constructors(s)]
        if symbols:
            return Found(tuple(symbols), own.env, own)
        if name in own.bindings:
            return None
    return None


def _names_constructors(symbol: Symbol) -> bool:
    """`using Base::Base` stands for constructors, which have no name."""
    return symbol.kind is SymbolKind.USING and symbol.target[-2:-1] == symbol.target[-1:]


def in_namespace(machine: Engine, scope: Scope, name: str, file: str, depth: int = 0) -> Found | None:
    """What a namespace declares under a name, in its unnamed namespaces and by what it uses."""
    program = linked(machine)
    for where in (scope, (*scope, "")):
        symbols = _visible(program.symbols.at(where, name), file)
        if symbols:
            return Found(tuple(symbols), program.namespace(machine, where, symbols[0].unit))
    if depth < _DEPTH:
        for used in (*program.symbols.used(scope), *program.symbols.used((*scope, ""))):
            if used.unit and used.unit != file and used.unit.endswith(_SOURCES):
                continue
            target = _used(machine, scope, used)
            if target is not None and target != scope:
                found = in_namespace(machine, target, name, file, depth + 1)
                if found is not None:
                    return found
    return None


def seeing(machine: Engine) -> str:
    """The file of the code that runs: what a source keeps to itself is seen from there."""
    return machine.frames[-1].code.file if machine.frames else ""


def _used(machine: Engine, scope: Scope, used: Symbol) -> Scope | None:
    """The namespace that a `using namespace` in a scope names; None on the way to itself, for it is one of those that are used there."""
    known = linked(machine).used
    if used.key not in known:
        known[used.key] = None
        known[used.key] = namespace_of(machine, linked(machine).namespace(machine, scope), used.target)
    return known[used.key]


def _visible(symbols: Sequence[Symbol], file: str) -> Sequence[Symbol]:
    """Those that code of a file can mean: what another source keeps to itself is none of them."""
    if all(not s.unit for s in symbols):
        return symbols
    return [s for s in symbols if not s.unit or s.unit == file or not s.unit.endswith(_SOURCES)]


def namespace_of(machine: Engine, env: ModuleValue, names: Scope) -> Scope | None:
    """The namespace that is written so in a scope; None where there is none."""
    step: Step | None = None
    absolute = bool(names) and names[0] == ""
    for index, name in enumerate(names[1:] if absolute else names):
        if index == 0:
            step = _first(machine, env, name, absolute=absolute)
        elif isinstance(step, Namespace):
            step = _in_namespace_step(machine, step.scope, name, env.file)
        if not isinstance(step, Namespace):
            return None
    return step.scope if isinstance(step, Namespace) else () if absolute else None


def _first(machine: Engine, env: ModuleValue, name: str, *, absolute: bool) -> Step | None:
    """The first of several parts: a namespace or a class, the innermost that is there."""
    program = linked(machine)
    here: ModuleValue | None = program.namespace(machine, (), env.file) if absolute else env
    elsewhere: Value | None = None
    while here is not None:
        info = program.info(here)
        if info is not None:
            if name in info.bindings:
                return info.bindings[name]
            elsewhere = elsewhere or info.elsewhere.get(name)
            named = _injected(machine, info, name)
            if named is not None:
                return named
            found = in_class(machine, info, name)
            if found is not None and _is_scope(found):
                return found
            if name in info.around:
                return info.around[name]
        else:
            step = _in_namespace_step(machine, program.scope_of(here), name, env.file)
            if step is not None:
                return step
        here = outer_of(machine, here)
    return elsewhere


def _in_namespace_step(machine: Engine, scope: Scope, name: str, file: str) -> Step | None:
    """A part in the middle of a name: a namespace or class in a namespace."""
    program = linked(machine)
    found = in_namespace(machine, scope, name, file)
    if found is not None:
        first = found.symbols[0]
        if first.kind is SymbolKind.NAMESPACE_ALIAS or (first.kind is SymbolKind.USING and not _leads_to_type(first)):
            target = namespace_of(machine, found.env, first.target)
            if target is not None:
                return Namespace(target)
            if first.kind is SymbolKind.NAMESPACE_ALIAS:
                return External(".".join(n for n in first.target if n))
        if _is_scope(found):
            return found
    if program.symbols.is_namespace((*scope, name)):
        return Namespace((*scope, name))
    for used in program.symbols.used(scope):
        if used.unit and used.unit != file and used.unit.endswith(_SOURCES):
            continue
        target = _used(machine, scope, used) if used.target[-1:] != (name,) else None
        if target is not None and target != scope and program.symbols.is_namespace((*target, name)):
            return Namespace((*target, name))
    return None


def _leads_to_type(symbol: Symbol) -> bool:
    return bool(symbol.target) and symbol.target[-1][:1].isupper()


def _is_scope(found: Found) -> bool:
    kinds = {SymbolKind.CLASS, SymbolKind.ENUM, SymbolKind.ALIAS, SymbolKind.USING}
    return any(s.kind in kinds for s in found.symbols)


def resolve(
    machine: Engine,
    env: ModuleValue,
    parts: Sequence[Part],
    *,
    base: Value | None = None,
    absolute: bool = False,
    using: tuple[Scope, ...] = (),
) -> Found | Value:
    """What a name of several parts stands for."""

    def value_of(found: Found, part: Part) -> Value:
        return linked(machine).value_of(machine, found, part.types)

    step: Step | None = base
    rest = list(parts)
    if step is None:
        if len(rest) == 1:
            if absolute:
                found = in_namespace(machine, (), rest[0].name, env.file)
                return found if found is not None else _external("", rest[0])
            found_here = _of_template(machine, unqualified(machine, env, rest[0].name, using), rest[0], env.file)
            return (
                found_here
                if found_here is not None
                else _external(_library(machine, env, rest[0].name, using), rest[0])
            )
        part = rest.pop(0)
        step = _of_template(machine, _first(machine, env, part.name, absolute=absolute), part, env.file)
        if step is None:
            for target in using:
                scope = namespace_of(machine, env, target)
                step = step or (None if scope is None else _in_namespace_step(machine, scope, part.name, env.file))
        if step is None:
            step = _external("", part)
        elif isinstance(step, Found):
            step = value_of(step, part)
    while rest:
        part = rest.pop(0)
        last = not rest
        if isinstance(step, Namespace):
            if last:
                found = in_namespace(machine, step.scope, part.name, env.file)
                return found if found is not None else _external(".".join(n for n in step.scope if n), part)
            inner = _in_namespace_step(machine, step.scope, part.name, env.file)
            if inner is None:
                inner = _external(".".join(n for n in step.scope if n), part)
            step = value_of(inner, part) if isinstance(inner, Found) else inner
        else:
            assert step is not None
            assert not isinstance(step, Found)
            member = _in_value(machine, step, part)
            if last:
                return member
            step = value_of(member, part) if isinstance(member, Found) else member
    assert step is not None
    return External(".".join(step.scope)) if isinstance(step, Namespace) else step


def _in_value(machine: Engine, value: Value, part: Part) -> Found | Value:
    """A member of a class or type."""
    program = linked(machine)
    info = program.info(value)
    if info is not None:
        named = _injected(machine, info, part.name)
        if named is not None:
            return named if part.types is None else _of_template(machine, named, part, "") or named
        found = in_class(machine, info, part.name)
        if found is not None:
            return found
        if part.name in info.bindings:
            return info.bindings[part.name]
    if isinstance(value, Unknown):
        return value
    if isinstance(value, External):  # an enum is no scope at run time: its enumerators are found by its name
        names = tuple(value.name.split("."))
        symbols = program.symbols.at(names, part.name)
        if symbols:
            return Found(tuple(symbols), program.namespace(machine, names))
    for base in value.mro if isinstance(value, Class) else (value,):
        known = None if isinstance(base, Class) else known_member(base, part.name)
        if known is not None:
            return known
    return _external(dotted(value), part)


def _external(before: str, part: Part) -> Value:
    """What a library declares: a constant or type that is known, else something of that name."""
    name = f"{before}.{part.name}" if before else part.name
    known = known_name(name, part.types)
    if known is not None:
        return known
    if name.endswith("_") and message_name(name[:-1]) is not None:
        return External(name[:-1])  # `String_<std::allocator<void>>` is what a String is
    return External(name) if part.types is None else TypeOf(name, part.types)


def _may_have(space: str, name: str) -> bool:
    """Whether a namespace of a library may have a name: that of interfaces has `msg`, `srv` and `action` alone, and these have types alone."""
    if space.endswith((".msg", ".srv", ".action")):
        return name[:1].isupper()
    return not space.endswith(("_msgs", "_srvs", "_interfaces"))


def _library(machine: Engine, env: ModuleValue, name: str, using: tuple[Scope, ...]) -> str:
    """The namespace of a library that an unknown name may belong to, of those that are used; '' where none is the only one."""
    candidates = list(dict.fromkeys(_used_libraries(machine, env, using)))
    native = machine.library.native
    known = [c for c in candidates if native(f"{c}.{name}") or native(f"{c}.{name}.new")]
    if known or native(name):  # a macro of a library is in no namespace
        return known[0] if known else ""
    others = [c for c in candidates if not c.startswith("std.") and _may_have(c, name)]
    return others[0] if len(others) == 1 else ""


def _used_libraries(machine: Engine, env: ModuleValue, using: tuple[Scope, ...]) -> Iterator[str]:
    program = linked(machine)
    for target in using:
        if namespace_of(machine, env, target) is None or target[:1] == ("std",):
            yield ".".join(n for n in target if n)
    here: ModuleValue | None = env
    while here is not None:
        for used in program.symbols.used(program.scope_of(here)) if program.info(here) is None else ():
            if used.unit and used.unit != env.file and used.unit.endswith(_SOURCES):
                continue
            if namespace_of(machine, here, used.target) is None or used.target[:1] == ("std",):
                yield ".".join(n for n in used.target if n)
        here = outer_of(machine, here)
