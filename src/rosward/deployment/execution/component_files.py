# SPDX-License-Identifier: Apache-2.0
"""What does launch read in a parameter file of a component, other than rcl?

talker: {ros__parameters: {rate: 1}}
other: {ros__parameters: {mixed: [1, a]}}    rcl refuses all of it; launch looks at the keys of the component alone
other: {ros__parameters: {letter: y}}        for rcl true, for launch a text
rate: 1                                      rcl refuses it; for launch a file without `ros__parameters` is a table of parameters
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rosward.deployment.execution.yaml_values import load_yaml, value_of
from rosward.domain.unknown import NO_ORIGINS
from rosward.effects.configuration import Given
from rosward.location import Place

_PARAMETERS: Final = "ros__parameters"


def read_as_launch(text: str, file: str) -> tuple[Given, ...] | None:
    """What a file gives by the keys of nodes, as PyYAML reads it; None where it is not a mapping."""
    found = load_yaml(text)
    if found.error or not isinstance(found.value, dict):
        return None
    tables = dict(_tables(found.value, ())) or {"/**": found.value}
    place = Place(file, 0)
    return tuple(
        Given(node, name, value_of(value, NO_ORIGINS), place)
        for node, table in tables.items()
        if isinstance(table, dict)
        for name, value in _flat(table, ())
    )


def _tables(found: dict[object, object], keys: tuple[str, ...]) -> Iterator[tuple[str, object]]:
    """The tables of parameters by the names above them; what follows one in the same mapping is not looked at."""
    for key, value in found.items():
        if key == _PARAMETERS:
            yield "/" + "/".join(keys), value
            return
        if isinstance(value, dict):
            yield from _tables(value, (*keys, str(key).lstrip("/")))


def _flat(table: dict[object, object], names: tuple[str, ...]) -> Iterator[tuple[str, object]]:
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _flat(value, (*names, str(key)))
        else:
            yield ".".join((*names, str(key))), value
