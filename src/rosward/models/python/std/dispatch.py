# SPDX-License-Identifier: Apache-2.0
"""`functools.singledispatch`: which function is registered for the class of an argument?

@describe.register
def _(value: int | str): …        for both classes, by the annotation of the first parameter
describe(5)                       the function of the nearest class of `int`; of each that may be, where that is not known
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from rosward.domain.choice import join_all, lift
from rosward.domain.compound import BoundMethod, Descriptor, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import TRUE, Function, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.std.annotations import named, parsed


def _classes(call: NativeCall) -> Value:
    """functools._classes(function or class): the classes that `register` means, a tuple."""
    value, skip = call.exactly(2)
    while isinstance(value, (BoundMethod, Descriptor)):
        value = value.function if isinstance(value, BoundMethod) else value.getter
    if not isinstance(value, Function):
        return Tuple((value,)) if not isinstance(value, Tuple) else value
    names = value.code.parameters.positional[1 if call.machine.truth(skip) else 0 :]
    text = value.code.annotations.get(names[0]) if names else None
    if text is None:
        return call.machine.die(
            "TypeError", "register() takes a class, or a function whose first parameter is annotated"
        )
    return Tuple(tuple(named(call.machine, value.module, parsed(text))))


def _choose(call: NativeCall) -> Value:
    """functools._choose(registered, functions, value): the function for a value; `registered` are pairs of class and function.

    Of two pairs for one class the later one counts; where not all pairs are known, each of the `functions` may be meant.
    """
    machine = call.machine
    known, rest = machine.iterate(call.args[0])
    pairs = [p.items for p in known if isinstance(p, Tuple) and len(p.items) == 2]
    if rest is None and len(pairs) == len(known):
        return lift(lambda value: _for_one(machine, pairs, value), call.args[2])
    functions, more = machine.iterate(call.args[1])
    unknown = machine.unknown(Cause.OPERATION, "functools.singledispatch")
    return join_all([*functions, *(() if more is None else (more,)), unknown])


def _for_one(machine: Machine, pairs: Sequence[tuple[Value, ...]], value: Value) -> Value:
    best: tuple[Value, ...] | None = None
    perhaps: list[Value] = []
    seen: list[Value] = []
    for pair in reversed(pairs):  # of two for one class the later one counts
        if pair[0] in seen:
            continue
        seen.append(pair[0])
        answer = machine.is_instance(value, pair[0])
        if answer is None:
            perhaps.append(pair[1])
        elif answer and (best is None or _is_nearer(machine, value, pair[0], best[0])):
            best = pair
    return join_all([*perhaps, *(() if best is None else (best[1],))])


def _is_nearer(machine: Machine, value: Value, cls: Value, other: Value) -> bool:
    """Whether a class stands before another one in the order of a value's class."""
    if machine.call_native("builtins.issubclass", (cls, other)) == TRUE:
        return True
    if machine.call_native("builtins.issubclass", (other, cls)) == TRUE:
        return False
    order = machine.load_attr(machine.call_native("builtins.type", (value,)), "__mro__")
    found = order.items if isinstance(order, Tuple) else ()
    return cls in found and (other not in found or found.index(cls) < found.index(other))


NATIVES: Final[dict[str, NativeFunction]] = {
    "functools._classes": _classes,
    "functools._choose": _choose,
}
