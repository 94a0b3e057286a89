# SPDX-License-Identifier: Apache-2.0
"""Information flow in the words of ROS: what each output of a node is made of.

topic:/cmd_vel <- data topic:/plan, parameter:max_speed; control topic:/e_stop; trigger timer
"""

from __future__ import annotations

from typing import Final

from rosward.location import Place
from rosward.records import NamedTuple, dataclass

EXECUTING: Final = ("code", "pickle", "method")
"""Kinds of what is no output, but decides what is executed."""
STRENGTHS: Final = ("data", "control", "trigger")
"""From strong to weak: the content is in it; the content decides what or whether; only that it arrived counts."""


class End(NamedTuple):
    """Where information comes from or goes to: a kind (`topic`, `file`, …), and a name where the kind has names, `*` for each unknown part."""

    kind: str
    name: str = ""

    def __str__(self) -> str:
        return f"{self.kind}:{self.name}" if self.name else self.kind


def _of(sent: NodeSink | NodeCall, strength: str) -> tuple[End, ...]:
    return {"data": sent.data, "control": sent.control, "trigger": sent.trigger}[strength]


class NodeCall(NamedTuple):
    """An output as some callers use it, who are named from the outermost on: its sources then."""

    through: tuple[Place, ...]
    data: tuple[End, ...] = ()
    control: tuple[End, ...] = ()
    trigger: tuple[End, ...] = ()

    def of(self, strength: str) -> tuple[End, ...]:
        """The sources of one strength."""
        return _of(self, strength)


@dataclass(frozen=True, slots=True)
class NodeSink:
    """One output of a node, at one statement, with the sources of each strength, each in the strongest that holds only.

    `assumed`: those of them that stand here only because something is not analysed. `paths`: through which lines each comes here.
    `calls`: the same by callers, where these are told apart; else empty.
    """

    sink: End
    at: Place
    data: tuple[End, ...] = ()
    control: tuple[End, ...] = ()
    trigger: tuple[End, ...] = ()
    assumed: tuple[End, ...] = ()
    paths: tuple[tuple[End, tuple[Place, ...]], ...] = ()
    calls: tuple[NodeCall, ...] = ()

    def of(self, strength: str) -> tuple[End, ...]:
        """The sources of one strength."""
        return _of(self, strength)


@dataclass(frozen=True, slots=True)
class NodeCallback:
    """A callback of a node: what wakes it (a source, or `timer`, `thread`), its function, where that begins.

    `sends`: the outputs that it sends, and what each depends on, in any strength, when this callback sends it.

    `period`: of a timer of the client library, in nanoseconds; 0 where it is not known.
    """

    events: tuple[End, ...]
    function: str
    at: Place
    sends: tuple[tuple[End, tuple[End, ...]], ...] = ()
    period: int | None = None


@dataclass(frozen=True, slots=True)
class NodeFlows:
    """All outputs of a node; `complete`: no limit was reached, so that nothing had to be assumed.

    `executed`: where values decide what the node itself executes: kind `code`, `pickle` or `method`.
    `released`: what the functions give that release something, each a source of outputs by its name.
    """

    sinks: tuple[NodeSink, ...] = ()
    complete: bool = True
    executed: tuple[NodeSink, ...] = ()
    released: tuple[NodeSink, ...] = ()
    callbacks: tuple[NodeCallback, ...] = ()
