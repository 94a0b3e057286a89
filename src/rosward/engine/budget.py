# SPDX-License-Identifier: Apache-2.0
"""Every limit of the analysis, in one record. Hitting one is a finding (RW201), never silence."""

from __future__ import annotations

from typing import Final

from rosward.location import Place
from rosward.records import NamedTuple


class Budget(NamedTuple):
    """Limits of the interpretation of one process.

    Steps are operations interpreted, and what takes as long: joins of states by the objects that differ, natives by their cost. So what is
    found does not depend on the machine.

    `steps`: those of the main body before it is given up; `entry_steps`: those of each callback; `callback_steps`: those of all callbacks.
    `coarse`: the part of the main body's, and of those of all callbacks, after which precision is given up, so that
    what computes much comes to rest: loops are no longer followed turn by turn, nor calls in contexts of their own.
    `unaware`: those in functions in C++ that know nothing of ROS, before those that take many are no longer followed.
    `entry_coarse`: the steps of one callback after which the same happens; `loop_steps`: those of one outermost loop, until it ends.
    `entry_idle`, `loop_idle`: those since something was created, for a process followed in haste, as each in Python is at first: where something
    is created that may depend on it, or a callback takes `entry_hasty` or a loop `loop_hasty`, it is followed anew, that part without haste.
    `large`: the operations of a body that is then followed once for all its calls.
    `depth`: nested calls. `recursion`: calls of one function inside itself that are followed with their own arguments.
    `unroll`: turns of a loop over a known sequence that are followed one by one; `unroll_while`: the same for a `while` whose condition is
    known; `unroll_forever`: for `while True`.
    `turns`: turns of loops, nested ones included, that are followed one by one within one outermost loop.
    `fixpoint`: turns after which a loop that is followed by joining must have come to rest; `widen_after`: turns before widening.
    `rounds`: rounds in which all callbacks run before widening forces an end. `items`: elements of one collection kept apart.
    `seconds`: of CPU time for one process: a net below all the others, many times what the steps take.
    `flow`: information flow is followed as well; `watched`: the functions, by their dotted names, of which it is told what they give.
    `net`: what fails in rosward itself is a finding (RW299) and costs one piece of input; without it, it is raised.
    """

    steps: int = 500_000
    entry_steps: int = 1_000_000
    callback_steps: int = 2_000_000
    coarse: float = 0.25
    entry_coarse: int = 30_000
    entry_idle: int = 300
    entry_hasty: int = 180_000
    unaware: int = 60_000
    loop_steps: int = 120_000
    loop_idle: int = 1_000
    loop_hasty: int = 100_000
    large: int = 50
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
    seconds: float = 600.0

    def times(self, factor: float) -> Budget:
        """The budget with its steps multiplied: what `--budget` asks for."""
        each = (
            "steps",
            "entry_steps",
            "entry_coarse",
            "entry_idle",
            "entry_hasty",
            "callback_steps",
            "loop_steps",
            "loop_idle",
            "loop_hasty",
        )
        counted = (*each, "unaware", "seconds")
        more = {name: type(value)(value * factor) for name, value in self._asdict().items() if name in counted}
        return self._replace(**more)

    net: bool = True
    flow: bool = False
    watched: frozenset[str] = frozenset()

    @property
    def factor(self) -> float:
        """How many times the usual steps it has."""
        return self.steps / Budget().steps


class LimitReachedError(Exception):
    """A limit of the budget was reached; `what` says which, in words, `place` where in the user's code."""

    def __init__(self, what: str, place: Place) -> None:
        super().__init__(what)
        self.what = what
        self.place = place


MAIN_BODY: Final = "main body"
"""Among what is to be followed without haste: the loops that are in no callback."""


class BeginAnewError(BaseException):
    """Something is created, of which a part was followed in haste: the process is to be followed anew, that part without haste.

    `parts`: the callbacks by the keys of their code, and `MAIN_BODY`.
    It is no `Exception`: what catches the faults of a part of an analysis must not take it for one.
    """

    def __init__(self, parts: frozenset[str]) -> None:
        super().__init__(*parts)
        self.parts = parts
