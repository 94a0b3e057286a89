# SPDX-License-Identifier: Apache-2.0
"""Going on behind a `yield`: the rest of its block, then the rest of the block around it, to the end of the body.

for n in names:              the rest of this turn, then the turns that are ahead
    with opened(n) as f:     the rest of the `with`, then `__exit__`; it is not entered again
        yield f              what is sent becomes the value of `yield`; what is thrown is raised here
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from rosward.domain.choice import join, join_all, options
from rosward.domain.suspended import ANY_TURN, EACH, KEPT, Path
from rosward.domain.unknown import Cause
from rosward.domain.values import UNBOUND, Value
from rosward.engine import control
from rosward.engine.python import contexts, exceptions, iteration, stepping, suspending
from rosward.engine.python.equality import truth
from rosward.engine.python.iteration import Begun
from rosward.engine.running.catcher import ANYTHING
from rosward.engine.running.frame import Frame, join_into
from rosward.engine.running.stepped import Resumption
from rosward.engine.running.ways import parts
from rosward.engine.throwing import is_unseen, note_sources
from rosward.ir import ops
from rosward.models.native import Items

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


def go_on(machine: Engine, block: ops.Block, frame: Frame, path: Path, kept: list[Value], action: Resumption) -> bool:
    """Go on in a block at the yield to which `path` leads; True where control comes out at its end. `kept`: what its loops keep."""
    step, inner = path[0], path[1:]
    op: Any = block[step.number]
    if inner:
        alive = _INSIDE[op.__class__](machine, op, frame, path, kept, action)
    else:
        alive = _behind(machine, op, frame, step.turn, kept, action)
    return alive is not False and machine.run(block[step.number + 1 :], frame)


def _behind(
    machine: Engine, op: ops.Yield, frame: Frame, turn: int, kept: list[Value], action: Resumption
) -> bool | None:
    """At the yield itself."""
    frame.op, frame.sequence = op, 0
    if op.many:
        source, ahead, rest = kept
        if stepping.steps(machine, source):
            number = turn if turn < 0 else turn + 1 if turn < machine.budget.unroll else ANY_TURN
            return suspending.delegate(machine, op, frame, source, number, action)
        if action.kind not in ("throw", "close"):
            known, more = machine.iterate(ahead)
            others = join(rest, UNBOUND if more is None else more)
            left = Items(known, None if others is UNBOUND else others)
            return suspending.give(machine, op, frame, source, left, turn + 1 if turn >= 0 else ANY_TURN)
    if action.kind in ("throw", "close"):
        exceptions.thrown_in(machine, action.value)
        return False
    frame.registers[op.dst] = action.value
    return None


def _inside(
    machine: Engine, op: ops.Op, frame: Frame, path: Path, kept: list[Value], action: Resumption
) -> Callable[[], bool]:
    """Going on in the block of `op` that the path leads into, when the statement around it is ready."""
    block = dict(parts(op))[path[0].part]
    return lambda: go_on(machine, block, frame, path[1:], kept, action)


def _if(machine: Engine, op: ops.If, frame: Frame, path: Path, kept: list[Value], action: Resumption) -> bool:
    return _inside(machine, op, frame, path, kept, action)()


def _while(
    machine: Engine, op: ops.While, frame: Frame, path: Path, kept: list[Value], action: Resumption
) -> bool | None:
    finish = _inside(machine, op, frame, path, kept, action)
    part, turn = path[0].part, path[0].turn
    if part == "orelse":
        return finish()

    def rest_of_turn() -> bool:
        alive = finish()
        if part == "condition" and alive:
            decided = truth(machine, frame.registers[op.test])
            if decided is not True:
                frame.exits.ended = join_into(machine, frame.exits.ended, machine.snapshot(frame))
            alive = decided is not False and machine.run(op.body, frame)
        return control.end_turn(machine, frame, alive=alive)

    return control.loop(machine, op, frame, (turn, rest_of_turn))


def _for_each(
    machine: Engine, op: ops.ForEach, frame: Frame, path: Path, kept: list[Value], action: Resumption
) -> bool | None:
    if path[0].part != EACH:
        return _inside(machine, op, frame, path, kept, action)()
    finish = _inside(machine, op, frame, path, kept[KEPT:], action)
    source, ahead, rest = kept[:KEPT]
    known, more = machine.iterate(ahead)
    others = join(rest, UNBOUND if more is None else more)
    left = Items(known, None if others is UNBOUND else others)

    def rest_of_turn() -> bool:
        return control.end_turn(machine, frame, alive=finish())

    return iteration.for_each(machine, op, frame, Begun(path[0].turn, source, left, rest_of_turn))


def _try(machine: Engine, op: ops.Try, frame: Frame, path: Path, kept: list[Value], action: Resumption) -> bool | None:
    part, finish = path[0].part, _inside(machine, op, frame, path, kept, action)
    if part == "final":
        return _in_finally(machine, op, frame, finish)
    if part == "body":
        return exceptions.attempt(machine, op, frame, body=finish)
    handled = _in_handler(machine, op, frame, part, finish) if part.startswith("handler ") else finish
    return exceptions.attempt(machine, op, frame, handled=handled)


def _in_handler(
    machine: Engine, op: ops.Try, frame: Frame, part: str, finish: Callable[[], bool]
) -> Callable[[], bool]:
    """The rest of a handler, in which what it handles goes on by a bare `raise`."""
    caught = options(frame.registers[op.handlers[int(part.partition(" ")[2])].bind])
    known = [c for c in caught if not is_unseen(c)]

    def handled() -> bool:
        with machine.handles(join_all(known), ANYTHING if len(known) < len(caught) else 0):
            return finish()

    return handled


def _in_finally(machine: Engine, op: ops.Try, frame: Frame, finish: Callable[[], bool]) -> bool:
    """Behind a `finally` that was suspended: on any of the ways that lead through one, also with an exception that is on its way."""
    if not finish():
        return False
    exits = frame.exits
    exits.value = join(exits.value, machine.unknown(Cause.LIMIT, "what `return` gives where `finally` yields"))
    ways = _ways_out(op.blocks[:-1], nested=False)
    for way in ("returned", *sorted(ways & {"broken", "continued"})):
        setattr(exits, way, join_into(machine, getattr(exits, way), machine.snapshot(frame)))
    note_sources(machine)
    if "raised" in ways:
        machine.log.may_end(machine)
    return True


def _ways_out(blocks: tuple[ops.Block, ...], *, nested: bool) -> set[str]:
    """How control may leave blocks in words of the program: `raised`, `broken`, `continued`; `nested`: in a loop that stands in them."""
    found: set[str] = set()
    for op in (op for block in blocks for op in block):
        if op.__class__ is ops.Raise:
            found.add("raised")
        elif not nested and op.__class__ in _JUMPS:
            found.add(_JUMPS[op.__class__])
        inner: tuple[ops.Block, ...] = getattr(op, "blocks", ())
        if op.__class__ in (ops.ForEach, ops.While):  # what its `else` says, it says of the loop around
            *turns, orelse = inner
            found |= _ways_out(tuple(turns), nested=True)
            inner = (orelse,)
        found |= _ways_out(inner, nested=nested)
    return found


_JUMPS: Final[dict[type[ops.Op], str]] = {ops.Break: "broken", ops.Continue: "continued"}


def _with(
    machine: Engine, op: ops.With, frame: Frame, path: Path, kept: list[Value], action: Resumption
) -> bool | None:
    return contexts.with_context(machine, op, frame, body=_inside(machine, op, frame, path, kept, action))


_INSIDE: Final[dict[type[ops.Op], Callable[..., bool | None]]] = {
    ops.If: _if,
    ops.While: _while,
    ops.ForEach: _for_each,
    ops.Try: _try,
    ops.With: _with,
}
