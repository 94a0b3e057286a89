# SPDX-License-Identifier: Apache-2.0
"""Which code of a process was run, what of it did others get into their hands, and what may be called without being seen?"""

from __future__ import annotations

from typing import final

from rosward.domain.values import Value
from rosward.ir.program import OpKey
from rosward.location import Place


@final
class Trace:
    """What the interpretation of one process came by."""

    __slots__ = ("asked", "creating", "entered", "handed", "instantiated", "reached")

    def __init__(self) -> None:
        self.creating: set[str] = set()  # the key of each code body within which something of ROS was created
        self.entered: set[str] = set()  # the key of each code body that was run
        self.reached: set[OpKey] = set()  # each operation that was run and reads a method that creates an entity
        self.instantiated: set[Place] = set()  # where the classes stand of which there are objects
        self.handed: dict[Value, Place] = {}  # classes and objects that reached unknown code, and where
        self.asked: set[tuple[str, str, str]] = set()  # what may be called unseen: see `analysis/unreached.py`
