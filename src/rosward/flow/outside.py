# SPDX-License-Identifier: Apache-2.0
"""What leaves a process past ROS, and what comes into it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.domain.values import Const
from rosward.effects.flows import RELEASED, Sink, Source

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def out(walker: Walker, kind: str, mask: int) -> None:
    """Something leaves ROS here."""
    walker.send(Sink(kind, walker.node, None, walker.place()), mask)


def cleaned(walker: Walker, name: str, mask: int) -> None:
    """A function of a library, of which a mark says that it releases what it gets, is called here: what it gets, and what decides that."""
    walker.send(Sink(RELEASED, walker.node, Const(name), walker.place()), mask)


def comes_in(walker: Walker, kind: str) -> int:
    """Something comes from outside of ROS."""
    return walker.sources.data(Source(kind))
