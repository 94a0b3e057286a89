# SPDX-License-Identifier: Apache-2.0
"""Patterns in place of names: nothing that was allowed is lost, all that is new is told, and nothing is widened without need."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples
from outputs.networks import entity, fleet, node, pub, sub

from rosward.enclaves.compact import compact
from rosward.enclaves.privileges import Privilege, by_enclave, on_dds, parts, privileges
from rosward.enclaves.size import LARGEST, signed_size, size_findings
from rosward.enclaves.widened import Widened
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.policies.permissions import permissions
from rosward.outputs.policies.policy import policies, policy_xml
from rosward.policies.match import Pattern
from rosward.policies.read import read_policy
from rosward.ros.entities import EntityKind, Node

from .systems import nodes

TOPICS = (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)


def joint(robots: int) -> Network:
    """A fleet in one enclave: eight robots are 68 KB, twenty 164."""
    made = fleet(robots=robots)
    return connect("jazzy", [replace(n, enclave="/all") for n in made.nodes])


def allowed(document: str) -> dict[str, list[Pattern]]:
    grant = ET.fromstring(document)
    return {
        way: [Pattern(t.text or "") for t in grant.iterfind(f".//{way}/topics/topic")]
        for way in ("publish", "subscribe")
    }


def told(widened: tuple[Widened, ...]) -> set[Privilege]:
    return {Privilege(each.kind, name) for each in widened for name in each.more}


@given(nodes(enclave="/all"), st.integers(3_000, 9_000))
@settings(max_examples=examples(0.8))
def test_the_laws_of_compaction(made: tuple[Node, ...], largest: int) -> None:
    network = connect("jazzy", made)
    compaction = compact(network.nodes, largest=largest)
    before, after = permissions(network), permissions(network, widened=compaction.widened)
    every_name = {part for right in privileges(network.nodes) for part in parts(right) if part.ros}
    for path, members in by_enclave(network.nodes):
        old, new = allowed(before[path]), allowed(after[path])
        size = len(after[path]) + after[path].count("\n") + 2048
        if path not in compaction.widened:
            assert before[path] == after[path], "what is small enough, or cannot be helped, keeps each byte"
            assert (size <= largest) != any(f.code == "RW304" and f" {path} " in f.message for f in compaction.findings)
            continue
        assert len(before[path]) + before[path].count("\n") + 2048 > largest >= size
        for way, patterns in old.items():
            assert all(any(p.covers(o) for p in new[way]) for o in patterns), "no right is lost"
        more = told(compaction.widened[path])
        for name in {p.name for p in every_name}:
            for kind in (*TOPICS, EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT):
                if not any(p.name == name and (p.kind in TOPICS) == (kind in TOPICS) for p in every_name):
                    continue
                right = Privilege(kind, name)
                covered = [
                    all(any(p.covers(Pattern(r.name)) for p in ps[r.direction.value]) for r in on_dds(right))
                    for ps in (old, new)
                ]
                if covered == [False, True]:
                    assert right in more, "each right that is new is told"
        assert not any(privileges(members).get(right) is not None for right in more)
        for each in compaction.widened[path]:
            assert each.name not in ("/*", "*")
            fewer = {path: tuple(w for w in compaction.widened[path] if w != each)}
            without = permissions(network, widened=fewer)[path]
            assert len(without) + without.count("\n") + 2048 > largest, "no pattern is idle"


@given(nodes(enclave="/all"))
def test_the_size_is_that_of_the_document(made: tuple[Node, ...]) -> None:
    network = connect("jazzy", made)
    documents = permissions(network)
    for path, members in by_enclave(network.nodes):
        rights = {right for each in privileges(members) for right in on_dds(each)}
        assert signed_size(path, rights) == len(documents[path]) + documents[path].count("\n") + 2048


@pytest.mark.parametrize("robots", [8, 20])
def test_a_fleet_in_one_enclave(robots: int) -> None:
    """By the parameter services of nodes and the parts of actions alone: no name that is known is allowed besides."""
    network = joint(robots)
    assert [f.code for f in size_findings(network.nodes)] == ["RW304"]
    compaction = compact(network.nodes)
    assert {f.code for f in compaction.findings} == {"RW340"}
    document = permissions(network, widened=compaction.widened)["/all"]
    assert len(document) + document.count("\n") + 2048 <= LARGEST
    assert all("*" in name for w in compaction.widened["/all"] for name in w.more), (
        "names with holes may turn out to be anything"
    )
    assert all(w.name.endswith(("/_action/*", "/*_parameter*")) for w in compaction.widened["/all"])
    assert compact(network.nodes) == compaction
    shuffled = tuple(reversed(network.nodes))
    assert compact(shuffled).widened == compaction.widened


def test_policy_and_permissions_say_the_same(tmp_path: object) -> None:
    network = joint(8)
    widened = compact(network.nodes).widened
    text = policies(network, widened=widened)["/all"]
    file = tmp_path / "policy.xml"  # type: ignore[operator]
    file.write_text(text, encoding="utf-8")
    (enclave,) = read_policy([str(file)]).enclaves
    document = allowed(permissions(network, widened=widened)["/all"])
    said = {(r.direction.value, r.name) for rule in enclave.rules for r in rule.rights}
    assert said | {(way, "ros_discovery_info") for way in document} == {
        (way, pattern.text) for way, patterns in document.items() for pattern in patterns
    }
    assert "<!-- compacted: " in policy_xml(network, widened=widened)
    assert "compacted" not in policy_xml(network)


def test_what_a_pattern_allows_besides_is_told() -> None:
    """Two of three topics of a folder, and the third is somebody else's."""
    own = [pub(f"/sensors/front_{n}/range") for n in range(40)]
    made = [
        node("/a", *own, system=False),
        node("/b", pub("/sensors/secret"), pub("/sensors/front_x/range"), system=False),
    ]
    network = connect("jazzy", made)
    (small,) = compact(network.nodes, largest=4_000).widened["/a"]
    assert (small.name, small.more) == ("/sensors/front_*/range", ("/sensors/front_x/range",))
    (finding,) = compact(network.nodes, largest=4_000).findings
    assert finding.message == (
        "enclave /a: publisher /sensors/front_*/range replaces 40 names; "
        "it also allows /sensors/front_x/range, and any other name of this form"
    )
    assert finding.place == network.nodes[0].entities[0].created_at[0]


