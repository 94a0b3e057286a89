# SPDX-License-Identifier: Apache-2.0
"""Every limit of the analysis, in one record. Hitting one is a finding (RW201), never silence."""

from __future__ import annotations

from typing import NamedTuple

from rosward.source.location import Place


class Budget(NamedTuple):
    """Limits of the interpretation of one process.

    `steps`: operations interpreted before the process is given up; `entry_steps`: the same for each callback, afterwards.
    `coarse`: the part of either after which precision is given up, so that what computes much comes to rest: loops are no longer followed
    turn by turn, nor calls in contexts of their own. `loop_steps`: the same for one outermost loop, until it ends.
    `depth`: nested calls. `recursion`: calls of one function inside itself that are followed with their own arguments.
    `unroll`: turns of a loop over a known sequence that are followed one by one; `unroll_while`: the same for a `while` whose condition is
    known; `unroll_forever`: for `while True`.
    `turns`: turns of loops, nested ones included, that are followed one by one within one outermost loop.
    `fixpoint`: turns after which a loop that is followed by joining must have come to rest; `widen_after`: turns before widening.
    `rounds`: rounds in which all callbacks run before widening forces an end. `items`: elements of one collection kept apart.
    `seconds`: of CPU time for one process.
    `net`: what fails in rosward itself is a finding (RW299) and costs one piece of input; without it, it is raised.
    """

    steps: int = 300_000
    entry_steps: int = 60_000
    coarse: float = 0.4
    loop_steps: int = 120_000
    depth: int = 60
    recursion: int = 4
    unroll: int = 300
    unroll_while: int = 50
    unroll_forever: int = 4
    turns: int = 600
    fixpoint: int = 12
    widen_after: int = 2
    rounds: int = 8
    items: int = 1_000
    seconds: float = 12.0
    net: bool = True


class LimitReachedError(Exception):
    """A limit of the budget was reached; `what` says which, in words, `place` where in the user's code."""

    def __init__(self, what: str, place: Place) -> None:
        super().__init__(what)
        self.what = what
        self.place = place
