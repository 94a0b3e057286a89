# SPDX-License-Identifier: Apache-2.0
"""Branches and loops: how a structured block maps a state to the states in which control leaves it.

if unknown: x = 'a'            both ways are followed, and joined behind
while k < 3: k += 1            a known condition is followed turn by turn
while unknown: …               anything else runs until nothing changes, widening at the head (`iteration.py` has the loops over items)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, options, widen
from rosward.domain.state import EventKey
from rosward.domain.suspended import ANY_TURN
from rosward.domain.unknown import INSTEAD, Cause, Reason
from rosward.domain.values import UNBOUND, Choice, Const, Unknown, Value
from rosward.engine.running.frame import Frame, OfLoop, Snapshot, join_into
from rosward.engine.running.rest import Rest
from rosward.engine.throwing import note_turn
from rosward.ir import ops
from rosward.location import Place
from rosward.models.ros import parameter_tests

if TYPE_CHECKING:
    from rosward.engine.machine import Engine


_TELLING: Final = (Choice, Const)


def branch(machine: Engine, op: ops.If, frame: Frame) -> bool | None:
    """Follow the way that the test decides, or both."""
    frame.op, frame.sequence = op, 0
    decided = machine.language.truth(machine, frame.registers[op.test])
    if decided is not None:
        return machine.run(op.then if decided else op.orelse, frame) or False
    before = machine.snapshot(frame)
    test = frame.registers[op.test]
    frame.uncertain += 1
    try:
        if test.__class__ in _TELLING:
            parameter_tests.tell(machine, test, _asked(op.then), frame.registers, sense=True)
        first = machine.run(op.then, frame)
        after = Snapshot(frame.registers, machine.state) if first else None
        machine.resume(frame, before)
        if test.__class__ in _TELLING:
            parameter_tests.tell(machine, test, _asked(op.orelse), frame.registers, sense=False)
        second = machine.run(op.orelse, frame)
    finally:
        frame.uncertain -= 1
    if after is not None:
        if second:
            after = join_into(machine, after, Snapshot(frame.registers, machine.state))
        machine.resume(frame, after)
        return None
    return None if second else False


def _asked(block: ops.Block) -> list[int]:
    """The registers of which the test of a branch says something."""
    return [op.src for op in block if op.__class__ is ops.Assume]


def leave(machine: Engine, op: ops.Return, frame: Frame) -> bool:
    """Return from the function."""
    exits = frame.exits
    exits.value = join(exits.value, frame.registers[op.src])
    exits.returned = join_into(machine, exits.returned, Snapshot(frame.registers, machine.state))
    return False


def break_(machine: Engine, _op: ops.Break, frame: Frame) -> bool:
    """Leave the loop."""
    frame.exits.broken = join_into(machine, frame.exits.broken, Snapshot(frame.registers, machine.state))
    return False


def continue_(machine: Engine, _op: ops.Continue, frame: Frame) -> bool:
    """Go on with the next turn."""
    frame.exits.continued = join_into(machine, frame.exits.continued, Snapshot(frame.registers, machine.state))
    return False


def behind(machine: Engine, op: ops.While | ops.ForEach, frame: Frame, alive: bool, around: OfLoop) -> bool | None:
    """Behind a loop: `else` where it ended by itself (a `break` there leaves the loop `around`), joined with where it was left by break."""
    broken, ended = frame.exits.broken, frame.exits.ended
    frame.exits.broken, frame.exits.continued, frame.exits.ended = around
    if ended is not None:
        machine.resume(frame, join_into(machine, ended, Snapshot(frame.registers, machine.state)) if alive else ended)
        alive = True
    alive = alive and machine.run(op.orelse, frame)
    if broken is not None:
        if alive:
            broken = join_into(machine, broken, Snapshot(frame.registers, machine.state))
        machine.resume(frame, broken)
        return None
    return None if alive else False


def turn(machine: Engine, body: ops.Block, frame: Frame) -> bool:
    """One turn of a loop's body; True where a next one can follow."""
    return end_turn(machine, frame, alive=machine.run(body, frame))


