# SPDX-License-Identifier: Apache-2.0
"""What does a snapshot say? The reader of what `snapshot.py` writes.

    {"schema_version": 1, "nodes": [{"name": "talker", "namespace": "/", …, "publishers": [{"name": "/chatter", …}]}]}  ->  LiveGraph

A snapshot comes from elsewhere, so the reader is strict: what is not of that form is refused with the place of it, and size is bounded.
"""

from __future__ import annotations

import json
from typing import Final

from rosward.findings import Finding
from rosward.ros.entities import EntityKind, Qos
from rosward.running.graph import LISTS, LiveEntity, LiveGraph, LiveNode, UnreadableError, with_actions
from rosward.source.location import Place
from rosward.source.text import read_bytes

__all__ = ["Fields", "json_document", "read_snapshot", "snapshot_of"]

_LARGEST: Final = 64_000_000
_LONGEST: Final = 1_000
_MOST_ENTITIES: Final = 200_000
_MOST_NODES: Final = 20_000
_MOST_PROFILES: Final = 50
_MOST_PROBLEMS: Final = 100
_SCHEMA_VERSION: Final = 1


def read_snapshot(path: str) -> LiveGraph:
    """What a file says. Raises UnreadableError."""
    return snapshot_of(json_document(path), path)


def json_document(path: str) -> object:
    """The JSON in a file. Raises UnreadableError."""
    data = read_bytes(path, path, _LARGEST)
    if isinstance(data, Finding):
        raise UnreadableError(f"{path}: {data.message}")
    try:
        return json.loads(data)
    except (ValueError, RecursionError) as error:
        raise UnreadableError(f"{path}: no JSON: {error}") from error


def snapshot_of(document: object, source: str = "") -> LiveGraph:
    """What a document says; `source` is where it comes from. Raises UnreadableError."""
    try:
        return _graph(Fields(document, "the document"), source)
    except UnreadableError as error:
        raise UnreadableError(f"{source or 'the snapshot'}: no snapshot of rosward: {error}") from error


class Fields:
    """An object of JSON whose fields are asked for by their kind; one of another kind is told with its place."""

    def __init__(self, value: object, where: str) -> None:
        if not isinstance(value, dict):
            raise UnreadableError(f"{where} is no object")
        self._value = value
        self.where = where

    def __contains__(self, key: str) -> bool:
        return self._value.get(key) is not None

    def text(self, key: str) -> str:
        """A text."""
        found = self._value.get(key)
        if not isinstance(found, str) or len(found) > _LONGEST:
            raise UnreadableError(f"{self.where}.{key} is no text of at most {_LONGEST} characters")
        return found

    def long_text(self, key: str) -> str:
        """A text of any length."""
        found = self._value.get(key)
        if not isinstance(found, str):
            raise UnreadableError(f"{self.where}.{key} is no text")
        return found

    def inner(self, key: str) -> Fields:
        """An object in it."""
        return Fields(self._value.get(key), f"{self.where}.{key}")

    def text_or_none(self, key: str) -> str | None:
        """A text, or nothing."""
        return self.text(key) if key in self else None

    def number(self, key: str) -> int:
        """A natural number."""
        found = self._value.get(key)
        if not isinstance(found, int) or isinstance(found, bool) or not 0 <= found < 1 << 31:
            raise UnreadableError(f"{self.where}.{key} is no number of things")
        return found

    def flag(self, key: str, default: bool) -> bool:
        """True or false."""
        found = self._value.get(key, default)
        if not isinstance(found, bool):
            raise UnreadableError(f"{self.where}.{key} is neither true nor false")
        return found

    def qos(self) -> Qos:
        """What it says of a QoS profile."""
        return Qos(
            self.text_or_none("reliability"),
            self.text_or_none("durability"),
            self.text_or_none("history"),
            self._integer_or_none("depth"),
        )

    def _integer_or_none(self, key: str) -> int | None:
        found = self._value.get(key)
        if found is not None and (not isinstance(found, int) or isinstance(found, bool)):
            raise UnreadableError(f"{self.where}.{key} is no integer")
        return found

    def version(self) -> None:
        """Refuse a document of another version."""
        found = self._value.get("schema_version")
        if found != _SCHEMA_VERSION or isinstance(found, bool):
            raise UnreadableError(f"schema_version is not {_SCHEMA_VERSION}")

    def objects(self, key: str, most: int) -> list[Fields]:
        """A list of objects."""
        return [Fields(value, f"{self.where}.{key}[{n}]") for n, value in enumerate(self._list(key, most))]

    def texts(self, key: str, most: int) -> list[str]:
        """A list of texts."""
        found = self._list(key, most)
        texts = [value for value in found if isinstance(value, str) and len(value) <= _LONGEST]
        if len(texts) < len(found):
            raise UnreadableError(f"{self.where}.{key} is no list of texts of at most {_LONGEST} characters")
        return texts

    def _list(self, key: str, most: int) -> list[object]:
        found = self._value.get(key)
        if not isinstance(found, list):
            raise UnreadableError(f"{self.where}.{key} is no list")
        if len(found) > most:
            raise UnreadableError(f"{self.where}.{key} has more than {most:,} items")
        return found


