# SPDX-License-Identifier: Apache-2.0
"""Algorithms that take a container instead of two iterators: `std::ranges`, `std::erase_if`, `boost::range`.

std::ranges::sort(names)                    std::sort(names.begin(), names.end())
std::erase_if(names, f)                     what is left of a vector, string, set or map
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import options
from rosward.domain.compound import External
from rosward.domain.slots import Slot
from rosward.domain.values import Ref, Value
from rosward.models.cpp.algorithms import changing, searching
from rosward.models.cpp.iteration.contained import erased
from rosward.models.cpp.iteration.iterators import as_iterator, begin, end, keys_in_order
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers import dicts
from rosward.models.python.plain import unknown_from

__all__ = ["NATIVES"]

_SPACES: Final = ("std.ranges", "boost.range", "boost.algorithm")
_NOT_OF_BOOST: Final = frozenset({"find", "replace", "copy"})


def _of_range(name: str) -> NativeFunction:
    """An algorithm of `std::ranges`, on a container or, as the older one, on iterators."""
    plain = f"std.{name}"
    function = {**changing.NATIVES, **searching.NATIVES}[plain]

    def apply(call: NativeCall) -> Value:
        first = call.args[0]
        if as_iterator(read(call.machine, first)) is not None:
            return function(call._replace(name=plain))
        ends = (begin(call.machine, first), end(call.machine, first))
        return function(call._replace(name=plain, args=(*ends, *call.args[1:])))

    return apply


def _erase(call: NativeCall) -> Value:
    """std::erase(container, value), std::erase_if(container, f)."""
    machine, place = call.machine, call.args[0]
    by = "remove_if" if call.name.endswith("_if") else "remove"
    for option in options(read(machine, place)):
        if isinstance(option, Ref) and machine.obj(option).kind == "dict":
            _erase_entries(machine, option, read(machine, call.args[1]))
        elif isinstance(option, Ref):
            last = machine.call(External(f"std.{by}"), (begin(machine, option), end(machine, option), *call.args[1:]))
            erased(machine, option, last, end(machine, option))
        elif place.__class__ is Slot:
            last = machine.call(External(f"std.{by}"), (begin(machine, place), end(machine, place), *call.args[1:]))
            machine.call(External("std.string.erase"), (place, last, end(machine, place)))
    return unknown_from(machine, call.name, "int", read(machine, call.args[1]))


def _erase_entries(machine: Machine, ref: Ref, function: Value) -> None:
    keys = keys_in_order(machine, ref)
    for key in (*keys.known, *(() if keys.rest is None else (keys.rest,))):
        answer = machine.truth(machine.call(function, (Slot(ref, "entry", key),)))
        if answer is False:
            continue
        obj = machine.obj(ref)
        if answer and keys.rest is None:
            dicts.take(machine, ref, key)
        else:
            machine.update(ref, obj.replace(maybe=obj.maybe | {k for k in obj.entries if key in (k, keys.rest)}))


NATIVES: Final[dict[str, NativeFunction]] = {
    **{
        f"{space}.{name.removeprefix('std.')}": _of_range(name.removeprefix("std."))
        for space in _SPACES
        for name in (*changing.NATIVES, *searching.NATIVES)
        if name.count(".") == 1 and not (space.startswith("boost") and name.removeprefix("std.") in _NOT_OF_BOOST)
    },
    "std.erase": _erase,
    "std.erase_if": _erase,
}
