# SPDX-License-Identifier: Apache-2.0
"""Which YAML documents have been read already? The same text is the same document, whoever asks.

    documents = YamlDocuments()
    documents.read(text, "view.rviz")        reads it; again, gives what was read

Nobody may change what is in a document.
"""

from __future__ import annotations

from typing import Final, final

from rosward.source.yaml_nodes import Item, Malformed, read_yaml

__all__ = ["YamlDocuments"]

_MOST_CHARACTERS: Final = 2_000_000


@final
class YamlDocuments:
    """Documents by file and text, as many as have room; those that nobody asked for longest go first."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, str, bool], Item | Malformed] = {}
        self._characters = 0

    def read(self, text: str, file: str, *, repeated: bool = False) -> Item:
        """The one document of a text; a key may be `repeated`, of which the last one counts. Raises `Malformed`."""
        key = file, text, repeated
        found = self._known.pop(key, None)
        if found is None:
            found = _read(text, file, repeated=repeated)
            self._characters += len(text)
        self._known[key] = found
        while self._characters > _MOST_CHARACTERS:
            oldest = next(iter(self._known))
            del self._known[oldest]
            self._characters -= len(oldest[1])
        if isinstance(found, Malformed):
            raise Malformed(found.message, found.place)
        return found


def _read(text: str, file: str, *, repeated: bool) -> Item | Malformed:
    try:
        return read_yaml(text, file, repeated=repeated)
    except Malformed as problem:
        return Malformed(problem.message, problem.place)
