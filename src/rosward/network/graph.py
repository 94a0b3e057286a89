# SPDX-License-Identifier: Apache-2.0
"""The graph of the whole system, as every output reads it: frozen, sorted, free of machine and time."""

from __future__ import annotations

from rosward.findings import Finding
from rosward.network.asked import NOT_TOLD, Asked
from rosward.records import dataclass
from rosward.ros.entities import Node


@dataclass(frozen=True, slots=True)
class Topic:
    """A topic and the full names of the nodes at its two ends."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[str, ...]
    subscriptions: tuple[str, ...]
    system: bool


@dataclass(frozen=True, slots=True)
class Service:
    """A service and the full names of its servers and clients."""

    name: str
    types: tuple[str, ...]
    servers: tuple[str, ...]
    clients: tuple[str, ...]
    system: bool


@dataclass(frozen=True, slots=True)
class Action:
    """An action and the full names of its servers and clients."""

    name: str
    types: tuple[str, ...]
    servers: tuple[str, ...]
    clients: tuple[str, ...]
    system: bool


@dataclass(frozen=True, slots=True)
class Network:
    """What the analysis says of a system. `files` and `lines` count the source that was read; `asked` is the question."""

    distro: str
    nodes: tuple[Node, ...]
    topics: tuple[Topic, ...]
    services: tuple[Service, ...]
    actions: tuple[Action, ...]
    findings: tuple[Finding, ...]
    files: int = 0
    lines: int = 0
    processes: int = 0
    asked: Asked = NOT_TOLD
