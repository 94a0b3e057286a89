# SPDX-License-Identifier: Apache-2.0
"""XML that stands in the program, or in a file of the sources: `xml.etree.ElementTree`.

ElementTree.fromstring('<a t="/x"><b/></a>')      ('a', {'t': '/x'}, None, None, (('b', {}, None, None, ()),))

The stub makes elements of it. Documents with a document type are not read.
"""

from __future__ import annotations

from typing import Any, Final
from xml.parsers.expat import ParserCreate

from rosward.domain.choice import lift
from rosward.domain.compound import Tuple
from rosward.domain.text import origins_of
from rosward.domain.unknown import Origins
from rosward.domain.values import NONE, Const, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import text_of
from rosward.models.python.std.data import MAX_TEXT
from rosward.models.python.std.support import MAX_DEPTH, NotKnown, place_dict
from rosward.source.xml_events import parse

_MOST: Final = 10_000
"""How many elements are read."""


class _Element:
    """An element while it is read."""

    def __init__(self, tag: str, attributes: dict[str, str]) -> None:
        self.tag = tag
        self.attributes = attributes
        self.text: list[str] = []
        self.tail: list[str] = []
        self.inside: list[_Element] = []


def _name(name: str) -> str:
    """A name with its name space, as ElementTree writes it."""
    return f"{{{name}" if "}" in name else name


def _read(text: str) -> _Element:
    """The outermost element; raises `NotKnown`, or ValueError where the text is not XML."""
    parser = ParserCreate(namespace_separator="}")
    parser.buffer_text = True
    top = _Element("", {})
    opened = [top]
    count = 0

    def start(name: str, attributes: dict[str, str]) -> None:
        nonlocal count
        count += 1
        if count > _MOST or len(opened) > MAX_DEPTH:
            raise NotKnown
        made = _Element(_name(name), {_name(n): v for n, v in attributes.items()})
        opened[-1].inside.append(made)
        opened.append(made)

    def characters(data: str) -> None:
        last = opened[-1]
        (last.inside[-1].tail if last.inside else last.text).append(data)

    def end(_: str) -> None:
        opened.pop()

    parser.StartElementHandler = start
    parser.CharacterDataHandler = characters
    parser.EndElementHandler = end
    wrong = parse(parser, text.encode("utf-8", "surrogateescape"), "the text")
    if wrong is not None:
        if "document type" in wrong[0]:
            raise NotKnown
        raise ValueError(wrong[0])
    return top.inside[0]


def _tree(call: NativeCall) -> Value:
    """xml.etree.ElementTree._tree(text): (tag, attributes, text, tail, elements inside); None where the text is not known."""

    def one(option: Value) -> Value:
        plain: Any = text_of(option)
        if isinstance(option, Const) and isinstance(option.value, bytes):
            plain = option.value.decode("utf-8", "replace")
        if plain is None or len(plain) > MAX_TEXT:
            return NONE
        try:
            return _built(call, _read(plain), origins_of(option), ())
        except NotKnown:
            return NONE
        except ValueError as error:
            return call.machine.die("xml.etree.ElementTree.ParseError", str(error))

    return lift(one, call.args[0])


def _built(call: NativeCall, element: _Element, origins: Origins, path: tuple[object, ...]) -> Tuple:
    def text(parts: list[str]) -> Value:
        return Const("".join(parts), origins) if parts else NONE

    attributes: dict[Value, Value] = {Const(name): Const(value, origins) for name, value in element.attributes.items()}
    inside = tuple(_built(call, each, origins, (*path, number)) for number, each in enumerate(element.inside))
    return Tuple(
        (
            Const(element.tag, origins),
            place_dict(call.machine, attributes, ("element", path)),
            text(element.text),
            text(element.tail),
            Tuple(inside),
        )
    )


NATIVES: Final[dict[str, NativeFunction]] = {"xml.etree.ElementTree._tree": _tree}
