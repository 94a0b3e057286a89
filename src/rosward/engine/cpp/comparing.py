# SPDX-License-Identifier: Apache-2.0
"""What do comparisons give that nobody has written the body of?

bool operator==(const Key &) const = default;       member by member: those of the bases, then its own in their order
auto operator<=>(const Key &) const = default;      the first of them that differ decide; a class that has it has `==` as well
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from rosward.domain.unknown import Cause
from rosward.domain.values import Class, Const, Ref, Value
from rosward.engine.cpp import names
from rosward.engine.cpp.linked import linked
from rosward.engine.cpp.patterns import type_of_pattern
from rosward.models.cpp.values.contents import has_content, within
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import name_of

if TYPE_CHECKING:
    from rosward.domain.values import Function
    from rosward.engine.machine import Engine

__all__ = ["COMPARED", "by_members", "is_ordered_by_members", "made_up"]

COMPARED: Final = frozenset({"operator==", "operator<=>"})
"""What a class can have made up by `= default`; of the others it follows."""


def made_up(machine: Engine, name: str, function: Function, registers: list[Value]) -> Value:
    """What a function of that name gives that is `= default`: a member, or a friend."""
    signature = function.code.signature
    count = len(signature.parameters) if signature is not None else 0
    right = read(machine, registers[-1])
    left = read(machine, registers[-2] if count > 1 else registers[0])
    cls = type_of_pattern(machine, function.module, signature.parameters[-1].type) if signature is not None else None
    return by_members(machine, name.removeprefix("operator"), left, right, cls)


def is_ordered_by_members(machine: Engine, value: Value) -> bool:
    """Whether the class of an object has `operator<=>(…) = default`, and so `==` as well."""
    cls = machine.obj(value).cls if isinstance(value, Ref) else None
    info = linked(machine).info(cls) if isinstance(cls, Class) else None
    if info is None:
        return False
    name = "operator<=>"
    found = names.in_class(machine, info, name) or names.in_namespace(
        machine, info.symbol.scope, name, names.seeing(machine)
    )
    return found is not None and any("default" in symbol.marks for symbol in found.symbols)


def by_members(machine: Engine, operator: str, left: Value, right: Value, cls: Value | None = None) -> Value:
    """`==` or `<=>` of two objects, as objects of a class where that is one of a base."""
    if not isinstance(left, Ref) or not isinstance(right, Ref):
        return machine.unknown(Cause.OPERATION, operator, "bool" if operator == "==" else "int")
    answer: Value = Const(operator == "==" or 0)
    known = answer
    for a, b in _members(machine, left, right, machine.obj(left).cls if cls is None else cls):
        found = read(machine, machine.compare(operator, a, b))
        if found == known:
            continue
        if isinstance(found, Const) and (operator == "==" or answer == known):
            return found
        answer = machine.unknown(Cause.OPERATION, operator, "bool" if operator == "==" else "int")
    return answer


def _members(machine: Engine, left: Ref, right: Ref, cls: Value) -> Iterator[tuple[Value, Value]]:
    """The members of both objects that stand for one another: an array is as many as it has elements."""
    program = linked(machine)
    info = program.info(cls)
    if info is None or info.cls is None:
        if has_content(machine, left) and has_content(machine, right):
            yield within(machine, left), within(machine, right)
        return
    for base in info.cls.bases:
        yield from _members(machine, left, right, base)
    for field in info.fields:
        values = []
        for ref in (left, right):
            key = program.key_in(machine, ref, info, field.name)
            obj = machine.obj(ref)
            held = obj.attrs.get(key) if key is not None and key not in obj.partial else None
            values.append(machine.unknown(Cause.OPERATION, field.name) if held is None else read(machine, held))
        yield from _elements(machine, *values)


def _elements(machine: Engine, left: Value, right: Value) -> Iterator[tuple[Value, Value]]:
    if isinstance(left, Ref) and isinstance(right, Ref) and name_of(machine.obj(left).cls) == "array":
        ours, theirs = machine.obj(left).items, machine.obj(right).items
        if ours is None or theirs is None or len(ours) != len(theirs):
            yield (unknown := machine.unknown(Cause.OPERATION, "array")), unknown
            return
        for a, b in zip(ours, theirs, strict=True):
            yield from _elements(machine, a, b)
    else:
        yield left, right
