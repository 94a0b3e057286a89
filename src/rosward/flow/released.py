# SPDX-License-Identifier: Apache-2.0
"""What comes of a function that releases what it gives?"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.values import Const, Function
from rosward.effects.flows import RELEASED, Sink, Source
from rosward.flow.body import Body
from rosward.flow.marks import Mark, name_of
from rosward.flow.site import callees

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen
    from rosward.flow.walker import Walker
    from rosward.ir import ops


def released(walker: Walker, op: ops.Call, body: Body, function: Mark, seen: Seen, given: Mark) -> Mark:
    """What a watched function gives is a source of its own: what it is made of is told of the function."""
    if not walker.watched:
        return given
    names = {name_of(root) for root in function.roots}
    for callee in callees(seen.functions):
        if isinstance(callee, Function):  # by its file, since the module that is started has another name
            names.add(f"{callee.code.file.removesuffix('.py').replace('/', '.')}.{callee.code.qualname}")
    found = sorted(w for w in walker.watched if any(f".{name}".endswith(f".{w}") for name in names))
    if not found:
        return given
    mask = body.pc
    for word in found:
        sink = Sink(RELEASED, walker.node, Const(word), walker.place())
        walker.send(sink, walker.memory.deep(given))
        mask |= walker.sources.data(Source(RELEASED, word))
    root = walker.shape.made(body.activation, op.number, found[0])
    walker.memory.renew(root)
    return Mark(mask, frozenset((root,)))
