# SPDX-License-Identifier: Apache-2.0
"""What is a value where a test of it came out true, or false?

if side in ('left', 'right'): …       a str that was not known is one of the two
if topic: …                           topic = declare_parameter('topic', '').value is no longer '', but what somebody gives instead
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all, options
from rosward.domain.compound import Descriptor, Tuple
from rosward.domain.enumerated import Enumerated, Whole
from rosward.domain.text import origins_of
from rosward.domain.unknown import COMPARED, Cause, Origin, Origins, Reason
from rosward.domain.values import Const, Function, Ref, Unknown, Value, is_nan
from rosward.ir import ops
from rosward.models.python.containers.lists import ITERATOR
from rosward.models.python.operators.operators import is_default
from rosward.models.python.plain import int_of

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

_MOST: Final = 32
"""So many values that a test names are told apart."""
_TRUTHS: Final = {"true": True, "empty": False}
"""The tests that ask whether a value counts as true: what is empty does not."""


def narrowed(machine: Engine, value: Value, test: str, other: Value | None, sense: bool) -> Value | None:
    """The alternatives of a value for which a test may come out as `sense`; None where there are none."""
    kept = [
        _one(machine, option, test, other, sense)
        for option in options(value)
        if _may(machine, option, test, other, sense)
    ]
    return join_all(kept) if kept else None


def _may(machine: Engine, value: Value, test: str, other: Value | None, sense: bool) -> bool:
    """Whether a test may come out as `sense` for one alternative.

    `>=` stands here as what is not `<`, and NaN is neither.
    """
    if test in ("<", ">") and (_is_nan(value) or _is_nan(other)):
        return True
    return machine.language.may(machine, value, test, other, sense)


def _is_nan(value: Value | None) -> bool:
    return isinstance(value, Const) and is_nan(value.value)


def _one(machine: Engine, value: Value, test: str, other: Value | None, sense: bool) -> Value:
    """A default for which the test comes out otherwise is not the value here; nor is a text that is not known, if it is named."""
    if not is_open(value):
        return value
    named = _named(machine, test, other)
    if test in _TRUTHS:
        wanted = sense is _TRUTHS[test]
        wrong = isinstance(value, Const) and bool(value.value) is not wanted
        return _given(machine, value, wanted) if wrong else value
    if test in ("<", ">"):
        wrong = isinstance(value, Const) and other is not None and not _may_be(machine, value, test, other, sense)
        return _another(machine, value) if wrong else value
    if named is None:
        return value
    if isinstance(value, Const) and (value in [Const(n.value, value.origins) for n in named]) is sense:
        return value
    if not sense:
        return _another(machine, value) if isinstance(value, Const) else value
    kind = value.value.__class__ if isinstance(value, Const) else str
    source = compared(value)
    same = [Const(n.value, n.origins | source) for n in named if n.value.__class__ is kind]
    return join_all(same) if len(same) == len(named) else value


def _may_be(machine: Engine, value: Const, test: str, other: Value, sense: bool) -> bool:
    """Whether the test of a default may come out so while nobody gives another value."""
    return _may(machine, Const(value.value), test, _as_given(other), sense)


def _as_given(value: Value) -> Value:
    return Const(value.value) if isinstance(value, Const) else value


def is_open(value: Value) -> bool:
    """Whether a single value may be another one: a default, or a text that is not known."""
    return is_default(value.origins) if isinstance(value, Const) else isinstance(value, Unknown) and value.hint == "str"


def _named(machine: Engine, test: str, other: Value | None) -> list[Const] | None:
    """The constants that a test compares with."""
    if test == "==" and isinstance(other, Const):
        return [other]
    if test != "in":
        return None
    items: tuple[Value, ...] | None = None
    if isinstance(other, Tuple):
        items = other.items
    elif (
        isinstance(other, Ref) and machine.obj(other).kind in ("list", "set") and machine.obj(other).payload != ITERATOR
    ):
        items = machine.obj(other).items
    if not items or len(items) > _MOST:
        return None
    constants = [item for item in items if isinstance(item, Const)]
    return constants if len(constants) == len(items) else None


def _given(machine: Engine, value: Value, sense: bool) -> Value:
    """What somebody gives in place of a default, so that it is true, or false. An empty text is one of the names that they may give."""
    content = value.value if isinstance(value, Const) else None
    if sense is False and isinstance(content, (bool, int, float)):
        zero = content.of(0) if isinstance(content, (Enumerated, Whole)) else content.__class__()
        return Const(zero, compared(value))
    if content is False:
        return Const(True, compared(value))
    return _another(machine, value)


def compared(value: Value) -> Origins:
    """Where a value stems from that a test has told: it is no default any more, whatever else is known of its parameter."""
    source = origins_of(value)
    return source | {Origin(COMPARED, o.name, settled=True) for o in source if o.kind == "parameter" and not o.settled}


def _another(machine: Engine, value: Value) -> Value:
    """What somebody gives in place of a default."""
    reasons = tuple(Reason(Cause.OTHER, o.name, machine.place) for o in sorted(origins_of(value)))
    return Unknown(reasons, value.value.__class__.__name__ if isinstance(value, Const) else "")


# Where the tested value stands


def narrow_attribute(machine: Engine, target: Value, name: str, value: Value) -> None:
    """What an object surely holds in an attribute of its own turned out to be `value`."""
    if not isinstance(target, Ref):
        return
    obj = machine.part(target, name)
    if obj.kind != "instance" or obj.many:
        return
    if name not in obj.attrs:
        name = _returned_by(machine.language.lookup(machine, obj.cls, name))
        obj = machine.part(target, name)
    if name in obj.attrs and obj.attrs[name] is not value:
        machine.put(target.address, obj.with_attr(name, value))


def _returned_by(found: Value | None) -> str:
    """The attribute that a property returns as it is; '' where it does anything else."""
    if not isinstance(found, Descriptor) or found.kind != "property" or not isinstance(found.getter, Function):
        return ""
    code = found.getter.code
    if len(code.ops) < 2 or code.cells:
        return ""
    load, leave = code.ops[:2]
    plain = isinstance(load, ops.LoadAttr) and load.obj == 0 and isinstance(leave, ops.Return) and leave.src == load.dst
    return load.name if plain and isinstance(load, ops.LoadAttr) else ""


def narrow_item(machine: Engine, target: Value, index: Value, value: Value) -> None:
    """What a dict or list surely holds under a key turned out to be `value`: so the key is there."""
    if not isinstance(target, Ref) or not isinstance(index, Const):
        return
    obj = machine.obj(target)
    if obj.many:
        return
    number = int_of(index)
    if obj.kind == "dict" and index in obj.entries and obj.rest is None:
        if obj.entries[index] != value or index in obj.maybe:
            entries = {**obj.entries, index: value}
            machine.put(target.address, obj.replace(entries=entries, maybe=obj.maybe - {index}))
    elif (
        obj.kind == "list"
        and obj.items is not None
        and number is not None
        and -len(obj.items) <= number < len(obj.items)
    ):
        items = list(obj.items)
        items[number] = value
        machine.put(target.address, obj.replace(items=tuple(items)))
