# SPDX-License-Identifier: Apache-2.0
"""Which keys stand at the top of a parameter file?

"amcl: {ros__parameters: {…}}\n/left/arm: {…}"    ->    {'amcl', '/left/arm'}

Only the events of the parser are looked at: nothing is built, so no alias is expanded.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

import yaml

from rosward.deployment.execution.rewrites import key_path
from rosward.holes import HOLE

if TYPE_CHECKING:
    from rosward.deployment.execution.content import Content

_MOST: Final = 200_000


def has_key(content: Content, key: str) -> bool | None:
    """Whether a file has a key at its top; None where that is not known."""
    if content.text is not None:
        found = top_keys(content.text)
        return None if found is None else key in found
    if content.rows is None:
        return None
    paths = [key_path(row.node) for row in content.rows]
    if any("*" in path or HOLE in path for path in paths):
        return None
    if "/" in key or any(path.startswith(f"{key}/") for path in paths):
        return None  # keys below each other, or one with slashes in it: what was rewritten tells no more which
    return key in paths


def top_keys(text: str) -> frozenset[str] | None:
    """The keys that are texts; None where the text is no YAML, or too long."""
    try:
        return frozenset(_keys(text))
    except (yaml.YAMLError, ValueError, RecursionError, _TooLongError):
        return None


class _TooLongError(Exception):
    """So many events are not looked at."""


def _keys(text: str) -> Iterator[str]:
    depth, is_key = 0, True
    for number, event in enumerate(yaml.parse(text, Loader=yaml.SafeLoader)):
        if number > _MOST:
            raise _TooLongError
        if isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
        if depth == 1 and isinstance(event, yaml.NodeEvent | yaml.CollectionEndEvent):
            if is_key and isinstance(event, yaml.ScalarEvent):
                yield event.value
            if not isinstance(event, yaml.CollectionStartEvent):
                is_key = not is_key
        if isinstance(event, yaml.CollectionStartEvent):
            if depth == 0 and not isinstance(event, yaml.MappingStartEvent):
                return
            depth += 1
