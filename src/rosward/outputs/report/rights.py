# SPDX-License-Identifier: Apache-2.0
"""Which line of which policy gives which entity its right?

    publisher e0 /a/chatter  ->  rule r0 of enclave c0, written as `<topic>/a/chatter</topic>`

The lines are those of the policy file itself, since the writer of policies says of each line which right it gives.
"""

from __future__ import annotations

from typing import Final

from rosward.enclaves.grants import NOT_WIDENED, Enclave, Grant, Profile, enclaves
from rosward.enclaves.widened import Widenings
from rosward.network.checks import UnknownNames
from rosward.network.graph import Network
from rosward.outputs.policies.policy import policy_lines
from rosward.outputs.report.numbered import Numbered
from rosward.outputs.report.plain import harmless
from rosward.policies.elements import ELEMENTS
from rosward.records import NamedTuple

__all__ = ["NONE", "DocumentRights", "EntityRight", "rights"]


class EntityRight(NamedTuple):
    """The rule that an entity causes; None, and why, where it causes none."""

    rule: str | None
    why_not: str


class DocumentRights(NamedTuple):
    """The enclaves and rules of the document, the enclave of each node, and the right of each entity, both by their ids."""

    enclaves: list[object]
    rules: list[object]
    enclave_of: dict[str, str]
    right_of: dict[str, EntityRight]


NONE: Final = EntityRight(None, "")


def rights(
    network: Network, numbers: Numbered, unknown: UnknownNames, widened: Widenings = NOT_WIDENED
) -> DocumentRights:
    """Number the rules in the order in which the policies write them.

    Where patterns take the place of names, an entity may need several rules (those of the parts of an action): the first stands for all.
    """
    found = DocumentRights([], [], {}, {})
    node_ids = {id(member.node): member.id for member in numbers.members}
    for number, enclave in enumerate(enclaves(network, unknown, widened)):
        enclave_id = f"c{number}"
        nodes = [node_ids[id(node)] for profile in enclave.profiles for node in profile.nodes]
        found.enclave_of.update(dict.fromkeys(nodes, enclave_id))
        found.enclaves.append(
            {
                "id": enclave_id,
                "path": harmless(enclave.path),
                "nodes": sorted(nodes, key=lambda node: int(node[1:])),
                "policy": _lines(enclave, enclave_id, numbers, found),
            }
        )
        for profile in enclave.profiles:
            for omission in profile.omissions:
                found.right_of[numbers.entity_ids[id(omission.entity)]] = EntityRight(None, omission.why)
            _share(profile, numbers, found)
    return found


def _share(profile: Profile, numbers: Numbered, found: DocumentRights) -> None:
    """Equal entities of nodes of one name have one right; that of a pattern may name the first of them alone."""
    if len(profile.nodes) > 1:
        ids = [(entity, numbers.entity_ids[id(entity)]) for node in profile.nodes for entity in node.entities]
        rights = {entity: found.right_of[id_] for entity, id_ in ids if id_ in found.right_of}
        found.right_of.update({id_: rights[entity] for entity, id_ in ids if entity in rights})


def _lines(enclave: Enclave, enclave_id: str, numbers: Numbered, found: DocumentRights) -> list[object]:
    lines: list[object] = []
    for line in policy_lines([enclave]):
        rule = None if line.grant is None else _rule(line.grant, enclave_id, numbers, found)
        lines.append({"text": line.text, "rule": rule})
    return lines


def _rule(grant: Grant, enclave_id: str, numbers: Numbered, found: DocumentRights) -> str:
    rule = f"r{len(found.rules)}"
    entities = [numbers.entity_ids[id(entity)] for entity in grant.entities]
    text = harmless(f"{ELEMENTS[grant.kind].verb} {grant.name}")
    found.rules.append({"id": rule, "enclave": enclave_id, "text": text, "entities": entities})
    for entity in entities:
        found.right_of.setdefault(entity, EntityRight(rule, ""))
    return rule
