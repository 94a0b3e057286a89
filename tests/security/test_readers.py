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
from collections.abc import Callable, Iterator
from importlib import resources
from pathlib import Path
from typing import Any, Final

import pytest
import xmlschema
from outputs.networks import entity, node, pub, sub, talker_and_listener

from rosward import Entity, EntityKind, Network
from rosward.network.connect import connect
from rosward.outputs.grants import enclaves
from rosward.outputs.permissions import permissions
from rosward.outputs.policy import policies, policy_xml

from .readers import Right, Seen, UnreadableError, comments, merged, rights, zenoh_rights
from .systems import NAMES, systems

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


def real_sros2(policy: str, seen: list[Seen]) -> tuple[str, dict[str, set[Right]]]:
    command = [sys.executable, str(_REAL), os.environ["ROSWARD_SROS2"]]
    given = json.dumps({"policy": policy, "graph": seen})
    done = subprocess.run(command, input=given, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    answer: dict[str, Any] = json.loads(done.stdout)
    return answer["merged"], {path: {(w, t) for w, t in found} for path, found in answer["rights"].items()}


READERS: Final = [
    pytest.param(own_rules, id="rules"),
    pytest.param(
        real_sros2,
        id="sros2",
        marks=pytest.mark.skipif("ROSWARD_SROS2" not in os.environ, reason="ROSWARD_SROS2 names no sros2"),
    ),
]
Reader = Callable[[str, list[Seen]], tuple[str, dict[str, set[Right]]]]


def networks(name: str, folder: Path) -> Iterator[Network]:
    return (network for network in systems(name, folder) if network.nodes)


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("name", NAMES)
def test_sros2_reads_in_the_policy_what_is_in_the_permissions(
    name: str, reader: Reader, tmp_path: Path, tally: Counter[str]
) -> None:
    for network in networks(name, tmp_path):
        policy = policy_xml(network)
        text, found = reader(policy, [])
        assert found == in_permissions(network)
        assert comments(text) == comments(policy)
        tally[f"enclaves read back by {reader.__name__}"] += len(found)


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("name", NAMES)
def test_merging_the_running_system_into_it_changes_nothing_that_was_granted(
    name: str, reader: Reader, tmp_path: Path
) -> None:
    for network in networks(name, tmp_path):
        policy = policy_xml(network)
        text, found = reader(policy, graph(network))
        before = in_permissions(network)
        assert found.keys() == before.keys()
        for path, own in found.items():
            assert own >= before[path]
            assert own == before[path] or any("*" in topic for _, topic in before[path]), path
        assert comments(text) == comments(policy)
        again, still = reader(text, graph(network))
        assert (again, still) == (text, found)


@pytest.mark.parametrize("reader", READERS)
def test_a_node_that_was_not_in_the_sources_is_added_beside_ours(reader: Reader) -> None:
    network = talker_and_listener()
    strange = Seen("/", "strange", "/strange", "topic", "subscribe", "/robot1/chatter")
    _, found = reader(policy_xml(network), [strange])
    added = {("read", "rt/robot1/chatter"), ("read", "ros_discovery_info"), ("write", "ros_discovery_info")}
    assert found == in_permissions(network) | {"/strange": added}


_BY_ZENOH: Final = {
    EntityKind.PUBLISHER: "publish",
    EntityKind.SUBSCRIPTION: "subscribe",
    EntityKind.SERVICE_SERVER: "reply",
    EntityKind.SERVICE_CLIENT: "request",
}


@pytest.mark.parametrize("name", NAMES)
def test_zenoh_reads_every_topic_and_service_of_the_file_of_an_enclave(name: str, tmp_path: Path) -> None:
    """Names are absolute and each list has one attribute, so nothing is lost but actions, which it never reads."""
    for network in networks(name, tmp_path):
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
