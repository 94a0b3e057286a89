# SPDX-License-Identifier: Apache-2.0
"""Binding of arguments to parameters, as Python does it, with room for arguments of unknown number.

def f(a, b=1, *c, d=2, **e)      f(0, d=3)  ->  registers a=0, b=1, c=(), d=3, e={}
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import join
from rosward.domain.compound import Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import NONE, UNBOUND, Const, Function, Unknown, Value
from rosward.engine.arguments import ANY, LOOSE, MAYBE, ORDER
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.program import Code


class BadCallError(Exception):
    """The call fails for sure: the arguments do not fit the parameters."""


def bind_arguments(
    machine: Engine, function: Function, args: tuple[Value, ...], keywords: dict[str, Value]
) -> list[Value]:
    """The values of the parameters in register order. Raises `BadCallError`."""
    code, parameters = function.code, function.code.parameters
    names = parameters.positional
    count = len(names)
    if (
        not keywords
        and parameters.vararg is None
        and not parameters.kwonly
        and parameters.kwarg is None
        and len(args) == count
    ):
        return list(args)
    keywords = dict(keywords)
    perhaps = {k[1:]: keywords.pop(k) for k in [k for k in keywords if k[:1] == MAYBE]}
    loose, anything = keywords.pop(LOOSE, None), keywords.pop(ANY, None)
    order = keywords.pop(ORDER, None)
    if anything is UNBOUND:
        anything = Unknown((Reason(Cause.CALLER, code.name, Place(code.file, code.line)),))
    values: list[Value] = list(args[:count])
    extra = args[count:]
    if extra and parameters.vararg is None and anything is None:
        raise BadCallError(f"{len(args)} positional arguments for {count}")
    first_default = count - len(function.defaults)
    for number in range(len(values), count):
        name = names[number]
        if name in keywords and number >= parameters.posonly:
            values.append(keywords.pop(name))
            continue
        default = function.defaults[number - first_default] if number >= first_default else None
        values.append(_missing(code, name, default, loose, anything, perhaps))
    if parameters.vararg is not None:
        if loose is not None or anything is not None:
            rest = loose if loose is not None else anything
            if isinstance(order, Tuple) and len(args) >= count:
                values.append(machine.new_list(extra, order.items[0], order.items[1:]))
            else:
                values.append(machine.new_list(extra, rest))
        else:
            values.append(Tuple(extra))
    kwdefaults = dict(function.kwdefaults)
    for name in parameters.kwonly:
        if name in keywords:
            values.append(keywords.pop(name))
        else:
            values.append(_missing(code, name, kwdefaults.get(name), loose, anything, perhaps))
    if parameters.kwarg is not None:
        entries: dict[Value, Value] = {Const(k): v for k, v in keywords.items()}
        entries.update({Const(k): v for k, v in perhaps.items()})
        rest = loose if loose is not None else anything
        maybe: frozenset[Value] = frozenset(Const(k) for k in perhaps)
        record = Obj("dict", Native("builtins.dict"), entries=entries, rest=rest, maybe=maybe)
        values.append(machine.allocate(record, (code.file, code.line)))
    elif keywords and anything is None and loose is None:
        unexpected = next(iter(keywords))
        if unexpected in names[: len(args)]:
            raise BadCallError(f"several values for argument {unexpected}")
        raise BadCallError(f"unexpected argument {unexpected}")
    return values


def _missing(
    code: Code, name: str, default: Value | None, loose: Value | None, anything: Value | None, perhaps: dict[str, Value]
) -> Value:
    """A parameter that the call does not surely name: what it may be given, and its default."""
    given = perhaps.pop(name, None)
    if given is not None:
        return join(join(default if default is not None else UNBOUND, given), loose if loose is not None else UNBOUND)
    if loose is not None:
        return join(default if default is not None else UNBOUND, loose)
    if default is not None:
        # who calls from outside gives what has no value yet (`event=None`), not what a function keeps for itself (`i=i`)
        if anything is None or default != NONE or _nobody(anything) or code.is_model:
            return default
        return join(default, anything)
    if anything is not None:
        return Unknown((Reason(Cause.CALLER, name, Place(code.file, code.line)),)) if _nobody(anything) else anything
    raise BadCallError(f"argument {name} is missing")


def _nobody(value: Value) -> bool:
    """Whether no caller is known: then the parameter's own name says best what is missing."""
    return isinstance(value, Unknown) and all(r.cause is Cause.CALLER for r in value.reasons)
