# SPDX-License-Identifier: Apache-2.0
"""What does a YAML launch file say?

    launch:
    - node: {pkg: demo, exec: talker}      ->  Description((StartNode(package=(Const('demo'),), …),), file)

The file is one mapping with the key `launch`; an action is a mapping with its tag as the only key. Aliases are followed as often as they
stand there, up to a limit on the whole.
"""

from __future__ import annotations

from typing import Final, final

import yaml

from rosward.deployment.markup.element import Attribute, Format, Refusals, Tag
from rosward.deployment.markup.tags import read_description
from rosward.deployment.markup.values import UnreadableMarkupError, Values, compose
from rosward.deployment.tree import Description
from rosward.findings import Finding
from rosward.location import Place
from rosward.source import limits

_MERGE: Final = "tag:yaml.org,2002:merge"


def read_yaml(text: str, file: str) -> tuple[Description, tuple[Finding, ...]]:
    """The launch file `file`; what launch would refuse in it is a finding."""
    refusals = Refusals()
    try:
        if len(text) > limits.LAUNCH_YAML_TEXT:
            raise UnreadableMarkupError(f"It is longer than {limits.LAUNCH_YAML_TEXT:,} characters.")
        root = _Document(file, refusals).root(compose(text))
    except UnreadableMarkupError as error:
        message = f"The YAML launch file cannot be read. {error}"
        return Description((), file), (Finding("RW310", message, Place(file, error.line, error.column)),)
    return Description(read_description(root), file), refusals.findings


@final
class _Document:
    """The elements of one document, each with the place of its key."""

    def __init__(self, file: str, refusals: Refusals) -> None:
        self._file = file
        self._refusals = refusals
        self._values = Values()
        self._count = 0

    def root(self, node: yaml.Node | None) -> Tag:
        """The element `launch`; raises UnreadableError."""
        if not isinstance(node, yaml.MappingNode):
            raise UnreadableMarkupError("Its root is not a mapping with the key 'launch'.")
        entries = self._entries(node, 0)
        if [name for name, *_ in entries] != ["launch"]:
            raise UnreadableMarkupError("Its root is not a mapping with 'launch' as its only key.")
        _, key, value = entries[0]
        if isinstance(value, yaml.ScalarNode):
            raise UnreadableMarkupError("'launch' is not a list of actions.", value.start_mark.line + 1)
        return self._element("launch", key, value, 0)

    def _place(self, node: yaml.Node) -> Place:
        return Place(self._file, node.start_mark.line + 1, node.start_mark.column + 1)

    def _unreadable(self, why: str, node: yaml.Node) -> UnreadableMarkupError:
        return UnreadableMarkupError(why, node.start_mark.line + 1, node.start_mark.column + 1)

    def _visit(self, node: yaml.Node, depth: int) -> None:
        """Count what is read: aliases make more of it than there are nodes."""
        self._count += 1
        if self._count > limits.LAUNCH_ELEMENTS:
            raise self._unreadable("With its aliases it is too large.", node)
        if depth > limits.LAUNCH_DEPTH:
            raise self._unreadable("It is nested too deeply.", node)

    def _element(self, tag: str, key: yaml.Node, node: yaml.Node, depth: int) -> Tag:
        self._visit(node, depth)
        attributes: dict[str, Attribute] = {}
        groups: dict[str, tuple[Tag, ...]] = {}
        body: tuple[Tag, ...] | None = None
        self._values.check(node)
        if isinstance(node, yaml.SequenceNode):
            body = self._actions(node, depth)
        elif isinstance(node, yaml.MappingNode):
            for name, _, value in self._entries(node, depth):
                self._visit(value, depth)
                if not isinstance(value, yaml.SequenceNode):
                    attributes[name] = self._attribute(value)
                elif name == "children":
                    body = self._actions(value, depth + 1)
                elif value.value and isinstance(value.value[0], yaml.MappingNode):
                    groups[name] = tuple(self._element(name, each, each, depth + 1) for each in value.value)
                else:
                    self._count += len(value.value)
                    attributes[name] = self._attribute(value)
        else:
            self._values.native(node)
            self._refusals.add(
                f"<{tag}> is not a mapping, which launch expects ({{}} if it has no attributes).", self._place(key)
            )
        return Tag(
            tag,
            self._place(key),
            Format.YAML,
            self._refusals,
            attributes=attributes,
            groups=groups,
            body=body,
        )

    def _attribute(self, node: yaml.Node) -> Attribute:
        value = self._values.native(node)
        return Attribute(node.value if isinstance(node, yaml.ScalarNode) else "", value, self._place(node))

    def _actions(self, node: yaml.SequenceNode, depth: int) -> tuple[Tag, ...]:
        self._visit(node, depth)
        self._values.check(node)
        found: list[Tag] = []
        for item in node.value:
            self._visit(item, depth)
            entries = self._entries(item, depth) if isinstance(item, yaml.MappingNode) else []
            if len(entries) != 1:
                self._refusals.add("An action must be a mapping with its tag as the only key.", self._place(item))
                entries = [each for each in entries if not isinstance(each[2], yaml.ScalarNode)]
            found += [self._element(tag, key, value, depth + 1) for tag, key, value in entries]
        return tuple(found)

    def _entries(self, node: yaml.MappingNode, depth: int) -> list[tuple[str, yaml.Node, yaml.Node]]:
        """The keys and values of a mapping, with what is merged into it; of equal keys the last counts."""
        self._values.check(node)
        own: dict[str, tuple[str, yaml.Node, yaml.Node]] = {}
        merged: dict[str, tuple[str, yaml.Node, yaml.Node]] = {}
        for key, value in node.value:
            self._visit(key, depth)
            if key.tag == _MERGE:
                for name, entry in self._merged(value, depth + 1).items():
                    merged.setdefault(name, entry)
                continue
            if not isinstance(key, yaml.ScalarNode):
                raise self._unreadable("A key is not a scalar.", key)
            self._values.native(key)
            if key.value in own:
                message = f"The key {key.value!r} occurs twice in one mapping: launch uses the last one and ignores the first."
                self._refusals.add(message, self._place(key))
            own[key.value] = (key.value, key, value)
        return list({**merged, **own}.values())

    def _merged(self, node: yaml.Node, depth: int) -> dict[str, tuple[str, yaml.Node, yaml.Node]]:
        """What `<<` brings: a mapping, or a list of them of which the first wins."""
        self._visit(node, depth)
        sources = node.value if isinstance(node, yaml.SequenceNode) else [node]
        found: dict[str, tuple[str, yaml.Node, yaml.Node]] = {}
        for each in sources:
            if not isinstance(each, yaml.MappingNode):
                raise self._unreadable("The value of << is not a mapping.", each)
            self._visit(each, depth)
            for name, key, value in self._entries(each, depth):
                found.setdefault(name, (name, key, value))
        return found
