# SPDX-License-Identifier: Apache-2.0
"""What is an element of a launch file, whichever format it is written in, and which part of it did nobody read?

    <node pkg="demo" exec="talker" nmae="t"/>      - node: {pkg: demo, exec: talker, nmae: t}
    ->  Element('node', attributes pkg, exec, nmae); after its reader took pkg and exec: "Unexpected attribute 'nmae'"

launch reads an element by asking for attributes by name, and raises an exception if something is left over. XML has only text, which is
converted to the type that is asked for; YAML has types, which are checked. What launch refuses is a finding here, and reading goes on.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping
from typing import Final, final

from rosward.deployment.markup.substitutions import (
    UNKNOWN,
    SubstitutionError,
    parse_substitution,
    unescaped,
    unknown_text,
)
from rosward.deployment.markup.values import Native, text_value
from rosward.deployment.tree import Condition, Substitution, Template
from rosward.domain.values import Const
from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple

_REFUSAL_LIMIT: Final = 500


class Format(enum.Enum):
    """How a launch file is written."""

    XML = "xml"
    YAML = "yaml"


class Attribute(NamedTuple):
    """A value with a name: `text` as it is written (in YAML, that of a scalar), `value` what YAML makes of it there."""

    text: str
    value: Native
    place: Place


@final
class Refusals:
    """What launch would refuse in one file."""

    def __init__(self) -> None:
        self._found: list[Finding] = []

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All of it, in the order of the file."""
        return tuple(sorted(self._found, key=lambda each: (each.place.line, each.place.column)))

    def add(self, message: str, place: Place) -> None:
        """An exception of launch, at `place`."""
        if len(self._found) < _REFUSAL_LIMIT:
            self._found.append(Finding("RW320", message, place))
        elif len(self._found) == _REFUSAL_LIMIT:
            message = f"launch rejects more than {_REFUSAL_LIMIT} items in this file; the rest is not listed."
            self._found.append(Finding("RW320", message, place))

    def template(self, text: str, place: Place) -> Template:
        """The substitutions in `text`; unknown text where launch refuses it."""
        try:
            template = parse_substitution(text, place)
        except SubstitutionError as error:
            self.add(str(error), place)
            return unknown_text(text, place)
        for name in _unknown_names(template):
            self.add(f"launch has no substitution $({name} …).", place)
        return template


