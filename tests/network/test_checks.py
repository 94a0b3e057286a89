# SPDX-License-Identifier: Apache-2.0
"""Findings that come from the whole: when each speaks, and when it has to be silent."""

from __future__ import annotations

from outputs.networks import entity, node, pub, sub

from rosward.location import Place
from rosward.network.checks import UnknownNames
from rosward.network.connect import connect
from rosward.network.enclaves import enclave_paths
from rosward.ros.entities import EntityKind, Node, Resolution


def found(code: str, *nodes: Node, unknown: UnknownNames = "deny") -> list[str]:
    network = connect("jazzy", nodes, unknown=unknown)
    return [f"{finding.place}: {finding.message}" for finding in network.findings if finding.code == code]


def test_several_nodes_in_one_process() -> None:
    a, b = node("/a", process="p"), node("/b", process="p")
    (text,) = found("RW301", a, b)
    assert text.startswith("src/demo/demo/b.py:7: process p holds 2 nodes (/a, /b)")
    assert not found("RW301", node("/a", process="p", enclave="/e"), node("/b", process="p", enclave="/e"))
    assert not found("RW301", node("/a", process="p"), node("/b", process="q"))


def test_wildcards_are_told_once_for_node_and_name() -> None:
    pattern = Resolution.PATTERN
    (text,) = found(
        "RW302", node("/a", pub("/r_*/x", line=4, resolution=pattern), sub("/r_*/x", line=5, resolution=pattern))
    )
    assert text == "src/demo/demo/node.py:4: node /a: publisher and subscription /r_*/x: it also allows /r_any/depth/x"


def test_a_node_whose_name_has_a_hole_is_told_once() -> None:
    assert len(found("RW302", node("/robot_*/a"))) == 1


def test_an_unknown_name_is_a_wildcard_only_if_asked_for() -> None:
    asking = node("/a", pub("/*", resolution=Resolution.UNKNOWN))
    assert not found("RW302", asking)
    assert len(found("RW302", asking, unknown="wildcard")) == 1


def test_long_enclaves() -> None:
    assert not found("RW303", node("/" + "a" * 63))
    (text,) = found("RW303", node("/" + "a" * 64))
    assert "65 characters" in text


def test_a_topic_outside_the_ros_names() -> None:
    (text,) = found("RW305", node("/a", pub("/x", line=8, ros_prefix=False)))
    assert text == "src/demo/demo/node.py:8: node /a: publisher /x has no rt prefix in its DDS name"


def test_differing_types() -> None:
    (text,) = found("RW306", node("/a", pub("/x", "p/msg/A", 3)), node("/b", sub("/x", "p/msg/B", 5)))
    assert text == "src/demo/demo/node.py:5: topic /x: p/msg/A (publisher in /a); p/msg/B (subscription in /b)"
    kind = EntityKind
    ends = entity(kind.ACTION_SERVER, "/x", "p/action/A"), entity(kind.ACTION_CLIENT, "/x", "p/action/B")
    assert len(found("RW306", node("/a", *ends))) == 1


def test_types_that_do_not_clash() -> None:
    service = entity(EntityKind.SERVICE_SERVER, "/x", "p/srv/A")
    assert not found("RW306", node("/a", pub("/x", "p/msg/A"), sub("/x", None)))
    assert not found("RW306", node("/a", pub("/x", "p/msg/A"), service))
    assert not found("RW306", node("/a", pub("/*", "p/msg/A")), node("/b", sub("/*", "p/msg/B")))
    alternatives = pub("/x", "p/msg/A", conditional=True), pub("/x", "p/msg/B", conditional=True)
    assert not found("RW306", node("/a", *alternatives))
    assert len(found("RW306", node("/a", *alternatives), node("/b", sub("/x", "p/msg/A")))) == 1


def test_a_node_name_used_twice() -> None:
    (text,) = found("RW307", node("/a", process="p"), node("/a", process="q", defined_at=Place("z.py", 1)))
    assert text == "z.py:1: 2 nodes are named /a (in p, q)"
    assert not found("RW307", node("/r*/a", process="p"), node("/r*/a", process="q"))


def test_enclave_paths_are_valid_and_stay_apart() -> None:
    enclaves = ["/a/b", "/robot_*/a", "/robot_unknown/a", "/*", "/", "/1/x", "/a b", "/a_b", "/../../etc", "/é"]
    paths = enclave_paths([node("/n", enclave=enclave) for enclave in enclaves])
    assert paths["/a/b"] == "/a/b"
    assert paths["/robot_unknown/a"] == "/robot_unknown/a"
    assert paths["/robot_*/a"] == "/robot_unknown/a_2"
    assert paths["/*"] == "/unknown"
    assert paths["/"] == "/"
    assert paths["/1/x"] == "/_1/x"
    assert paths["/../../etc"] == "/__/__/etc"
    assert len(set(paths.values())) == len(enclaves)
