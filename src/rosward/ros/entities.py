# SPDX-License-Identifier: Apache-2.0
"""The records that everything after the interpretation speaks in: entities, nodes, QoS, parameters.

All are frozen and hold fully qualified names: what is here is what the running system would show, with `*` for what is not known.
"""

from __future__ import annotations

import enum
import re
from collections.abc import Iterable
from typing import Final

from rosward.location import Place
from rosward.records import dataclass, field, replace
from rosward.ros.flows import NodeFlows

__all__ = [
    "ENTITY_LISTS",
    "KIND_ORDER",
    "Entity",
    "EntityKind",
    "Interface",
    "Node",
    "Parameter",
    "Qos",
    "Resolution",
    "assumed_label",
    "is_assumed_label",
    "least_sure",
    "replace",
    "surest",
]


class EntityKind(enum.Enum):
    """What a node can have; the value is the word used in messages."""

    PUBLISHER = "publisher"
    SUBSCRIPTION = "subscription"
    SERVICE_SERVER = "service server"
    SERVICE_CLIENT = "service client"
    ACTION_SERVER = "action server"
    ACTION_CLIENT = "action client"

    @property
    def meeting(self) -> str:
        """Where it meets others: topic, service or action."""
        word = self.value.partition(" ")[0]
        return word if word in ("service", "action") else "topic"


KIND_ORDER: Final = {kind: number for number, kind in enumerate(EntityKind)}
"""The order in which entities stand in documents and messages."""

ENTITY_LISTS: Final = {
    "publishers": EntityKind.PUBLISHER,
    "subscriptions": EntityKind.SUBSCRIPTION,
    "service_servers": EntityKind.SERVICE_SERVER,
    "service_clients": EntityKind.SERVICE_CLIENT,
    "action_servers": EntityKind.ACTION_SERVER,
    "action_clients": EntityKind.ACTION_CLIENT,
}
"""The lists of a node in documents (`network.json`, snapshots), and what is in them."""


class Resolution(enum.Enum):
    """How a name was found, from the surest to the least."""

    EXACT = "exact"
    DEFAULT = "default"
    BOUND = "bound"
    PATTERN = "pattern"
    UNKNOWN = "unknown"

    @property
    def whole(self) -> bool:
        """Whether all of the name is known."""
        return self is not Resolution.PATTERN and self is not Resolution.UNKNOWN


_SURENESS: Final = {resolution: number for number, resolution in enumerate(Resolution)}


def surest(found: Iterable[Resolution]) -> Resolution:
    """What is found in several ways is found as the surest of them. Raises ValueError where there is none."""
    return min(found, key=_SURENESS.__getitem__)


def least_sure(*found: Resolution) -> Resolution:
    """What is made of several parts is found as the least sure of them."""
    return max(found, key=_SURENESS.__getitem__)


class Interface(enum.Enum):
    """What is known of all that a node has, from the surest to the least.

    An analysed node was interpreted from its source, a declared one is what a file says of it. In part: it was, and something says that
    it may have more. Of an unknown one there is what every node has.
    """

    ANALYSED = "analysed"
    DECLARED = "declared"
    PARTIAL = "partial"
    UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True)
class Qos:
    """What is known of a QoS profile; None for what is not. The words are those of `ros2 topic info -v`, in lower case with `_`."""

    reliability: str | None = None
    durability: str | None = None
    history: str | None = None
    depth: int | None = None


@dataclass(frozen=True, slots=True)
class Entity:
    """One endpoint of a node.

    `name` is fully qualified, after expansion and remapping, `*` for each unknown part. `reasons` says, for a name or type that is
    not completely known, why, in words for a person ("parameter 'ns' has no default (talker.py:12)"), `causes` by what findings of it are put
    together; `via` names the library function
    that created the entity on behalf of the user's code (`tf2_ros.TransformListener`), None where the user's code did so itself.
    `ros_prefix` is False for a topic with `avoid_ros_namespace_conventions`. `path` is one chain of calls in the user's code that ends
    where the entity is created; it says how, not what, so two entities that differ in it alone are equal.
    """

    kind: EntityKind
    name: str
    type: str | None
    system: bool = False
    resolution: Resolution = Resolution.EXACT
    conditional: bool = False
    callback: str | None = None
    qos: Qos | None = None
    depends_on: tuple[str, ...] = ()
    created_at: tuple[Place, ...] = ()
    reasons: tuple[str, ...] = ()
    causes: tuple[str, ...] = ()
    via: str | None = None
    ros_prefix: bool = True
    path: tuple[Place, ...] = field(default=(), compare=False)


@dataclass(frozen=True, slots=True)
class Parameter:
    """A declared parameter. `type` is rcl's word (bool, integer, double, string, byte_array, bool_array, …), None where unknown.

    `default` and `value` are plain Python values; None where there is none or it is not known.
    """

    name: str
    type: str | None
    default: object
    value: object
    declared_at: Place | None


@dataclass(frozen=True, slots=True)
class Node:
    """One node of one process with everything that it has. `entities` is sorted by kind, name and type.

    `enclave` is where it runs; `given_enclave` is the one that its launch file, arguments or environment name, None where they name none.
    `conditional`: some execution does not have it. `assumed`: it is what a class makes that nothing in the sources instantiates, so no
    execution is known that has it; it is conditional, too, and `process` names the class. `lacks` says why its interface is known in part,
    or not at all. `label` is what tells a node of unknown name from others: PACKAGE/EXECUTABLE, None where its name is known. `flows` is None
    where that was not asked for, or nothing is known of it.
    """

    namespace: str
    name: str
    resolution: Resolution
    enclave: str
    package: str | None
    executable: str | None
    process: str
    launched_by: Place | None
    defined_at: Place
    entities: tuple[Entity, ...] = ()
    parameters: tuple[Parameter, ...] = ()
    reasons: tuple[str, ...] = field(default=())
    given_enclave: str | None = None
    conditional: bool = False
    assumed: bool = False
    causes: tuple[str, ...] = ()
    interface: Interface = Interface.ANALYSED
    lacks: tuple[str, ...] = ()
    label: str | None = None
    flows: NodeFlows | None = None

    @property
    def display_name(self) -> str:
        """What the node is called where people read it: its full name, or its label where nobody knows its name. No two nodes share a label."""
        return self.label or self.fqn

    @property
    def fqn(self) -> str:
        """The fully qualified name, `/namespace/name`; a namespace that is not known at all may be the root."""
        if self.namespace in ("/", "/*"):
            return self.namespace + self.name
        return f"{self.namespace}/{self.name}"

    def of_kind(self, kind: EntityKind) -> tuple[Entity, ...]:
        """The entities of one kind, in order."""
        return tuple(e for e in self.entities if e.kind is kind)


_ASSUMED: Final = re.compile(r"class .+:\w+", re.DOTALL)


def assumed_label(file: str, name: str) -> str:
    """What stands in place of a process for a node class that nothing instantiates: `class demo/talker.py:Talker`."""
    return f"class {file}:{name}"


def is_assumed_label(process: str) -> bool:
    """Whether a process is such a class."""
    return _ASSUMED.fullmatch(process) is not None
