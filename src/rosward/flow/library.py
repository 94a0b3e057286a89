# SPDX-License-Identifier: Apache-2.0
"""What libraries do with what they get: where something leaves ROS, where something comes from outside, and who only computes.

socket.socket.sendto(data, …)     leaves into the network
time.time()                       comes from the clock
cv2.rectangle(image, …)           nobody knows: the image, and the result, may hold any of the arguments
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from rosward.domain.values import Function
from rosward.flow import marked_cpp
from rosward.flow.marked import FUNCTIONS, MUTATORS, PURE, STOPS, WRITES, Effect
from rosward.flow.marks import Mark, Root, demoted
from rosward.flow.outside import comes_in, out
from rosward.flow.reading import owners_of
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.flow.body import Body
    from rosward.flow.walker import Walker
    from rosward.ir import ops


_KNOWN: Final = ("rclpy.", "tf2_ros.", "builtins.")
"""Their methods keep nothing of what they are given that they give back later, unless a model says so."""
_FEW: Final = 12
"""So many objects the result of an unknown call is said to be itself; it leads to more."""


class _Pattern(NamedTuple):
    pattern: re.Pattern[str]
    effect: Effect


def _pattern(name: str) -> str:
    return re.escape(name).replace(r"\*\*", r"[\w.]+").replace(r"\*", r"\w*")


_PATTERNS: Final = tuple(
    _Pattern(re.compile("(?:" + "|".join(map(_pattern, e.names.split())) + r")\Z"), e)
    for e in (*FUNCTIONS, *marked_cpp.FUNCTIONS)
)
_PURE: Final = re.compile("(?:" + "|".join(PURE.split()).replace(".", r"\.").replace("*", r"[\w.]*") + r")\Z")


def effects_of(name: str) -> list[Effect]:
    """What a function of a library does, by its dotted name."""
    return [p.effect for p in _PATTERNS if p.pattern.match(name)]


def is_pure(name: str) -> bool:
    """Whether a function only computes from what it is given."""
    return _PURE.match(name) is not None and name not in WRITES


def name_of(root: Root) -> str:
    """The dotted name of what stands behind something of a library; '' where it is of no library."""
    if isinstance(root, int):
        return ""
    if root[0] == "external":
        return str(root[1])
    if root[0] == "made":
        return str(root[3])
    if root[0] == "of":
        owner = name_of(root[1])  # type: ignore[arg-type]  # a root
        return f"{owner}.{root[2]}" if owner else ""
    return ""


def perform(walker: Walker, name: str, mask: int, pc: int) -> int:
    """What is known of a function by its name: its sinks get the mask; the sources of its result."""
    given = 0
    for effect in effects_of(name):
        if effect.sink:
            out(walker, effect.sink, mask | pc)
        if effect.source:
            given |= comes_in(walker, effect.source)
    return given


def declared(walker: Walker, body: Body, function: Function, marks: list[Mark]) -> Mark:
    """A function of which a model says only that it is there: its result is computed from what it gets, which its object may keep."""
    name = f"{function.module.name}.{function.code.qualname}"
    mask = body.pc
    nodes = walker.shape.nodes
    for number, mark in enumerate(marks):
        roots = frozenset(r for r in mark.roots if r not in nodes) if number == 0 else mark.roots
        mask |= walker.memory.deep(Mark(mark.mask, roots))
    given = perform(walker, name, mask, body.pc)
    if name in STOPS and marks:
        for root in (marks[-1] if function.code.name.startswith("destroy") and len(marks) > 1 else marks[0]).roots:
            stop(walker, root, body.pc | demoted(marks[0].mask))
    if "." in function.code.qualname and marks and not name.startswith(_KNOWN):
        walker.memory.write_any(marks[0].roots - nodes, Mark(mask))
    root = walker.shape.made(body.activation, body.at.number, name)
    walker.memory.renew(root)
    return Mark(mask | given, frozenset((root,)))


def computed(walker: Walker, body: Body, name: str, marks: list[Mark]) -> Mark:
    """A function that only computes, taken as a whole: what it gives may be a view of what it is given; few write to their object."""
    mask = body.pc
    for mark in marks:
        mask |= walker.memory.deep(mark)
    roots = frozenset[Root]().union(*(m.roots for m in marks))
    if name.rpartition(".")[2] in MUTATORS:
        walker.memory.write_any(marks[0].roots, Mark(mask, roots - marks[0].roots))
        return Mark(mask, marks[0].roots)
    root = walker.shape.made(body.activation, body.at.number, name)
    walker.memory.renew(root)
    if len(roots) > _FEW:
        walker.shape.melt(roots)
    return Mark(mask, roots | {root})


def stop(walker: Walker, root: Root, mask: int) -> None:
    """A timer or subscription is stopped or started here: its callback runs only where this decides so."""
    old = walker.stopped.get(root, 0)
    if old | mask != old:
        walker.stopped[root] = old | mask
        walker.changed = True


def unknown(walker: Walker, op: ops.Call, body: Body, function: Mark, marks: list[Mark]) -> Mark:
    """Code that is not known, unless its name is: it may write to all that it can reach, and give any of it."""
    names = sorted({n for r in function.roots if (n := name_of(r))})
    everything = [*marks, Mark(function.mask, owners_of(function))]
    mask = body.pc
    for mark in everything:
        mask |= walker.memory.deep(mark)
    given = 0
    for name in names:
        given |= perform(walker, name, mask, body.pc)
    root = walker.shape.made(body.activation, op.number, names[0] if names else "")
    walker.memory.renew(root)
    if names and all(is_pure(n) or (effects_of(n) and n not in WRITES) for n in names):
        return Mark(mask | given, frozenset((root,)))
    reached: set[Root] = set()
    for mark in everything:
        reached.update(walker.memory.reached(mark))
    walker.memory.write_any(reached, Mark(mask), mask)
    behind = frozenset[Root]().union(*(m.roots for m in everything))
    if len(behind) > _FEW:
        walker.shape.melt(behind)
    return Mark(mask | given, behind | {root})
