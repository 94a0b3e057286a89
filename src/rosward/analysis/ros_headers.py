# SPDX-License-Identifier: Apache-2.0
"""Can a source in C++ have to do with ROS?

main.cpp  includes  pump.hpp  includes  <rclcpp/rclcpp.hpp>      ->  yes

A node is made by a library of ROS, an entity has a type. The text alone is looked at: no condition is asked.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, final

from rosward.frontends.cpp.model_headers import modelled, of_ros

if TYPE_CHECKING:
    from rosward.frontends.cpp.headers import Headers

_INCLUDE: Final = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^">\n]+)[">]', re.MULTILINE)
_FILES: Final = 5_000


@final
class RosHeaders:
    """Looks through files, each once."""

    def __init__(self, headers: Headers) -> None:
        self._headers = headers
        self._modelled = modelled()
        self._included: dict[str, tuple[tuple[str, bool], ...]] = {}
        self._known: dict[tuple[str, tuple[str, ...]], bool] = {}

    def reached(self, path: str, includes: tuple[str, ...]) -> bool:
        """Whether a source includes a header of ROS, directly or through files of the workspace."""
        key = path, includes
        if key not in self._known:
            self._known[key] = self._reached(path, includes)
        return self._known[key]

    def _reached(self, path: str, includes: Sequence[str]) -> bool:
        seen = {path}
        waiting = [path]
        while waiting and len(seen) < _FILES:
            here = waiting.pop()
            for name, quoted in self._includes(here):
                found = self._headers.included(name, here, includes, quoted)
                if found is None:
                    if of_ros(name, self._modelled):
                        return True
                elif found not in seen:
                    seen.add(found)
                    waiting.append(found)
        return bool(waiting)  # what was not looked at may

    def _includes(self, path: str) -> tuple[tuple[str, bool], ...]:
        found = self._included.get(path)
        if found is None:
            text = self._headers.read(path)
            names = _INCLUDE.findall(text) if isinstance(text, str) else ()
            found = self._included[path] = tuple((name.strip(), mark == '"') for mark, name in names)
        return found
