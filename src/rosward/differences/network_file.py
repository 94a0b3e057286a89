# SPDX-License-Identifier: Apache-2.0
"""What does a `network.json` hold that is compared?

    {"schema_version": 1, "nodes": [{"fqn": "/talker", "enclave": "/talker", "publishers": [{"name": "/chatter", …}], …}]}
      ->  Snapshot: node /talker, its publisher, and the right to publish rt/chatter in enclave /talker

The reader is strict: what is not of the form that `network_json.py` writes is refused with the place of it. Size is bounded.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Final

from rosward.differences.snapshot import EntityLine, Snapshot, UnreadableError
from rosward.findings import Finding
from rosward.policies.match import LONGEST_NAME, is_pattern
from rosward.policies.records import EnclavePolicy, Policy, PolicyRule
from rosward.policies.rights import rights_of
from rosward.ros.entities import EntityKind, Resolution
from rosward.source.location import Place
from rosward.source.text import read_bytes

__all__ = ["network_of", "read_network"]

_LARGEST: Final = 32_000_000
_MOST_PATTERNS: Final = 1_000
"""In one enclave, so that comparing them stays a matter of seconds."""

_SCHEMA_VERSION: Final = 1
_LISTS: Final = {
    "publishers": EntityKind.PUBLISHER,
    "subscriptions": EntityKind.SUBSCRIPTION,
    "service_servers": EntityKind.SERVICE_SERVER,
    "service_clients": EntityKind.SERVICE_CLIENT,
    "action_servers": EntityKind.ACTION_SERVER,
    "action_clients": EntityKind.ACTION_CLIENT,
}
_UNKNOWN: Final = Resolution.UNKNOWN.value
_RESOLUTIONS: Final = frozenset(r.value for r in Resolution)


def read_network(path: str) -> Snapshot:
    """The snapshot of a file. Raises UnreadableError."""
    data = read_bytes(path, path, _LARGEST)
    if isinstance(data, Finding):
        raise UnreadableError(f"{path}: {data.message}")
    try:
        text = data.decode("utf-8-sig")
    except ValueError as error:
        raise UnreadableError(f"{path}: no JSON: {error}") from error
    return network_of(text, path)


def network_of(text: str, path: str) -> Snapshot:
    """The snapshot of the text of a `network.json`; `path` is what messages call it. Raises UnreadableError."""
    try:
        document = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UnreadableError(f"{path}: no JSON: {error}") from error
    try:
        return _snapshot(document, path)
    except UnreadableError as error:
        raise UnreadableError(f"{path}: no network.json of rosward: {error}") from error


def _snapshot(document: object, path: str) -> Snapshot:
    top = _object(document, "the document")
    if top.get("schema_version") != _SCHEMA_VERSION or isinstance(top["schema_version"], bool):
        raise UnreadableError(f"schema_version is not {_SCHEMA_VERSION}")
    nodes: set[str] = set()
    entities: set[EntityLine] = set()
    rules: dict[str, dict[tuple[str, str], PolicyRule]] = {}
    for number, value in enumerate(_list(top, "nodes", "the document")):
        where = f"nodes[{number}]"
        node = _object(value, where)
        fqn = _text(node, "fqn", where)
        nodes.add(fqn)
        granted = rules.setdefault(_text(node, "enclave", where), {})
        for line, rule in _entities(node, fqn, where, path):
            entities.add(line)
            granted.setdefault((rule.words, rule.name), rule)
    for enclave, granted in rules.items():
        if sum(is_pattern(name) for _, name in granted) > _MOST_PATTERNS:
            raise UnreadableError(f"enclave {enclave} has more than {_MOST_PATTERNS:,} names with a wildcard")
    place = Place(path)
    enclaves = tuple(EnclavePolicy(enclave, place, tuple(rules[enclave].values())) for enclave in sorted(rules))
    return Snapshot("network", frozenset(nodes), frozenset(entities), Policy(enclaves))


def _entities(node: dict[str, object], fqn: str, where: str, path: str) -> Iterator[tuple[EntityLine, PolicyRule]]:
    for key, kind in _LISTS.items():
        for number, value in enumerate(_list(node, key, where)):
            place = f"{where}.{key}[{number}]"
            entity = _object(value, place)
            name, type_ = _text(entity, "name", place), entity.get("type")
            if type_ is not None and not isinstance(type_, str):
                raise UnreadableError(f"{place}.type is neither text nor null")
            if not name.startswith("/") or "[" in name or "?" in name:
                raise UnreadableError(f"{place}.name is no full name")
            if _text(entity, "resolution", place) not in _RESOLUTIONS:
                raise UnreadableError(f"{place}.resolution is none that there is")
            right = "/*" if entity["resolution"] == _UNKNOWN and name.endswith("/*") else name
            rule = PolicyRule(True, kind.value, right, rights_of(kind, right), _created(entity, path))
            yield EntityLine(fqn, kind.value, name, type_ or ""), rule


def _created(entity: dict[str, object], path: str) -> Place:
    """Where the entity is created first; the file that was read, where it does not say."""
    places = entity.get("created_at")
    first = places[0] if isinstance(places, list) and places else None
    if not isinstance(first, dict):
        return Place(path)
    file, line = first.get("file"), first.get("line")
    return Place(file, line) if isinstance(file, str) and isinstance(line, int) else Place(path)


def _object(value: object, where: str) -> dict[str, object]:
    if not isinstance(value, dict):
        raise UnreadableError(f"{where} is no object")
    return value


def _list(value: dict[str, object], key: str, where: str) -> list[object]:
    found = value.get(key)
    if not isinstance(found, list):
        raise UnreadableError(f"{where}.{key} is no list")
    return found


def _text(value: dict[str, object], key: str, where: str) -> str:
    found = value.get(key)
    if not isinstance(found, str) or len(found) > LONGEST_NAME:
        raise UnreadableError(f"{where}.{key} is no text of at most {LONGEST_NAME} characters")
    return found