@final
class Tag:
    """A tag with what belongs to it. Everything that is asked for counts as read; `finish` tells of the rest.

    `groups` are the nested elements by tag: in XML the children, in YAML the lists of mappings below a key.
    `body` are the actions inside: in XML the same children, in YAML the element itself (a list) or its key `children`; None if there are none.
    """

    __slots__ = ("_attributes", "_body", "_groups", "_read", "_refusals", "_seen", "format", "place", "tag")

    def __init__(
        self,
        tag: str,
        place: Place,
        written: Format,
        refusals: Refusals,
        *,
        attributes: Mapping[str, Attribute],
        groups: Mapping[str, tuple[Tag, ...]],
        body: tuple[Tag, ...] | None,
    ) -> None:
        self.tag = tag
        self.place = place
        self.format = written
        self._refusals = refusals
        self._attributes = attributes
        self._groups = groups
        self._body = body
        self._read: set[str] = set()  # names of attributes
        self._seen: set[str] = set()  # tags of nested elements

    def refuse(self, message: str, place: Place | None = None) -> None:
        """Launch raises an exception here, when it loads the file."""
        self._refusals.add(message, place or self.place)

    def attribute(self, name: str) -> Attribute | None:
        """The attribute as it is, whatever its type."""
        self._read.add(name)
        found = self._attributes.get(name)
        if found is None and name in self._groups and self.format is Format.YAML:
            self._seen.add(name)
            self.refuse(f"{name!r} of <{self.tag}> is a list of mappings, but launch expects a value.")
        return found

    def text(self, name: str) -> str | None:
        """An attribute that is text, without a look at its substitutions."""
        found = self.attribute(name)
        if found is None:
            return None
        if self.format is Format.YAML and not isinstance(found.value, str):
            self.refuse(
                f"{name!r} of <{self.tag}> is {_kind_of(found.value)}, but launch requires a string: quote it.",
                found.place,
            )
        return found.text

    def template(self, name: str) -> Template | None:
        """An attribute that is text with substitutions."""
        text = self.text(name)
        if text is None:
            return None
        attribute = self._attributes[name]
        if not text and attribute.value != "":  # a list, or nothing at all: refused above
            return unknown_text(name, attribute.place)
        return self._refusals.template(text, attribute.place)

    def required(self, name: str) -> Template:
        """An attribute without which launch refuses the element: then unknown text."""
        template = self.template(name)
        if template is None:
            self.refuse(f"<{self.tag}> has no attribute {name!r}, which launch requires.")
            return unknown_text(name, self.place)
        return template

    def name(self, name: str) -> str:
        """A required text in which escapes are the only special signs."""
        text = self.text(name)
        if text is None:
            self.refuse(f"<{self.tag}> has no attribute {name!r}, which launch requires.")
        return unescaped(text or "")

    def parsed(self, text: str) -> Template:
        """Text of this element that may hold substitutions."""
        return self._refusals.template(text, self.place)

    def flag(self, name: str) -> bool | str | None:
        """An attribute that is true or false; text (with a substitution, most likely) is left as it is."""
        found = self.attribute(name)
        if found is None:
            return None
        value = found.value
        if self.format is Format.XML:
            value = text_value({"0": "false", "1": "true"}.get(found.text, found.text))
        if isinstance(value, bool):
            return value
        if not isinstance(value, str):
            self.refuse(
                f"{name!r} of <{self.tag}> is {_kind_of(value)}, but launch requires true or false.", found.place
            )
        return found.text

    def switch(self, name: str) -> bool | Template | None:
        """An attribute that is true or false, or text with substitutions that becomes so."""
        found = self.flag(name)
        return self.parsed(found) if isinstance(found, str) else found

    def number(self, name: str, kind: type[int] | type[float] = float) -> Template | None:
        """An attribute that is a number, or text with substitutions that becomes one."""
        found = self.attribute(name)
        if found is None:
            return None
        if self.format is Format.YAML and not isinstance(found.value, (str, kind)):
            self.refuse(
                f"{name!r} of <{self.tag}> is {_kind_of(found.value)}, but launch requires {kind.__name__}.",
                found.place,
            )
        return self._refusals.template(found.text, found.place)

    def seconds(self, name: str) -> None:
        """An attribute that launch compares with zero before any substitution is performed."""
        found = self.attribute(name)
        if found is None:
            return
        typed = self.format is Format.XML or isinstance(found.value, float)
        if not (typed and _is_duration(found.text)):
            self.refuse(
                f"{name!r} of <{self.tag}> must be a non-negative float; substitutions are not allowed.", found.place
            )

    def elements(self, name: str) -> tuple[Tag, ...]:
        """The nested elements of that tag."""
        self._seen.add(name)
        if self.format is Format.YAML and name in self._attributes:
            self._read.add(name)
            self.refuse(f"{name!r} of <{self.tag}> is not a list of mappings, which launch expects.")
        return self._groups.get(name, ())

    def children(self) -> tuple[Tag, ...]:
        """All that is nested, in order: actions."""
        if self.format is Format.XML:
            self._seen.update(self._groups)
        else:
            self._read.add("children")
            self._seen.add("children")
            if self._body is None:
                self.refuse(
                    f"<{self.tag}> has no nested entities: launch expects a list, or a list below the key 'children'."
                )
        return self._body or ()

    def pairs(self, tag: str, first: str, second: str) -> tuple[tuple[Template, Template], ...]:
        """Two texts from each nested element of that tag, as in <remap from="" to=""/>."""
        found: list[tuple[Template, Template]] = []
        for each in self.elements(tag):
            found.append((each.required(first), each.required(second)))
            each.finish()
        return tuple(found)

    def condition(self) -> Condition | None:
        """What `if` and `unless` say."""
        ways = {name: self.template(name) for name in ("if", "unless")}
        given = {name: template for name, template in ways.items() if template is not None}
        if len(given) > 1:
            self.refuse(f"<{self.tag}> has both 'if' and 'unless', which launch does not accept together.")
            return Condition("if", (unknown_text("if and unless", self.place),), self.place)
        return next((Condition(name, (template,), self.place) for name, template in given.items()), None)

    def ignore(self, *names: str) -> None:
        """Attributes that decide nothing here; their substitutions are still parsed, as launch does."""
        for name in names:
            self.template(name)

    def finish(self) -> None:
        """Tell of what nobody asked for."""
        for name, attribute in self._attributes.items():
            if name not in self._read:
                self.refuse(f"Unexpected attribute {name!r} of <{self.tag}>.", attribute.place)
        for tag, group in self._groups.items():
            if tag not in self._seen:
                self.refuse(f"Unexpected nested tag <{tag}> in <{self.tag}>.", group[0].place)
        if self.format is Format.YAML and self._body is not None and "children" not in self._seen:
            self.refuse(f"Unexpected nested entities in <{self.tag}>.")


def _is_duration(text: str) -> bool:
    try:
        return len(text) < 100 and not float(text) < 0
    except ValueError:
        return False


def _kind_of(value: Native) -> str:
    if value is None:
        return "empty or a structure"
    return "a list" if isinstance(value, tuple) else f"of type {type(value).__name__}"


def _unknown_names(template: Template) -> list[str]:
    names: list[str] = []
    for piece in template:
        if isinstance(piece, Substitution):
            if piece.kind == UNKNOWN:
                names += [str(part.value) for each in piece.arguments for part in each if isinstance(part, Const)]
            else:
                names += [name for each in piece.arguments for name in _unknown_names(each)]
    return names
