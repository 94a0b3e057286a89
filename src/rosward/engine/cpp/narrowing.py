# SPDX-License-Identifier: Apache-2.0
"""What does a test tell in C++, and what stands where the tested value was read?

if (name.empty()) name = "x";      name is '' there, and behind the `if` anything but ''
if (!topic) return;                an optional behind it holds something
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import join_all, lift, options
from rosward.domain.heap import Obj
from rosward.domain.slots import Slot
from rosward.domain.text import origins_of
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Text, Unknown, Value
from rosward.engine.narrowing import compared
from rosward.engine.running.frame import Frame
from rosward.engine.transfer import CORE
from rosward.ir import cpp, ops
from rosward.models.cpp import operators as plain
from rosward.models.cpp.values.conversions import is_empty_optional
from rosward.models.cpp.values.copies import write
from rosward.models.cpp.values.slots import stored
from rosward.models.cpp.values.types import Shape, shape_of
from rosward.models.python.operators.operators import is_default

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["assume", "may", "narrow"]


def may(machine: Engine, value: Value, test: str, other: Value | None, sense: bool) -> bool:
    """Whether a test may come out as `sense` for one alternative of a value. No operator of the program runs again for it."""
    if any(isinstance(v, Ref) and isinstance(machine.obj(v).cls, Class) for v in (value, other)):
        return True
    if test == "true":
        answer = plain.truth(machine, value)
    elif test == "empty":
        answer = _is_empty(machine, value)
    else:
        answer = None if other is None else plain.truth(machine, plain.compare(machine, test, value, other))
    return answer is None or answer is sense


def _is_empty(machine: Engine, value: Value) -> bool | None:
    if isinstance(value, Const):
        return None if is_default(value.origins) or not isinstance(value.value, str) else not value.value
    if isinstance(value, Text):
        return None if is_default(value.origins) else False
    if not isinstance(value, Ref):
        return None
    obj = machine.obj(value)
    if obj.kind == "dict":
        return True if not obj.entries and obj.rest is None else False if obj.entries.keys() - obj.maybe else None
    if obj.kind not in ("list", "set"):
        return None
    series = obj.series()
    return not series.head if series.exact else False if series.least else None


def assume(machine: Engine, op: ops.Assume, frame: Frame) -> bool | None:
    """Narrow a value: what is not known and equals a constant is that; an object holds something, or nothing."""
    value = frame.registers[op.src]
    if op.test == "decided":
        frame.registers[op.dst] = join_all(_decided(option, op.sense) for option in options(value))
        return None
    if value is UNBOUND or (value.__class__ is Const and not value.origins):
        frame.registers[op.dst] = value
        return None
    frame.op, frame.sequence = op, 0
    if isinstance(value, Ref):
        if op.test in ("true", "empty"):
            _fill(machine, value, filled=op.sense is (op.test == "true"))
        frame.registers[op.dst] = value
        return None
    other = frame.registers[op.other] if op.other != ops.NO_REGISTER else None
    if op.test == "==" and op.sense and isinstance(other, Const) and not is_default(other.origins):
        known = other
        narrowed = lift(lambda v: _equal(v, known), value)
        if narrowed != value:
            frame.registers[op.dst] = narrowed
            return None
    if CORE[ops.Assume](machine, op, frame) is False:
        return False
    frame.registers[op.dst] = lift(_set, frame.registers[op.dst]) if NONE in options(value) else frame.registers[op.dst]
    return None


def _decided(value: Value, sense: bool) -> Value:
    """The outcome of `a || b` where `a` decides it: of a default that says otherwise, that is of another value."""
    if value.__class__ is Const and is_default(value.origins) and bool(value.value) is not sense:
        return Const(sense, compared(value) - origins_of(value))
    return Const(sense)


def _set(value: Value) -> Value:
    """An environment variable that turned out to be set: where it is not, the program has another value."""
    if not isinstance(value, Unknown) or not value.variable:
        return value
    return Unknown(tuple(r._replace(cause=Cause.SET) for r in value.reasons), value.hint, value.variable)


def _equal(value: Value, other: Const) -> Value:
    """What is not known and equals a text or whole number."""
    if not isinstance(value, Unknown):
        return value
    if isinstance(other.value, str) and value.hint in ("", "str"):
        return Const(other.value, other.origins | origins_of(value))
    return Const(other.value, other.origins) if other.value.__class__ is int and value.hint == "int" else value


def _fill(machine: Engine, ref: Ref, *, filled: bool) -> None:
    """An optional, or a container that turned out to be empty."""
    obj = machine.obj(ref)
    if obj.many or isinstance(obj.cls, Class):
        return
    if shape_of(obj.cls) is Shape.OPTIONAL:
        if obj.kind != "list" or is_empty_optional(machine, ref) is not None:
            return
        element = obj.series().element()
        machine.put(ref.address, obj.replace(items=(element,) if filled else (), rest=None))
    elif not filled and _is_empty(machine, ref) is None:
        machine.put(ref.address, _emptied(obj))


def _emptied(obj: Obj) -> Obj:
    if obj.kind == "dict":
        return obj.replace(entries={}, maybe=frozenset(), rest=None, rest_key=None)
    return obj.replace(items=(), rest=None)


def narrow(machine: Engine, op: cpp.Narrow, frame: Frame) -> None:
    """What was read at a slot turned out to be something that is less."""
    before, after, slot = frame.registers[op.before], frame.registers[op.src], frame.registers[op.slot]
    if after is before or not isinstance(slot, Slot) or not isinstance(slot.base, Ref):
        return
    frame.op, frame.sequence = op, 0
    base = machine.obj(slot.base)
    if base.many or slot.kind not in ("cell", "field") or stored(machine, slot) != before:
        return
    if slot.kind == "field" and str(slot.key) not in base.attrs:
        return
    write(machine, slot, after)
