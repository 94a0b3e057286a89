# SPDX-License-Identifier: Apache-2.0
"""The document of the report: small networks with what it says of them, one form for all, the same bytes for the same sources."""

from __future__ import annotations

import json
from typing import Any

import jsonschema
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples

from rosward.enclaves.widened import Widened
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.launch_tree import GivenParameter, Inclusion, LaunchEntry, LaunchSystem, Shown
from rosward.outputs.background import Background
from rosward.outputs.policies.policy import policies
from rosward.outputs.report.document import report_document
from rosward.outputs.report.page import document_text
from rosward.ros.entities import EntityKind, Parameter, Qos, Resolution

from .networks import entity, fleet, hostile, node, pub, sub, talker_and_listener
from .reports import SCHEMA, Report


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_a_whole_document() -> None:
    """One node with one publisher: everything that the page gets to know."""
    talker = node(
        "/a/talker", pub("/a/chatter", line=20, qos=Qos("reliable", "volatile", "keep_last", 10)), system=False
    )
    document = Report(connect("jazzy", [talker], files=1, lines=30, processes=1)).document
    here = {"file": "src/demo/demo/node.py", "line": 20}
    assert document["summary"] | {"rosward": "0"} == {
        "rosward": "0",
        "distro": "jazzy",
        "files": 1,
        "lines": 30,
        "processes": 1,
        "complete": True,
        "counts": {
            "nodes": 1,
            "topics": {"total": 1, "system": 0},
            "services": {"total": 0, "system": 0},
            "actions": {"total": 0, "system": 0},
            "names": {"exact": 1, "default": 0, "bound": 0, "pattern": 0, "unknown": 0},
            "findings": {"error": 0, "warning": 0, "note": 1},
        },
        "places_without_code": 0,
    }
    assert document["nodes"] == [
        {
            "id": "n0",
            "fqn": "/a/talker",
            "namespace": "/a",
            "name": "talker",
            "package": "demo",
            "executable": "talker",
            "process": "demo/a/talker",
            "enclave": "c0",
            "resolution": "exact",
            "reasons": [],
            "conditional": False,
            "assumed": False,
            "interface": "analysed",
            "lacks": [],
            "place": {"file": "src/demo/demo/talker.py", "line": 7},
            "launched_by": None,
            "includes": [],
            "entities": ["e0"],
            "parameters": [],
            "findings": ["f0"],
        }
    ]
    assert document["endpoints"] == [
        {
            "id": "t0",
            "kind": "topic",
            "name": "/a/chatter",
            "types": ["std_msgs/msg/String"],
            "system": False,
            "resolution": "exact",
            "findings": ["f0"],
        }
    ]
    assert document["entities"] == [
        {
            "id": "e0",
            "node": "n0",
            "endpoint": "t0",
            "kind": "publisher",
            "name": "/a/chatter",
            "type": "std_msgs/msg/String",
            "system": False,
            "resolution": "exact",
            "reasons": [],
            "remedies": [],
            "conditional": False,
            "callback": None,
            "qos": {"reliability": "reliable", "durability": "volatile", "history": "keep_last", "depth": 10},
            "via": None,
            "places": [here],
            "path": [],
            "sources": [],
            "remaps": [],
            "rule": "r0",
            "why_not": "",
            "findings": ["f0"],
        }
    ]
    assert document["rules"] == [{"id": "r0", "enclave": "c0", "text": "publish /a/chatter", "entities": ["e0"]}]
    (enclave,) = document["enclaves"]
    assert (enclave["id"], enclave["path"], enclave["nodes"]) == ("c0", "/a/talker", ["n0"])
    assert document["findings"] == [
        {
            "id": "f0",
            "code": "RW332",
            "severity": "note",
            "title": "topic without a subscription",
            "help": "Check the name and its remapping. Perhaps only tools read it, or nothing does.",
            "message": "topic /a/chatter: publisher in /a/talker, but no subscription",
            "place": here,
            "subjects": ["n0", "t0", "e0"],
            "first": None,
        }
    ]
    assert document["code"] == {}


@pytest.mark.parametrize(
    "network", [talker_and_listener(), fleet(3), connect("jazzy", [])], ids=["two", "fleet", "none"]
)
@pytest.mark.parametrize("unknown", ["deny", "wildcard"])
def test_a_policy_is_the_file_line_by_line(network: Any, unknown: Any) -> None:
    report = Report(network, unknown=unknown)
    written = {row["path"]: "\n".join(line["text"] for line in row["policy"]) for row in report["enclaves"]}
    assert written == policies(network, unknown)


