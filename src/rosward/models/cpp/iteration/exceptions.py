# SPDX-License-Identifier: Apache-2.0
"""What does the standard library throw, and what follows where it is not known whether it does?

v.at(7) of three elements       std::out_of_range is thrown, and the path ends
std::stoi(unknown)              a `try` around it may see std::invalid_argument; the path goes on
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import External
from rosward.domain.values import UNBOUND, Const, Value
from rosward.models.cpp.values.slots import read
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import origins, unknown_from

__all__ = ["NATIVES", "is_settled", "may_raise", "raises"]


def raises(machine: Machine, name: str, message: str) -> Value:
    """`throw std::name(message)`; returns UNBOUND, since nothing follows on this path."""
    machine.throw(machine.call(External(f"std.{name}"), (Const(message),)))
    return UNBOUND


def _what(call: NativeCall) -> Value:
    """exception.what() of one that is not known."""
    return unknown_from(call.machine, "what", "str", read(call.machine, call.args[0]))


NATIVES: Final[dict[str, NativeFunction]] = {"std.exception.what": _what}


def is_settled(*values: Value) -> bool:
    """Whether none is a mere default: what fails for that may go well for another value, and the other way round."""
    return all(origin.settled for origin in origins(*values))


def may_raise(machine: Machine, name: str, message: str) -> None:
    """The same where it may be: only who catches it is told, for what fails for the values that we see may go well for others."""
    if machine.is_tried:
        raises(machine, name, message)
