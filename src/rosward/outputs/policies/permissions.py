# SPDX-License-Identifier: Apache-2.0
"""The DDS Security permissions of one enclave, unsigned: what sros2 makes of a policy, for those who sign by other
means.

    publisher /chatter         ->  publish rt/chatter
    service client /add        ->  publish rq/addRequest, subscribe rr/addReply
    action server /dock        ->  three services and two topics under /dock/_action

Two things that sros2 takes from the machine are arguments here: the domain and the time of validity. The topic
`ros_discovery_info`, which every RMW on DDS needs, is in the permissions unless asked otherwise; so is a topic outside
the ROS name space, which a policy cannot express but DDS can.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Final

from rosward.enclaves.grants import NOT_WIDENED, Enclave, Profile, enclave_named, enclaves
from rosward.enclaves.widened import Widenings
from rosward.network.checks import UnknownNames
from rosward.network.graph import Network
from rosward.outputs.writing import File, Material, of_enclaves
from rosward.policies.rights import DISCOVERY, Direction, Right, rights_of
from rosward.records import NamedTuple
from rosward.safe import xml_attribute, xml_text

__all__ = ["NOT_AFTER", "NOT_BEFORE", "files", "permissions", "permissions_xml"]

NOT_BEFORE: Final = "2020-01-01T00:00:00"
NOT_AFTER: Final = "2049-12-31T23:59:59"
"""Wide and fixed, so that the same sources give the same bytes; the certificate sets the narrower limit."""

_SCHEMA: Final = "http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd"


def files(material: Material) -> Iterator[File]:
    """The files of the format `permissions`."""
    documents = permissions(material.network, unknown=material.unknown, widened=material.widened)
    yield from of_enclaves("permissions", documents, "permissions.xml")


def permissions_xml(
    network: Network,
    enclave: str,
    domain_id: int = 0,
    *,
    not_before: str = NOT_BEFORE,
    not_after: str = NOT_AFTER,
    ros_discovery_info: bool = True,
    unknown: UnknownNames = "deny",
    widened: Widenings = NOT_WIDENED,
) -> str:
    """The permissions of one enclave of the network; ValueError if there is none such. Dates are `xs:dateTime`."""
    chosen = enclave_named(network, enclave, unknown, widened)
    return _document(chosen, _Terms(domain_id, not_before, not_after, ros_discovery_info))


def permissions(
    network: Network,
    domain_id: int = 0,
    *,
    not_before: str = NOT_BEFORE,
    not_after: str = NOT_AFTER,
    ros_discovery_info: bool = True,
    unknown: UnknownNames = "deny",
    widened: Widenings = NOT_WIDENED,
) -> dict[str, str]:
    """The permissions of every enclave, by its path."""
    terms = _Terms(domain_id, not_before, not_after, ros_discovery_info)
    return {enclave.path: _document(enclave, terms) for enclave in enclaves(network, unknown, widened)}


class _Terms(NamedTuple):
    """What holds for the whole document."""

    domain_id: int = 0
    not_before: str = NOT_BEFORE
    not_after: str = NOT_AFTER
    ros_discovery_info: bool = True


def _document(enclave: Enclave, terms: _Terms) -> str:
    rights = {right for profile in enclave.profiles for right in _rights(profile)}
    discovery = DISCOVERY if terms.ros_discovery_info else ()
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="{_SCHEMA}">',
        "  <permissions>",
        f'    <grant name="{xml_attribute(enclave.path)}">',
        f"      <subject_name>CN={xml_text(enclave.path)}</subject_name>",
        "      <validity>",
        f"        <not_before>{xml_text(terms.not_before)}</not_before>",
        f"        <not_after>{xml_text(terms.not_after)}</not_after>",
        "      </validity>",
        *_rule(terms.domain_id, rights),
        *_rule(terms.domain_id, discovery),
        "      <default>DENY</default>",
        "    </grant>",
        "  </permissions>",
        "</dds>",
    ]
    return "\n".join(lines) + "\n"


def _rule(domain_id: int, rights: Collection[Right]) -> Iterator[str]:
    if not rights:
        return
    yield "      <allow_rule>"
    yield "        <domains>"
    yield f"          <id>{domain_id}</id>"
    yield "        </domains>"
    for direction in Direction:
        topics = sorted(right.name for right in rights if right.direction is direction)
        if topics:
            yield f"        <{direction.value}>"
            yield "          <topics>"
            yield from (f"            <topic>{xml_text(topic)}</topic>" for topic in topics)
            yield "          </topics>"
            yield f"        </{direction.value}>"
    yield "      </allow_rule>"


def _rights(profile: Profile) -> Iterator[Right]:
    """What a profile needs on DDS, with the topics outside the ROS namespace, which a policy leaves out."""
    for grant in profile.grants:
        yield from rights_of(grant.kind, grant.name)
    for omission in profile.omissions:
        if omission.dds_name:
            yield from rights_of(omission.entity.kind, omission.entity.name, ros=False)