def test_every_line_with_a_right_leads_to_who_needs_it() -> None:
    report = Report(fleet(2))
    lines = [(e["id"], line) for e in report["enclaves"] for line in e["policy"] if line["rule"] is not None]
    assert [line["rule"] for _, line in lines] == [rule["id"] for rule in report["rules"]]
    for enclave, line in lines:
        rule = report.row(line["rule"])
        name = rule["text"].partition(" ")[2]
        assert rule["enclave"] == enclave
        assert f">{name}</" in line["text"]
        for id_ in rule["entities"]:
            assert report.row(id_)["rule"] == rule["id"]
            assert report.row(report.row(id_)["node"])["enclave"] == enclave
    assert all(row["rule"] or row["why_not"] for row in report["entities"])


def test_an_entity_without_a_rule_says_why() -> None:
    asking = node("/a", pub("/*", None, resolution=Resolution.UNKNOWN, reasons=("unmodelled call: f (a.py:3)",)))
    row = Report(connect("jazzy", [asking])).entity("/a", "publisher", "/*")
    assert (row["rule"], row["why_not"]) == (None, "unknown name")
    assert row["reasons"] == ["unmodelled call: f (a.py:3)"]
    assert row["remedies"] == ["describe the call in a stub file (--models DIR)"]
    allowed = Report(connect("jazzy", [asking]), unknown="wildcard")
    assert allowed.row(allowed.entity("/a", "publisher", "/*")["rule"])["text"] == "publish /*"


def test_nodes_of_one_name_share_a_rule() -> None:
    one, two = (node("/a", pub("/x"), process=name, system=False) for name in ("p", "q"))
    report = Report(connect("jazzy", [one, two]))
    assert [rule["entities"] for rule in report["rules"]] == [["e0", "e1"]]
    assert report["enclaves"][0]["nodes"] == ["n0", "n1"]


def test_a_pattern_in_place_of_names_is_the_rule_of_all_that_it_stands_for() -> None:
    """Also for nodes of one name, and for one part of an action."""
    nodes = [
        node(
            "/a",
            pub("/x1"),
            pub("/x2"),
            entity(EntityKind.ACTION_SERVER, "/go", "p/action/Go"),
            process=process,
            system=False,
        )
        for process in ("p", "q")
    ]
    widened = {
        "/a": (
            Widened(EntityKind.PUBLISHER, "/x*", frozenset({"/x1", "/x2"}), ()),
            Widened(
                EntityKind.SERVICE_SERVER, "/go/_*", frozenset({"/go/_action/cancel_goal", "/go/_action/send_goal"}), ()
            ),
        )
    }
    network = connect("jazzy", nodes)
    report = Report(network, Background(widened=widened))
    rules = {row["id"]: row["text"] for row in report["rules"]}
    for row in report["entities"]:
        assert row["rule"] is not None
        assert rules[row["rule"]] == "publish /x*" or row["kind"] == "action server"
    assert (
        "\n".join(line["text"] for line in report["enclaves"][0]["policy"]) == policies(network, widened=widened)["/a"]
    )


def test_a_name_with_a_hole_tells_which_names_it_may_be() -> None:
    known = node("/a", pub("/left/scan"), pub("/right/scan"), pub("/left/image"), sub("/x/scan/raw"))
    watcher = node("/b", sub("/*/scan", resolution=Resolution.PATTERN), sub("/*", resolution=Resolution.UNKNOWN))
    report = Report(connect("jazzy", [known, watcher]))
    named = [report.row(id_)["name"] for id_ in report.endpoint("/*/scan")["matches"]]
    assert named == ["/left/scan", "/right/scan"]
    assert "matches" not in report.endpoint("/*")
    assert "matches" not in report.endpoint("/left/scan")


def test_a_name_is_as_sure_as_the_surest_of_its_ends() -> None:
    pair = node("/a", pub("/x", resolution=Resolution.DEFAULT)), node("/b", sub("/x"))
    assert Report(connect("jazzy", pair)).endpoint("/x")["resolution"] == "exact"


def test_one_name_of_two_kinds_is_two_endpoints() -> None:
    both = node("/a", pub("/x"), entity(EntityKind.SERVICE_SERVER, "/x", "p/srv/X"))
    report = Report(connect("jazzy", [both]))
    assert report.endpoint("/x")["types"] == ["std_msgs/msg/String"]
    assert report.endpoint("/x", "service")["types"] == ["p/srv/X"]


def test_parameters_and_what_a_name_is_made_of() -> None:
    at = Place("src/demo/demo/node.py", 11)
    asking = node(
        "/a",
        pub("/front/scan", resolution=Resolution.DEFAULT, depends_on=("side",)),
        parameters=(
            Parameter("huge", "integer", 2**60, 2**60, None),
            Parameter("rates", "double_array", [0.5, float("inf")], [0.5, float("inf")], at),
            Parameter("side", "string", "front", "front", at),
        ),
    )
    report = Report(connect("jazzy", [asking]))
    here = {"file": "src/demo/demo/node.py", "line": 11}
    assert report.node("/a")["parameters"] == [
        {
            "name": "huge",
            "type": "integer",
            "default": "1152921504606846976",
            "value": "1152921504606846976",
            "place": None,
        },
        {"name": "rates", "type": "double_array", "default": [0.5, ".inf"], "value": [0.5, ".inf"], "place": here},
        {"name": "side", "type": "string", "default": "front", "value": "front", "place": here},
    ]
    assert report.entity("/a", "publisher", "/front/scan")["sources"] == [
        {"name": "side", "what": "parameter", "value": "front", "origin": "its default", "places": [here]}
    ]


