# SPDX-License-Identifier: Apache-2.0
"""What is there to say of a topic, service or action, and which other ones may one of a partly known name be?

    /robot_*/scan  ->  "matches": ["t3", "t7"]      the ids of /robot_1/scan and /robot_2/scan

Of a name that is not known at all nothing is said: it may be any.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Mapping

from rosward.network.holes import may_be
from rosward.outputs.report.numbered import NumberedEndpoint
from rosward.ros.entities import Resolution, surest

__all__ = ["endpoint_rows"]


def endpoint_rows(endpoints: Iterable[NumberedEndpoint], findings: Mapping[str, list[str]]) -> list[object]:
    """The endpoints of the document; `findings` are those of each id."""
    names: dict[str, list[tuple[str, str]]] = {}
    everything = tuple(endpoints)
    for endpoint in everything:
        names.setdefault(endpoint.word, []).append((endpoint.name, endpoint.id))
    return [_row(endpoint, names[endpoint.word], findings.get(endpoint.id, [])) for endpoint in everything]


def _row(endpoint: NumberedEndpoint, names: list[tuple[str, str]], findings: list[str]) -> dict[str, object]:
    entities = [end.entity for end in endpoint.ends]
    own = [entity for entity in entities if not entity.system]
    resolution = surest(entity.resolution for entity in own or entities)
    row: dict[str, object] = {
        "id": endpoint.id,
        "kind": endpoint.word,
        "name": endpoint.name,
        "types": sorted({entity.type for entity in entities if entity.type is not None}),
        "system": not own,
        "resolution": resolution.value,
        "findings": findings,
    }
    if "*" in endpoint.name and resolution is not Resolution.UNKNOWN:
        row["matches"] = _matches(endpoint, names)
    return row


def _matches(endpoint: NumberedEndpoint, names: list[tuple[str, str]]) -> list[str]:
    """The ids of the names that a pattern may be. The names are sorted, so those with its beginning stand together."""
    beginning = endpoint.name.partition("*")[0]
    found: list[str] = []
    for number in range(bisect_left(names, (beginning, "")), len(names)):
        name, id_ = names[number]
        if not name.startswith(beginning):
            break
        if id_ != endpoint.id and may_be(name, endpoint.name):
            found.append(id_)
    return found
