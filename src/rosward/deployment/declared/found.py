# SPDX-License-Identifier: Apache-2.0
"""What a reader of arguments or files gives: endpoints that it found, and what it could not find out.

FoundEndpoint('publisher', Const('/scan'), Const('sensor_msgs/msg/LaserScan'), Qos(…))
Open('the configuration file of rviz2 is not known')
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final

from rosward.deployment.declared.text import TemplateScope
from rosward.domain.choice import options
from rosward.domain.values import EMPTY, Const, Value
from rosward.records import NamedTuple
from rosward.ros.entities import Qos
from rosward.source.yaml_documents import YamlDocuments
from rosward.source.yaml_nodes import Item

DEFAULT_QOS: Final = Qos("reliable", "volatile", "keep_last", 10)


class FoundEndpoint(NamedTuple):
    """One endpoint. `type` is the text of a type."""

    kind: str
    name: Value
    type: Value
    qos: Qos | None = DEFAULT_QOS
    certain: bool = True


class Open(NamedTuple):
    """What the interface has beyond what is found, in words."""

    reason: str


ReadFile = Callable[[Value], "str | None"]
"""The text of the file that a path names; None where it is not among the sources."""


class FilesRead(NamedTuple):
    """The files that arguments name."""

    text: ReadFile
    documents: YamlDocuments

    def yaml(self, path: Value, *, repeated: bool = False) -> Item | None:
        """The document in the file of a path, where the path has one meaning; None where it is not among the sources. Raises `Malformed`."""
        several = [o for o in options(path) if o != EMPTY]
        text = self.text(several[0]) if len(several) == 1 else None
        return None if text is None else self.documents.read(text, "", repeated=repeated)


Reader = Callable[[TemplateScope, FilesRead], Iterator["FoundEndpoint | Open"]]


def constant(value: Value) -> str | None:
    """The str that a value surely is."""
    return value.value if isinstance(value, Const) and isinstance(value.value, str) else None
