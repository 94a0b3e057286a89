# SPDX-License-Identifier: Apache-2.0
"""Texts of `ros2 node info` are read as they are printed by humble to kilted, and as they look after they were copied about."""

from __future__ import annotations

import contextlib
import textwrap
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st
from outputs.networks import entity, node, pub, sub

from rosward.audit.graph import LiveEntity
from rosward.audit.node_info import read_node_info
from rosward.ros.entities import EntityKind
from rosward.source.json_fields import UnreadableError

from .graphs import told

SERVER, CLIENT = EntityKind.SERVICE_SERVER, EntityKind.SERVICE_CLIENT
COMPLEX = """\
/complex_node
  Subscribers:
    /strings: test_msgs/msg/Strings
  Publishers:
    /arrays: test_msgs/msg/Arrays
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /rosout: rcl_interfaces/msg/Log
  Service Servers:
    /basic: test_msgs/srv/BasicTypes
    /complex_node/describe_parameters: rcl_interfaces/srv/DescribeParameters
  Service Clients:

  Action Servers:
    /fibonacci: test_msgs/action/Fibonacci
  Action Clients:

"""
HIDDEN = """\
/fib
  Subscribers:

  Publishers:
    /fib/_action/feedback: test_msgs/action/Fibonacci_FeedbackMessage
    /fib/_action/status: action_msgs/msg/GoalStatusArray
  Service Servers:
    /fib/_action/cancel_goal: action_msgs/srv/CancelGoal
    /fib/_action/get_result: test_msgs/action/Fibonacci_GetResult
    /fib/_action/send_goal: test_msgs/action/Fibonacci_SendGoal
  Service Clients:

  Action Servers:
    /fib: test_msgs/action/Fibonacci
  Action Clients:

"""


def read(text: str) -> dict[str, list[str]]:
    """The entities of each node, in words."""
    graph = read_node_info({"info.txt": text})
    return {n.name: [f"{e} {e.type}" for e in n.entities] for n in graph.nodes}


def test_a_text_as_it_is_printed() -> None:
    assert read(COMPLEX) == {
        "/complex_node": [
            "subscription /strings test_msgs/msg/Strings",
            "publisher /arrays test_msgs/msg/Arrays",
            "publisher /parameter_events rcl_interfaces/msg/ParameterEvent",
            "publisher /rosout rcl_interfaces/msg/Log",
            "service server /basic test_msgs/srv/BasicTypes",
            "service server /complex_node/describe_parameters rcl_interfaces/srv/DescribeParameters",
            "action server /fibonacci test_msgs/action/Fibonacci",
        ]
    }


@pytest.mark.parametrize(
    "text",
    [
        textwrap.indent(COMPLEX, "    "),
        COMPLEX.replace("  ", ""),
        COMPLEX.replace("  ", "\t"),
        COMPLEX.replace("\n", "\r\n"),
        COMPLEX + COMPLEX,
    ],
)
def test_indentation_and_repetition_do_not_matter(text: str) -> None:
    assert read(text) == read(COMPLEX)


def test_several_nodes_one_after_another() -> None:
    graph = read_node_info({"a.txt": COMPLEX, "b.txt": HIDDEN})
    assert [n.name for n in graph.nodes] == ["/complex_node", "/fib"]
    assert not graph.whole


def test_hidden_names_fold_into_their_action() -> None:
    assert read(HIDDEN) == {"/fib": ["action server /fib test_msgs/action/Fibonacci"]}
    assert read_node_info({"": HIDDEN}).nodes[0].hidden
    assert not read_node_info({"": COMPLEX}).nodes[0].hidden


def test_a_section_that_is_not_there_is_not_known() -> None:
    (live,) = read_node_info({"": "/a\n  Publishers:\n    /x: std_msgs/msg/String\n"}).nodes
    assert live.known == {EntityKind.PUBLISHER}
    expected = node("/a", pub("/x"), pub("/y"), sub("/z"), system=False)
    assert told([expected], read_node_info({"": "/a\n  Publishers:\n    /x: std_msgs/msg/String\n"})) == [
        ("RW503", "/a", "publisher /y")
    ]


def test_a_name_of_two_types_is_two_entities() -> None:
    (live,) = read_node_info({"": "/a\nPublishers:\n/x: a/msg/B, c/msg/D\n"}).nodes
    assert live.entities == (
        LiveEntity(EntityKind.PUBLISHER, "/x", "a/msg/B"),
        LiveEntity(EntityKind.PUBLISHER, "/x", "c/msg/D"),
    )


def test_nodes_that_no_text_is_of_are_not_absent() -> None:
    expected = [node("/a", pub("/x"), system=False), node("/b", system=False)]
    assert told(expected, read_node_info({"": "/a\n  Publishers:\n    /x: std_msgs/msg/String\n"})) == []


def test_hidden_names_are_not_absent_where_none_is_shown() -> None:
    hidden = entity(SERVER, "/a/_secret", "std_srvs/srv/Empty")
    text = "/a\n  Service Servers:\n"
    assert told([node("/a", hidden, system=False)], read_node_info({"": text})) == []
    shown = text + "    /b/_other: std_srvs/srv/Empty\n"
    assert told([node("/a", hidden, system=False)], read_node_info({"": shown})) == [
        ("RW502", "/a", "service server /b/_other"),
        ("RW503", "/a", "service server /a/_secret"),
    ]


def test_the_warning_about_nodes_of_one_name_counts() -> None:
    warning = (
        'There are 3 nodes in the graph with the exact name "/a". You are seeing information about only one of them.\n'
    )
    graph = read_node_info({"": warning + "/a\n  Publishers:\n"})
    assert graph.nodes[0].count == 3
    assert graph.findings == ()


def test_what_is_not_understood_is_told_with_its_line() -> None:
    graph = read_node_info({"i.txt": f"$ ros2 node info /a\n{COMPLEX}Unable to find node '/b'\n"})
    assert [(str(f.place), f.code, f.message) for f in graph.findings] == [
        ("i.txt:1", "RW505", "The line could not be parsed: $ ros2 node info /a"),
        ("i.txt:18", "RW505", "There was no node /b."),
    ]


@pytest.mark.parametrize("text", ["", "\n\n", "hello", "Publishers:\n  /x: a/msg/B\n", "\0\x1b[31m"])
def test_a_text_without_a_node_is_refused(text: str) -> None:
    with pytest.raises(UnreadableError):
        read_node_info({"i.txt": text})


@given(st.text(alphabet="/ab_: \n,PublishersSection\t\0"))
def test_any_text_ends_in_nodes_or_a_refusal(text: str) -> None:
    try:
        graph = read_node_info({"i.txt": "/n\nPublishers:\n" + text})
    except UnreadableError:
        return
    assert len(graph.findings) <= 20


@pytest.mark.parametrize(
    "text", ["/a\nPublishers:\n" + "/x" * 500_000, "/a\nPublishers:\n/x: " + "a/msg/B, " * 200_000, "x\n" * 1_000_000]
)
def test_large_texts_take_bounded_time(text: str) -> None:
    start = time.process_time()
    with contextlib.suppress(UnreadableError):
        assert len(read_node_info({"i.txt": "/n\n" + text}).findings) <= 20
    assert time.process_time() - start < 10