def end_turn(machine: Engine, frame: Frame, *, alive: bool) -> bool:
    """The end of a turn, which control reaches through the body (`alive`) or by `continue`."""
    continued = frame.exits.continued
    if continued is not None:
        frame.exits.continued = None
        if alive:
            continued = join_into(machine, continued, Snapshot(frame.registers, machine.state))
        machine.resume(frame, continued)
        return True
    return alive


_FEW: Final = 16
"""So many turns of a loop within which something is created are followed one by one where precision is given up."""


def roughly(machine: Engine, frame: Frame, turns: int) -> bool:
    """Whether a loop of so many turns is to be joined at once: where precision is given up, but for short ones that create something."""
    return machine.precision.coarse and (turns > _FEW or frame.code.key not in machine.trace.creating)


def loop(
    machine: Engine, op: ops.While, frame: Frame, begun: tuple[int, Callable[[], bool]] | None = None
) -> bool | None:
    """A while loop: followed while its condition is known, then to a fixpoint. `begun`: a turn that was suspended, and how it is finished."""
    frame.op, frame.sequence = op, 0
    around, context = frame.exits.enter_loop(), frame.context
    forever = bool(op.condition) and len(op.condition) == 1 and op.condition[0].__class__ is ops.Const
    limit = machine.budget.unroll_forever if forever else machine.budget.unroll_while
    alive, number, doubts = True, 0, 0
    sure: frozenset[EventKey] | None = None  # what had happened before the first turn of which there may be none
    machine.precision.begin_loop(op, frame)
    if begun is not None:
        number, finish = begun
        _enter_turn(machine, op, frame, context, number)
        alive = finish()
        if not alive:
            machine.precision.end_loop(op, frame)
            frame.context = context
            return behind(machine, op, frame, alive, around)
        limit += number + 1
        number = number + 1 if 0 <= number < machine.budget.unroll_while else ANY_TURN
    while True:
        note_turn(machine)
        _enter_turn(machine, op, frame, context, number)
        if number == ANY_TURN:
            alive = until_stable(machine, op, frame, None, None)
            break
        seen = (machine.state.version, frame.registers.copy())
        alive = machine.run(op.condition, frame)
        if not alive:
            break
        test = frame.registers[op.test]
        frame.op, frame.sequence = op, 0  # which asks, not the last operation of its condition
        decided = machine.language.truth(machine, test)
        ways = _named_ways(test) if decided is None and op.counted else frozenset()
        # Defaults and alternatives say how many turns there are: none only of themselves.
        if True in ways or (ways and number):
            if len(ways) > 1:
                frame.exits.ended = join_into(machine, frame.exits.ended, machine.snapshot(frame))
            decided = True in ways
            sure = machine.state.done if sure is None else sure
            frame.uncertain += 1
            doubts += 1
        if decided is False:
            break
        if (
            decided is None
            or number >= limit
            or machine.precision.turns >= machine.budget.turns
            or roughly(machine, frame, number)
        ):
            _enter_turn(machine, op, frame, context, ANY_TURN)
            alive = until_stable(machine, op, frame, seen[1], None)
            break
        alive = turn(machine, op.body, frame)
        if not alive:
            break
        if machine.state.version == seen[0] and frame.registers == seen[1]:
            if not forever and machine.schedule_book.entries:  # something that runs meanwhile may end it
                machine.spin()
                if machine.state.version != seen[0]:
                    continue
                if machine.schedule_book.running:
                    break
            alive = False  # nothing changes any more: it never ends
            _never_ends(machine, frame)
            break
        number += 1
        machine.precision.turns += 1
        machine.check_time()
    frame.uncertain -= doubts
    if sure is not None:
        machine.state.done = sure
    machine.precision.end_loop(op, frame)
    frame.context = context
    return behind(machine, op, frame, alive, around)


