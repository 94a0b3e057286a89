# SPDX-License-Identifier: Apache-2.0
"""What leaves a process past ROS, and what comes into it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.effects.flows import Sink, Source

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def out(walker: Walker, kind: str, mask: int) -> None:
    """Something leaves ROS here."""
    walker.send(Sink(kind, walker.node, None, walker.place()), mask)


def comes_in(walker: Walker, kind: str) -> int:
    """Something comes from outside of ROS."""
    return walker.sources.data(Source(kind))
