# SPDX-License-Identifier: Apache-2.0
"""Which operations may raise an exception because of what they work on?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.compound import BoundMethod, Native
from rosward.domain.values import Class, Function, Value
from rosward.flow.marked_cpp import is_safe
from rosward.ir import ops

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen


STRUCTURED: Final = (
    ops.If,
    ops.While,
    ops.ForEach,
    ops.Try,
    ops.With,
    ops.Return,
    ops.Break,
    ops.Continue,
    ops.Raise,
    ops.Yield,
)
"""Operations with blocks, and those at which control leaves one."""


def may_fail(op: ops.Op, seen: Seen) -> bool:
    """Whether an operation may raise an exception because of what it works on; a function of the program says so itself."""
    if seen.natives or seen.strange:
        return bool(seen.strange) or not all(map(is_safe, seen.natives))
    if isinstance(op, ops.Call):
        return any(not isinstance(f, (Function, Class)) and not _is_safe(f) for f in seen.functions)
    return op.__class__ in _FAILING


_FAILING: Final = frozenset((ops.LoadItem, ops.Binary, ops.Unpack, ops.StoreItem, ops.ForEach, ops.Format))


def _is_safe(function: Value) -> bool:
    """Whether a call surely raises nothing because of its arguments, or is one of the program."""
    if isinstance(function, BoundMethod):
        return isinstance(function.function, Function) or function.function in _SAFE
    return function in _SAFE


_SAFE: Final = frozenset(
    Native(name)
    for name in (
        *("list.append", "list.extend", "list.clear", "dict.get", "dict.items", "dict.keys", "dict.values", "set.add"),
        *("builtins.len", "builtins.str", "builtins.isinstance", "builtins.print", "builtins.list", "builtins.repr"),
    )
)
