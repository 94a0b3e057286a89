# SPDX-License-Identifier: Apache-2.0
"""Promise: who else reads our policies reads in them what we wrote: sros2, and, but for actions, the tool of Zenoh.

The rules of both stand in `readers.py`. `ROSWARD_SROS2` may name the folder of the real sros2 (with `lxml` at hand):
then its own code reads, merges and translates the same policies, and must come to the same.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Callable
from importlib import resources
from pathlib import Path
from typing import Final

import pytest
import xmlschema
from outputs.networks import entity, node, pub, sub, talker_and_listener
from sampling import sample

from rosward import Entity, EntityKind, Network
from rosward.enclaves.grants import enclaves
from rosward.network.connect import connect
from rosward.outputs.policies.permissions import permissions
from rosward.outputs.policies.policy import policies, policy_xml

from .readers import Right, Seen, UnreadableError, comments, merged, rights, zenoh_rights
from .systems import NAMES

_SCHEMA: Final = xmlschema.XMLSchema10(str(resources.files("rosward.outputs") / "schemas" / "policy.xsd"))
_REAL: Final = Path(__file__).with_name("real_sros2.py")

_SEEN: Final = {
    EntityKind.PUBLISHER: [("topic", "publish", "")],
    EntityKind.SUBSCRIPTION: [("topic", "subscribe", "")],
    EntityKind.SERVICE_SERVER: [("service", "reply", "")],
    EntityKind.SERVICE_CLIENT: [("service", "request", "")],
    EntityKind.ACTION_SERVER: [
        *(("service", "reply", f"/_action/{name}") for name in ("send_goal", "get_result", "cancel_goal")),
        *(("topic", "publish", f"/_action/{name}") for name in ("feedback", "status")),
    ],
    EntityKind.ACTION_CLIENT: [
        *(("service", "request", f"/_action/{name}") for name in ("send_goal", "get_result", "cancel_goal")),
        *(("topic", "subscribe", f"/_action/{name}") for name in ("feedback", "status")),
    ],
}


def graph(network: Network) -> list[Seen]:
    """What generate_policy finds when the granted entities are there; a hole in a name is a 1."""
    return [
        Seen(profile.namespace, profile.name, enclave.path, element, way, (grant.name + more).replace("*", "1"))
        for enclave in enclaves(network)
        for profile in enclave.profiles
        for grant in profile.grants
        for element, way, more in _SEEN[grant.kind]
    ]


def in_permissions(network: Network) -> dict[str, set[Right]]:
    """Our own permissions, without topics outside the ROS names, which no policy can hold."""
    ways = (("write", "publish"), ("read", "subscribe"))
    return {
        path: {
            (way, topic.text or "")
            for way, element in ways
            for topic in ET.fromstring(document).iterfind(f".//{element}/topics/topic")
            if not (topic.text or "").startswith("/")
        }
        for path, document in permissions(network).items()
    }


def own_rules(policy: str, seen: list[Seen]) -> tuple[str, dict[str, set[Right]]]:
    _SCHEMA.validate(policy)
    text = merged(policy, seen)
    _SCHEMA.validate(text)
    return text, rights(text)


def unharmed(network: Network, text: str, found: dict[str, set[Right]]) -> bool:
    """Whether all rights and comments are there as before, and no others, but for names that a pattern stands for."""
    before = in_permissions(network)
    assert found.keys() == before.keys()
    for path, own in found.items():
        assert own >= before[path], path
        assert own == before[path] or any("*" in topic for _, topic in before[path]), path
    return comments(text) == comments(policy_xml(network))


@pytest.mark.parametrize("name", sample(NAMES, 3))
def test_sros2_reads_and_merges_the_policy_unharmed(
    name: str, read: Callable[[str], list[Network]], tally: Counter[str]
) -> None:
    """Translated, it is our permissions; with the running system merged into it, once or twice, it is the same."""
    for network in with_nodes(read(name)):
        text, found = own_rules(policy_xml(network), [])
        assert found == in_permissions(network)
        assert unharmed(network, text, found)
        text, found = own_rules(policy_xml(network), graph(network))
        assert unharmed(network, text, found)
        assert own_rules(text, graph(network)) == (text, found)
        tally["enclaves read back"] += len(found)


STRANGE: Final = Seen("/", "strange", "/strange", "topic", "subscribe", "/robot1/chatter")


def test_a_node_that_was_not_in_the_sources_is_added_beside_ours() -> None:
    network = talker_and_listener()
    _, found = own_rules(policy_xml(network), [STRANGE])
    added = {("read", "rt/robot1/chatter"), ("read", "ros_discovery_info"), ("write", "ros_discovery_info")}
    assert found == in_permissions(network) | {"/strange": added}


@pytest.mark.skipif("ROSWARD_SROS2" not in os.environ, reason="ROSWARD_SROS2 names no folder of sros2")
def test_the_real_sros2_agrees(read: Callable[[str], list[Network]], tally: Counter[str]) -> None:
    """It validates, translates, merges and sorts by its own schema and stylesheets, and comes to what our rules say."""
    networks = [network for name in NAMES for network in with_nodes(read(name))]
    given = [(policy_xml(n), seen) for n in networks for seen in ([], graph(n), [*graph(n), STRANGE])]
    command = [sys.executable, str(_REAL), os.environ["ROSWARD_SROS2"]]
    done = subprocess.run(command, input=json.dumps(given), capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0, done.stderr
    for (policy, seen), (text, answer) in zip(given, json.loads(done.stdout), strict=True):
        found = {path: {(way, topic) for way, topic in own} for path, own in answer.items()}
        assert found == own_rules(policy, seen)[1]
        assert comments(text) == comments(policy)
        tally["enclaves read back by the real sros2"] += len(found)


def with_nodes(networks: list[Network]) -> list[Network]:
    """Without a node there is no policy."""
    return [network for network in networks if network.nodes]


_BY_ZENOH: Final = {
    EntityKind.PUBLISHER: "publish",
    EntityKind.SUBSCRIPTION: "subscribe",
    EntityKind.SERVICE_SERVER: "reply",
    EntityKind.SERVICE_CLIENT: "request",
}


@pytest.mark.parametrize("name", NAMES)
def test_zenoh_reads_every_topic_and_service_of_the_file_of_an_enclave(
    name: str, read: Callable[[str], list[Network]]
) -> None:
    """Names are absolute and each list has one attribute, so nothing is lost but actions, which it never reads."""
    for network in read(name):
        documents = policies(network)
        for enclave in enclaves(network):
            if any(not profile.grants for profile in enclave.profiles):
                continue
            expected = {
                profile.name: {(_BY_ZENOH[g.kind], g.name[1:]) for g in profile.grants if g.kind in _BY_ZENOH}
                for profile in enclave.profiles
            }
            if len(expected) == len(enclave.profiles):
                assert zenoh_rights(documents[enclave.path]) == expected


def one(*entities: Entity) -> str:
    return policy_xml(connect("jazzy", [node("/ns/a", *entities, system=False)]))


def test_what_zenoh_does_not_read() -> None:
    """Limits of its reader: an action is not there for it, and a node without any rule stops it."""
    assert zenoh_rights(one(entity(EntityKind.ACTION_SERVER, "/dock"), sub("/x"))) == {"a": {("subscribe", "x")}}
    with pytest.raises(UnreadableError):
        zenoh_rights(one())


def test_a_name_in_both_directions_stands_in_two_lists() -> None:
    """In one list with two attributes, the reader of Zenoh would see only one of them."""
    assert zenoh_rights(one(pub("/x"), sub("/x"))) == {"a": {("publish", "x"), ("subscribe", "x")}}
