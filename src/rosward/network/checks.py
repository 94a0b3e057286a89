# SPDX-License-Identifier: Apache-2.0
"""What can only be seen in the whole: several nodes in a process, wildcards, enclave paths, types that differ, QoS
that does not fit (`qos.py`), names used twice.

One function a rule, each from the network to findings. `check` runs them all.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from itertools import chain
from typing import Literal, TypeVar

from rosward.findings import Finding
from rosward.guard import Steps
from rosward.location import Place
from rosward.network.enclaves import LONGEST_ENCLAVE, enclave_paths
from rosward.network.graph import Network
from rosward.network.qos import incompatible_qos
from rosward.ros.entities import Entity, EntityKind, Node, Resolution
from rosward.rules import MADE_ANEW

__all__ = ["UnknownNames", "check", "place_of"]

UnknownNames = Literal["deny", "wildcard"]
"""What a policy says for a wholly unknown name: nothing, or `*`."""

_K = TypeVar("_K")
_V = TypeVar("_V")

_MEETING = (
    ("topic", (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)),
    ("service", (EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT)),
    ("action", (EntityKind.ACTION_SERVER, EntityKind.ACTION_CLIENT)),
)


def check(network: Network, unknown: UnknownNames = "deny", *, net: bool = True) -> list[Finding]:
    """Every finding that comes from the network as a whole, in no particular order."""
    rules: tuple[Callable[[], Iterable[Finding]], ...] = (
        lambda: _several_nodes_in_one_process(network.nodes),
        lambda: _wildcards(network.nodes, unknown),
        lambda: _long_enclaves(network.nodes),
        lambda: _outside_ros_names(network.nodes),
        lambda: _differing_types(network.nodes),
        lambda: incompatible_qos(network.nodes),
        lambda: _names_used_twice(network.nodes),
    )
    steps = Steps(net=net)
    nothing: list[Finding] = []
    found = [steps(_all_of(rule), nothing, "one of the checks of the whole system was not performed") for rule in rules]
    return [*chain.from_iterable(found), *steps.findings]


def _all_of(rule: Callable[[], Iterable[Finding]]) -> Callable[[], list[Finding]]:
    return lambda: list(rule())


def place_of(node: Node, entity: Entity) -> Place:
    """Where an entity is created; where its node is defined if nothing nearer is known."""
    return entity.created_at[0] if entity.created_at else node.defined_at


def _several_nodes_in_one_process(nodes: Iterable[Node]) -> Iterator[Finding]:
    """RW301, unless the nodes of the process are in one enclave already."""
    for process, members in _grouped((node.process, node) for node in nodes if not node.assumed):
        if len({node.enclave for node in members}) > 1:
            names = ", ".join(sorted({node.fqn for node in members}))
            yield Finding(
                "RW301",
                f"process {process} holds {len(members)} nodes ({names}), but a process has one enclave: "
                "no single policy file of the result lets it start",
                members[1].defined_at,
            )


def _wildcards(nodes: Iterable[Node], unknown: UnknownNames) -> Iterator[Finding]:
    """RW302, once for each node and name; what a node's own unknown name brings with it is said once for the node."""
    told = {Resolution.PATTERN} if unknown == "deny" else {Resolution.PATTERN, Resolution.UNKNOWN}
    for node in nodes:
        granted = unknown == "wildcard" or node.resolution is not Resolution.UNKNOWN
        granted = granted and not _made_anew(node)
        if granted and "*" in node.fqn and any(e.system and "*" in e.name for e in node.entities):
            message = (
                f"the system services and topics of node {node.fqn} are granted for every node that matches its name"
            )
            yield Finding("RW302", message, node.defined_at, node.causes)
        own = [
            e for e in node.entities if not e.system and "*" in e.name and e.resolution in told and not _made_anew(e)
        ]
        for name, entities in _grouped((e.name, e) for e in own):
            kinds = " and ".join(dict.fromkeys(e.kind.value for e in entities))
            message = f"node {node.fqn}: {kinds} {name}: {_also_matches(name)}"
            yield Finding("RW302", message, place_of(node, entities[0]), entities[0].causes)


def _made_anew(named: Node | Entity) -> bool:
    """Whether nobody can make more of the name known: that and the pattern for it are told already (RW107)."""
    return named.resolution is Resolution.PATTERN and named.causes == (MADE_ANEW,)


def _also_matches(name: str) -> str:
    return f"it also allows {name.replace('*', 'any/depth', 1)}" if name != "/*" else "it allows every name"


def _long_enclaves(nodes: Iterable[Node]) -> Iterator[Finding]:
    """RW303, once for each enclave."""
    paths = enclave_paths(nodes)
    for enclave, members in _grouped((node.enclave, node) for node in nodes):
        if len(paths[enclave]) > LONGEST_ENCLAVE:
            message = f"enclave {paths[enclave]} has {len(paths[enclave])} characters, but at most {LONGEST_ENCLAVE} are possible"
            yield Finding("RW303", message, members[0].defined_at)


def _outside_ros_names(nodes: Iterable[Node]) -> Iterator[Finding]:
    """RW305."""
    for node in nodes:
        for entity in node.entities:
            if not entity.ros_prefix:
                message = f"node {node.fqn}: {entity.kind.value} {entity.name} has no rt prefix in its DDS name"
                yield Finding("RW305", message, place_of(node, entity))


def _differing_types(nodes: Iterable[Node]) -> Iterator[Finding]:
    """RW306, once for each name. A partly known name may be two names, and a node's own alternatives never meet."""
    for word, kinds in _MEETING:
        ends = [
            ((e.name, e.ros_prefix), (node, e))
            for node in nodes
            for e in node.entities
            if e.kind in kinds and e.type is not None and "*" not in e.name
        ]
        for (name, _), members in _grouped(ends):
            other = _that_clashes(members)
            if other:
                uses = "; ".join(_of_type(members, type_) for type_ in sorted({e.type or "" for _, e in members}))
                yield Finding("RW306", f"{word} {name}: {uses}", place_of(*other))


def _that_clashes(members: list[tuple[Node, Entity]]) -> tuple[Node, Entity] | None:
    """The first end that cannot talk with one before it."""
    if len({e.type for _, e in members}) == 1:
        return None
    for index, (node, entity) in enumerate(members):
        for earlier_node, earlier in members[:index]:
            alternatives = node is earlier_node and entity.conditional and earlier.conditional
            if entity.type != earlier.type and not alternatives:
                return node, entity
    return None


def _of_type(members: list[tuple[Node, Entity]], type_: str) -> str:
    who = sorted({f"{e.kind.value} in {node.fqn}" for node, e in members if e.type == type_})
    shown = ", ".join(who[:3]) + (f" and {len(who) - 3} more" if len(who) > 3 else "")
    return f"{type_} ({shown})"


def _names_used_twice(nodes: Iterable[Node]) -> Iterator[Finding]:
    """RW307. A name with a hole may well be two names."""
    for name, members in _grouped((node.fqn, node) for node in nodes):
        if len(members) > 1 and "*" not in name:
            processes = ", ".join(sorted({node.process for node in members}))
            yield Finding("RW307", f"{len(members)} nodes are named {name} (in {processes})", members[1].defined_at)


def _grouped(pairs: Iterable[tuple[_K, _V]]) -> list[tuple[_K, list[_V]]]:
    groups: dict[_K, list[_V]] = defaultdict(list)
    for key, value in pairs:
        groups[key].append(value)
    return list(groups.items())
