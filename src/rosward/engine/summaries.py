# SPDX-License-Identifier: Apache-2.0
"""What is remembered of calls: what each gave, and one summary for all calls of a function."""

from __future__ import annotations

from typing import TYPE_CHECKING, final

from rosward.domain.choice import join
from rosward.domain.state import State, join_objects
from rosward.domain.values import UNBOUND, Value

if TYPE_CHECKING:
    from rosward.domain.state import Merge
    from rosward.engine.catcher import Catcher
    from rosward.engine.machine import Engine


@final
class Summary:
    """What is known so far of a function: the join of its calls, of its results and of the states behind.

    Of the state before, what counts is what stands at the addresses that the body asked for; of the one behind, what it changed.
    """

    __slots__ = ("after", "asked_for", "before", "catcher", "provisional", "registers", "turn", "value")

    def __init__(self, registers: list[Value], before: State) -> None:
        self.registers = registers
        self.before = before
        self.value: Value = UNBOUND
        self.after: State | None = None
        self.catcher: Catcher | None = None  # what leaves it by exceptions; in coarse mode only
        self.asked_for: set[int] = set()  # the addresses whose records its body read
        self.provisional = False  # it was made of another summary that was unfinished then
        self.turn = -1  # the turn of the outermost summary in which it was made last

    @property
    def versions(self) -> tuple[object, ...]:
        """What must not change any more."""
        after = self.after.version if self.after is not None else -1
        return (tuple(self.registers), self.before.version, self.value, after)

    def take_in(self, machine: Engine, registers: list[Value], merge: Merge) -> bool:
        """One more call, from the machine's state: whether the body may do something else in it than it is known to do.

        Then `before` is that state, with what the other calls had where the body looks.
        """
        new = [merge(a, b) for a, b in zip(self.registers, registers, strict=True)]
        changed = new != self.registers
        self.registers = new
        state = machine.state.copy()
        known, heap = self.before.heap, state.heap
        for address in self.asked_for:
            ours, theirs = known.get(address), heap.get(address)
            if ours is theirs:
                continue
            ours, theirs = known.stands(address), heap.stands(address)
            if ours is None or theirs is None:
                changed = changed or ours is None
                if theirs is None and ours is not None:
                    heap[address] = ours
                continue
            both = join_objects(ours, theirs, merge)
            changed = changed or both is not ours
            heap[address] = both
        self.before.done &= state.done
        if changed:
            state.done = self.before.done
            state.version = machine.fresh_version()
            self.before = state
        return changed

    def behind(self, machine: Engine, called: State, state: State) -> State:
        """What a state that the body left is for a call from the state `called`: that, with what the body changed."""
        found = called.copy()
        for address, obj in state.heap.changed_since(self.before.heap):
            old = found.heap.get(address)
            if old is None or self.before.heap.get(address) is not None:
                found.heap[address] = obj
            else:  # another one was made there before
                found.heap[address] = join_objects(old, obj, join).replace(many=True)
        found.done |= state.done - self.before.done
        found.version = machine.fresh_version()
        return found


@final
class Summaries:
    """What one process remembers of its calls."""

    __slots__ = ("changes", "epoch", "finished", "large", "memo", "provisional", "recursive", "running", "turns")

    def __init__(self) -> None:
        self.memo: dict[object, tuple[Value, int]] = {}  # results, and what Python may raise
        self.epoch = 0  # which run of a summary's body is going on: what was remembered outside of it tells not what it asked for
        self.running: dict[object, Summary] = {}  # of recursions that are being solved
        self.finished: dict[object, Summary] = {}  # of recursions and large functions; in coarse mode only
        self.provisional = 0  # how often an unfinished summary of a recursion was read
        self.large: dict[str, bool] = {}  # whether a code body, by its key, has loops
        self.recursive: set[str] = set()  # the code bodies, by their keys, that were called inside themselves
        self.turns = 0  # of all summaries that are in no other one
        self.changes = 0  # how often a summary became another one
