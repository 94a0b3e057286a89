# SPDX-License-Identifier: Apache-2.0
"""A YAML document with the place of each of its parts, in bounded time and without anchors.

    'a: [1, x]'  ->  Mapping({'a': Item(Sequence([Item(1), Item('x')]), place)}, place)

A reader asks for what it expects and notes what is wrong; nothing is raised for what a file can hold, but `Malformed`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import limits

if TYPE_CHECKING:
    import yaml  # it takes a while to load, and most sources come without
    from yaml.constructor import SafeConstructor

Scalar = bool | int | float | str
Plain = Scalar | None


class Malformed(ValueError):  # noqa: N818 (a state of the file, which becomes a finding)
    """What is wrong with a file, and where."""

    def __init__(self, message: str, place: Place) -> None:
        super().__init__(message)
        self.message = message
        self.place = place


class Item(NamedTuple):
    """A node of the document: one of a scalar, a list or a mapping; `named` is where its key stands."""

    value: Plain | list[Item] | dict[str, Item]
    place: Place
    named: Place = Place("")

    def text(self) -> str:
        """The str that this is."""
        if isinstance(self.value, str):
            return self.value
        raise Malformed("expected a string here", self.place)

    def flag(self) -> bool:
        """The bool that this is."""
        if isinstance(self.value, bool):
            return self.value
        raise Malformed("expected true or false here", self.place)

    def scalar(self) -> Scalar:
        """A scalar that is not null."""
        if isinstance(self.value, (bool, int, float, str)):
            return self.value
        raise Malformed("expected a number, a string, true or false here", self.place)

    def items(self) -> list[Item]:
        """The list that this is."""
        if isinstance(self.value, list):
            return self.value
        raise Malformed("expected a list here", self.place)

    def mapping(self, allowed: frozenset[str] | None = None) -> dict[str, Item]:
        """The mapping that this is; with `allowed`, no other keys may stand in it."""
        if not isinstance(self.value, dict):
            raise Malformed("expected a mapping here", self.place)
        for key, item in self.value.items():
            if allowed is not None and key not in allowed:
                raise Malformed(f"unknown key '{key}'; expected one of: {', '.join(sorted(allowed))}", item.place)
        return self.value


def read_yaml(text: str, file: str, *, repeated: bool = False) -> Item:
    """The one document of a text; a key may be `repeated`, of which the last one counts. Raises `Malformed`."""
    import yaml

    whole = Place(file)
    if len(text) > limits.PARAMETERS_FILE:
        raise Malformed("the file is too large", whole)
    try:
        node = _node(_events(text, file))
    except Malformed:
        raise
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        raise Malformed(f"not valid YAML: {error.problem}", Place(file, mark.line + 1) if mark else whole) from None
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise Malformed(f"not valid YAML: {str(error).splitlines()[0]}", whole) from None
    if node is None:
        raise Malformed("the file is empty", whole)
    return _item(node, file, yaml.constructor.SafeConstructor(), repeated=repeated)


def _node(events: Sequence[yaml.Event]) -> yaml.Node | None:
    """What `yaml.compose` makes of the text, which is not scanned again."""
    from yaml.composer import Composer
    from yaml.resolver import Resolver

    class Composing(Composer, Resolver):
        """As a loader of yaml, of events that are there already."""

        def __init__(self) -> None:
            Composer.__init__(self)
            Resolver.__init__(self)
            self._left = list(reversed(events))

        def check_event(self, *kinds: type[yaml.Event]) -> bool:
            return bool(self._left) and (not kinds or isinstance(self._left[-1], kinds))

        def peek_event(self) -> yaml.Event | None:
            return self._left[-1] if self._left else None

        def get_event(self) -> yaml.Event | None:
            return self._left.pop() if self._left else None

    found: yaml.Node | None = Composing().get_single_node()
    return found


def _events(text: str, file: str) -> list[yaml.Event]:
    """All events, which come to an end and do not nest without bound."""
    import yaml

    found: list[yaml.Event] = []
    depth = 0
    for event in yaml.parse(text, Loader=yaml.SafeLoader):
        found.append(event)
        if isinstance(event, yaml.AliasEvent):
            raise Malformed("aliases are not supported: write out the anchored value", _place(event, file))
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > limits.YAML_DEPTH:
                raise Malformed("nested too deeply", _place(event, file))
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
    return found


def _place(at: yaml.Event | yaml.Node, file: str) -> Place:
    mark = at.start_mark
    return Place(file) if mark is None else Place(file, mark.line + 1, mark.column + 1)


def _item(node: yaml.Node, file: str, scalars: SafeConstructor, *, repeated: bool) -> Item:
    import yaml

    place = _place(node, file)
    if isinstance(node, yaml.SequenceNode):
        return Item([_item(each, file, scalars, repeated=repeated) for each in node.value], place)
    if isinstance(node, yaml.MappingNode):
        return Item(dict(_pairs(node, file, scalars, repeated=repeated)), place)
    try:
        value = scalars.construct_object(node)
    except (yaml.YAMLError, ValueError, OverflowError):
        value = str(node.value)
    if value is not None and not isinstance(value, (bool, int, float, str)):
        value = str(node.value)  # dates and the like
    return Item(value, place)


def _pairs(
    node: yaml.MappingNode, file: str, scalars: SafeConstructor, *, repeated: bool
) -> Iterator[tuple[str, Item]]:
    from yaml import ScalarNode

    seen: set[str] = set()
    for key, value in node.value:
        place = _place(key, file)
        if not isinstance(key, ScalarNode):
            raise Malformed("a key must be a string", place)
        name = str(key.value)
        if name in seen and not repeated:
            raise Malformed(f"'{name}' occurs twice here", place)
        seen.add(name)
        yield name, _item(value, file, scalars, repeated=repeated)._replace(named=place)
