# SPDX-License-Identifier: Apache-2.0
"""What has a class of Python's own, beside its methods?

type(7).__mro__          (int, object)
ValueError.__bases__     (Exception,)
"""

from __future__ import annotations

import builtins
from typing import TYPE_CHECKING

from rosward.domain.compound import Native, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Value

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def of_class(cls: str, name: str) -> Value | None:
    """What every class has, of one of Python's own; None for anything else."""
    found = getattr(builtins, cls, None)
    if not isinstance(found, type):
        return None
    if name == "__module__":
        return Const("builtins")
    if name in ("__mro__", "__bases__"):
        return Tuple(tuple(Native(f"builtins.{b.__name__}") for b in getattr(found, name)))
    if name == "__base__":
        return NONE if found.__base__ is None else Native(f"builtins.{found.__base__.__name__}")
    return Native("builtins.type") if name == "__class__" else None


def of_exception_class(machine: Engine, cls: str, name: str) -> Value:
    """What Python's own exception classes have as any class has."""
    found = of_class(cls, name)
    if found is not None:
        return found
    return Native(f"{cls}.{name}") if hasattr(getattr(builtins, cls), name) else machine.unknown(Cause.ERROR, name)
