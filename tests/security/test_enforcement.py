# SPDX-License-Identifier: Apache-2.0
"""Promise: a process with our permissions may make every endpoint of its nodes, and no endpoint of any other node.

For each system: every enclave gets its permissions, signed, and tries every writer and reader that any node of the
system has, and each of their topics the other way. A real DDS decides. What it has to decide is not read from our
permissions, but from the entities (`endpoints.py`).
"""

from __future__ import annotations

import fnmatch
import re
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import replace

import pytest
from outputs.networks import fleet, node, pub, sub
from sampling import sample

from rosward import Network, Resolution
from rosward.enclaves.compact import compact
from rosward.enclaves.grants import Enclave, enclaves
from rosward.enclaves.privileges import Privilege, on_dds
from rosward.enclaves.size import LARGEST, size_findings
from rosward.network.checks import UnknownNames
from rosward.network.connect import connect
from rosward.outputs.policies.permissions import permissions, permissions_xml
from rosward.policies.rights import Direction

from .cyclone import Cyclone, DdsError
from .endpoints import Endpoint, endpoints_of, turned
from .keystore import Keystore
from .systems import NAMES

STRING = "std_msgs::msg::dds_::String_"
_WAY = {Direction.PUBLISH: "write", Direction.SUBSCRIBE: "read"}
FILLINGS = ("1", "", "x/y", "_")


def everything(networks: Iterable[Network]) -> list[Endpoint]:
    """What can be tried: the endpoints of all nodes, both ways. A hole in a name is filled with several texts."""
    found = endpoints_of(*(n for network in networks for n in network.nodes))
    filled = {e._replace(topic=e.topic.replace("*", text)) for e in found for text in FILLINGS}
    return sorted(filled | {turned(e) for e in filled})


def rightful(enclave: Enclave, tried: Iterable[Endpoint]) -> set[Endpoint]:
    """What of this the nodes of an enclave have: the same names, or names that a pattern stands for."""
    own = endpoints_of(*(n for profile in enclave.profiles for n in profile.nodes))
    plain = {(e.way, e.topic) for e in own}
    patterns = [(e.way, re.compile(fnmatch.translate(e.topic))) for e in own if "*" in e.topic]
    return {
        e
        for e in tried
        if (e.way, e.topic) in plain or any(e.way == way and one.fullmatch(e.topic) for way, one in patterns)
    }


def enforced(
    dds: Cyclone, keystore: Keystore, network: Network, tried: list[Endpoint], unknown: UnknownNames = "deny"
) -> dict[str, set[Endpoint]]:
    """What DDS lets each enclave make of all that is tried."""
    allowed: dict[str, set[Endpoint]] = {}
    for path, document in permissions(network, keystore.domain, unknown=unknown).items():
        with dds.participant(keystore.domain, keystore.enclave(path, document)) as participant:
            allowed[path] = {endpoint for endpoint in tried if participant.may(endpoint)}
    return allowed


@pytest.mark.parametrize("name", sample(NAMES, 4))
def test_each_node_may_do_what_it_does_and_nothing_else(
    name: str, read: Callable[[str], list[Network]], dds: Cyclone, keystore: Keystore, tally: Counter[str]
) -> None:
    networks = read(name)
    tried = everything(networks)
    for network in networks:
        allowed = enforced(dds, keystore, network, tried)
        for enclave in enclaves(network):
            expected = rightful(enclave, tried)
            assert allowed[enclave.path] == expected, enclave.path
            tally["policies enforced"] += 1
            tally["endpoints allowed"] += len(expected)
            tally["endpoints refused"] += len(tried) - len(expected)


def test_an_unknown_name_is_denied_or_is_any_name(dds: Cyclone, keystore: Keystore) -> None:
    lost = pub("/ns/*", None, resolution=Resolution.UNKNOWN)
    network = connect("jazzy", [node("/ns/a", lost, sub("/in"), system=False)])
    tried = [
        Endpoint("read", "rt/in", STRING),
        Endpoint("write", "rt/ns/x", STRING),
        Endpoint("write", "rt/anything/else", STRING),
        Endpoint("read", "rt/ns/x", STRING),
        Endpoint("write", "rq/ns/xRequest", STRING),
    ]
    assert enforced(dds, keystore, network, tried) == {"/ns/a": {tried[0]}}
    assert enforced(dds, keystore, network, tried, "wildcard") == {"/ns/a": set(tried[:3])}


