# SPDX-License-Identifier: Apache-2.0
"""Which of many functions does a call mean, of whose arguments nothing is known?

Forty functions `convert(…)`, each for a message or a part of one, that call each other with parts of messages of which nobody knows the types:
a call may mean any of them. Followed as any others they would run in each order, one within the other. So all such calls that are made within
one are taken together, as the calls of a recursion are (`summarised.py`): of all functions that they may mean each runs once, from any state in
which it is called so, in turns, until nothing changes any more.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join_all
from rosward.domain.state import State, join_states
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import UNBOUND, Function, Unknown, Value
from rosward.engine.calls.alternatives import each_apart
from rosward.engine.cpp.guess import Arguments, Call, Guess
from rosward.engine.cpp.linked import linked
from rosward.engine.running.catcher import Catcher
from rosward.engine.running.summaries import Summary
from rosward.engine.throwing import rethrow
from rosward.models.cpp.values.slots import read

if TYPE_CHECKING:
    from rosward.engine.machine import Engine

__all__ = ["each", "is_guess"]

_FEW: Final = 3
"""So many functions that may be meant are followed as any others."""
_KEY: Final = "guess"


def is_guess(machine: Engine, chosen: Sequence[Function], args: Arguments) -> bool:
    """Whether a call may mean many functions, because nothing is known of what it gives them."""
    return len(chosen) > _FEW and bool(args) and all(isinstance(read(machine, arg), Unknown) for arg in args)


def each(machine: Engine, name: str, chosen: Sequence[Function], args: Arguments, call: Call) -> Value:
    """What such a call gives; `call` follows one of the functions."""
    program, summaries, frame = linked(machine), machine.summaries, machine.frames[-1]
    if program.guess is not None:
        return _inside(machine, program.guess, chosen, args, call)
    reason = Reason(Cause.LIMIT, f"recursion of {name}", machine.place)
    guess = program.guess = Guess(Catcher(machine, frame), reason)
    begun, sequence = machine.state.copy(), frame.sequence
    outermost, open_ones = not summaries.running, (summaries.provisional, summaries.open)
    summaries.running[_KEY] = Summary([], begun)
    try:
        for _ in range(machine.budget.fixpoint * 4):
            seen, frame.sequence = guess.version, sequence
            summaries.turns += 1  # what was computed from an answer within is computed anew, whatever runs around
            machine.state = begun.copy()
            value = each_apart(machine, chosen, lambda function: call(function, args))
            if guess.before is not None:
                _turn(machine, guess, guess.before.copy())
            if guess.version == seen:
                break
        else:
            machine.report("RW201", f"the recursion of {name} did not converge")
    finally:
        program.guess = None
        del summaries.running[_KEY]
    if outermost:  # all that was asked for within is answered: what runs around may be remembered
        summaries.provisional, summaries.open = open_ones
    return value


def _turn(machine: Engine, guess: Guess, before: State) -> None:
    """Run all of the functions once. The machine's state is left as it is."""
    here, frame, outer = machine.state, machine.frames[-1], machine.catchers
    sequence, doubts = frame.sequence, machine.log.open_doubts
    machine.catchers = [*outer, guess.catcher]
    machine.precision.apart += 1
    try:
        for key, (function, call, args) in list(guess.calls.items()):
            machine.state, frame.sequence = before.copy(), sequence
            value = call(function, args)
            if value is UNBOUND:
                continue
            known = guess.values.get(key)
            guess.values[key] = value if known is None else guess.merge(known, value)
            state = machine.state.copy()
            state.done -= before.done
            after = guess.after
            guess.after = state if after is None else join_states(after, state, machine.fresh_version, guess.merge)
    finally:
        machine.precision.apart -= 1
        machine.log.settle_doubts(doubts, sure=False)
        machine.catchers = outer
        machine.state = here


def _inside(machine: Engine, guess: Guess, chosen: Sequence[Function], args: Arguments, call: Call) -> Value:
    """Such a call within another one: what is known so far of the functions that it may mean.

    What one writes to what it is given is not seen, which is unknown, and stays so.
    """
    called = machine.state.copy()
    done = called.done
    plain = tuple(read(machine, arg) for arg in args)
    for function in chosen:
        guess.calls.setdefault(function.code.key, (function, call, plain))
    if guess.before is None:
        guess.before = called.copy()
    else:
        guess.before = join_states(guess.before, called, machine.fresh_version, guess.merge, guess.joined)
        guess.joined = called.heap
    machine.summaries.provisional += 1  # what is computed from it now may not be its last word
    machine.summaries.open += 1
    rethrow(machine, guess.catcher)
    values = [guess.values[function.code.key] for function in chosen if function.code.key in guess.values]
    if guess.after is None or not values:
        return UNBOUND
    machine.state = guess.after.copy()
    machine.state.done |= done
    return join_all(values)
