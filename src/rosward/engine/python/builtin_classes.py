# SPDX-License-Identifier: Apache-2.0
"""What have classes, functions and values of Python's own, beside methods?

type(7).__mro__          (int, object)
ValueError.__bases__     (Exception,)
len.__name__             'len'; what it says of itself by any other such name is not known
(7).real                 7
"""

from __future__ import annotations

import builtins
from typing import TYPE_CHECKING, Final

from rosward.domain.compound import Native, Range, Slice, Tuple
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Value
from rosward.engine.python.members import of_native_class
from rosward.models.python.builtins.attributes import of_python
from rosward.models.python.exceptions import is_exception
from rosward.models.python.plain import with_origins

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


_NAMES: Final = frozenset({"__name__", "__qualname__", "__module__"})


def of_native(machine: Engine, native: str, name: str) -> Value:
    """What a builtin, or the method of one, has: a method, or what Python says of it."""
    dotted, here = f"{native}.{name}", of_python(native)
    own = of_class(native, name) or (of_native_class(machine, native, name) if is_exception(native) else None)
    if own is not None:
        return own
    if name in _NAMES and (here is not None or name != "__module__"):
        said = getattr(here, name, native.rpartition(".")[2])
        return Const(said) if isinstance(said, str) else machine.unknown(Cause.CALL, dotted)
    found = getattr(len if here is None else here, name, None)  # what a model does in code is like a builtin
    is_method = callable(found) and not isinstance(found, type)
    if is_method or machine.library.native(dotted) or (here is None and not name.startswith("__")):
        return Native(dotted)
    return machine.unknown(Cause.CALL, dotted)


_RANGE: Final = ("start", "stop", "step")


def of_value(value: Value, name: str) -> Value | None:
    """What a value holds under a name that is no method of its class."""
    if isinstance(value, (Range, Slice)):
        return value.fields()[_RANGE.index(name)] if name in _RANGE else None
    if not isinstance(value, Const) or name.startswith("__"):
        return None
    found = getattr(value.value, name, None)
    return with_origins(Const(found), value.origins) if isinstance(found, (int, float)) else None
