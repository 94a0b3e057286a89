# SPDX-License-Identifier: Apache-2.0
"""The drawing: what is in it and what is not, and that it is well-formed whatever the names are."""

from __future__ import annotations

import random
import subprocess
import xml.etree.ElementTree as ET
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples

from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.graphs.dot import drawing, graph_dot
from rosward.outputs.graphs.layers import steps_between_layers
from rosward.outputs.graphs.svg import graph_svg
from rosward.ros.entities import Entity, Resolution

from .networks import fleet, node, pub, stack, sub, talker_and_listener

SVG = "{http://www.w3.org/2000/svg}"


def texts(picture: str) -> list[str]:
    return [element.text or "" for element in ET.fromstring(picture).iter(f"{SVG}text")]


def test_what_is_drawn() -> None:
    text = graph_dot(talker_and_listener())
    assert '"node /robot1/talker" -> "topic /robot1/chatter" [color="#b07800", class="of-topic"];' in text
    assert '"topic /robot1/chatter" -> "node /robot1/listener"' in text
    assert '"node /robot1/talker" -> "service /add"' in text
    assert '"service /add" -> "node /robot1/listener"' in text
    assert (
        '"node /robot1/talker" -> "topic /robot_*/cmd_vel" [color="#b07800", class="of-topic", style=dashed];' in text
    )


def test_system_entities_and_types_on_demand() -> None:
    network = talker_and_listener()
    assert "rosout" not in graph_dot(network)
    assert "rosout" in graph_dot(network, system=True)
    assert "std_msgs" not in graph_dot(network)
    assert r"chatter\nstd_msgs/msg/String" in graph_dot(network, types=True)


def test_namespaces_of_nodes_are_clusters() -> None:
    text = graph_dot(connect("jazzy", [node("/a/x", pub("/a/x/private")), node("/a/b/y", sub("/a/b/z"))]))
    assert text.count("subgraph") == 2
    assert 'graph [label="/a"' in text
    assert 'graph [label="b"' in text
    assert '"topic /a/x/private" [label="x/private"' in text


def test_two_unknown_names_never_meet() -> None:
    unknown = Resolution.UNKNOWN
    network = connect("jazzy", [node("/a", pub("/*", resolution=unknown)), node("/b", sub("/*", resolution=unknown))])
    text = graph_dot(network)
    assert '"topic /* of /a"' in text
    assert '"topic /* of /b"' in text


def test_what_everyone_uses_is_drawn_beside_each() -> None:
    crowd = [node(f"/n{i}", pub("/tf")) for i in range(13)]
    assert graph_dot(connect("jazzy", crowd)).count("peripheries=2") == 13
    assert "peripheries" not in graph_dot(connect("jazzy", crowd[:12]))


def test_the_picture_holds_the_names() -> None:
    shown = texts(graph_svg(talker_and_listener()))
    assert {"talker", "listener", "chatter", "/add", "dock", "/robot_*/cmd_vel ?", "* ?", "/robot1"} <= set(shown)


def test_fifty_nodes_are_drawn() -> None:
    shown = texts(graph_svg(fleet(8)))
    assert shown.count("planner") == 8
    assert "/dispatcher" in shown


def test_the_same_network_gives_the_same_picture() -> None:
    assert graph_svg(fleet(2), links=True) == graph_svg(fleet(2), links=True)


def test_nothing_to_draw() -> None:
    assert texts(graph_svg(connect("jazzy", []))) == []


def size(picture: str) -> tuple[float, float]:
    root = ET.fromstring(picture)
    return float(root.attrib["width"].removesuffix("pt")), float(root.attrib["height"].removesuffix("pt"))


@pytest.mark.parametrize(
    ("network", "expected"),
    [
        (talker_and_listener, {"talker", "chatter"}),
        (
            partial(stack, 24),
            {"/sensing/lidar/top/stage_0_of_filter", "Omitted: 1 that connects many nodes with many."},
        ),
        (partial(stack, 190), {"/sensing/lidar/top/", "12 nodes", "/stage_0_of_filter"}),
        (partial(fleet, 110), {"/robot*/", "660 nodes", "/dispatcher"}),
        (partial(fleet, 500), {"/robot*/", "3000 nodes", "/dispatcher"}),
    ],
    ids=["2", "24", "190", "662", "3002"],
)
def test_a_system_of_any_size_is_drawn_on_one_screen(network: Callable[[], Network], expected: set[str]) -> None:
    """As near as there is room for: with its topics, its nodes alone, its namespaces, those alike together."""
    picture = graph_svg(network())
    assert expected <= set(texts(picture))
    width, height = size(picture)
    assert width <= 2600
    assert height <= 1700


