# SPDX-License-Identifier: Apache-2.0
"""What is the value that a declaration gives: of a constant, a type, a first value?"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Function, ModuleValue, Value
from rosward.engine.calls import activation
from rosward.engine.cpp.linked import linked

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.program import Code

__all__ = ["evaluate"]


def evaluate(
    machine: Engine, code: Code, env: ModuleValue, *, leading: tuple[Value, ...] = (), types: tuple[Value, ...] = ()
) -> Value:
    """The result of a thunk in its scope; of a template, for these arguments. What asks for itself is not known."""
    program = linked(machine)
    key = (code.key, env.address)
    if key in program.evaluating and not types and not leading:
        return machine.unknown(Cause.ERROR, f"value of {code.name} in its own definition")
    signature = code.signature
    parameters = len(signature.template) if signature is not None else 0
    given = [*types[:parameters], *[UNBOUND] * (parameters - len(types))]
    program.evaluating.add(key)
    try:
        scope = ModuleValue(env.address, env.name, code.file)
        value = activation.invoke(machine, Function(code, scope, (), (), ()), [*leading, *given])
    finally:
        program.evaluating.discard(key)
    return value if value is not UNBOUND else machine.unknown(Cause.ERROR, code.name)