def test_what_no_pattern_helps_is_left_as_it_is() -> None:
    """Names that share nothing: `/*` would do, and is never written."""
    made = connect("jazzy", [node("/a", *(sub(f"/{chr(97 + n)}zy") for n in range(26)), system=False)]).nodes
    compaction = compact(made, largest=3_500)
    assert compaction.widened == {}
    (finding,) = compaction.findings
    assert finding.code == "RW304"
    assert "patterns reduce them only to" in finding.message


def test_a_part_of_an_action_may_be_left() -> None:
    """A pattern for services takes the three of the action; its topics are written one by one."""
    servers = [entity(EntityKind.SERVICE_SERVER, f"/arm/tool_{n}") for n in range(60)]
    made = connect("jazzy", [node("/n", entity(EntityKind.ACTION_SERVER, "/arm/tool_x"), *servers, system=False)])
    widened = {
        "/n": (
            Widened(
                EntityKind.SERVICE_SERVER,
                "/arm/tool_*",
                frozenset({f"/arm/tool_x/_action/{s}" for s in ("send_goal", "get_result", "cancel_goal")}),
                (),
            ),
        )
    }
    text = policy_xml(made, widened=widened)
    assert "<action>" not in text
    assert "<topic>/arm/tool_x/_action/feedback</topic>" in text
    assert "<service>/arm/tool_*</service>" in text
