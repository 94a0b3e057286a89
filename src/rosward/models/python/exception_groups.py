# SPDX-License-Identifier: Apache-2.0
"""Exception groups: which of their exceptions are of some class.

group = ExceptionGroup('both', [ValueError('a'), TypeError('b')])
split(group, ValueError)      a group of the same message with the ValueError, and one with the rest
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Class, Ref, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.exceptions import GROUP, arguments, builtin_base, member_of
from rosward.records import NamedTuple

_DEPTH: Final = 8


class Parts(NamedTuple):
    """What of an exception is of some class, and what is not; None: nothing. `sure`: so it is in each execution."""

    matching: Value | None
    rest: Value | None
    sure: bool


def is_group(machine: Machine, value: Value) -> bool:
    """Whether a value is an exception group."""
    base = builtin_base(machine.obj(value).cls) if isinstance(value, Ref) else None
    return base is not None and issubclass(base, GROUP)


def wrapped(machine: Machine, value: Value) -> Value:
    """A group without a message, of one exception; a group itself."""
    return value if is_group(machine, value) else made(machine, Native("builtins.ExceptionGroup"), Tuple((value,)))


def made(machine: Machine, cls: Value, exceptions: Tuple, message: Value | None = None) -> Value:
    """A group."""
    from_text = message if message is not None else machine.call_native("builtins.str", ())
    attrs: dict[str, Value] = {"args": Tuple((from_text, exceptions))}
    return machine.allocate(Obj("instance", cls, attrs=attrs), ("group", exceptions))


def split(machine: Machine, value: Value, wanted: Value, depth: int = _DEPTH) -> Parts:
    """The exceptions of a group that are of a class, and the others, each as a group like it."""
    decided = machine.is_instance(value, wanted)
    if decided is not False or not is_group(machine, value) or not depth:
        return Parts(
            value if decided is not False else None,
            value if decided is not True else None,
            decided is not None,
        )
    assert isinstance(value, Ref)
    obj = machine.obj(value)
    inner = member_of(machine, obj, "exceptions")
    if not isinstance(inner, Tuple):
        return Parts(value, value, False)
    parts = [split(machine, each, wanted, depth - 1) for each in inner.items]
    message = (arguments(machine, obj) or (NONE,))[0]
    matching = tuple(p.matching for p in parts if p.matching is not None)
    rest = tuple(p.rest for p in parts if p.rest is not None)
    whole = obj.cls if isinstance(obj.cls, (Class, Native)) else Native("builtins.ExceptionGroup")
    return Parts(
        made(machine, whole, Tuple(matching), message) if matching else None,
        made(machine, whole, Tuple(rest), message) if rest else None,
        all(p.sure for p in parts),
    )


def _split(call: NativeCall) -> Value:
    """group.split(class): a pair."""
    if len(call.args) < 2 or not isinstance(call.args[1], (Class, Native, Tuple)):
        return call.machine.unknown(Cause.LIVE, "exception group")
    parts = split(call.machine, call.args[0], call.args[1])
    if not parts.sure:
        return call.machine.unknown(Cause.LIVE, "exception group")
    return Tuple((parts.matching or NONE, parts.rest or NONE))


def _subgroup(call: NativeCall) -> Value:
    """group.subgroup(class): the first of the pair."""
    pair = _split(call)
    return pair.items[0] if isinstance(pair, Tuple) else pair


def _derive(call: NativeCall) -> Value:
    """group.derive(exceptions): a group with the same message."""
    machine = call.machine
    if len(call.args) < 2 or not isinstance(call.args[0], Ref):
        return machine.unknown(Cause.LIVE, "exception group")
    known, rest = machine.iterate(call.args[1])
    if rest is not None:
        return machine.unknown(Cause.LIVE, "exception group")
    message = (arguments(machine, machine.obj(call.args[0])) or (NONE,))[0]
    return made(machine, Native("builtins.ExceptionGroup"), Tuple(known), message)


NATIVES: Final[dict[str, NativeFunction]] = {
    "BaseExceptionGroup.split": _split,
    "BaseExceptionGroup.subgroup": _subgroup,
    "BaseExceptionGroup.derive": _derive,
}