def _named_ways(test: Value) -> frozenset[bool]:
    """How a test comes out for the values that are known; none where something else may be there than what is given in place of a default."""
    known = [o for o in options(test) if not (isinstance(o, Unknown) and all(r.cause in INSTEAD for r in o.reasons))]
    if not all(isinstance(o, Const) for o in known):
        return frozenset()
    return frozenset(bool(o.value) for o in known if isinstance(o, Const))


def _enter_turn(machine: Engine, op: ops.While, frame: Frame, context: int, number: int) -> None:
    """A turn begins: what it makes is told apart from what others make."""
    frame.context = machine.context(context, frame.code.key, op.number, "*" if number == ANY_TURN else number)
    if frame.yielded is not None:
        frame.turns[op.number] = (number,)


def _never_ends(machine: Engine, frame: Frame) -> None:
    """A loop is not left at its end. One of a generator waits at its `yield`, which blocks nothing."""
    if frame.yielded is None or frame.yielded.state is None:
        machine.log.may_end(machine)


Feed = Callable[[], tuple[Value, Snapshot | None]]
"""The next item of what a loop runs over, and where the loop ends instead (None: it surely does not)."""


def until_stable(
    machine: Engine, op: ops.While | ops.ForEach, frame: Frame, registers: list[Value] | None, feed: Feed | None
) -> bool:
    """Any number of turns: joins the states at the head of the loop until they do not change, widening after a few.

    For a while loop the condition has just been run once too often: `registers` are those of before. Leaves the machine in the state
    in which the loop ends by itself; False where it cannot.
    """
    if registers is not None:
        frame.registers = registers
    reason = Reason(Cause.LOOP, "", Place(frame.code.file, op.line, op.column))

    def widening(old: Value, new: Value) -> Value:
        return widen(old, new, reason)

    begun = machine.snapshot(frame)
    known = machine.precision.rest_of((frame.code.key, op.number)) if machine.precision.coarse else None
    if known is not None:  # where it came to rest before it probably does again
        head = known.joined(machine, begun, widening)
    else:
        head = Snapshot(begun.registers, begun.state.copy())
    ended: Snapshot | None = None
    frame.uncertain += 1
    # Inside a loop that is followed to a fixpoint itself, each turn would be joined many times over: there it widens at once.
    patience = 0 if machine.precision.fixpoints or machine.precision.coarse else machine.budget.widen_after
    machine.precision.fixpoints += 1
    for number in range(machine.budget.fixpoint * 4):
        machine.resume(frame, Snapshot(head.registers.copy(), head.state.copy()))
        note_turn(machine)
        ended = None
        alive = True
        if isinstance(op, ops.While):
            alive = machine.run(op.condition, frame)
            frame.op, frame.sequence = op, 0
            decided = machine.language.truth(machine, frame.registers[op.test]) if alive else False
            if alive and decided is not True:
                ended = machine.snapshot(frame)
            alive = alive and decided is not False
        else:
            assert feed is not None
            frame.op, frame.sequence = op, 0
            item, ended = feed()
            frame.registers[op.item] = item
            alive = item is not UNBOUND
        if not (alive and turn(machine, op.body, frame)):
            break
        version, before = head.state.version, head.registers
        merge = join if number < patience else widening
        head = join_into(machine, head, Snapshot(frame.registers, machine.state), merge)
        if head.state.version == version and head.registers is before:
            break
        machine.check_time()
    else:
        frame.op = op
        machine.report("RW201", "the loop did not converge; what later iterations create may be missing")
    frame.uncertain -= 1
    machine.precision.fixpoints -= 1
    if machine.precision.coarse:
        machine.precision.comes_to_rest((frame.code.key, op.number), known, Rest.of(begun, head))
    if ended is None:
        _never_ends(machine, frame)
        return False
    machine.resume(frame, ended)
    return True
