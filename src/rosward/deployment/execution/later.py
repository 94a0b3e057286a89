# SPDX-License-Identifier: Apache-2.0
"""What waits for a timer or an event, and in which order it comes.

timer 5 s: a; timer 1 s: b; OnProcessExit(n): c; n    ->    n, b, a, c (and c only if n was started)

Handlers of a process that has started come first, then timers in the order of their time, then the other event handlers in the order
in which they were registered: whatever these start may
let further ones come.
"""

from __future__ import annotations

from typing import Final, final

from rosward.deployment import tree
from rosward.deployment.execution.nodes import At
from rosward.domain.values import Value
from rosward.location import Place
from rosward.records import NamedTuple

_DOUBTFUL: Final = {
    "process-exit": "the end of a process",
    "execution-complete": "the end of an action",
    "process-io": "output of a process",
    "lifecycle": "a transition of a lifecycle node",
    "other": "an event",
}
"""Events that need not come, and what they are."""


class Later(NamedTuple):
    """Actions that wait. `time` orders timers; `files` is the current launch file, which a timer keeps and an event handler lacks."""

    actions: tuple[tree.LaunchAction, ...]
    at: At
    place: Place
    function: Value | None = None
    target: Value | None = None
    time: float = 0.0
    files: tuple[Value | None, ...] = (None,)


@final
class Agenda:
    """All that waits, and which actions were executed: a handler whose target was not does not come."""

    def __init__(self) -> None:
        self._timers: list[Later] = []
        self._handlers: list[Later] = []
        self._now = 0.0
        self._seen: set[Value] = set()
        self._executed: dict[Value, At] = {}

    def see(self, action: tree.LaunchAction) -> None:
        """An action that exists: handlers that wait for it wait until it is executed."""
        if action.identity is not None:
            self._seen.add(action.identity)

    def see_inside(self, action: tree.LaunchAction) -> None:
        """The actions that an action holds exist, though it is not (or not yet) executed."""
        left = list(_inside(action))
        while left:
            found = left.pop()
            self.see(found)
            left.extend(_inside(found))

    def executed(self, action: tree.LaunchAction, at: At) -> None:
        """An action is executed."""
        if action.identity is not None:
            self._executed[action.identity] = at

    def add_timer(self, timer: tree.Timer, seconds: float, files: tuple[Value | None, ...], at: At) -> None:
        """A timer starts now."""
        at = at._replace(event="timer")
        self._timers.append(Later(timer.actions, at, timer.place, time=self._now + seconds, files=files))
        self.see_inside(timer)

    def add_handler(self, handler: tree.OnEvent, at: At) -> None:
        """An event handler is registered. What is started while launch shuts down never runs."""
        if handler.event == "shutdown":
            return
        at = at._replace(event=handler.event)
        doubt = _DOUBTFUL.get(handler.event)
        at = at.maybe(doubt) if doubt else at
        self._handlers.append(Later(handler.actions, at, handler.place, handler.function, handler.target))
        self.see_inside(handler)

    def add_on_exit(self, actions: tuple[tree.LaunchAction, ...], place: Place, at: At) -> None:
        """What a process that was started lets start when it ends."""
        if actions:
            handler = tree.OnEvent(place=place, event="process-exit", actions=actions)
            self.add_handler(handler, at)

    def next(self) -> Later | None:
        """What comes next, taken off; None where nothing more comes."""
        started = next((h for h in self._handlers if h.at.event == "process-start" and self._comes(h)), None)
        if started is not None:  # this event comes at once
            self._handlers.remove(started)
            return started
        if self._timers:
            timer = min(self._timers, key=lambda each: each.time)
            self._timers.remove(timer)
            self._now = timer.time
            return timer
        found = next((h for h in self._handlers if not self._waits_in_vain(h)), None)
        if found is not None:
            self._handlers.remove(found)
        return found

    def _comes(self, handler: Later) -> bool:
        return handler.target is not None and handler.target in self._executed

    def _waits_in_vain(self, handler: Later) -> bool:
        target = handler.target
        return target is not None and target in self._seen and target not in self._executed

    def circumstances(self, later: Later) -> At:
        """Those under which it comes: its own, and those of the action that it waits for."""
        at = later.at._replace(depth=0)
        target = self._executed.get(later.target) if later.target is not None else None
        for why in target.why if target is not None else ():
            at = at.maybe(why)
        return at


def _inside(action: tree.LaunchAction) -> tuple[tree.LaunchAction, ...]:
    """The actions that an action holds."""
    if isinstance(action, (tree.Group, tree.Maybe, tree.Timer, tree.OnEvent)):
        return action.actions
    if isinstance(action, (tree.Include, tree.ForEach)):
        return action.body
    return action.on_exit if isinstance(action, (tree.StartNode, tree.StartProcess)) else ()
