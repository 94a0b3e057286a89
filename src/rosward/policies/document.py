# SPDX-License-Identifier: Apache-2.0
"""Which elements does an XML file hold, with those that it includes, and in which lines?

    <xi:include href="common/node.xml" xpointer="xpointer(/profile/*)"/>   ->  the children of <profile> of that file

Nothing but elements, attributes and text is read: no document type, so no entities. XInclude takes only files in the folder of the
first file or below it, never another place, and of XPointer only paths of element names, as policies use them. Elements, depth and
size are bounded.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import Final, final
from xml.parsers import expat

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import disk, limits
from rosward.source.text import place_name, read_bytes
from rosward.source.xml_events import RefusedXmlError, parse

__all__ = ["Element", "elements", "read_document"]

_INCLUDES: Final = ("http://www.w3.org/2001/XInclude include", "http://www.w3.org/2003/XInclude include")
_POINTER: Final = re.compile(r"(?:xpointer\()?((?:/(?:\*|[A-Za-z_][\w.-]*))+)\)?")


class Element(NamedTuple):
    """An element, and where it begins. A tag with a name space is `URI tag`."""

    tag: str
    attributes: dict[str, str]
    children: list[Element]
    words: list[str]
    place: Place

    @property
    def text(self) -> str:
        """The text that stands directly in it, white space included."""
        return "".join(self.words)


def read_document(path: str) -> tuple[Element | None, list[Finding]]:
    """The outermost element of a file, its inclusions replaced, and what could not be read (RW403)."""
    reading = _Reading(os.path.dirname(disk.real_path(path)))  # noqa: PTH120
    return reading.document(path, 0), reading.findings


@final
class _Reading:
    """One file and all that it includes."""

    def __init__(self, folder: str) -> None:
        self.findings: list[Finding] = []
        self._folder = folder
        self._elements = 0
        self._includes = 0

    def document(self, path: str, depth: int) -> Element | None:
        file = place_name(os.path.abspath(path), os.getcwd())  # noqa: PTH100, PTH109
        data = read_bytes(path, file, limits.POLICY_INCLUDED_FILE if depth else limits.POLICY_FILE)
        if isinstance(data, Finding):
            self._tell(data.message, data.place)
            return None
        builder = _Builder(file, limits.POLICY_ELEMENTS - self._elements)
        problem = builder.read(data)
        self._elements += builder.count
        if problem is not None or builder.root is None:
            message, line = problem or ("It has no elements.", 1)
            self._tell(message, Place(file, line))
            return None
        self._expand(builder.root, os.path.dirname(path), depth)  # noqa: PTH120
        return builder.root

    def _expand(self, element: Element, folder: str, depth: int) -> None:
        children: list[Element] = []
        for child in element.children:
            if child.tag in _INCLUDES:
                children += self._included(child, folder, depth)
            else:
                self._expand(child, folder, depth)
                children.append(child)
        element.children[:] = children

    def _included(self, element: Element, folder: str, depth: int) -> list[Element]:
        href = element.attributes.get("href", "")
        path = os.path.join(folder, href)  # noqa: PTH118
        pointer = _POINTER.fullmatch(element.attributes.get("xpointer", "/*"))
        self._includes += 1
        if self._includes > limits.POLICY_INCLUDES:
            message = (
                f"There are more than {limits.POLICY_INCLUDES} inclusions; this one and those after it were not read."
            )
            return self._tell(message, element.place) if self._includes == limits.POLICY_INCLUDES + 1 else []
        if depth >= limits.POLICY_INCLUDE_DEPTH:
            return self._tell("Inclusions are nested too deeply; this one was not read.", element.place)
        if not href or "://" in href or "\0" in href or not self._within(path):
            return self._tell(
                f"{href!r} is not a file in or below the folder of the policy. It was not read.", element.place
            )
        if pointer is None or element.attributes.get("parse", "xml") != "xml":
            return self._tell(
                "XInclude is supported only for elements selected by paths such as /profile/*.", element.place
            )
        root = self.document(path, depth + 1)
        return [] if root is None else _pointed(root, pointer[1].split("/")[1:])

    def _within(self, path: str) -> bool:
        return disk.real_path(path).startswith(os.path.join(self._folder, ""))  # noqa: PTH118

    def _tell(self, message: str, place: Place) -> list[Element]:
        self.findings.append(Finding("RW403", message, place))
        return []


def _pointed(root: Element, steps: list[str]) -> list[Element]:
    found = [root] if steps[0] in ("*", root.tag) else []
    for step in steps[1:]:
        found = [child for element in found for child in element.children if step in ("*", child.tag)]
    return found


@final
class _Builder:
    """Makes the elements of one document."""

    def __init__(self, file: str, most: int) -> None:
        self.root: Element | None = None
        self.count = 0
        self._file = file
        self._most = most
        self._open: list[Element] = []
        self._parser = expat.ParserCreate(namespace_separator=" ")

    def read(self, data: bytes) -> tuple[str, int] | None:
        """What is wrong with the document, and in which line."""
        parser = self._parser
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        return parse(parser, data, "The file", " XML")

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self.count += 1
        if self.count > self._most:
            raise RefusedXmlError(f"The policy has more than {limits.POLICY_ELEMENTS:,} elements.")
        if len(self._open) >= limits.POLICY_DEPTH:
            raise RefusedXmlError("The file is nested too deeply.")
        element = Element(tag, attributes, [], [], Place(self._file, self._parser.CurrentLineNumber))
        if self._open:
            self._open[-1].children.append(element)
        else:
            self.root = element
        self._open.append(element)

    def _end(self, _: str) -> None:
        self._open.pop()

    def _characters(self, text: str) -> None:
        if self._open:
            self._open[-1].words.append(text)


def elements(parent: Element, tag: str) -> Iterator[Element]:
    """The children of one tag."""
    return (child for child in parent.children if child.tag == tag)
