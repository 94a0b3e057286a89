# SPDX-License-Identifier: Apache-2.0
"""Which value is a piece of YAML, as PyYAML's safe_load makes it?

    0.5 -> 0.5      yes -> True      [1, 2] -> (1, 2)      a: b -> None      !!python/object:… -> UnreadableError

launch reads YAML launch files and the values of XML parameters so. Depth, aliases and numbers are bounded before anything is built.
"""

from __future__ import annotations

from typing import Final, final

import yaml
from yaml.constructor import SafeConstructor

Scalar = str | bool | int | float
Native = Scalar | tuple[Scalar, ...] | None
"""A value as YAML types it; None for what no attribute can be (nothing, a date, a list of lists, a mapping)."""

_EVENT_LIMIT: Final = 60_000
_DEPTH_LIMIT: Final = 150
_NUMBER_LIMIT: Final = 4_000
"""Characters of a number: converting long ones takes quadratic time."""
_PREFIX: Final = "tag:yaml.org,2002:"
_NUMBERS: Final = frozenset({_PREFIX + "int", _PREFIX + "float"})
_STRUCTURES: Final = frozenset(_PREFIX + each for each in ("seq", "map", "set", "omap", "pairs"))


class UnreadableMarkupError(Exception):
    """The file is no launch file at all, or a value no YAML; the message says why."""

    def __init__(self, message: str, line: int = 1, column: int = 1) -> None:
        super().__init__(message)
        self.line = line
        self.column = column


def compose(text: str) -> yaml.Node | None:
    """The one document in `text`; None if it is empty. Raises UnreadableError."""
    try:
        depth = 0
        for count, event in enumerate(yaml.parse(text, Loader=yaml.SafeLoader)):
            depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
            if depth > _DEPTH_LIMIT or count > _EVENT_LIMIT:
                raise _error("It is too long" if count > _EVENT_LIMIT else "It is nested too deeply", event.start_mark)
        return yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
        why = getattr(error, "problem", None) or str(error).partition("\n")[0]
        raise _error(f"It is not YAML: {why}", mark) from None
    except (ValueError, RecursionError):
        raise UnreadableMarkupError("It is not YAML.") from None


def _error(why: str, mark: object) -> UnreadableMarkupError:
    line, column = getattr(mark, "line", 0), getattr(mark, "column", 0)
    return UnreadableMarkupError(f"{why}.", line + 1, column + 1)


def text_value(text: str) -> Native:
    """What the text of an XML attribute is worth as YAML: the text itself if it is none."""
    try:
        node = compose(text) if text else None
        return text if not text else None if node is None else Values().native(node)
    except UnreadableMarkupError:
        return text


@final
class Values:
    """The values of the nodes of one document."""

    def __init__(self) -> None:
        self._constructor = SafeConstructor()

    def native(self, node: yaml.Node) -> Native:
        """The value of a scalar or a list of scalars, None for all else."""
        if isinstance(node, yaml.SequenceNode):
            self.check(node)
            items = [self._scalar(each) if isinstance(each, yaml.ScalarNode) else None for each in node.value]
            known = tuple(item for item in items if item is not None)
            return known if len(known) == len(items) and node.tag == _PREFIX + "seq" else None
        if isinstance(node, yaml.ScalarNode):
            return self._scalar(node)
        self.check(node)
        return None

    def check(self, node: yaml.Node) -> None:
        """Refuse a tag that safe_load does not know."""
        if not isinstance(node, yaml.ScalarNode) and node.tag not in _STRUCTURES:
            raise _error(f"The tag {node.tag!r} is not supported", node.start_mark)

    def _scalar(self, node: yaml.ScalarNode) -> Scalar | None:
        if node.tag in _NUMBERS and len(node.value) > _NUMBER_LIMIT:
            raise _error("A number is too long", node.start_mark)
        if node.tag not in SafeConstructor.yaml_constructors:
            raise _error(f"The tag {node.tag!r} is not supported", node.start_mark)
        try:
            value = self._constructor.construct_object(node)
        except (yaml.YAMLError, ValueError, KeyError, IndexError, OverflowError, AttributeError):
            raise _error(f"{node.value[:40]!r} is not a value of the type {node.tag!r}", node.start_mark) from None
        return value if isinstance(value, (str, bool, int, float)) else None
