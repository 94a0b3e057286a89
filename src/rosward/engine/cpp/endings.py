# SPDX-License-Identifier: Apache-2.0
"""What ends, and which destructors run then?

{ Guard guard; }                     at the end of its block, with what it holds by value
std::unique_ptr<Lamp> p; p.reset()   what a pointer alone owns ends with the pointer, or where it gets another
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.slots import Pointer
from rosward.domain.values import NONE, UNBOUND, Class, Ref, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.cpp import calls, names
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.values import overloads
from rosward.models.cpp.values.types import argument, name_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["end", "end_with"]

_NESTED: Final = 6
"""How deep in an object the ends of what it holds are followed."""


def _has_values(cls: Value) -> bool:
    """Whether what a container holds is its own: in a tuple (`std::tie(lamp)`), or in wrappers of references, it may be of others."""
    return name_of(cls) != "std.tuple" and name_of(argument(cls, 0)) != "std.reference_wrapper"


def _destroy(machine: Engine, ref: Ref, depth: int) -> bool:
    """An object ends: the destructors of its class, of what it holds by value, and of its bases run; False where one never ends."""
    program = linked(machine)
    obj = machine.obj(ref)
    if obj.kind in ("list", "dict"):
        return _end_parts(machine, ref, depth)
    for each in obj.cls.mro if isinstance(obj.cls, Class) else ():
        info = program.info(each)
        if info is None:
            continue
        symbols = program.members(info, f"~{info.symbol.name}")
        if symbols:
            function = overloads(machine, names.Found(tuple(symbols), info.env, info), (), ref)
            if calls.invoke(machine, function, ()) is UNBOUND:
                return False
        for symbol in reversed(info.fields) if depth < _NESTED else ():
            key = program.key_in(machine, ref, info, symbol.name)
            held = machine.obj(ref).attrs.get(key) if key is not None and symbol.name not in info.references else None
            if held is not None and not end(machine, held, depth + 1):
                return False
    return True


def end(machine: Engine, value: Value, depth: int = 0) -> bool:
    """What a variable held ends, whichever it is; False where a destructor never does."""
    several = dict.fromkeys(_owned(option) for option in options(value))
    ending = each_apart(machine, list(several), lambda o: NONE if o is None or _destroy(machine, o, depth) else UNBOUND)
    return ending is not UNBOUND


def _owned(value: Value) -> Ref | None:
    """The object that ends with a value; None where the value owns none, or may have given it away."""
    if isinstance(value, Pointer) and value.owner == "unique":
        value = value.target
    return value if isinstance(value, Ref) else None


_ENDING: Final = frozenset(
    f"std.{name}" for name in ("shared_ptr.reset", "optional.reset", "optional.emplace", "vector.clear", "map.clear")
)
"""Methods that end what their object holds."""


def end_with(machine: Engine, native: str, value: Value) -> bool:
    """What a method of a library ends that is called on a value; False where a destructor never does."""
    if native not in _ENDING:
        return True
    if not isinstance(value, Ref):
        return end(machine, value, 0)
    return _end_parts(machine, value, 0)


def _end_parts(machine: Engine, ref: Ref, depth: int) -> bool:
    """What a container holds ends, as far as it is known to be there."""
    obj = machine.obj(ref)
    if not _has_values(obj.cls) or depth >= _NESTED:
        return True
    held = (*(obj.items or ()), *(value for key, value in obj.entries.items() if key not in obj.maybe))
    backwards = name_of(obj.cls) in ("array", "std.array")
    return all(end(machine, item, depth + 1) for item in (reversed(held) if backwards else held))
