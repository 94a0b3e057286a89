# SPDX-License-Identifier: Apache-2.0
"""A law: the policy that rosward writes of a system is, held against the same system, without a difference. Always.

And: a node of which nothing is known shares neither label nor enclave nor profile with another one.
"""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Final

import pytest
from hypothesis import given
from hypothesis import strategies as st
from outputs.networks import entity, node

from rosward.enclaves.grants import enclaves
from rosward.network.checks import UnknownNames
from rosward.network.connect import connect
from rosward.network.contexts import with_enclaves
from rosward.network.enclave_mode import EnclaveMode
from rosward.network.graph import Network
from rosward.network.labels import labelled
from rosward.outputs.policies.permissions import permissions
from rosward.outputs.policies.policy import policy_xml
from rosward.policies.compare import compare
from rosward.policies.read import read_policy
from rosward.ros.entities import Entity, EntityKind, Interface, Node, Resolution

NAMES: Final = ("/scan", "/r1/scan", "/r_*/scan", "/r1/*", "/*", "/map", "/a[b]", "/r1/fib")
NODES: Final = ("/talker", "/r1/talker", "/*", "/r1/*", "/r_*/talker", "/*/talker", "/r_*/*")
PROGRAMS: Final = ("acme/driver", "acme/camera", "other/driver", "other/1st-try.py")


@st.composite
def entities(draw: st.DrawFn) -> Entity:
    name = draw(st.sampled_from(NAMES))
    kind = draw(st.sampled_from(list(EntityKind)))
    topic = kind in (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)
    wholly = Resolution.UNKNOWN if name.endswith("/*") else Resolution.PATTERN
    return entity(
        kind,
        name,
        conditional=draw(st.booleans()),
        ros_prefix=not topic or draw(st.integers(0, 5)) > 0,
        resolution=draw(st.sampled_from((wholly, Resolution.UNKNOWN))) if "*" in name else Resolution.EXACT,
    )


@st.composite
def started(draw: st.DrawFn, number: int) -> Node:
    fqn = draw(st.sampled_from(NODES))
    program = draw(st.sampled_from(PROGRAMS))
    nameless = fqn.endswith("/*")
    unknown = draw(st.booleans())
    made = node(
        fqn,
        *(() if unknown else draw(st.lists(entities(), max_size=4))),
        package=program.partition("/")[0],
        executable=program.partition("/")[2],
        process=f"{program}#{number}" if draw(st.integers(0, 3)) else "acme/pair",
        given_enclave=draw(st.sampled_from((None, None, None, "/given", "/talker", "/r_*/talker", "bad"))),
        resolution=Resolution.UNKNOWN if nameless else Resolution.PATTERN if "*" in fqn else Resolution.EXACT,
        interface=Interface.UNKNOWN if unknown else Interface.ANALYSED,
    )
    own = tuple(
        replace(e, resolution=Resolution.UNKNOWN) if nameless and e.system and "*" in e.name else e
        for e in made.entities
    )
    return replace(made, entities=own)


@st.composite
def systems(draw: st.DrawFn) -> Network:
    made = [draw(started(number)) for number in range(1, draw(st.integers(2, 8)))]
    placed, _ = with_enclaves(labelled(made), draw(st.sampled_from(list(EnclaveMode))))
    return connect("jazzy", placed)


def differences(network: Network, text: str) -> list[str]:
    with tempfile.NamedTemporaryFile("w", suffix=".xml", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        policy = read_policy([file.name])
    assert not policy.findings
    return [f"{each.enclave}: {each.finding.code} {each.finding.message}" for each in compare(network, policy)]


@given(systems(), st.sampled_from(("deny", "wildcard")))
@pytest.mark.slow
def test_its_own_policy_has_no_difference(network: Network, unknown: UnknownNames) -> None:
    assert differences(network, policy_xml(network, unknown=unknown)) == []


@pytest.mark.slow
@given(systems(), st.sampled_from(("deny", "wildcard")))
def test_nor_have_the_permissions(network: Network, unknown: UnknownNames) -> None:
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, text in enumerate(permissions(network, unknown=unknown).values()):
            files.append(str(Path(folder) / f"{number}.xml"))
            Path(files[-1]).write_text(text, encoding="utf-8")
        found = compare(network, read_policy(files))
    assert [f"{each.enclave}: {each.finding.message}" for each in found] == []


@given(systems())
def test_who_is_not_known_is_nobody_else(network: Network) -> None:
    unknown = [n for n in network.nodes if n.interface is Interface.UNKNOWN and "*" in n.fqn]
    assert len({n.display_name for n in unknown}) == len(unknown)
    profiles = [p for e in enclaves(network) for p in e.profiles if any(n in p.nodes for n in unknown)]
    assert len(profiles) == len(unknown)
    assert all(len(p.nodes) == 1 for p in profiles)


@given(systems())
def test_without_a_reason_it_shares_no_enclave(network: Network) -> None:
    """What shares an enclave with a nameless node shares its process, or was started in that enclave, or all share `/`."""
    given = {n.process for n in network.nodes if n.given_enclave}
    for one in network.nodes:
        for other in network.nodes:
            if one.label and one is not other and one.enclave == other.enclave and one.enclave != "/":
                assert one.process == other.process or one.process in given or other.process in given
