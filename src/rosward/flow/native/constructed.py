# SPDX-License-Identifier: Apache-2.0
"""Objects of classes that say nothing of how they are made: their fields hold what they are made of.

@dataclass class Pose: x: float; y: float      Pose(msg.x, y=0.0): the field `x` holds msg.x
class Refused(Exception): pass                 Refused(text): nobody knows where it stands, so anywhere
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.choice import options
from rosward.domain.values import Class
from rosward.flow.marks import Mark, Root
from rosward.flow.native import partials
from rosward.flow.native.native_call import NativeCall

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen
    from rosward.flow.body import Body
    from rosward.flow.stored.memory import Memory
    from rosward.flow.walker import Walker
    from rosward.ir import ops


def construct(walker: Walker, op: ops.Call, body: Body, seen: Seen, marks: list[Mark]) -> None:
    """An object of the program's own class is made, and no code of the program takes the arguments."""
    classes = [o for f in seen.functions for o in options(f)]
    if not seen.refs or not classes or not all(isinstance(c, Class) and not c.stub for c in classes):
        return
    makers = (called.function.code for called in seen.calls.values())
    if any(code.name in ("__init__", "__new__") for code in makers):
        return
    roots = frozenset[Root](seen.refs)
    names = walker.shape.fields(roots)
    number = 0
    for argument, mark in zip(op.arguments, marks, strict=True):
        written = mark.under(body.pc)
        if argument.kind == "keyword":
            walker.memory.set_attribute(roots, argument.name, written)
        elif argument.kind == "positional" and 0 <= number < len(names):
            walker.memory.write(roots, names[number], written)
            number += 1
        else:
            spread = Mark(walker.memory.deep(written), written.roots | walker.memory.read_all(written.roots).roots)
            walker.memory.write_any(roots, written if argument.kind == "positional" else spread)
            number = -1
    given = partials.bound_in(body.registers[op.func])
    if given:
        walker.memory.write_any(roots, partials.Given(walker, given).whole.under(body.pc))


def attributes(memory: Memory, classes: frozenset[Root], mark: Mark, pc: int) -> None:
    """Classes have what stands in a dict as their attributes: `type(name, bases, found)`, `__prepare__`."""
    for root in mark.roots:
        content = memory.of(root)
        memory.write_each(classes, {key: each.under(pc) for key, each in content.slots.items()}, content.slots)
        memory.write_any(classes, content.any.under(content.base | pc))


def fill(call: NativeCall) -> Mark:
    """The fields of a named tuple, from what it is called with: `*args` and `**kwargs`."""
    memory, roots = call.walker.memory, call.mark(0).roots
    names = call.walker.shape.fields(roots)
    for mark in call.marks[1:]:
        for root in mark.roots:
            content = memory.of(root)
            for key, found in content.slots.items():
                if isinstance(key, int) and key >= len(names):  # nobody knows which field that is
                    memory.write_any(roots, found.under(call.pc))
                    continue
                memory.write(roots, names[key] if isinstance(key, int) else key, found.under(call.pc))
            memory.write_any(roots, content.any.under(content.base | call.pc | mark.mask))
    return Mark(call.pc)


def initialise(call: NativeCall) -> Mark:
    """The `__init__` that `@dataclass` makes: the fields of the first argument hold the others; it gives nothing."""
    memory, roots = call.walker.memory, call.mark(0).roots
    names, number = call.walker.shape.fields(roots), 0
    given = list(call.given())
    for argument, mark in given[1:] if len(given) == len(call.marks) else given:  # a bound method is given none
        written = mark.under(call.pc)
        if argument.kind == "keyword":
            memory.set_attribute(roots, argument.name, written)
        elif argument.kind == "positional" and 0 <= number < len(names):
            memory.write(roots, names[number], written)
            number += 1
        else:
            memory.write_any(roots, Mark(memory.deep(written), written.roots | memory.read_all(written.roots).roots))
            number = -1
    return Mark(call.pc)
