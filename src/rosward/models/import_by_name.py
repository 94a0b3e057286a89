# SPDX-License-Identifier: Apache-2.0
"""Imports by a name that the program computes: followed where the name is known, told (RW203) where it is not."""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import join_all, options
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Value
from rosward.models.host import host
from rosward.models.native import NativeCall, NativeFunction


def _import_module(call: NativeCall) -> Value:
    """`importlib.import_module(name)`."""
    found: list[Value] = []
    for name in options(call.args[0]) if call.args else ():
        if isinstance(name, Const) and isinstance(name.value, str) and not name.value.startswith("."):
            found.append(host(call.machine).load_module(name.value))
        else:
            call.machine.report("RW203", "the name of the module that is imported here is not known")
            found.append(call.machine.unknown(Cause.CALL, call.name))
    return join_all(found) if found else call.machine.unknown(Cause.CALL, call.name)


NATIVES: Final[dict[str, NativeFunction]] = {"importlib.import_module": _import_module}