@pytest.mark.parametrize(
    ("pattern", "matched", "not_matched"),
    [
        ("/robot_*/cmd", ["/robot_1/cmd", "/robot_/cmd", "/robot_1/x/cmd"], ["/robot/cmd", "/robot_1/cmdx", "/Robot_1/cmd"]),
        ("/deep/*", ["/deep/a", "/deep/a/b", "/deep/"], ["/deep", "/deeper/a", "/x/deep/a"]),
        ("/*/end", ["/a/end", "/a/b/end"], ["/end", "/a/end/b", "/a/bend_"]),
        ("/a*b*c", ["/abc", "/aXbYc", "/a/b/c"], ["/ab", "/acb", "/abcd"]),
        ("/plain", ["/plain"], ["/plain/x", "/plai", "/plainx"]),
    ],
)  # fmt: skip
def test_a_star_matches_any_text(
    pattern: str, matched: list[str], not_matched: list[str], dds: Cyclone, keystore: Keystore
) -> None:
    """As docs/limits.md and RW302 say: `*` crosses `/`, and it may stand for nothing."""
    network = connect("jazzy", [node("/a", pub(pattern, resolution=Resolution.PATTERN), system=False)])
    tried = [Endpoint("write", f"rt{name}", STRING) for name in (*matched, *not_matched)]
    (allowed,) = enforced(dds, keystore, network, tried).values()
    assert [e.topic[2:] for e in tried if e in allowed] == matched


@pytest.mark.parametrize("name", ["/a[bc]", "/a?", "/[!x]", "/a\\*"])
def test_what_is_special_to_dds_grants_nothing(name: str, dds: Cyclone, keystore: Keystore) -> None:
    """No name of ROS holds these, but a source may; DDS would read them as patterns of other names."""
    network = connect("jazzy", [node("/n", pub(name), pub("/ok"), system=False)])
    tried = [Endpoint("write", f"rt{text}", STRING) for text in ("/ab", "/ax", "/b", "/a", "/ok")]
    (allowed,) = enforced(dds, keystore, network, tried).values()
    assert allowed == {tried[-1]}


def test_a_node_with_nothing_starts(dds: Cyclone, keystore: Keystore) -> None:
    """The one topic of the RMW is all that it needs, and without that no participant can be made at all."""
    network = connect("jazzy", [node("/n", system=False)])
    with dds.participant(keystore.domain, keystore.enclave("/n", permissions_xml(network, "/n", keystore.domain))) as n:
        assert n.may(Endpoint("write", "ros_discovery_info", STRING))
        assert not n.may(Endpoint("write", "rt/rosout", STRING))
    bare = permissions_xml(network, "/n", keystore.domain, ros_discovery_info=False)
    with (
        pytest.raises(DdsError, match="not allowed to create participant"),
        dds.participant(keystore.domain, keystore.enclave("/n", bare)),
    ):
        pass


def test_the_size_of_signed_permissions_is_estimated_from_above(keystore: Keystore) -> None:
    """RW304 is for the file that is sent: signing adds an envelope, and a carriage return to each line."""
    sizes = {}
    for nodes in range(60, 80):
        network = connect("jazzy", [node(f"/n{i}", pub("/out"), enclave="/all") for i in range(nodes)])
        signed = keystore.enclave("/all", permissions_xml(network, "/all", keystore.domain)) / "permissions.p7s"
        sizes[signed.stat().st_size] = bool(size_findings(network.nodes))
    assert {told for size, told in sizes.items() if size > LARGEST} == {True}
    assert {told for size, told in sizes.items() if size < LARGEST - 1024} == {False}


@pytest.mark.parametrize("largest", [7_000, 4_300, 4_000])
def test_patterns_in_place_of_names_allow_what_is_needed_and_what_is_told(
    largest: int, dds: Cyclone, keystore: Keystore, tally: Counter[str]
) -> None:
    """`--compact`: a robot of a fleet in one enclave, the other robot's nodes in theirs; the fewer bytes, the wider the patterns."""
    nodes = [replace(n, enclave="/robot1") if n.fqn.startswith("/robot1/") else n for n in fleet(robots=2).nodes]
    network = connect("jazzy", nodes)
    widened = compact(network.nodes, largest=largest).widened["/robot1"]
    (enclave,) = (e for e in enclaves(network) if e.path == "/robot1")
    tried = everything([network])
    more = {Privilege(each.kind, name) for each in widened for name in each.more}
    told = [(_WAY[r.direction], re.compile(fnmatch.translate(r.name))) for each in more for r in on_dds(each)]
    patterns = [
        (_WAY[r.direction], re.compile(fnmatch.translate(r.name)))
        for w in widened
        for r in on_dds(Privilege(w.kind, w.name))
    ]
    document = permissions(network, keystore.domain, widened={"/robot1": widened})["/robot1"]
    with dds.participant(keystore.domain, keystore.enclave("/robot1", document)) as participant:
        allowed = {endpoint for endpoint in tried if participant.may(endpoint)}
    needed = rightful(enclave, tried)
    assert needed <= allowed
    assert {e for e in tried if any(way == e.way and p.fullmatch(e.topic) for way, p in patterns)} <= allowed
    assert all(any(way == e.way and p.fullmatch(e.topic) for way, p in told) for e in allowed - needed)
    tally["policies enforced"] += 1
    tally["endpoints allowed by patterns"] += len(allowed)
    tally["of these not needed, and told"] += len(allowed - needed)
