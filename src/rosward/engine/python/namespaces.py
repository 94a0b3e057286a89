# SPDX-License-Identifier: Apache-2.0
"""The variables of a running piece of code as a dict: `globals()`, `locals()`, and the `__dict__` of what has one.

globals()['SPEED'] = 2         writes the module's variable
'{robot}/cmd'.format(**locals())     reads the function's
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.compound import Native
from rosward.domain.heap import Obj
from rosward.domain.values import UNBOUND, Class, Const, Ref, Value
from rosward.engine.running.frame import Frame, own_frame
from rosward.ir.program import CodeKind
from rosward.models.native import Items

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def table_of(machine: Engine, address: int, apart: frozenset[str] = frozenset()) -> Value:
    """A dict of the attributes kept at an address, without those in slots and `apart`; what is stored in it becomes an attribute there."""
    attrs = machine.at(address).attrs
    partial = machine.at(address).partial
    cls = machine.at(address).cls
    slots = apart | {n for base in (cls.mro if isinstance(cls, Class) else ()) for n in slots_of(machine, base) or ()}
    entries: dict[Value, Value] = {
        Const(k): v
        for k, v in attrs.items()
        if v is not UNBOUND and k.isidentifier() and k not in slots and not k.startswith("_rosward")
    }
    maybe = frozenset(k for k in map(Const, partial) if k in entries)
    record = Obj("dict", Native("builtins.dict"), entries=entries, maybe=maybe, payload=Ref(address))
    return machine.allocate(record, ("variables", address))


def slots_of(machine: Engine, cls: Value) -> tuple[str, ...] | None:
    """The names that `__slots__` of a class lists; None where it has none, or they are not known."""
    written = machine.at(cls.address).attrs.get("__slots__") if isinstance(cls, Class) and not cls.stub else None
    if written is None:
        return None
    names, rest = machine.iterate(written) if not isinstance(written, Const) else Items((written,))
    if rest is not None or not all(isinstance(n, Const) for n in names):
        return None
    return tuple(str(n.value) for n in names if isinstance(n, Const))


def variables(machine: Engine, *, local: bool) -> Value | None:
    """What `locals()` or `globals()` gives here; None where no code of the program is running."""
    frame = own_frame(machine.frames)
    if frame is None:
        return None
    kind = frame.code.kind
    if not local or kind is CodeKind.MODULE:
        return table_of(machine, frame.module.address)
    if kind is CodeKind.CLASS:
        return table_of(machine, frame.namespace)
    return machine.new_dict({Const(name): value for name, value in _of_function(machine, frame).items()})


def _of_function(machine: Engine, frame: Frame) -> dict[str, Value]:
    """The variables of a function that have a value: registers, and cells where inner functions share them."""
    code = frame.code
    found = dict(zip(code.variables, frame.registers, strict=False))
    for name, cell in zip((*code.cells, *code.free), frame.cells, strict=False):
        found[name] = machine.at(cell).attrs.get("value", UNBOUND)
    return {n: v for n, v in found.items() if v is not UNBOUND and n != "__class__"}
