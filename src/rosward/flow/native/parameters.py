# SPDX-License-Identifier: Apache-2.0
"""What code itself gives to parameters: the default with which it declares one, and the values that it sets.

self.declare_parameter('gain', self.measured)     whoever reads `gain` reads what was measured, unless it was set from outside
self.set_parameters([Parameter('gain', value=2.0)])   reads what decides that this runs
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from rosward.domain.values import Const
from rosward.effects.flows import Sink, Source
from rosward.flow.marks import Mark, Root, demoted

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def keep(walker: Walker, nodes: Iterable[Root], name: object, value: Mark, pc: int) -> None:
    """A parameter of these nodes gets a value, or loses it; `name` is no text where it is not known."""
    nodes = frozenset(nodes)
    held = _held(nodes)
    mark = Mark(walker.memory.deep(value) | pc)
    if any(source.kind != "parameter" for source in walker.sources.apart(mark.mask)[0]):
        _told(walker, nodes, mark.mask)
    if isinstance(name, str):
        walker.memory.write(held, name, mark)
        walker.memory.write_any(held, Mark(), pc)
    else:
        walker.memory.write_any(held, mark, mark.mask)


def _told(walker: Walker, nodes: Iterable[Root], mask: int) -> None:
    """The client library publishes what parameters become, and answers who asks for them."""
    for node in nodes:
        if isinstance(node, int):
            for kind, name in (("topic", "/parameter_events"), ("response", "~/get_parameters")):
                walker.send(Sink(kind, node, Const(name), walker.place()), mask)


def kept(walker: Walker, nodes: Iterable[Root], name: object) -> int:
    """What code has given to a parameter of these nodes; to any, where it is not known to which."""
    held = _held(nodes)
    found = walker.memory.read(held, name) if isinstance(name, str) else walker.memory.read_all(held)
    return found.mask


def judged(walker: Walker, node: Root, mask: int) -> None:
    """A callback says whether parameters of a node are set: what decides that, but for those that it is told of, decides their values."""
    told = Source("parameter", "*")
    decides = 0
    for source in walker.sources.apart(mask)[1]:
        decides |= walker.sources.data(source) if source != told else 0
    if decides:
        keep(walker, (node,), None, Mark(), demoted(decides))


def declared(walker: Walker, nodes: Iterable[Root]) -> int:
    """What decides which parameters there are."""
    return walker.memory.size(_held(nodes))


def _held(nodes: Iterable[Root]) -> frozenset[Root]:
    return frozenset(("parameters", node) for node in nodes)
