# SPDX-License-Identifier: Apache-2.0
"""Operations at which a function stops and others go on: `yield`, `yield from`, `await`.

x = yield y      y is among what the generator gives, x what `send` was given
x = await y      whatever else runs may have written meanwhile
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.flow import implicit
from rosward.flow.body import Body
from rosward.flow.calls import run_callees
from rosward.flow.marks import NOTHING, Mark
from rosward.flow.reading import each_of, elements, leads, opaque
from rosward.flow.ways import either
from rosward.ir import ops

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen
    from rosward.flow.walker import Walker


def _yield(walker: Walker, op: ops.Yield, body: Body, seen: Seen) -> None:
    value, size = body.registers[op.src].under(body.pc), body.pc  # of how often it gives something
    if op.many:
        size |= value.mask | walker.memory.size(value.roots)
        value = elements(walker, value).under(body.pc)
        given = run_callees(walker, op, body, seen)
        if given is not None:
            value = value.joined(implicit.gone_through(walker, given))
            size |= given.mask | walker.memory.size(given.roots)
    key = body.activation.code.key
    walker.memory.write_any([("generator", key)], value, size)
    thrown = walker.memory.of(("thrown", key)).any
    if walker.attempts and thrown != NOTHING:
        walker.attempts[-1].raises(thrown, walker.memory.deep(thrown))
    body.leave(walker.memory)  # others go on from here, before the rest of it runs
    given = walker.memory.of(("sent", key)).any.under(body.pc)
    body.registers[op.dst] = given.joined(value) if op.many else given  # `yield from` gives what the other one returns


def _await(walker: Walker, op: ops.Await, body: Body, seen: Seen) -> None:
    walker.wait()
    given = run_callees(walker, op, body, seen)
    awaited = body.registers[op.src]
    given = either(given, each_of(walker, awaited))
    if given is None:  # what a library gives later is known as what it gave now
        given = Mark(walker.memory.deep(awaited), opaque(awaited) if seen.opaque else frozenset())
    walker.wait()
    body.registers[op.dst] = Mark(given.mask | awaited.mask | body.pc, leads(seen, given))


TABLE: Final[dict[type[ops.Op], Any]] = {ops.Yield: _yield, ops.Await: _await}
