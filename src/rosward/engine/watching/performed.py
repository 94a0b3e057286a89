# SPDX-License-Identifier: Apache-2.0
"""Which builtins and models in code does an operation run that are not called by the operation as it is written, and with what?

partial(items.append, x)()           `list.append`, of `items` and `x`
list(map(items.append, xs))          `list.append`, of `items` and an element
create_subscription(…, items.append) the same, when a message arrives
setattr(*given)                      `setattr`, of the elements of `given`

What each is given is told as for functions (`seen.Handed`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import options
from rosward.domain.compound import BoundMethod, External, Native, Partial
from rosward.domain.values import NONE, Class, Const, Function, Ref, Unknown, Value
from rosward.engine.running.seen import SILENT, Handed, Performed, refs_of
from rosward.ir import ops
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.engine.running.frame import Frame

_NEVER: Final = frozenset({Function, Class})
"""Values whose calls run no native, or say themselves which."""
_PLAIN: Final = frozenset({Function, Native, External, Unknown})


class _Call(NamedTuple):
    """A native, with all that it is given; `given`: some of it by a partial function."""

    native: Value
    args: tuple[Value, ...]
    keywords: Mapping[str, Value]
    given: bool


def is_as_written(frame: Frame, function: Value) -> bool:
    """Whether all that a called value leads to is told by the operation that calls it, or by itself: what `performed` would find is nothing."""
    cls = function.__class__
    if cls in _NEVER:
        return True
    op = frame.op
    if op.__class__ is not ops.Call or op.simple is None or frame.registers[op.func] is not function:
        return False
    return cls in _PLAIN or (cls is BoundMethod and function.function.__class__ in _PLAIN)  # type: ignore[attr-defined]  # a method


def performed(
    frame: Frame, read: Sequence[int], function: Value, args: tuple[Value, ...], keywords: Mapping[str, Value]
) -> Iterator[Performed]:
    """The natives that a called value leads to, unless the operation, which reads these registers, calls them as it is written."""
    op = frame.op
    written = isinstance(op, ops.Call) and bool(frame.registers) and frame.registers[op.func] is function
    plain = isinstance(op, ops.Call) and not op.spreads
    for call in _natives(_Call(function, args, keywords, False)):
        if not (written and (call.native.__class__ is Unknown or (plain and not call.given))):
            told = handed(standing(frame.registers, read, (*call.args, *call.keywords.values())))
            named = tuple(zip(call.keywords, told[len(call.args) :], strict=True))
            keys = tuple(map(_key, call.args))
            yield Performed(call.native, tuple(told[: len(call.args)]), named, keys, written)


Standing = tuple[tuple[int, ...], frozenset[int], bool]


def handed(several: Iterable[Standing]) -> list[Handed]:
    """Where arguments stand, and what they are."""
    return [Handed(frozenset(registers), refs, more) for registers, refs, more in several]


def standing(registers: Sequence[Value], read: Sequence[int], values: Sequence[Value]) -> tuple[Standing, ...]:
    """In which of the registers that are read each value stands as it is, the objects that it is, and whether it is more than these."""
    found: dict[int, tuple[int, ...]] = {}  # by the identity of the value
    for register in read if registers else ():
        value = id(registers[register])
        found[value] = (*found[value], register) if value in found else (register,)
    return tuple([(found.get(id(value), ()), *_refs_in(value)) for value in values])


_NO_REFS: Final = frozenset[int]()
_LEADING_NOWHERE: Final = SILENT | {Const, Unknown}


def _refs_in(value: Value) -> tuple[frozenset[int], bool]:
    """The objects that a value is or holds, and whether it is more."""
    if value.__class__ is Ref:
        return frozenset((value.address,)), False
    if value.__class__ in _LEADING_NOWHERE:
        return _NO_REFS, True
    refs = frozenset(refs_of(value))
    return refs, value.__class__ is not Class and not all(o.__class__ is Ref or o == NONE for o in options(value))


def _natives(call: _Call) -> Iterator[_Call]:
    for option in options(call.native):
        if option.__class__ is Native or option.__class__ is External:
            yield call._replace(native=option)
        elif option.__class__ is Unknown:
            yield call._replace(native=option, args=(option, *call.args))
        elif isinstance(option, BoundMethod):
            yield from _natives(call._replace(native=option.function, args=(option.receiver, *call.args)))
        elif isinstance(option, Partial):
            keywords = {**dict(option.keywords), **call.keywords} if option.keywords else call.keywords
            yield from _natives(_Call(option.function, (*option.arguments, *call.args), keywords, True))


def _key(value: Value) -> object:
    """The constant that may name a slot."""
    return value.value if isinstance(value, Const) and not value.origins else None
