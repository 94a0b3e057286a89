# SPDX-License-Identifier: Apache-2.0
"""Which classes of Python's own does module `types` name?

type(run) is types.FunctionType       perhaps: both are called `function`
type(run) is types.MethodType         no
type(vars(C)) is types.MappingProxyType    perhaps: both are a dict
"""

from __future__ import annotations

import types
from typing import Final

from rosward.domain.compound import Native
from rosward.domain.values import Class, Function, Value

_DICT: Final = Native("builtins.dict")


def names_kind(left: Value, right: Value) -> bool:
    """Whether one may be the name that module `types` has for the other: a model knows them as two."""
    return _is_named(left, right) or _is_named(right, left)


def _is_named(cls: Value, native: Value) -> bool:
    if isinstance(cls, Function):  # `MappingProxyType(names)` is the dict itself, as is what `vars(C)` gives
        return cls.module.name == "types" and native == _DICT
    if not isinstance(cls, Class) or not cls.stub or cls.module != "types" or not isinstance(native, Native):
        return False
    kind = getattr(types, cls.name, None)
    return isinstance(kind, type) and native.name == f"builtins.{kind.__name__}"