def test_long_values_are_cut_and_say_so() -> None:
    wide = node(
        "/a",
        parameters=(
            Parameter("list", "byte_array", bytes(500), None, None),
            Parameter("text", "string", "x" * 5000, None, None),
        ),
    )
    items, text = (p["default"] for p in Report(connect("jazzy", [wide])).node("/a")["parameters"])
    assert (len(items), items[-1]) == (101, "… 400 more")
    assert text.endswith("x… (5000 characters)")


def test_what_launch_files_say_of_a_node() -> None:
    """The include that leads to it, the remap rule and the parameter that its names come from."""
    start = Place("launch/robot.launch.py", 12, 9)
    launched = node(
        "/left/viewer",
        sub("/left/scan", resolution=Resolution.BOUND, depends_on=("topic",)),
        launched_by=start,
        parameters=(Parameter("topic", "string", "scan", "/left/scan", None),),
    )
    entry = LaunchEntry(
        kind="node",
        package=Shown("demo"),
        executable=Shown("viewer"),
        plugin=None,
        container=None,
        name=None,
        namespace=Shown("/left"),
        remaps=((Shown("scan"), Shown("/left/scan")),),
        parameters=(GivenParameter("dict", "topic", Shown("/left/scan"), "", Place("launch/robot.launch.py", 15)),),
        words=(),
        environment=(),
        place=start,
        trail=(Inclusion(Place("launch/all.launch.py", 4), "launch/robot.launch.py", 0),),
        program="demo/viewer.py",
        conditional=False,
        why=(),
        event="",
    )
    systems = (LaunchSystem("all.launch.py", "launch/all.launch.py", (entry,)),)
    report = Report(connect("jazzy", [launched]), Background(systems=systems))
    row = report.node("/left/viewer")
    assert row["launched_by"] == {"file": "launch/robot.launch.py", "line": 12}
    assert row["includes"] == [{"file": "launch/all.launch.py", "line": 4}]
    end = report.entity("/left/viewer", "subscription", "/left/scan")
    assert end["remaps"] == ["scan → /left/scan"]
    (source,) = end["sources"]
    assert (source["origin"], source["places"]) == (
        "set in the launch file",
        [{"file": "launch/robot.launch.py", "line": 15}],
    )


def test_a_chain_of_calls_ends_where_the_entity_is_created() -> None:
    path = (Place("a.py", 30, 5), Place("b.py", 7, 9))
    row = Report(connect("jazzy", [node("/a", pub("/x", path=path, created_at=(path[-1],)))])).entity(
        "/a", "publisher", "/x"
    )
    assert row["path"] == [{"file": "a.py", "line": 30}, {"file": "b.py", "line": 7}]
    assert row["places"] == row["path"][-1:]


def test_loose_ends_are_told_unless_they_are_taken_away() -> None:
    network = connect("jazzy", [node("/a", pub("/x"))])
    assert [f["code"] for f in Report(network)["findings"]] == ["RW332"]
    assert Report(network, Background(loose=()))["findings"] == []


@settings(max_examples=examples(2))
@given(st.text(alphabet=st.characters(), max_size=10))
def test_any_text_gives_a_document_of_the_same_form(text: str) -> None:
    """Policies are as their files; the schema refuses control characters elsewhere."""
    report = Report(hostile(text))
    assert len(report["entities"]) == len(Report(hostile("plain"))["entities"])


def test_the_same_network_gives_the_same_bytes() -> None:
    assert Report(fleet(3)).text == Report(fleet(3)).text


def test_a_system_of_500_nodes() -> None:
    """Every id is used once and means something; the size grows with the system, not with its square."""
    document = json.loads(document_text(report_document(fleet(83))))
    assert len(document["nodes"]) == 500
    kinds = ("nodes", "endpoints", "entities", "enclaves", "rules", "findings")
    ids = [row["id"] for kind in kinds for row in document[kind]]
    assert len(ids) == len(set(ids))
    assert [row["id"] for row in document["entities"]] == [i for row in document["nodes"] for i in row["entities"]]
    assert {row["endpoint"] for row in document["entities"]} == {row["id"] for row in document["endpoints"]}
    assert {i for row in document["rules"] for i in row["entities"]} <= set(ids)
    assert len(json.dumps(document)) < 500 * 15_000
