# SPDX-License-Identifier: Apache-2.0
"""Which constructors has a class, and what do they take?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.values import NONE, Class, Function, Ref, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.binding import deduce
from rosward.engine.cpp.categories import cast_to
from rosward.engine.cpp.handing import is_a
from rosward.engine.cpp.linked import Info, linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.engine.cpp.thunks import evaluate
from rosward.engine.cpp.values import function_of, value_of
from rosward.ir.symbols import Symbol, SymbolKind
from rosward.models.cpp.values.contents import content_base
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import Shape, name_of, shape_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = [
    "closed",
    "constructors",
    "inherited_constructors",
    "inheriting",
    "is_copy",
    "is_copying",
    "is_one",
    "least",
    "outside",
    "takes",
    "takes_list",
]


_SEVERAL: Final = frozenset({Shape.LIST, Shape.MAP, Shape.MULTIMAP, Shape.SET})


def constructors(machine: Engine, info: Info) -> list[Symbol]:
    """Those that are written."""
    symbols = linked(machine).members(info, info.symbol.name)
    return [s for s in symbols if s.kind is SymbolKind.FUNCTION]


def takes_list(machine: Engine, info: Info) -> bool:
    """Whether one takes a `std::initializer_list` first."""
    return inherits_list(machine, info) or any(
        p.type.names[-1:] == ("initializer_list",) for s in constructors(machine, info) for p in s.parameters[:1]
    )


def takes(function: Function, count: int) -> bool:
    """Whether a function may be called with so many arguments."""
    signature = function.code.signature
    least = sum(1 for p in signature.parameters if not p.default and not p.pack) if signature is not None else 0
    most = len(signature.parameters) if signature is not None else count
    return least <= count and (count <= most or (signature is not None and any(p.pack for p in signature.parameters)))


def least(symbol: Symbol) -> int:
    """How many arguments a function needs."""
    return sum(1 for p in symbol.parameters if not p.default and not p.pack)


def is_copying(info: Info, symbol: Symbol) -> bool:
    """Whether a constructor copies or moves an object of its class."""
    first = symbol.parameters[0].type if len(symbol.parameters) == 1 else None
    return first is not None and first.names[-1:] == (info.symbol.name,) and bool(first.reference)


def is_one(machine: Engine, value: Value, cls: Class) -> bool:
    """Whether a value is an object of a class, or of one that derives from it."""
    return all(is_a(machine, option, cls) for option in options(read(machine, value)))


def is_copy(machine: Engine, info: Info, args: tuple[Value, ...]) -> bool:
    """Whether nothing is given but an object of the class, so that it is copied: not by a constructor for what derives from it.

    template<class T> explicit Sensors(T & node);  Crtp(D & self);      class Driver : Crtp<Driver> {Driver() : Crtp(*this) {}}
    """
    if len(args) != 1 or info.cls is None or not is_one(machine, args[0], info.cls):
        return False
    classes = {machine.obj(o).cls for o in options(read(machine, args[0])) if isinstance(o, Ref)}
    if info.cls in classes or cast_to(machine, args):
        return True
    return not any(_takes_derived(machine, info, symbol) for symbol in constructors(machine, info))


def _takes_derived(machine: Engine, info: Info, symbol: Symbol) -> bool:
    """Whether a constructor takes an object of a class that derives from its own, as what it is."""
    if least(symbol) > 1 or not symbol.parameters:
        return False
    pattern = symbol.parameters[0].type
    if len(pattern.names) == 1 and any(p.name == pattern.names[0] for p in symbol.template or ()):
        return not pattern.pointers
    type_ = type_of_pattern(machine, info.env, pattern)
    derived = linked(machine).info(type_) if isinstance(type_, Class) else None
    cls = derived.cls if derived is not None else None  # what is named in its own bases is not whole
    return cls is not None and cls != info.cls and info.cls in cls.mro


def outside(info: Info) -> Value | None:
    """The base that is no class of the program of which a class has the constructors: `using std::vector<Corner>::vector`."""
    bases = [b for b in info.cls.bases if not isinstance(b, Class) and name_of(b)] if info.cls is not None else []
    if not bases:
        return None
    usings = [s.target for s in info.symbol.members if s.kind is SymbolKind.USING and s.target]
    for base in bases:
        own = name_of(base).rpartition(".")[2]
        if own and any(u[-1] == own or u[-2:-1] == u[-1:] for u in usings):
            return base
    return None


def inherits_list(machine: Engine, info: Info) -> bool:
    """Whether what stands in braces is what an object of the class then holds."""
    base = content_base(info.cls) if info.cls is not None else None
    if base is None or shape_of(base) not in _SEVERAL:
        return False
    return outside(info) is not None or any(takes_list(machine, base) for base in inheriting(machine, info))


def inheriting(machine: Engine, info: Info) -> list[Info]:
    """The bases of which a class has the constructors: `using Base::Base`."""
    found: list[Info] = []
    for symbol in info.symbol.members:
        if symbol.kind is SymbolKind.USING and symbol.code is not None:
            base = linked(machine).info(evaluate(machine, symbol.code, info.env))
            if base is not None and symbol.target[-1:] in ((base.symbol.name,), symbol.target[-2:-1]):
                found.append(base)
    return found


def inherited_constructors(machine: Engine, bases: list[Info]) -> dict[Function, Info]:
    """The constructors that a class has of its bases, those that these have of theirs among them."""
    found: dict[Function, Info] = {}
    for base in bases:
        own = [function_of(machine, s, base.env) for s in constructors(machine, base) if not is_copying(base, s)]
        above = inherited_constructors(machine, inheriting(machine, base))
        found.update(dict.fromkeys((*own, *above), base))
    return found


def closed(machine: Engine, cls: Class, info: Info, args: tuple[Value, ...]) -> tuple[Class, Info]:
    """The instance of a template that follows from the arguments of its constructor (`Box box(1)`)."""
    template = info.symbol.template or ()
    for symbol in constructors(machine, info):
        function = function_of(machine, symbol, info.env)
        signature = function.code.signature
        if signature is None or len(signature.parameters) < len(args):
            continue
        found = deduce(machine, signature._replace(template=template), args, 0)
        if any(p.name in found for p in template):
            types = tuple(found.get(p.name, info.bindings.get(p.name, NONE)) for p in template)
            instance = value_of(machine, names.Found((info.symbol,), info.outer), types)
            inner = linked(machine).info(instance)
            if isinstance(instance, Class) and inner is not None:
                return instance, inner
    return cls, info
