# SPDX-License-Identifier: Apache-2.0
"""Which classes does no process make, so that somebody else may?

class Talker(Node)                                             nothing instantiates it: it is made with unknown arguments, and assumed
class Panel(rqt_gui_py.plugin.Plugin)                          rqt loads it, as its model says: assumed, too
class ArmEnv(gymnasium.Env)                                    a framework that is not read makes what derives from its classes
class Driver: def init(self, robot, properties), def step      Webots makes what has these methods
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rosward.analysis.seen import ClassSeen, Seen
from rosward.location import Place

__all__ = ["called_from_outside", "node_classes"]


def node_classes(seen: Iterable[Seen]) -> dict[str, list[str]]:
    """The classes of nodes and of plugins that no process instantiates and no other class inherits from, by file: their names."""
    return _by_file(c for c in _unmade(seen) if c.is_node or c.is_plugin)


def called_from_outside(seen: Iterable[Seen]) -> dict[str, list[str]]:
    """The classes that no process instantiates, but a framework may, by file: their names."""
    every = list(seen)
    return _by_file(
        c for c in _unmade(every) if not (c.is_node or c.is_plugin) and (c.from_library or _is_webots_plugin(every, c))
    )


_WEBOTS: Final = {"init": 3, "step": 1}
"""The methods of a Webots plugin, and how many parameters each has, `self` among them."""


def _is_webots_plugin(seen: Iterable[Seen], cls: ClassSeen) -> bool:
    """Whether a class has the methods that webots_ros2_driver calls."""
    found = {
        method.name: method.parameters
        for each in seen
        for method in each.methods
        if method.file == cls.place.file and method.owner == cls.qualname
    }
    return all(found.get(name) == number for name, number in _WEBOTS.items())


def _by_file(classes: Iterable[ClassSeen]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for cls in classes:
        found.setdefault(cls.place.file, []).append(cls.name)
    return found


def _unmade(seen: Iterable[Seen]) -> Iterator[ClassSeen]:
    """The classes of modules that no process instantiates and no other class inherits from, by their places."""
    made: set[Place] = set()
    inherited: set[Place] = set()
    defined: dict[Place, ClassSeen] = {}
    for each in seen:
        made |= each.instantiated
        for cls in each.classes:
            defined[cls.place] = cls
            inherited.update(cls.bases)
    for place, cls in sorted(defined.items(), key=lambda item: item[0]):
        if place not in made and place not in inherited and "." not in cls.qualname:
            yield cls
