# SPDX-License-Identifier: Apache-2.0
"""Which entities does a node have that no line of its program asks for: those of the client library?

Where a program overrides a method that the client library calls for them, they are what that makes of it.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Final

from rosward.domain.certain import is_true
from rosward.domain.choice import options
from rosward.domain.values import Const, Value
from rosward.effects.log import EffectLog, NodeEffect
from rosward.holes import HOLE, Holed
from rosward.naming.command_line import ValueRule
from rosward.naming.final_name import command_lines
from rosward.naming.parameters import values_of
from rosward.records import NamedTuple, replace
from rosward.ros import names
from rosward.ros.distro import Distro
from rosward.ros.entities import Entity, EntityKind, Resolution
from rosward.ros.implicit import ClientLibrary, implicit_entities

_SERVICES: Final = (EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT)
_OF_CONTAINERS: Final = {
    "load_node": "composition_interfaces/srv/LoadNode",
    "unload_node": "composition_interfaces/srv/UnloadNode",
    "list_nodes": "composition_interfaces/srv/ListNodes",
}
"""What a component manager serves below `~/_container`."""


class Identity(NamedTuple):
    """One of the full names that a node may have."""

    name: Holed
    namespace: Holed
    rules: tuple[ValueRule, ...]
    resolution: Resolution
    depends_on: tuple[str, ...]
    reasons: tuple[str, ...]
    causes: tuple[str, ...]
    sole: bool


Asked = frozenset[tuple[EntityKind, str, str | None]]
"""Kind, name and type of what is made through methods of the node."""


def of_client_library(
    log: EffectLog, effect: NodeEffect, identity: Identity, distro: Distro
) -> tuple[list[Entity], Asked]:
    """What the client library makes by itself, under the node's own rules; and what it asks the node for, if a program overrides that."""
    switches = dict(effect.options)

    def switch(name: str, default: bool) -> bool:
        value = switches.get(name)
        if isinstance(value, Const) and isinstance(value.value, bool) and not value.origins:
            return value.value
        return True if value is not None else default

    own, general = command_lines(log, effect)
    fqn = names.fully_qualified(identity.namespace, identity.name)
    values = values_of(log, effect)
    given = values.get("use_sim_time")
    description = switches.get("start_type_description_service", values.get("start_type_description_service"))
    sim = (given is not None and _may_be_true(given)) or any(
        p.address == effect.address
        and isinstance(p.name, Const)
        and p.name.value == "use_sim_time"
        and is_true(p.value)
        for p in log.parameters
    )
    wanted = partial(
        implicit_entities,
        distro,
        node_fqn=fqn,
        enable_rosout=switch("enable_rosout", True) and own.rosout_logs and general.rosout_logs,
        start_parameter_services=switch("start_parameter_services", True),
        type_description=not (isinstance(description, Const) and description.value is False),
        logger_service=switch("enable_logger_service", False),
        use_sim_time=sim or switch("use_sim_time", False),
        lifecycle=switch("lifecycle", False),
        lifecycle_services=switch("lifecycle_services", True),
        start_parameter_event_publisher=switch("start_parameter_event_publisher", True),
        topic_statistics=switch("enable_topic_statistics", False),
        client_library=_client_library(switches.get("client_library")),
    )
    every = _named(wanted(), effect, identity, fqn)
    if not switch("asked", False):
        return every, frozenset()
    asked = frozenset((e.kind, e.name, e.type) for e in _named(wanted(asked=True), effect, identity, fqn))
    return [e for e in every if (e.kind, e.name, e.type) not in asked], asked


def is_of_container(kind: EntityKind, name: str, type_: str | None) -> bool:
    """Whether this is a service by which components are loaded: every container has them, so none of them is the user's own."""
    above, _, last = name.rpartition("/")
    served = kind is EntityKind.SERVICE_SERVER and above.endswith("/_container")
    return served and last in _OF_CONTAINERS and type_ == _OF_CONTAINERS[last]


def _named(found: Iterable[Entity], effect: NodeEffect, identity: Identity, fqn: str) -> list[Entity]:
    """The entities under the names that the node's rules give them."""
    rules = tuple(r.rule for r in identity.rules)
    result: list[Entity] = []
    for entity in found:
        kind = names.RemapKind.SERVICE if entity.kind in _SERVICES else names.RemapKind.TOPIC
        for text in names.resolve(Holed(entity.name), kind, rules, identity.name, identity.namespace):
            resolution = identity.resolution if text.startswith(fqn) else Resolution.EXACT
            if HOLE in text and HOLE not in fqn:  # by a rule whose target is not known
                resolution = Resolution.UNKNOWN if text.strip("/") == HOLE else Resolution.PATTERN
            result.append(replace(entity, name=text, resolution=resolution, created_at=(effect.place,), system=True))
    return result


def _client_library(value: Value | None) -> ClientLibrary:
    written = value.value if isinstance(value, Const) else None
    return ClientLibrary.RCLCPP if written == ClientLibrary.RCLCPP.value else ClientLibrary.RCLPY


def _may_be_true(value: Value) -> bool:
    return any(not isinstance(o, Const) or o.value is True for o in options(value))
