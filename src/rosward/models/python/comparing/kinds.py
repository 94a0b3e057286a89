# SPDX-License-Identifier: Apache-2.0
"""Which classes of Python's own does module `types` name?

type(run) is types.FunctionType       perhaps: both are called `function`
type(run) is types.MethodType         no
"""

from __future__ import annotations

import types

from rosward.domain.compound import Native
from rosward.domain.values import Class, Value


def names_kind(left: Value, right: Value) -> bool:
    """Whether one may be the name that module `types` has for the other: a model knows them as two."""
    return _is_named(left, right) or _is_named(right, left)


def _is_named(cls: Value, native: Value) -> bool:
    if not isinstance(cls, Class) or not cls.stub or cls.module != "types" or not isinstance(native, Native):
        return False
    kind = getattr(types, cls.name, None)
    return isinstance(kind, type) and native.name == f"builtins.{kind.__name__}"
