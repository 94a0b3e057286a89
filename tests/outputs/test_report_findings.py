# SPDX-License-Identifier: Apache-2.0
"""Which nodes, endpoints and entities a finding of the report belongs to."""

from __future__ import annotations

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.outputs.background import Background
from rosward.ros.entities import EntityKind, Node, Qos, Resolution

from .networks import entity, node, pub, sub
from .reports import Report

FILE = "src/demo/demo/node.py"
UNKNOWN, PATTERN = Resolution.UNKNOWN, Resolution.PATTERN


def subjects(code: str, nodes: list[Node], *findings: Finding) -> list[list[str]]:
    """What the findings of a code belong to; no loose ends but those that are given."""
    return Report(connect("jazzy", nodes, findings), Background(loose=())).subjects(code)


def test_a_line_belongs_to_what_is_made_there_and_to_its_node_and_endpoint() -> None:
    nodes = [node("/a", pub("/x", line=20), pub("/y", line=21)), node("/b", sub("/x", line=30))]
    told = subjects("RW209", nodes, Finding("RW209", "The real library raises.", Place(FILE, 20, 9)))
    assert told == [["/a", "topic /x", "publisher /x of /a"]]


def test_what_has_a_finding_says_so() -> None:
    report = Report(
        connect("jazzy", [node("/a", pub("/x", line=20))], [Finding("RW209", "It fails.", Place(FILE, 20))]),
        Background(loose=()),
    )
    (finding,) = report["findings"]
    assert [report.row(i)["findings"] for i in finding["subjects"]] == [[finding["id"]]] * 3


def test_of_two_in_one_line_the_column_decides() -> None:
    two = node("/a", pub("/x", created_at=(Place(FILE, 5, 9),)), pub("/y", created_at=(Place(FILE, 5, 60),)))
    told = subjects("RW209", [two], Finding("RW209", "It fails.", Place(FILE, 5, 60)))
    assert told == [["/a", "topic /y", "publisher /y of /a"]]
    both = subjects("RW209", [two], Finding("RW209", "It fails.", Place(FILE, 5, 1)))
    assert both == [["/a", "topic /x", "topic /y", "publisher /x of /a", "publisher /y of /a"]]


def test_of_two_in_one_place_the_message_decides() -> None:
    """A publisher that has two names: one is known, the other is not."""
    place = Place(FILE, 8, 9)
    two = node(
        "/a",
        pub("/left", None, line=8),
        pub("/r_*", line=8, resolution=PATTERN),
        pub("/*", line=8, resolution=UNKNOWN),
    )
    assert subjects("RW101", [two], Finding("RW101", "the name of this publisher is unknown", place)) == [
        ["/a", "topic /*", "publisher /* of /a"]
    ]
    message = "the name of this publisher is known only as /r_*"
    assert subjects("RW102", [two], Finding("RW102", message, place)) == [["/a", "topic /r_*", "publisher /r_* of /a"]]
    message = "the type of the publisher /left is unknown"
    assert subjects("RW104", [two], Finding("RW104", message, place)) == [
        ["/a", "topic /left", "publisher /left of /a"]
    ]


def test_a_line_belongs_to_the_node_that_is_defined_or_started_there() -> None:
    at = Place("launch/robot.launch.py", 12, 9)
    nodes = [node("/a", launched_by=at), node("/b", launched_by=Place("launch/robot.launch.py", 20))]
    unknown_interface = Finding("RW314", "the interface of the node demo/a is unknown: C++", at)
    assert subjects("RW314", nodes, unknown_interface) == [["/a"]]
    unknown_name = Finding("RW105", "the name of this node is unknown", Place("src/demo/demo/any.py", 7, 1))
    assert subjects("RW105", [node("/*", pub("/x", line=7), resolution=UNKNOWN)], unknown_name) == [["/*"]]


def test_a_line_in_which_nothing_is_made_belongs_to_nothing() -> None:
    nodes = [node("/a", pub("/x", line=20))]
    assert subjects("RW203", nodes, Finding("RW203", "exec", Place(FILE, 90))) == [[]]
    assert subjects("RW001", nodes, Finding("RW001", "/a is a word here", Place(FILE, 0))) == [[]]


def test_wildcards_belong_to_the_node_and_the_name() -> None:
    nodes = [
        node("/a", pub("/r_*/x", resolution=PATTERN), sub("/r_*/x", resolution=PATTERN)),
        node("/b", sub("/r_*/x", resolution=PATTERN)),
    ]
    assert subjects("RW302", nodes) == [
        ["/a", "topic /r_*/x", "publisher /r_*/x of /a", "subscription /r_*/x of /a"],
        ["/b", "topic /r_*/x", "subscription /r_*/x of /b"],
    ]
    assert subjects("RW302", [node("/r_*")]) == [["/r_*"]]


def test_a_name_outside_of_ros() -> None:
    assert subjects("RW305", [node("/a", pub("/x", ros_prefix=False))]) == [["/a", "topic /x", "publisher /x of /a"]]


def test_nodes_that_share_a_process_or_a_name() -> None:
    assert subjects("RW301", [node("/a", process="p"), node("/b", process="p"), node("/c")]) == [["/a", "/b"]]
    assert subjects("RW307", [node("/a", process="p"), node("/a", process="q"), node("/b")]) == [["/a", "/a"]]


def test_an_enclave_is_its_nodes() -> None:
    """Also where other nodes are defined in the same line."""
    here = Place("src/demo/demo/robot.py", 7, 1)
    path = "/" + "a" * 70
    nodes = [node(f"/{name}", defined_at=here, enclave=path if name in "ab" else f"/{name}") for name in "abc"]
    assert subjects("RW303", nodes) == [["/a", "/b"]]
    message = "enclave /c: publisher /x_* replaces 3 names; it also allows any other name of this form"
    assert subjects("RW340", nodes, Finding("RW340", message, here)) == [["/c"]]


def test_differing_types_belong_to_every_end_of_the_name() -> None:
    """Also where a node and a service have that name."""
    nodes = [
        node("/x", pub("/x", "p/msg/A")),
        node("/b", sub("/x", "p/msg/B")),
        node("/c", entity(EntityKind.SERVICE_SERVER, "/x", "p/srv/X")),
    ]
    assert subjects("RW306", nodes) == [["/b", "/x", "topic /x", "subscription /x of /b", "publisher /x of /x"]]


def test_incompatible_qos_belongs_to_those_that_never_talk() -> None:
    best, sure = Qos("best_effort", "volatile"), Qos("reliable", "volatile")
    nodes = [
        node("/driver", pub("/scan", qos=best)),
        node("/other", pub("/scan", qos=sure)),
        node("/viewer", sub("/scan", qos=sure)),
        node("/watch", sub("/scan", qos=best)),
    ]
    assert subjects("RW309", nodes) == [
        ["/driver", "/viewer", "topic /scan", "publisher /scan of /driver", "subscription /scan of /viewer"]
    ]


def test_loose_ends_belong_to_their_ends() -> None:
    report = Report(connect("jazzy", [node("/a", sub("/x")), node("/b", sub("/x"))]))
    assert report.subjects("RW331") == [["/a", "/b", "topic /x", "subscription /x of /a", "subscription /x of /b"]]
