# SPDX-License-Identifier: Apache-2.0
"""How precisely is a process followed, and when is that given up, so that what computes much comes to rest?

Loops have turns and steps of their own, callbacks steps of their own. Where they are spent, precision is given up (`coarse`): loops are joined
at once, calls of one function share a context. `budget.py` says how much each may take.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, final

from rosward.deadline import Deadline
from rosward.engine.budget import MAIN_BODY, BeginAnewError, Budget, LimitReachedError
from rosward.engine.running.haste import Haste
from rosward.records import NamedTuple
from rosward.rules import TIME_LIMIT

if TYPE_CHECKING:
    from rosward.effects.log import Execution
    from rosward.engine.running.frame import Frame
    from rosward.engine.running.rest import Rest
    from rosward.ir.ops import Op
    from rosward.ir.program import OpKey


class Effort(NamedTuple):
    """How much was spent at a moment, or since one: steps, turns, loops. `first`: the turns at its beginning.

    `heavy`: how many loops were known to take too many steps, `given_up`: how often precision was given up for one.
    """

    steps: int
    first: int
    turns: int
    loops: int
    heavy: int
    given_up: int
    coarse: bool


Rests = dict["OpKey", "tuple[Rest | None, Rest]"]
"""By loop, where it came to rest before and where it does now."""


@final
class Precision:
    """The steps and turns that were spent, and what that means for those to come."""

    __slots__ = (
        "_always_coarse",
        "_begun",
        "_coarse_limit",
        "_created",
        "_entry_limit",
        "_heads",
        "_heavy",
        "_in_callbacks",
        "_in_model",
        "_loop_begun",
        "_repeated",
        "_short",
        "_whole_limit",
        "apart",
        "begun",
        "budget",
        "callback",
        "coarse",
        "deadline",
        "fixpoints",
        "given_up",
        "haste",
        "loop_limit",
        "loops",
        "repeated_in_callbacks",
        "rests",
        "spent",
        "step_limit",
        "steps",
        "turns",
    )

    def __init__(self, budget: Budget, careful: frozenset[str] | None = None) -> None:
        self.budget = budget
        self.haste = Haste(careful)  # precision is given up early where nothing is created
        self.callback = ""  # the key of that which is running
        self.steps = 0
        self.step_limit = budget.steps
        self._whole_limit = 0  # the same, while the main body may take fewer in a loop that is followed in haste
        self.coarse = False  # precision is given up: too many steps were spent
        # behind it precision is given up, until the outermost loop ends
        self.loop_limit = int(budget.steps * budget.coarse)
        self.deadline = Deadline(budget.seconds)
        self.fixpoints = 0  # how many loops are being followed to a fixpoint
        self.loops = 0  # how many loops are running
        self.apart = 0  # how often one of several alternatives is being followed
        self._repeated = 0  # steps that counted and were not taken, as what they do was known
        self.begun = 0  # how many loops began
        self.given_up = 0  # how often precision was given up for a loop
        self.turns = 0  # turns followed one by one since the outermost of them began
        self._heads: dict[OpKey, Rest] = {}  # where loops came to rest; in coarse mode only
        self.rests: Rests = {}  # of those that ran in the call that is to be remembered: what stood there before, and behind
        self.spent = 0  # steps of all callbacks, but for those that are running
        self.repeated_in_callbacks = 0  # those of them that were not taken
        self._entry_limit = budget.entry_steps  # those of the callback that is running
        self._begun = 0  # how many steps there were when these began
        self._created = 0  # how many there were when something was created last, or a callback began
        self._loop_begun = 0  # and when the outermost loop did
        self._in_model = False  # the outermost loop is one of a library
        self._short = False  # the callback that is running has few steps where it creates nothing
        self._in_callbacks = False
        self._always_coarse = False  # the callback that is running took too many steps when it ran before
        self._coarse_limit = self.loop_limit  # the same, outside of all loops
        self._heavy: set[OpKey] = set()  # the outermost loops that took too many steps

    def spend(self, steps: int, where: Execution) -> None:
        """Something takes as long as this many steps; raises where there are fewer left."""
        self.steps += steps
        if self.steps - self._repeated > self.step_limit:
            if self._short:
                raise BeginAnewError(frozenset((self.callback,)))
            if self._whole_limit and not self._in_callbacks:
                raise BeginAnewError(frozenset((MAIN_BODY,)))
            most = self._entry_limit if self._in_callbacks else self.budget.steps
            raise LimitReachedError(f"more than {most} steps", where.place)

    def give_up(self) -> None:
        """From here on, what runs is followed with less precision."""
        self.coarse = True
        if self._gave_up_early():
            self._whole_limit = self.step_limit
            self.step_limit = min(self.step_limit, self.steps - self._repeated + self.budget.loop_hasty)

    def check_time(self, where: Execution) -> None:
        """Raise where the process has used up its time."""
        if self.deadline.is_over():
            raise LimitReachedError(f"more than {self.budget.seconds:g} {TIME_LIMIT}", where.place)

    # Loops

    def begin_loop(self, op: Op, frame: Frame) -> None:
        """A loop begins: an outermost one has turns and steps of its own, before precision is given up."""
        self.loops += 1
        self.begun += 1
        if self.loops == 1:
            self.turns = 0
            self._loop_begun = self.steps
            self._in_model = frame.code.is_model  # it costs less than what it is made of where precision is given up
            self._set_limit()
            self.coarse = self.coarse or (frame.code.key, op.number) in self._heavy

    def end_loop(self, op: Op, frame: Frame) -> None:
        """A loop has ended."""
        self.loops -= 1
        if not self.loops:
            self.given_up += self.coarse
            if self.coarse and not self._always_coarse:
                self._heavy.add((frame.code.key, op.number))
                self._always_coarse = self._in_callbacks  # until the callback ends
            self._note_haste()
            if self._whole_limit and not self._in_callbacks:
                self.step_limit, self._whole_limit = self._whole_limit, 0
            if not self._in_callbacks:  # what follows in the main body has its part of what is left
                left = int((self.step_limit - self.steps) * self.budget.coarse)
                self._coarse_limit = max(self._coarse_limit, self.steps + left)
            self._set_limit()
            self.coarse = self._always_coarse or self.steps > self.loop_limit

    def note_creation(self, *, new: bool, exact: bool, key: object = None) -> None:
        """Something is created: what runs now is worth its steps. Raises where that comes too late.

        `new`: it was not known yet; `exact`: its name and type are wholly known, and no branch leaves open whether it is created;
        `key`: what tells it from others.
        """
        exact = exact and not self.apart
        self.haste.open += new and not exact
        if self.coarse and self._short:
            raise BeginAnewError(frozenset((self.callback,)))
        if new and self.haste.on:
            self.haste.note_creation(key, exact=exact, in_main=not self._in_callbacks, early=self._gave_up_early())
        self._created = self.steps
        if not self.coarse:
            self._set_limit()

    def _gave_up_early(self) -> bool:
        """Whether precision is given up for a loop of the main body, for no other reason than that it creates nothing."""
        if not self.haste.in_loops or self._in_callbacks or not self.coarse:
            return False
        return self.loop_limit < min(self._coarse_limit, self._loop_begun + self.budget.loop_steps)

    def note_unknown(self) -> None:
        """Something is done of which it is not known what."""
        self.haste.hides = self.haste.hides or (self.coarse and (self._short or self._gave_up_early()))

    def _note_haste(self) -> None:
        """What a loop of the main body leaves behind, or callbacks find that run within it, may depend on haste."""
        if self._gave_up_early():
            self.haste.note_loop()

    def _set_limit(self) -> None:
        most = self._coarse_limit
        if self.loops:
            begun = self._loop_begun
            most = min(most, begun + self.budget.loop_steps)
            if self.haste.in_loops and not self._in_callbacks and not self._in_model:
                most = min(most, max(begun, self._created) + self.budget.loop_idle)
        self.loop_limit = min(most, self._created + self.budget.entry_idle) if self._short else most

    def rest_of(self, loop: OpKey) -> Rest | None:
        """Where a loop came to rest when it ran last."""
        return self._heads.get(loop)

    def comes_to_rest(self, loop: OpKey, before: Rest | None, rest: Rest) -> None:
        """A loop has come to rest; `before`: what it began with."""
        if before is not None and rest.says_the_same(before):
            rest = before
        self._heads[loop] = rest
        self.note_rests({loop: (before, rest)})

    def note_rests(self, rests: Rests) -> None:
        """Loops ran in a call that is to be remembered."""
        for loop, (before, rest) in rests.items():
            first = self.rests.get(loop)
            self.rests[loop] = (before if first is None else first[0], rest)

    def begins_as(self, rests: Rests) -> bool:
        """Whether all of these loops would begin with what they began with then."""
        return all(self._heads.get(loop) is before for loop, (before, _) in rests.items())

    def rest_again(self, rests: Rests) -> None:
        """The same loops have come to rest again."""
        self._heads.update((loop, rest) for loop, (_, rest) in rests.items())
        self.note_rests(rests)

    # What is done once more

    def effort(self) -> Effort:
        """What was spent so far."""
        return Effort(self.steps, self.turns, self.turns, self.begun, len(self._heavy), self.given_up, self.coarse)

    def was_precise(self, begun: Effort) -> bool:
        """Whether no precision was given up since, or it is still."""
        if begun.coarse:
            return self.coarse
        return not self.coarse and begun.given_up == self.given_up

    def since(self, begun: Effort) -> Effort:
        """What was spent since."""
        turns, loops = self.turns - begun.turns, self.begun - begun.loops
        return Effort(self.steps - begun.steps, begun.turns, turns, loops, begun.heavy, begun.given_up, begun.coarse)

    def allows(self, effort: Effort) -> bool:
        """Whether as much can be spent again, and every loop would be followed as it was."""
        if not self.coarse and self.steps + effort.steps > self.loop_limit:
            return False
        if not effort.loops:
            return True
        if effort.heavy != len(self._heavy):
            return False
        latest = max(effort.first, self.turns) + effort.turns + self.budget.unroll
        return not self.loops or effort.first == self.turns or latest <= self.budget.turns

    def repeat(self, effort: Effort) -> None:
        """As much is spent again: it counts for how precisely all else is followed, but it takes no time."""
        self.steps += effort.steps
        self._repeated += effort.steps
        if self._in_callbacks:
            self.repeated_in_callbacks += effort.steps
        if self.loops:
            self.turns += effort.turns

    # Callbacks

    @contextmanager
    def callbacks(self) -> Iterator[None]:
        """Callbacks run within: they are in no loop of the main body, which keeps the steps that it has left."""
        self._note_haste()
        loops, fixpoints, coarse, short = self.loops, self.fixpoints, self.coarse, self._short
        whole_limit = self._whole_limit
        limits = self.step_limit, self._coarse_limit, self.loop_limit, self._created, self._loop_begun
        self.loops = self.fixpoints = 0
        self._in_callbacks, self._begun = True, self.steps
        try:
            yield
        finally:
            spent = self.steps - self._begun
            self.spent += spent
            self._in_callbacks = False
            self.loops, self.fixpoints, self.coarse, self._short = loops, fixpoints, coarse, short
            self._whole_limit = whole_limit and whole_limit + spent
            self.step_limit, self._coarse_limit, self.loop_limit, self._created, self._loop_begun = (
                limit + spent for limit in limits
            )

    @property
    def spent_in_callbacks(self) -> int:
        """The steps of all callbacks, while they run."""
        return self.spent + self.steps - self._begun

    def begin_callback(self, key: str, *, coarse: bool, short: bool, late: bool = False) -> int:
        """A callback begins, with steps of its own; `coarse`: it took too many before. What `end_callback` asks for.

        `short`: it has few where it creates nothing; `late`: it has few.
        """
        self.callback = key
        self.loops = self.fixpoints = 0
        most = self.budget.entry_hasty if short else self.budget.entry_steps
        most = self._entry_limit = min(most, self.budget.entry_coarse) if late else most
        self.step_limit = self.steps - self._repeated + most
        self.coarse = self._always_coarse = coarse
        self._coarse_limit = self.steps + self.budget.entry_coarse
        self._created, self._short = self.steps, short
        self._set_limit()
        return len(self._heavy)

    def end_callback(self, heavy: int) -> bool:
        """A callback has ended: whether it took too many steps to be followed as precisely again."""
        self._always_coarse = False
        return self.coarse or len(self._heavy) > heavy
