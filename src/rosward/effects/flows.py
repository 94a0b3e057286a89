# SPDX-License-Identifier: Apache-2.0
"""What flows through one process, by its own names: where information comes from, where it leaves, and what is in it there."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from rosward.domain.values import Value
from rosward.location import Place
from rosward.records import NamedTuple

RELEASED: Final = "released"
"""The kind of what a function gives that releases something: a sink of what it is made of, and a source."""


class Source(NamedTuple):
    """Where information comes from: a kind of `flow.json`, and what names it: a text, or the node and the name as the program has them."""

    kind: str
    name: str = ""
    node: int | None = None
    given: Value | None = None


class Sink(NamedTuple):
    """A place that sends: a kind of `flow.json`, the node, and the name as the program has it (None: the kind has no names)."""

    kind: str
    node: int | None
    given: Value | None
    place: Place


class Call(NamedTuple):
    """A sink as some callers use it, who are named from the outermost on: what is in it then, what decides it, what it waits for."""

    through: tuple[Place, ...]
    data: frozenset[Source]
    control: frozenset[Source]
    trigger: frozenset[Source]


class Flow(NamedTuple):
    """One sink of a process: what is in it, what decides it, what it waits for; and through which lines each comes there.

    `assumed`: those of `data` that stand there only because not all is known. `calls`: the same by callers; empty where these are not told apart.
    """

    sink: Sink
    data: frozenset[Source]
    control: frozenset[Source]
    trigger: frozenset[Source]
    paths: Mapping[Source, tuple[Place, ...]] = MappingProxyType({})
    assumed: frozenset[Source] = frozenset()
    calls: tuple[Call, ...] = ()


class Callback(NamedTuple):
    """A callback of a process: the node on whose behalf it runs, what wakes it, its function, where its code begins.

    `sinks`: where it sends, and what that depends on when this callback sends it.

    `period`: of a timer of the client library, in nanoseconds; 0 where it is not known.
    """

    node: int | None
    events: tuple[Source, ...]
    function: str
    place: Place
    sinks: tuple[tuple[Sink, frozenset[Source]], ...]
    period: int | None = None


class ProcessFlows(NamedTuple):
    """All sinks of a process, and its callbacks; `complete`: no limit was reached."""

    flows: tuple[Flow, ...] = ()
    complete: bool = True
    callbacks: tuple[Callback, ...] = ()