def test_a_namespace_and_a_node_of_one_name_are_two_shapes() -> None:
    made = [node("/a", pub("/t")), node("/a/x", sub("/t")), node("/a/y"), *(node(f"/b/n{i}") for i in range(301))]
    assert {"/a", "/a/", "2 nodes", "301 nodes"} <= set(texts(graph_svg(connect("jazzy", made))))


def test_a_graph_beyond_any_eye_is_told_in_words() -> None:
    crowd = [node(f"/n{chr(97 + i // 26)}{chr(97 + i % 26)}", system=False, package=f"p{i}") for i in range(400)]
    assert texts(graph_svg(connect("jazzy", crowd)))[0] == "This graph is too large to draw."


def test_a_renderer_that_is_missing_or_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    network = talker_and_listener()
    monkeypatch.setattr("rosward.outputs.graphs.svg._program", lambda: None)
    assert "not installed" in texts(graph_svg(network))[0]
    monkeypatch.setattr("rosward.outputs.graphs.svg._program", lambda: "false")
    assert "could not draw" in texts(graph_svg(network))[0]

    def too_slow(*_: Any, **__: Any) -> None:
        raise subprocess.TimeoutExpired("graphviz-pure", 1)

    monkeypatch.setattr("subprocess.run", too_slow)
    assert "seconds" in texts(graph_svg(network))[0]


def test_graphviz_draws_where_graphviz_pure_is_not_there(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    dot = tmp_path / "dot"
    dot.write_text("#!/bin/sh\ncat >/dev/null\necho '<?xml version=\"1.0\"?><svg>drawn</svg>'\n", encoding="utf-8")
    dot.chmod(0o755)
    monkeypatch.setattr("rosward.outputs.graphs.svg._PROGRAM", "no-such-program")
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    assert graph_svg(talker_and_listener()) == "<svg>drawn</svg>\n"
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert "not installed" in texts(graph_svg(talker_and_listener()))[0], "a program of the folder that is analysed"


ANY = st.text(alphabet=st.characters(), max_size=10) | st.sampled_from(
    [
        "\\N",
        "\\",
        '"',
        "&lt;b&gt;",
        "<b>",
        "</svg><script>alert(1)</script>",
        "}",
        "-->",
        "\ud800",
        "\x00",
        "\\n",
        "]]>",
    ]
)


@settings(max_examples=examples(1.2))
@given(ANY, ANY, ANY)
def test_any_text_gives_a_well_formed_picture(name: str, topic: str, type_: str) -> None:
    network = connect("jazzy", [node("/a", pub("/" + topic, type_, reasons=(topic,)), name=name, namespace="/" + name)])
    assert drawing(network).edges == 1
    picture = graph_svg(network, types=True, links=True)
    root = ET.fromstring(picture)
    assert "could not draw" not in picture
    assert {element.tag for element in root.iter()} <= {
        SVG + tag for tag in ("svg", "g", "title", "text", "ellipse", "polygon", "path", "a", "polyline")
    }
    assert not [key for element in root.iter() for key in element.attrib if key.startswith("on")]


def dense(nodes: int, topics: int, seed: int) -> Network:
    """Each topic has a publisher and a subscription somewhere: circles everywhere."""
    random_ = random.Random(seed)
    members: dict[int, list[Entity]] = {number: [] for number in range(nodes)}
    for topic in range(topics):
        members[random_.randrange(nodes)].append(pub(f"/t{topic}"))
        members[random_.randrange(nodes)].append(sub(f"/t{topic}"))
    return connect("jazzy", [node(f"/n{number}", *found, system=False) for number, found in members.items()])


def test_a_dense_graph_is_drawn_by_its_size_not_by_a_clock() -> None:
    """Its lines are straight, so that drawing ends soon; without the clock the picture would be the same."""
    small, large = drawing(dense(20, 20, 1)), drawing(dense(80, 220, 1))
    assert "splines=line" not in small.text
    assert "splines=line" in large.text
    assert 4_000 < large.steps <= 60_000


def test_what_cannot_be_seen_is_not_drawn() -> None:
    network = dense(200, 900, 1)
    assert drawing(network).steps > 60_000
    assert "/n*" in texts(graph_svg(network))


@given(st.sets(st.tuples(st.sampled_from("abcdefg"), st.sampled_from("abcdefg"))))
def test_steps_between_layers(edges: set[tuple[str, str]]) -> None:
    """Each edge takes at least one, and no more than there are shapes; in whichever order the edges come."""
    proper = {edge for edge in edges if edge[0] != edge[1]}
    steps = steps_between_layers(edges)
    assert len(proper) <= steps <= len(proper) * 6
    assert steps == steps_between_layers(sorted(edges, reverse=True))


def test_a_long_way_round_takes_a_step_for_each_layer() -> None:
    assert steps_between_layers([("a", "b"), ("b", "c"), ("a", "c")]) == 4
    assert steps_between_layers([("a", "b"), ("b", "a")]) == 2
    assert steps_between_layers([("a", "a")]) == 0
