# SPDX-License-Identifier: Apache-2.0
"""What leaves a process past ROS, and what comes into it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.effects.flows import Sink, Source
from rosward.source.location import Place

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def place_of(walker: Walker) -> Place:
    """The statement of the user's code that is running."""
    for body in reversed(walker.bodies):
        code = body.activation.code
        if not code.file.startswith("models:"):
            return Place(code.file, body.at.line, body.at.column)
    return Place("", 0)


def out(walker: Walker, kind: str, mask: int) -> None:
    """Something leaves ROS here."""
    walker.changed |= walker.sinks.add(Sink(kind, walker.node, None, place_of(walker)), mask, walker.event)


def comes_in(walker: Walker, kind: str) -> int:
    """Something comes from outside of ROS."""
    return walker.sources.data(Source(kind))
