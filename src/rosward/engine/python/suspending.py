# SPDX-License-Identifier: Apache-2.0
"""What `yield` does: the call is suspended at this point, its values are kept, and control goes to who advanced it.

yield name                  a point, the registers, the item
yield from words(child)     the same for each item of another iterator; behind its end the call goes on with what that returned
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.domain.choice import join
from rosward.domain.compound import Tuple
from rosward.domain.state import join_states
from rosward.domain.suspended import ANY_TURN, EACH, NO_TURN, Path, PathStep, Point, any_turn, join_values
from rosward.domain.values import NONE, UNBOUND, Value
from rosward.engine.python import stepping
from rosward.engine.running.frame import Frame
from rosward.engine.running.stepped import NEXT, Resumption
from rosward.engine.running.ways import Way, find_ways
from rosward.ir import ops
from rosward.models.native import Items
from rosward.models.python.containers.any_order import in_places

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.ir.program import Code

_TURNING: Final = frozenset({"condition", "turn", EACH})


def ways(machine: Engine, code: Code) -> dict[int, Way]:
    """The way to each yield of a body, by the number of its operation."""
    found = machine.ways.get(code.key)
    if found is None:
        found = machine.ways[code.key] = {}
        find_ways(code.ops, (), found)
    return found


def yield_(machine: Engine, op: ops.Yield, frame: Frame) -> bool | None:
    """The handler of `yield` and `yield from`."""
    frame.op, frame.sequence = op, 0
    source = frame.registers[op.src]
    if not op.many:
        _suspend(machine, op, frame, source)
        return False
    source = stepping.made(machine, source)
    if source is UNBOUND:
        return False
    if stepping.steps(machine, source):
        iterator = stepping.iterator_of(machine, source)
        first = NO_TURN if stepping.is_generator(machine, iterator) else 0
        return delegate(machine, op, frame, iterator, first, NEXT)
    return give(machine, op, frame, source, in_places(machine, source), 0)


def delegate(
    machine: Engine, op: ops.Yield, frame: Frame, iterator: Value, turn: int, action: Resumption
) -> bool | None:
    """`yield from` an iterator that is advanced: its next item; behind its end this call goes on. A generator counts its turns itself."""
    context = frame.context
    frame.context = machine.context(context, frame.code.key, op.number, turn)
    item, ended, value = stepping.step(machine, iterator, action)
    frame.context = context
    if item is not UNBOUND:
        _suspend(machine, op, frame, item, turn, (iterator, Tuple(()), UNBOUND))
    if ended is None:
        return False
    machine.state = ended
    frame.registers[op.dst] = value
    return None


def give(machine: Engine, op: ops.Yield, frame: Frame, source: Value, items: Items, turn: int) -> bool | None:
    """`yield from` items: the first of those that are ahead."""
    known, rest = items
    if known:
        if turn >= machine.budget.unroll:
            turn = ANY_TURN
            rest, known = join_all_items(items), ()
        else:
            kept = (source, Tuple(known[1:]), UNBOUND if rest is None else rest)
            _suspend(machine, op, frame, known[0], turn, kept)
            return False
    if rest is not None:
        _suspend(machine, op, frame, rest, ANY_TURN, (source, Tuple(()), rest))
    frame.registers[op.dst] = NONE
    return None


def join_all_items(items: Items) -> Value:
    """Any of some items."""
    value: Value = UNBOUND if items.rest is None else items.rest
    for item in items.known:
        value = join(value, item)
    return value


def _suspend(
    machine: Engine,
    op: ops.Yield,
    frame: Frame,
    item: Value,
    turn: int = NO_TURN,
    kept: tuple[Value, ...] = (),
) -> None:
    """Here the call is suspended, in this state."""
    yielded = frame.yielded
    if yielded is None:  # no call of a generator: the text of such a program would not compile
        return
    path, own = _here(ways(machine, frame.code)[op.number], frame, turn)
    function = yielded.function
    point = Point(function, yielded.context, frame.cells, path)
    values = (*frame.registers, *own, *kept)
    if yielded.shared:
        point, values = any_turn(point, values)
    before = yielded.points.get(point)
    yielded.points[point] = values if before is None else join_values(before, values)
    yielded.item = join(yielded.item, item)
    if yielded.state is None:
        yielded.state = machine.state.copy()
    else:
        yielded.state = join_states(yielded.state, machine.state.copy(), machine.fresh_version)


def _here(way: Way, frame: Frame, turn: int) -> tuple[Path, list[Any]]:
    """The path of the way that led to a yield now, and what the loops on it keep."""
    path: list[PathStep] = []
    kept: list[Value] = []
    for index, part, op in way:
        if part in _TURNING:
            number, *values = frame.turns[op.number]
            path.append(PathStep(index, part, number))
            kept.extend(values)
        else:
            path.append(PathStep(index, part))
    path[-1] = path[-1]._replace(turn=turn)
    return tuple(path), kept
