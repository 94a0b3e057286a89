# SPDX-License-Identifier: Apache-2.0
"""What does an XML launch file say?

    <launch><node pkg="demo" exec="talker"/></launch>  ->  Description((StartNode(package=(Const('demo'),), …),), file)

Text between tags means nothing to launch. A document type could only bring entities, which are not read: the file is refused.
"""

from __future__ import annotations

from typing import final
from xml.parsers import expat

from rosward.deployment.markup.element import Attribute, Format, Refusals, Tag
from rosward.deployment.markup.tags import read_description
from rosward.deployment.markup.values import UnreadableMarkupError
from rosward.deployment.tree import Description
from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import limits


def read_xml(text: str, file: str) -> tuple[Description, tuple[Finding, ...]]:
    """The launch file `file`; what launch would refuse in it is a finding."""
    refusals = Refusals()
    try:
        if len(text) > limits.LAUNCH_XML_TEXT:
            raise UnreadableMarkupError(f"The launch file is longer than {limits.LAUNCH_XML_TEXT:,} characters.")
        root = _Document(file, refusals).read(text)
        if root.tag != "launch":
            raise UnreadableMarkupError(f"The root is <{root.tag}>, not <launch>.", root.place.line, root.place.column)
    except UnreadableMarkupError as error:
        return Description((), file), (Finding("RW310", str(error), Place(file, error.line, error.column)),)
    return Description(read_description(root), file), refusals.findings


class _Open(NamedTuple):
    """A tag that is not closed yet."""

    tag: str
    place: Place
    attributes: dict[str, str]
    children: list[Tag]


@final
class _Document:
    """The elements of one document, each with the place of its start tag."""

    def __init__(self, file: str, refusals: Refusals) -> None:
        self._file = file
        self._refusals = refusals
        self._parser = expat.ParserCreate()
        self._stack: list[_Open] = []
        self._root: Tag | None = None
        self._count = 0

    def read(self, text: str) -> Tag:
        """The root; raises UnreadableError."""
        parser = self._parser
        parser.StartDoctypeDeclHandler = self._doctype
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        try:
            parser.Parse(text, True)
        except expat.ExpatError as error:
            why = expat.errors.messages.get(error.code, "syntax error")
            raise UnreadableMarkupError(f"The XML is not well-formed: {why}.", error.lineno, error.offset + 1) from None
        except ValueError:  # a lone surrogate, from bytes that are no text
            raise UnreadableMarkupError("The launch file is not UTF-8 text.") from None
        assert self._root is not None
        return self._root

    def _unreadable(self, why: str) -> UnreadableMarkupError:
        return UnreadableMarkupError(why, self._parser.CurrentLineNumber, self._parser.CurrentColumnNumber + 1)

    def _doctype(self, _: str, system: str | None, public: str | None, subset: bool) -> None:
        if system or public or subset:
            raise self._unreadable("The launch file has a document type declaration; entities are not supported.")

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if len(self._stack) >= limits.LAUNCH_DEPTH:
            raise self._unreadable("The tags are nested too deeply.")
        if self._count > limits.LAUNCH_ELEMENTS:
            raise self._unreadable(f"The launch file has more than {limits.LAUNCH_ELEMENTS:,} tags.")
        place = Place(self._file, self._parser.CurrentLineNumber, self._parser.CurrentColumnNumber + 1)
        self._stack.append(_Open(tag, place, attributes, []))

    def _end(self, _: str) -> None:
        opened = self._stack.pop()
        groups: dict[str, list[Tag]] = {}
        for child in opened.children:
            groups.setdefault(child.tag, []).append(child)
        element = Tag(
            opened.tag,
            opened.place,
            Format.XML,
            self._refusals,
            attributes={name: Attribute(text, text, opened.place) for name, text in opened.attributes.items()},
            groups={tag: tuple(group) for tag, group in groups.items()},
            body=tuple(opened.children),
        )
        if self._stack:
            self._stack[-1].children.append(element)
        else:
            self._root = element
