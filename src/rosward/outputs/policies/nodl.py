# SPDX-License-Identifier: Apache-2.0
"""How does the interface of one node look in the Node Definition Language?

    Node('/left', 'talker', …)  ->  nodl_version: 2
                                    publishers:
                                    - {name: chatter, type: std_msgs/msg/String, qos: {history: KEEP_LAST, depth: 10, …}}

The form is that of NoDL 2 (github.com/ros-tooling/nodl, nodl_schema). A document speaks of any instance of a node, so names below the
node are written `~/x`, names below its namespace `x`; what the client library creates by itself is left out. What NoDL has no form for,
such as a name of which a part is not known, stands in comments at the head.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, Final

import yaml

from rosward.ros.entities import Entity, EntityKind, Node, Parameter, Qos
from rosward.safe import printable

__all__ = ["nodl_document"]

_SECTIONS: Final = (
    (EntityKind.PUBLISHER, "publishers"),
    (EntityKind.SUBSCRIPTION, "subscriptions"),
    (EntityKind.SERVICE_SERVER, "service_servers"),
    (EntityKind.SERVICE_CLIENT, "service_clients"),
    (EntityKind.ACTION_SERVER, "action_servers"),
    (EntityKind.ACTION_CLIENT, "action_clients"),
)
_TOPICS: Final = (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)
_NAME: Final = re.compile(r"[A-Za-z]|[/~A-Za-z][A-Za-z0-9_/]*[A-Za-z0-9_]")
_TYPE: Final = re.compile(r"[a-zA-Z][a-zA-Z0-9_]*(/(msg|srv|action))?/[A-Z][a-zA-Z0-9]*")
_POLICIES: Final = {
    "history": frozenset(("KEEP_LAST", "KEEP_ALL", "SYSTEM_DEFAULT")),
    "reliability": frozenset(("RELIABLE", "BEST_EFFORT", "SYSTEM_DEFAULT", "BEST_AVAILABLE")),
    "durability": frozenset(("TRANSIENT_LOCAL", "VOLATILE", "SYSTEM_DEFAULT", "BEST_AVAILABLE")),
}
_UNKNOWN_QOS: Final = "QoS is unknown"
_TYPES: Final = {
    "bool": "bool",
    "integer": "int",
    "double": "double",
    "string": "string",
    "byte_array": "byte_array",
    "bool_array": "bool_array",
    "integer_array": "int_array",
    "double_array": "double_array",
    "string_array": "string_array",
}
_IMPLICIT: Final = frozenset(("use_sim_time", "start_type_description_service"))


def nodl_document(node: Node) -> str:
    """The NoDL 2 document of a node, as YAML."""
    left_out: list[str] = []
    document: dict[str, Any] = {"nodl_version": 2}
    program = "/".join(part for part in (node.package, node.executable) if part)
    document["description"] = (
        f"Node {node.name}{f' of {program}' if program else ''}, extracted from its source by rosward."
    )
    parameters = {p.name: _parameter(p) for p in node.parameters if _is_described(p, left_out)}
    if node.assumed:
        left_out.append(f"Assumed: nothing in the sources creates {node.process}.")
    if parameters:
        document["parameters"] = parameters
    for kind, section in _SECTIONS:
        found = [_endpoint(e, node) for e in _distinct(node.of_kind(kind)) if _is_describable(e, node, left_out)]
        if found:
            document[section] = found
    head = [f"# {printable(line)}" for line in left_out]
    body = yaml.safe_dump(document, sort_keys=False, width=120, allow_unicode=True)
    return "\n".join([*head, body]) if head else body


def _distinct(entities: Iterable[Entity]) -> list[Entity]:
    """The entities that the code of the node creates, each name and type once, those that are certain first."""
    found: dict[tuple[str, str | None], Entity] = {}
    for entity in sorted(entities, key=lambda e: e.conditional):
        if not entity.system:
            found.setdefault((entity.name, entity.type), entity)
    return sorted(found.values(), key=lambda e: (e.name, e.type or ""))


def _is_describable(entity: Entity, node: Node, left_out: list[str]) -> bool:
    """Whether NoDL has a form for an entity; a remark where it has none."""
    if not _NAME.fullmatch(_relative(entity.name, node)):
        left_out.append(f"Not described: {entity.kind.value} {entity.name}, whose name is not completely known.")
    elif entity.type is None:
        left_out.append(f"Not described: {entity.kind.value} {entity.name}, whose type is unknown.")
    elif not _TYPE.fullmatch(entity.type):
        left_out.append(f"Not described: {entity.kind.value} {entity.name} of type {entity.type}.")
    elif not entity.ros_prefix:
        left_out.append(f"Not described: {entity.kind.value} {entity.name}, outside the ROS namespace.")
    else:
        return True
    return False


def _endpoint(entity: Entity, node: Node) -> dict[str, Any]:
    remarks = ["only in some executions"] if entity.conditional else []
    result: dict[str, Any] = {"name": _relative(entity.name, node), "type": entity.type}
    if entity.kind in _TOPICS:
        result["qos"], known = _qos(entity.qos)
        if not known:
            remarks.append(_UNKNOWN_QOS)
    if remarks:
        result["description"] = "; ".join(remarks)
    return result


def _relative(name: str, node: Node) -> str:
    """`~/x` below the node, `x` below its namespace, else the full name."""
    if name.startswith(f"{node.fqn}/"):
        return "~" + name[len(node.fqn) :]
    prefix = "/" if node.namespace == "/" else f"{node.namespace}/"
    return name[len(prefix) :] if name.startswith(prefix) and name != prefix else name


def _qos(qos: Qos | None) -> tuple[dict[str, Any], bool]:
    """The profile, with SYSTEM_DEFAULT for what is not known, and whether all of it that NoDL demands is."""
    words = {policy: (getattr(qos, policy, None) or "").upper() for policy in _POLICIES}
    words = {policy: word for policy, word in words.items() if word in _POLICIES[policy]}
    depth = qos.depth if qos is not None else None
    known = "reliability" in words and "history" in words
    if words.get("history") == "KEEP_LAST" and not (depth and depth > 0):
        del words["history"]  # no number: a depth of 0 is that of the middleware
        known = known and depth == 0
    result: dict[str, Any] = {"history": words.get("history", "SYSTEM_DEFAULT")}
    if result["history"] == "KEEP_LAST":
        result["depth"] = depth
    result["reliability"] = words.get("reliability", "SYSTEM_DEFAULT")
    if "durability" in words:
        result["durability"] = words["durability"]
    return result, known


def _is_described(parameter: Parameter, left_out: list[str]) -> bool:
    """Whether a parameter is one of the node's own and of a known type; a remark where its type is not known."""
    if parameter.name in _IMPLICIT or parameter.name.startswith("qos_overrides."):
        return False
    if _type(parameter) is None:
        left_out.append(f"Not described: parameter {parameter.name}, whose type is unknown.")
        return False
    return True


def _type(parameter: Parameter) -> str | None:
    if parameter.type is not None:
        return _TYPES.get(parameter.type)
    if isinstance(parameter.default, (list, tuple)):
        inner = {type(v) for v in parameter.default}
        for kind, word in ((bool, "bool_array"), (int, "int_array"), (float, "double_array"), (str, "string_array")):
            if inner == {kind}:
                return word
    return None


def _parameter(parameter: Parameter) -> dict[str, Any]:
    result: dict[str, Any] = {"type": _type(parameter)}
    default = parameter.default
    if isinstance(default, (bool, int, float, str)):
        result["default_value"] = default
    elif isinstance(default, (list, tuple)) and None not in default:
        result["default_value"] = list(default)
    return result
