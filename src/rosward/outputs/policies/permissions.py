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

from collections.abc import Iterable, Iterator
from typing import Final, NamedTuple

from rosward.enclaves.grants import NOT_WIDENED, Enclave, Profile, enclave_named, enclaves
from rosward.enclaves.widened import Widenings
from rosward.network.checks import UnknownNames
from rosward.network.graph import Network
from rosward.outputs.writing import File, Material, of_enclaves
from rosward.ros.entities import EntityKind
from rosward.safe import xml_attribute, xml_text

__all__ = ["NOT_AFTER", "NOT_BEFORE", "files", "permissions", "permissions_xml"]

NOT_BEFORE: Final = "2020-01-01T00:00:00"
NOT_AFTER: Final = "2049-12-31T23:59:59"
"""Wide and fixed, so that the same sources give the same bytes; the certificate sets the narrower limit."""

_SCHEMA: Final = "http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd"
_ACTION_SERVICES: Final = ("cancel_goal", "get_result", "send_goal")
_ACTION_TOPICS: Final = ("feedback", "status")


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
    publish = sorted({topic for profile in enclave.profiles for topic in _publishes(profile)})
    subscribe = sorted({topic for profile in enclave.profiles for topic in _subscribes(profile)})
    discovery = ["ros_discovery_info"] if terms.ros_discovery_info else []
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
        *_rule(terms.domain_id, publish, subscribe),
        *_rule(terms.domain_id, discovery, discovery),
        "      <default>DENY</default>",
        "    </grant>",
        "  </permissions>",
        "</dds>",
    ]
    return "\n".join(lines) + "\n"


def _rule(domain_id: int, publish: list[str], subscribe: list[str]) -> Iterator[str]:
    if not publish and not subscribe:
        return
    yield "      <allow_rule>"
    yield "        <domains>"
    yield f"          <id>{domain_id}</id>"
    yield "        </domains>"
    for element, topics in (("publish", publish), ("subscribe", subscribe)):
        if topics:
            yield f"        <{element}>"
            yield "          <topics>"
            yield from (f"            <topic>{xml_text(topic)}</topic>" for topic in topics)
            yield "          </topics>"
            yield f"        </{element}>"
    yield "      </allow_rule>"


def _publishes(profile: Profile) -> Iterator[str]:
    for grant in profile.grants:
        match grant.kind:
            case EntityKind.PUBLISHER:
                yield f"rt{grant.name}"
            case EntityKind.SERVICE_CLIENT:
                yield f"rq{grant.name}Request"
            case EntityKind.SERVICE_SERVER:
                yield f"rr{grant.name}Reply"
            case EntityKind.ACTION_CLIENT:
                yield from _requests(grant.name)
            case EntityKind.ACTION_SERVER:
                yield from _replies(grant.name)
            case EntityKind.SUBSCRIPTION:
                pass
    yield from _outside_ros(profile, EntityKind.PUBLISHER)


def _subscribes(profile: Profile) -> Iterator[str]:
    for grant in profile.grants:
        match grant.kind:
            case EntityKind.SUBSCRIPTION:
                yield f"rt{grant.name}"
            case EntityKind.SERVICE_CLIENT:
                yield f"rr{grant.name}Reply"
            case EntityKind.SERVICE_SERVER:
                yield f"rq{grant.name}Request"
            case EntityKind.ACTION_CLIENT:
                yield from _replies(grant.name)
            case EntityKind.ACTION_SERVER:
                yield from _requests(grant.name)
            case EntityKind.PUBLISHER:
                pass
    yield from _outside_ros(profile, EntityKind.SUBSCRIPTION)


def _requests(action: str) -> Iterable[str]:
    return (f"rq{action}/_action/{service}Request" for service in _ACTION_SERVICES)


def _replies(action: str) -> Iterator[str]:
    yield from (f"rr{action}/_action/{service}Reply" for service in _ACTION_SERVICES)
    yield from (f"rt{action}/_action/{topic}" for topic in _ACTION_TOPICS)


def _outside_ros(profile: Profile, kind: EntityKind) -> Iterable[str]:
    """On DDS, such a topic is called just as in ROS, the first `/` included."""
    return (o.entity.name for o in profile.omissions if o.dds_name and o.entity.kind is kind)
