# SPDX-License-Identifier: Apache-2.0
"""What can be called, and with what: `std::bind`, `std::function`, `std::invoke`, function objects.

std::bind(&Lamp::on, this, _1)      the member function with its object: what is called with more is called with that
std::bind(f, _2, _1)                a native that puts its arguments in their places
std::function<void()> f;            null, else the callable itself
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Final

from rosward.domain.compound import External, Native, Partial, Tuple
from rosward.domain.slots import Pointer
from rosward.domain.values import FALSE, NONE, TRUE, Ref, Value
from rosward.models.cpp.values.copies import copied, write
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import REFERENCE, is_reference
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import unknown_from

__all__ = ["NATIVES", "OF_PLACES", "kept"]

_PLACEHOLDER: Final = re.compile(r"(?:(?:std|boost)\.)?(?:placeholders\.)?_(\d)")
_BOUND: Final = External("std.bind.call")


def _place_of(value: Value) -> int:
    """Which argument a placeholder stands for, from 1; 0 for what is none."""
    match = _PLACEHOLDER.fullmatch(value.name) if isinstance(value, (External, Native)) else None
    return int(match[1]) if match is not None else 0


def _callable(machine: Machine, value: Value) -> Value:
    """What is called: a lambda or function itself, not where it stands."""
    return read(machine, value)


def _bind(call: NativeCall) -> Value:
    """std::bind(callable, arguments…): copies of them, but for what `std::ref` wraps."""
    machine = call.machine
    function, *given = call.exactly(1) + call.args[1:]
    function = _callable(machine, function)
    values = [arg if isinstance(arg, External) else kept(machine, arg) for arg in given]
    places = [_place_of(value) for value in values]
    first = next((n for n, place in enumerate(places) if place), len(values))
    if places[first:] == list(range(1, len(places) - first + 1)):
        return Partial(function, tuple(values[:first]), ()) if first else function
    return Partial(_BOUND, (Tuple((function, *values)),), ())


def kept(machine: Machine, arg: Value) -> Value:
    """What `bind` and threads keep of an argument: a copy, or what `std::ref` refers to."""
    held = read(machine, arg)
    if is_reference(held):
        return held.arguments[0]
    return copied(machine, held) if not isinstance(held, Pointer) else held


def _refer(call: NativeCall) -> Value:
    """std::ref(x), std::reference_wrapper<T>(x): a value that refers to it."""
    place = call.args[-1]
    held = read(call.machine, place)
    return held if is_reference(held) else Partial(REFERENCE, (place,), ())


def _referred(call: NativeCall) -> Value:
    held = read(call.machine, call.args[0])
    return held.arguments[0] if is_reference(held) else call.args[0]


def _call_bound(call: NativeCall) -> Value:
    """A call of what `bind` gave: each placeholder is the argument of its number."""
    machine, bound, args = call.machine, call.args[0], call.args[1:]
    function, *values = bound.items if isinstance(bound, Tuple) else (bound,)
    filled: list[Value] = []
    for value in values:
        place = _place_of(value)
        if not place:
            inner = isinstance(value, Partial) and value.function == _BOUND
            filled.append(machine.call(value, args) if inner else value)
        elif place <= len(args):
            filled.append(args[place - 1])
        else:
            filled.append(unknown_from(machine, "std.bind", ""))
    return machine.call(function, filled)


def _invoke(call: NativeCall) -> Value:
    return call.machine.call(_callable(call.machine, call.args[0]), call.args[1:])


def _bind_front(call: NativeCall) -> Value:
    machine = call.machine
    return Partial(_callable(machine, call.args[0]), tuple(kept(machine, arg) for arg in call.args[1:]), ())


def _itself(call: NativeCall) -> Value:
    return _callable(call.machine, call.exactly(1)[0])


def _new_function(call: NativeCall) -> Value:
    """std::function<…>(callable): the type comes first."""
    value = _callable(call.machine, call.args[1]) if len(call.args) > 1 else NONE
    if isinstance(value, Tuple):
        value = _callable(call.machine, value.items[0]) if value.items else NONE
    return copied(call.machine, value)


def _call_method(call: NativeCall) -> Value:
    """function(arguments…) by its name, `operator()`."""
    return call.machine.call(_callable(call.machine, call.args[0]), call.args[1:])


def _swap(call: NativeCall) -> Value:
    ours, theirs = (read(call.machine, arg) for arg in call.exactly(2))
    write(call.machine, call.args[0], theirs)
    write(call.machine, call.args[1], ours)
    return NONE


def _hash(call: NativeCall) -> Value:
    return unknown_from(call.machine, "hash", "int", *(read(call.machine, a) for a in call.args))


def _not_fn(call: NativeCall) -> Value:
    return Partial(External("std.not_fn.call"), (_callable(call.machine, call.args[0]),), ())


def _call_not(call: NativeCall) -> Value:
    decided = call.machine.truth(call.machine.call(call.args[0], call.args[1:]))
    return unknown_from(call.machine, "!", "bool") if decided is None else FALSE if decided else TRUE


# Function objects


def _object(name: str) -> Callable[[NativeCall], Value]:
    """`std::less<T>()`: something that can be called later, or `std::less<T>()(a, b)`."""

    def make(call: NativeCall) -> Value:
        del call
        return External(f"std.{name}.call")

    return make


def _two(operator: str, *, compares: bool) -> NativeFunction:
    def compute(call: NativeCall) -> Value:
        left, right = (read(call.machine, arg) for arg in call.exactly(2))
        return call.machine.compare(operator, left, right) if compares else call.machine.binary(operator, left, right)

    return compute


_COMPARING: Final = {
    "less": "<", "greater": ">", "equal_to": "==", "not_equal_to": "!=", "less_equal": "<=", "greater_equal": ">=",
}  # fmt: skip
_COMPUTING: Final = {"plus": "+", "minus": "-", "multiplies": "*", "divides": "/", "modulus": "%"}
_OBJECTS: Final = (*_COMPARING, *_COMPUTING, "hash", "identity")


def _once(call: NativeCall) -> Value:
    """std::call_once(flag, callable, arguments…): by the flag, the first time."""
    machine, flag = call.machine, read(call.machine, call.args[0])
    if isinstance(flag, Ref):
        if machine.obj(flag).attrs.get("done") == TRUE:
            return NONE
        machine.update(flag, machine.obj(flag).with_attr("done", TRUE))
    machine.call(_callable(machine, call.args[1]), call.args[2:])
    return NONE


OF_PLACES: Final = frozenset(("std.function.swap",))
NATIVES: Final[dict[str, NativeFunction]] = {
    **dict.fromkeys(("std.bind", "boost.bind"), _bind),
    _BOUND.name: _call_bound,
    **dict.fromkeys(("std.ref", "std.cref", "boost.ref", "std.reference_wrapper.new"), _refer),
    "std.reference_wrapper.get": _referred,
    REFERENCE.name: lambda call: call.machine.call(read(call.machine, call.args[0]), call.args[1:]),
    "std.invoke": _invoke,
    "std.bind_front": _bind_front,
    "std.mem_fn": _itself,
    "std.function.new": _new_function,
    "boost.function.new": _new_function,
    "std.function.operator()": _call_method,
    "std.function.swap": _swap,
    "std.not_fn": _not_fn,
    "std.not_fn.call": _call_not,
    "std.call_once": _once,
    **{f"std.{name}.new": _object(name) for name in _OBJECTS},
    **{f"std.{name}.call": _two(operator, compares=True) for name, operator in _COMPARING.items()},
    **{f"std.{name}.call": _two(operator, compares=False) for name, operator in _COMPUTING.items()},
    "std.hash.call": _hash,
    "std.identity.call": lambda call: call.args[0],
}
