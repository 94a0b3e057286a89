# SPDX-License-Identifier: Apache-2.0
"""Promise: the report tells all flows that were followed, small and under its schema; and without them it is what it is without the word."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.background import Background
from rosward.outputs.report.page import report_html
from rosward.ros.flows import STRENGTHS, End, NodeSink

from .flowing import all_flowing, flowing, robot, sink
from .networks import fleet, node, pub, sub
from .reports import Report
from .test_report import Page, digest

FLOWS: Final = Background(loose=(), flow=True)


def edges(report: Report) -> set[tuple[str, str, str, str]]:
    """All that flows, in words: `/node`, the source, how, and the output; what is the same under two names has no node."""
    flows = report["flows"]
    words = [_word(report, content) for content in flows["contents"]]
    inside = {
        (report.row(one["node"])["fqn"], words[source], STRENGTHS[strength], words[output["content"]])
        for one in flows["nodes"]
        for output in one["outputs"]
        for source, strength, _, _ in output["sources"]
    }
    return inside | {("", words[left], "data", words[right]) for left, right in flows["meets"]}


def _word(report: Report, content: dict[str, Any]) -> str:
    of = "" if content["node"] is None else f" of {report.row(content['node'])['fqn']}"
    return f"{content['side']} {content['kind']}:{content['name']}{of}"


def test_a_whole_document() -> None:
    """One node that passes on what it gets: everything that the page learns of its flow."""
    relay = flowing(
        node("/relay", sub("/in"), pub("/out"), system=False),
        sink("topic:/out", 9, data=["topic:/in"], trigger=["timer"]),
    )
    report = Report(connect("jazzy", [relay]), FLOWS)
    ids = {name: report.endpoint(name)["id"] for name in ("/in", "/out")}
    assert report["flows"] == {
        "contents": [
            {"kind": "topic", "name": "/out", "side": "sent", "node": None, "endpoints": [ids["/out"]]},
            {"kind": "topic", "name": "/in", "side": "in", "node": None, "endpoints": [ids["/in"]]},
            {"kind": "timer", "name": "", "side": "in", "node": "n0", "endpoints": []},
        ],
        "places": [["a.py", 9], ["a.py", 5]],
        "nodes": [
            {
                "node": "n0",
                "followed": True,
                "complete": True,
                "outputs": [{"content": 0, "place": 0, "sources": [[1, 0, 0, [1, 0]], [2, 2, 0, []]]}],
            }
        ],
        "meets": [],
    }  # fmt: skip


def test_a_system() -> None:
    assert edges(Report(robot(), FLOWS)) == {
        ("/camera", "in device: of /camera", "data", "sent topic:/image"),
        ("/detector", "in topic:/image", "data", "sent topic:/boxes"),
        ("/detector", "in parameter:size of /detector", "data", "sent topic:/boxes"),
        ("/detector", "in topic:/mode", "control", "sent topic:/boxes"),
        ("/detector", "in topic:/image", "trigger", "sent topic:/status"),
        ("/detector", "in timer: of /detector", "trigger", "sent topic:/status"),
        ("/detector", "in topic:/image", "data", "sent file: of /detector"),
        ("/planner", "in topic:/boxes", "data", "sent request:/route"),
        ("/planner", "in response:/route", "data", "sent topic:/plan"),
        ("/planner", "in topic:/boxes", "control", "sent topic:/plan"),
        ("/router", "in request:/route", "data", "sent response:/route"),
        ("/router", "in file: of /router", "data", "sent response:/route"),
        ("/driver", "in topic:/plan", "data", "sent topic:/cmd_vel"),
        ("/eye", "in clock: of /eye", "data", "sent topic:/image_*"),
        ("/viewer", "in topic:/image_left", "data", "sent topic:/view"),
        ("", "sent topic:/image", "data", "in topic:/image"),
        ("", "sent topic:/boxes", "data", "in topic:/boxes"),
        ("", "sent topic:/plan", "data", "in topic:/plan"),
        ("", "sent request:/route", "data", "in request:/route"),
        ("", "sent response:/route", "data", "in response:/route"),
        ("", "sent topic:/image_*", "data", "in topic:/image_left"),
    }


def test_what_is_not_known_is_told() -> None:
    """A node that nobody analysed, and one whose analysis reached a limit."""
    limited = flowing(node("/slow", pub("/x"), system=False), complete=False)
    report = Report(connect("jazzy", [*robot().nodes, limited]), FLOWS)
    nodes = {report.row(one["node"])["fqn"]: one for one in report["flows"]["nodes"]}
    assert {name for name, one in nodes.items() if not one["followed"]} == {"/driver"}
    assert {name for name, one in nodes.items() if not one["complete"]} == {"/driver", "/slow"}
    assert [assumed for output in nodes["/driver"]["outputs"] for _, _, assumed, _ in output["sources"]] == [1]
    assert [output["sources"] for output in nodes["/lamp"]["outputs"]] == [[]]


def test_transforms_and_logs_are_drawn_as_the_topics_that_they_are() -> None:
    lidar = flowing(
        node("/a", pub("/tf"), pub("/rosout"), system=False), sink("tf", data=["clock"]), sink("log", data=["tf"])
    )
    watch = flowing(node("/b", sub("/rosout"), pub("/seen"), system=False), sink("topic:/seen", data=["topic:/rosout"]))
    report = Report(connect("jazzy", [lidar, watch]), FLOWS)
    drawn = {
        one["kind"]: [report.row(i)["name"] for i in one["endpoints"]]
        for one in report["flows"]["contents"]
        if one["side"] == "sent"
    }
    assert drawn == {"tf": ["/tf"], "log": ["/rosout"], "topic": ["/seen"]}
    assert ("", "sent log:", "data", "in topic:/rosout") in edges(report)
    assert ("", "sent tf:", "data", "in tf:") in edges(report)


def test_what_a_function_releases_is_a_step_of_its_own() -> None:
    blurs = sink("topic:/out", 9, data=["released:faces.blur"])
    inner = sink("released:faces.blur", 7, data=["topic:/in"])
    relay = flowing(node("/relay", sub("/in"), pub("/out"), system=False), blurs, released=(inner,))
    assert edges(Report(connect("jazzy", [relay]), FLOWS)) == {
        ("/relay", "in released:faces.blur of /relay", "data", "sent topic:/out"),
        ("/relay", "in topic:/in", "data", "in released:faces.blur of /relay"),
    }


def test_two_nodes_of_one_name_have_each_their_own_outputs() -> None:
    """Their parameters are one content: nobody can tell whose is meant."""
    nodes = [
        flowing(node("/twin", pub(name), system=False), sink(f"topic:{name}", data=["parameter:p"]))
        for name in ("/x", "/y")
    ]
    report = Report(connect("jazzy", nodes), FLOWS)
    assert [len(one["outputs"]) for one in report["flows"]["nodes"]] == [1, 1]
    assert [one["node"] for one in report["flows"]["contents"] if one["kind"] == "parameter"] == ["n0"]


def test_a_finding_has_its_way_and_its_nodes() -> None:
    way = (Place("a.py", 36), Place("a.py", 40))
    finding = Finding(
        "RW601", "/image reaches /boxes through /detector, which 'x' forbids", way[-1], nodes=("/detector",), path=way
    )
    network = connect("jazzy", robot().nodes, [finding])
    (row,) = (f for f in Report(network, FLOWS)["findings"] if f["code"] == "RW601")
    assert row["way"] == [{"file": "a.py", "line": 36}, {"file": "a.py", "line": 40}]
    assert Report(network, FLOWS).subjects("RW601") == [["/detector"]]
    assert "way" not in json.dumps(Report(network, Background(loose=()))["findings"])


def test_only_the_lines_of_a_way_come_with_it(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("\n".join(f"line {number}" for number in range(1, 60)), encoding="utf-8")
    relay = flowing(
        node("/relay", defined_at=Place("b.py", 1), system=False), sink("topic:/out", 40, data=["topic:/in"])
    )
    network = connect("jazzy", [relay])
    assert Report(network, FLOWS._replace(root=tmp_path))["code"] == {"a.py": {"36": "line 36", "40": "line 40"}}
    assert Report(network, Background(tmp_path, loose=()))["code"] == {}


def without(network: Network) -> Network:
    """The network as it is where nobody followed flows."""
    return replace(network, nodes=tuple(replace(one, flows=None) for one in network.nodes))


def test_without_flows_the_page_is_the_same_byte_for_byte() -> None:
    network = robot()
    assert report_html(network) == report_html(without(network))
    assert "flow" not in Page(report_html(network)).document.replace("rosward flow", "")
    assert not [script for script in Page(report_html(network)).started if "rosward.flows =" in script]


def test_its_scripts_and_styles_are_those_that_it_allows() -> None:
    plain, shown = Page(report_html(robot())), Page(report_html(robot(), FLOWS))
    rules = {rule.split()[0]: rule.split()[1:] for rule in shown.policy.split("; ")}
    assert [digest(script) for script in shown.started] == rules["script-src"]
    assert {digest(style) for style in shown.styles} == set(rules["style-src"])
    assert [script for script in shown.started if script in plain.started] == plain.started
    assert shown.styles[: len(plain.styles)] == [style for style in shown.styles if style in plain.styles]
    assert (len(shown.started) - len(plain.started), len(shown.styles) - len(plain.styles)) == (8, 1)
    assert not shown.handlers


@pytest.mark.parametrize(
    "text",
    ["<script>alert(1)</script>", "</script><img src=x onerror=alert(1)>", "{{ 7 * 7 }}", "\u202ereversed", "a\0b"],
)
def test_text_from_the_sources_stays_text(text: str) -> None:
    shown, plain = Page(report_html(_evil(text), FLOWS)), Page(report_html(_evil("plain"), FLOWS))
    assert shown.started == plain.started
    assert set(shown.tags) <= set(plain.tags)
    assert not shown.handlers


@settings(max_examples=examples(1))
@given(st.text(alphabet=st.characters(), max_size=10))
def test_any_text_gives_a_document_of_the_same_form(text: str) -> None:
    report, plain = Report(_evil(text), FLOWS), Report(_evil("plain"), FLOWS)
    assert len(report["flows"]["contents"]) >= len(plain["flows"]["contents"]) - 1  # a name that another one has
    assert len(report["flows"]["nodes"]) == len(plain["flows"]["nodes"])


def _evil(text: str) -> Network:
    names = End("topic", text), End(text, text), End("parameter", text)
    at = Place(text, 3)
    out = NodeSink(
        names[0], at, data=names[1:], control=(End("request", text),), assumed=names[1:2], paths=((names[1], (at, at)),)
    )
    return connect(
        "jazzy",
        [flowing(node("/a", pub(text), system=False), out, released=(replace(out, sink=End("released", text)),))],
    )


def test_the_same_network_gives_the_same_page() -> None:
    assert report_html(robot(), FLOWS) == report_html(robot(), FLOWS)


@pytest.mark.slow
def test_a_system_of_500_nodes() -> None:
    """No closure is in it: a twentieth more than without, however far everything reaches."""
    known = all_flowing(fleet(83))
    plain, shown = report_html(known, Background(loose=())), report_html(known, FLOWS)
    assert len(shown) < 1.1 * len(plain)
