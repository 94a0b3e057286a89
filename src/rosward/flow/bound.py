# SPDX-License-Identifier: Apache-2.0
"""What stands in the parameters of a function that is called: the arguments, the defaults, what `*` and `**` give and gather.

f(a, *more)      what stands in the register of `a`; of the elements of `more` nobody tells apart which is which
"""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Final

from rosward.engine.arguments import ANY, LOOSE, MAYBE, ORDER
from rosward.engine.running.seen import Called, Handed, refs_of
from rosward.flow.body import Body
from rosward.flow.marks import NOTHING, Mark, Root, demoted
from rosward.flow.reading import opaque
from rosward.flow.stored.content import Content
from rosward.flow.ways import joined_marks
from rosward.ir import ops
from rosward.ir.registers import reads
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.values import Function
    from rosward.flow.walker import Walker


class Spread(NamedTuple):
    """What stands in no register and is an argument: the elements that `*` and `**` give, or what a library got from another function.

    `size` decides how many arguments there are, and so which of them is which; `elements`: what methods of the program say that these are,
    which `ran` for it; `receivers`: the objects that are no elements.
    """

    size: int = 0
    elements: Mark = NOTHING
    ran: frozenset[str] = frozenset()
    receivers: frozenset[int] = frozenset()


NO_SPREAD: Final = Spread()


_FEW: Final = 8
"""So many calls of one body are told apart."""


def all_bound(walker: Walker, op: ops.Op, body: Body, several: list[Called], spread: Spread) -> list[list[Mark]]:
    """The marks of the parameters of each call; of many, joined."""
    marks = [_bound(walker, op, body, called, spread) for called in several]
    return marks if len(several) <= _FEW else [joined_marks(marks)]


def _bound(walker: Walker, op: ops.Op, body: Body, called: Called, spread: Spread) -> list[Mark]:
    """The marks of the parameters, in the order of their registers."""
    given = [handed(walker, op, body, h, spread) for h in called.args]
    size = spread.size
    if size:
        given = [mark.under(size) for mark in given]
    named: dict[str, Mark] = {}
    for name, passed in called.keywords:
        unknown = name in (LOOSE, ORDER, ANY)
        plain = name if unknown else name.removeprefix(MAYBE)
        named[plain] = handed(walker, op, body, passed, spread, "" if unknown else plain).under(size)
    made = Mark(body.registers[op.func].mask | size if isinstance(op, ops.Call) else 0)
    return in_parameters(walker, body, op.number, called.function, given, named, made, size)


def in_parameters(
    walker: Walker,
    body: Body,
    site: int,
    function: Function,
    given: list[Mark],
    named: dict[str, Mark],
    made: Mark,
    spread: int = 0,
) -> list[Mark]:
    """What stands in the parameters: the arguments, the defaults that are in what the function was `made` with, what `*` and `**` gather."""
    parameters = function.code.parameters
    count = len(parameters.positional)
    unnamed = NOTHING
    for name, mark in named.items():
        if name in (LOOSE, ORDER, ANY):
            unnamed = unnamed.joined(mark)
    marks = list(given[:count])
    for name in parameters.positional[len(marks) :]:
        marks.append((named.get(name) or _default(function, made, name)).joined(unnamed))
    if parameters.vararg is not None:
        root: Root = walker.shape.made(body.activation, site, "*", "tuple")
        slots: dict[object, Mark] = dict(enumerate(given[count:]))
        walker.memory.place(root, Content(0, unnamed, body.pc | spread, slots))
        marks.append(Mark(body.pc, frozenset((root,))))
    marks += [(named.get(n) or _default(function, made, n)).joined(unnamed) for n in parameters.kwonly]
    if parameters.kwarg is not None:
        root = walker.shape.made(body.activation, site, "**", "tuple")
        further: dict[object, Mark] = {n: m for n, m in named.items() if n not in parameters.names}
        walker.memory.place(root, Content(0, unnamed, body.pc | spread, dict(further)))
        marks.append(Mark(body.pc, frozenset((root,))))
    return marks


def _default(function: Function, made: Mark, name: str) -> Mark:
    """The mark of a parameter that is not given: what the function was made with."""
    positional, defaults = function.code.parameters.positional, function.defaults
    for named, default in chain(zip(reversed(positional), reversed(defaults), strict=False), function.kwdefaults):
        if named == name:
            return Mark(made.mask, frozenset(refs_of(default)))
    return Mark(made.mask)


def _only_chosen(walker: Walker, refs: frozenset[int]) -> bool:
    """Whether it is one object that says itself what stands in it: of one of a library, whoever leads to it does (what time it is)."""
    return len(refs) == 1 and walker.memory.is_one(refs) and not any(map(walker.shape.class_name, refs))


def handed(walker: Walker, op: ops.Op, body: Body, given: Handed, spread: Spread, name: str = "") -> Mark:
    """The mark of one argument: that of the registers in which it stands, else all that the operation reads, but for plain objects."""
    found = Mark(body.pc, frozenset(given.refs))
    for register in given.registers:
        found = found.joined(body.registers[register])
    if given.registers:
        return found
    is_object = given.refs and not given.more
    if spread.elements is not NOTHING and not (is_object and (not spread.ran or given.refs <= spread.receivers)):
        found = found.joined(spread.elements)
    named = [a.register for a in op.arguments if a.kind == "doublestar"] if name and isinstance(op, ops.Call) else []
    if named:
        for register in named:
            mark = body.registers[register]
            found = found.joined(walker.memory.read(mark.roots, name)).under(mark.mask)
        return found
    if is_object:
        if not isinstance(op, ops.Call):
            return found
        chosen = body.registers[op.func].mask  # of a receiver, or an object that is made here
        return found.under(demoted(chosen) if _only_chosen(walker, given.refs) else chosen)
    for register in reads(op):
        mark = body.registers[register]
        found = found.joined(Mark(walker.memory.deep(mark), opaque(mark)))
    for register in (a.register for a in op.arguments if a.is_spread) if isinstance(op, ops.Call) else ():
        found = found.joined(Mark(0, opaque(walker.memory.read_all(body.registers[register].roots))))
    return found
