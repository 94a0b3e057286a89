# SPDX-License-Identifier: Apache-2.0
"""The variables of a running piece of code as a dict: `globals()`, `locals()`, and the `__dict__` of what has one.

globals()['SPEED'] = 2         writes the module's variable
'{robot}/cmd'.format(**locals())     reads the function's
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.heap import Obj
from rosward.domain.values import UNBOUND, Const, Native, Ref, Value
from rosward.ir.program import CodeKind

if TYPE_CHECKING:
    from rosward.engine.frame import Frame
    from rosward.engine.interpreter import Interpreter


def table_of(machine: Interpreter, address: int) -> Value:
    """A dict of the attributes kept at an address; what is stored in it becomes an attribute there."""
    attrs = machine.at(address).attrs
    partial = machine.at(address).partial
    entries: dict[Value, Value] = {Const(k): v for k, v in attrs.items() if v is not UNBOUND and k.isidentifier()}
    maybe = frozenset(k for k in map(Const, partial) if k in entries)
    record = Obj("dict", Native("builtins.dict"), entries=entries, maybe=maybe, payload=Ref(address))
    return machine.allocate(record, ("variables", address))


def variables(machine: Interpreter, *, local: bool) -> Value | None:
    """What `locals()` or `globals()` gives here; None where no code of the program is running."""
    frame = next((f for f in reversed(machine.frames) if not f.stub), None)
    if frame is None:
        return None
    kind = frame.code.kind
    if not local or kind is CodeKind.MODULE:
        return table_of(machine, frame.module.address)
    if kind is CodeKind.CLASS:
        return table_of(machine, frame.namespace)
    return machine.new_dict({Const(name): value for name, value in _of_function(machine, frame).items()})


def _of_function(machine: Interpreter, frame: Frame) -> dict[str, Value]:
    """The variables of a function that have a value: registers, and cells where inner functions share them."""
    code = frame.code
    found = dict(zip(code.variables, frame.registers, strict=False))
    for name, cell in zip((*code.cells, *code.free), frame.cells, strict=False):
        found[name] = machine.at(cell).attrs.get("value", UNBOUND)
    return {n: v for n, v in found.items() if v is not UNBOUND and n != "__class__"}