def _graph(top: Fields, source: str) -> LiveGraph:
    top.version()
    nodes: dict[str, LiveNode] = {}
    left = _MOST_ENTITIES
    for fields in top.objects("nodes", _MOST_NODES):
        node = _node(fields)
        left -= len(node.entities)
        if left < 0:
            raise UnreadableError(f"there are more than {_MOST_ENTITIES:,} entities")
        if node.name in nodes:
            raise UnreadableError(f"{fields.where}: {node.name} is there twice")
        nodes[node.name] = node
    return LiveGraph(
        nodes=tuple(nodes[name] for name in sorted(nodes)),
        loose=tuple(_entity(f, _kind(f)) for f in top.objects("without_node", _MOST_ENTITIES)),
        looks=top.number("looks"),
        distro=top.text_or_none("ros_distro"),
        source=source,
        findings=tuple(Finding("RW505", text, Place(source)) for text in _problems(top, nodes)),
    )


def _problems(top: Fields, nodes: dict[str, LiveNode]) -> list[str]:
    if not nodes:
        return ["No node was seen: is it the right domain, and may the snapshot join the graph?"]
    told = [f"The middleware did not tell what {node.name} has." for node in nodes.values() if not node.known]
    problems = top.texts("problems", _MOST_PROBLEMS)
    return [*told, *(f"The snapshot could not ask for {problem}." for problem in problems)][:_MOST_PROBLEMS]


def _node(fields: Fields) -> LiveNode:
    name, namespace = fields.text("name"), fields.text("namespace")
    if not namespace.startswith("/") or not name or "/" in name:
        raise UnreadableError(f"{fields.where} has no name or no namespace")
    asked = fields.number("asked") > 0
    entities: list[LiveEntity] = []
    for key, kind in LISTS.items():
        entities += (_entity(f, kind) for f in fields.objects(key, _MOST_ENTITIES))
    return LiveNode(
        name=f"{namespace.rstrip('/')}/{name}",
        entities=with_actions(entities),
        count=max(fields.number("count"), 1),
        seen=fields.number("seen"),
        known=frozenset(LISTS.values()) if asked else frozenset(),
        enclaves=tuple(fields.texts("enclaves", _MOST_PROFILES)),
    )


def _kind(fields: Fields) -> EntityKind:
    found = LISTS.get(fields.text("kind"))
    if found is None:
        raise UnreadableError(f"{fields.where}.kind is none that there is")
    return found


def _entity(fields: Fields, kind: EntityKind) -> LiveEntity:
    return LiveEntity(
        kind=kind,
        name=fields.text("name"),
        type=fields.text("type"),
        seen=fields.number("seen"),
        qos=tuple(f.qos() for f in fields.objects("qos", _MOST_PROFILES)),
        ros_prefix=fields.flag("ros_prefix", True),
    )
