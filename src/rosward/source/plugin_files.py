# SPDX-License-Identifier: Apache-2.0
"""Which classes does a plugin description of pluginlib name?

<library path="shapes"><class name="demo/Square" type="demo::Square" base_class_type="demo::Shape"/></library>
->  PluginClass("demo/Square", "demo::Square", "demo::Shape", "shapes")
"""

from __future__ import annotations

from typing import final
from xml.parsers import expat

from rosward.records import NamedTuple
from rosward.source import limits
from rosward.source.xml_events import RefusedXmlError, parse

__all__ = ["PluginClass", "read_plugins"]


class PluginClass(NamedTuple):
    """A class that can be loaded: by its name, or by its type, as something of its base, from a library."""

    name: str
    type: str
    base: str
    library: str


def read_plugins(data: bytes, file: str) -> tuple[tuple[PluginClass, ...], tuple[str, int] | None]:
    """The classes of a description; and what is wrong with it, and in which line."""
    reading = _Reading(file)
    wrong = parse(reading.parser, data, file)
    return (tuple(reading.found) if wrong is None else ()), wrong


@final
class _Reading:
    """The elements of a description, one after the other."""

    def __init__(self, file: str) -> None:
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self._start
        self.found: list[PluginClass] = []
        self._library = ""
        self._count = 0
        self._file = file

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if self._count > limits.MANIFEST_ELEMENTS:
            raise RefusedXmlError(f"{self._file} has too many elements.")
        if tag == "library":
            self._library = attributes.get("path", "").rpartition("/")[2].removeprefix("lib").removesuffix(".so")
        elif tag == "class" and attributes.get("type"):
            type_ = attributes["type"].removeprefix("::")
            base = attributes.get("base_class_type", "").removeprefix("::")
            self.found.append(PluginClass(attributes.get("name") or type_, type_, base, self._library))
