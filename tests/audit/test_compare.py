# SPDX-License-Identifier: Apache-2.0
"""What runs is held against what the source says: each difference is told once, at its place, and nothing else is."""

from __future__ import annotations

import time
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from outputs.networks import entity, fleet, node, pub, sub, talker_and_listener

from rosward.audit.accepted import Accepted
from rosward.audit.compare import audit
from rosward.audit.result import Audit, Unseen
from rosward.audit.tools import tool_of
from rosward.findings import Finding
from rosward.location import Place
from rosward.ros.entities import EntityKind, Node, Qos, Resolution
from rosward.source.json_fields import UnreadableError

from .graphs import running, seen, told

TALKER = node("/talker", pub("/chatter", line=9), sub("/cmd", line=10))
RELIABLE = Qos("reliable", "volatile", "keep_last", 10)


def found(expected: list[Node], *live: Node) -> Audit:
    return audit(expected, (), running(*live), Accepted())


def test_a_system_that_does_what_its_source_says_has_no_differences() -> None:
    result = found([TALKER], TALKER)
    assert result.clean
    assert result.nodes == (1, 1, 0)
    assert result.entities == (11, 11, 0)


@pytest.mark.parametrize("nodes", [fleet().nodes, [n for n in talker_and_listener().nodes if "*" not in n.fqn]])
def test_networks_explain_themselves(nodes: list[Node]) -> None:
    known = [replace(n, entities=tuple(e for e in n.entities if "*" not in e.name)) for n in nodes]
    assert told(known, running(*known)) == []


def test_a_node_and_what_it_has_without_a_source() -> None:
    rogue = node("/rogue", pub("/spy"))
    (difference,) = found([TALKER], TALKER, rogue).differences
    assert difference.finding.code == "RW501"
    assert "/rogue runs but is not explained by the source; it has publisher /spy," in difference.finding.message
    assert difference.finding.place == Place("robot.json")


def test_an_entity_without_a_source_is_told_where_its_node_is_made() -> None:
    (difference,) = found([TALKER], replace(TALKER, entities=(*TALKER.entities, pub("/debug")))).differences
    assert (difference.finding.code, difference.entity) == ("RW502", "publisher /debug")
    assert difference.finding.place == TALKER.defined_at


def test_what_is_expected_and_absent_is_told_where_it_is_created() -> None:
    (difference,) = found([TALKER], replace(TALKER, entities=TALKER.entities[1:])).differences
    assert (difference.finding.code, difference.entity) == ("RW503", "publisher /chatter")
    assert difference.finding.place.line == 9


def test_an_expected_node_that_does_not_run() -> None:
    assert told([TALKER, node("/listener")], running(TALKER)) == [("RW503", "/listener", "")]


def test_what_only_some_executions_have_is_listed_apart() -> None:
    late = pub("/late", line=30, conditional=True)
    expected = replace(TALKER, entities=(*TALKER.entities, late))
    sometimes = node("/sometimes", conditional=True, launched_by=Place("launch/x.launch.py", 4))
    result = found([expected, sometimes], TALKER)
    assert result.clean
    assert result.unseen == (
        Unseen("/sometimes", "", Place("launch/x.launch.py", 4)),
        Unseen("/talker", "publisher /late", late.created_at[0]),
    )


def test_another_type_is_told_once() -> None:
    live = replace(TALKER, entities=(pub("/chatter", "std_msgs/msg/Int32"), *TALKER.entities[1:]))
    (difference,) = found([TALKER], live).differences
    assert difference.finding.code == "RW504"
    assert "has type std_msgs/msg/Int32, but the source says std_msgs/msg/String" in difference.finding.message


def test_a_type_that_the_source_does_not_know_fits_each() -> None:
    expected = node("/talker", pub("/chatter", None))
    assert told([expected], running(node("/talker", pub("/chatter", "std_msgs/msg/Int32")))) == []


@pytest.mark.parametrize(
    ("said", "runs", "differs"),
    [
        (RELIABLE, RELIABLE, False),
        (RELIABLE, replace(RELIABLE, durability="transient_local"), True),
        (RELIABLE, Qos("reliable", None, None, None), False),
        (Qos("system_default", None), RELIABLE, False),
        (None, RELIABLE, False),
        (RELIABLE, replace(RELIABLE, depth=1), True),
    ],
)
def test_qos_is_compared_where_both_are_known(said: Qos | None, runs: Qos, differs: bool) -> None:
    live = node("/talker", pub("/chatter", qos=runs))
    assert told([node("/talker", pub("/chatter", qos=said))], running(live)) == (
        [("RW504", "/talker", "publisher /chatter")] if differs else []
    )


def test_patterns_explain_names_and_are_counted() -> None:
    expected = node("/robot_*/driver", pub("/robot_*/state", resolution=Resolution.PATTERN), system=False)
    live = [node(f"/robot_{n}/driver", pub(f"/robot_{n}/state"), system=False) for n in (1, 2)]
    result = found([expected], *live)
    assert result.clean
    assert (result.nodes, result.entities) == ((2, 0, 2), (2, 0, 2))


def test_a_pattern_that_nothing_fulfils_is_absent() -> None:
    expected = node("/robot_*/driver", pub("/robot_*/state", resolution=Resolution.PATTERN), system=False)
    live = node("/robot_1/driver", system=False)
    assert told([expected], running(live)) == [("RW503", "/robot_1/driver", "publisher /robot_*/state")]
    assert told([expected], running()) == [("RW503", "/robot_*/driver", "")]


def test_an_unknown_name_explains_perhaps() -> None:
    unknown = sub(
        "/*", resolution=Resolution.UNKNOWN, reasons=("parameter 'topic' has no default (talker.py:3)",), line=3
    )
    expected = replace(TALKER, entities=(*TALKER.entities, unknown))
    live = replace(TALKER, entities=(*TALKER.entities, sub("/somewhere"), pub("/elsewhere")))
    differences = found([expected], live).differences
    assert [(d.finding.code, d.entity) for d in differences] == [
        ("RW502", "publisher /elsewhere"),
        ("RW506", "subscription /somewhere"),
    ]
    assert differences[1].finding.place.line == 3
    assert "parameter 'topic' has no default" in differences[1].finding.message


def test_a_node_of_unknown_name_explains_perhaps() -> None:
    unnamed = node("/*", resolution=Resolution.UNKNOWN)
    live = node("/anything", pub("/more"))
    assert told([unnamed], running(live)) == [("RW502", "/anything", "publisher /more"), ("RW506", "/anything", "")]
    assert [u.node for u in found([unnamed]).unseen] == ["/*"]


def test_a_node_of_unknown_interface_explains_by_its_name_alone() -> None:
    driver = node("/lidar", launched_by=Place("launch/r.launch.py", 5), defined_at=Place("launch/r.launch.py", 5))
    doubt = Finding("RW314", "the interface of the node acme/lidar is not known", Place("launch/r.launch.py", 5, 9))
    live = node("/lidar", pub("/scan"), system=False)
    result = audit([driver], [doubt], running(live), Accepted())
    assert result.clean
    assert [(u.node, u.entities) for u in result.unjudged] == [("/lidar", ("publisher /scan",))]


def test_several_nodes_of_one_name_need_as_many_in_the_source() -> None:
    twin = replace(TALKER, process="demo/twin")
    assert told([TALKER], running(TALKER, counts={"/talker": 2})) == [("RW501", "/talker", "")]
    assert told([TALKER, twin], running(TALKER, counts={"/talker": 2})) == []
    assert told([TALKER, twin], running(TALKER)) == [("RW503", "/talker", "")]


def test_of_two_nodes_of_one_name_each_may_be_the_one_that_runs() -> None:
    other = node("/talker", pub("/other"), conditional=True)
    assert told([TALKER, other], running(other)) == []


def test_an_action_stands_for_its_topics_and_services() -> None:
    server = entity(EntityKind.ACTION_SERVER, "/fib", "test_msgs/action/Fibonacci")
    client = entity(EntityKind.ACTION_CLIENT, "/fib", "test_msgs/action/Fibonacci")
    both = node("/fib", server, client)
    assert told([both], running(both)) == []
    assert told([node("/fib", server)], running(both)) == [("RW502", "/fib", "action client /fib")]
    assert told([both], running(node("/fib", client))) == [("RW503", "/fib", "action server /fib")]


def test_a_topic_of_an_action_alone_is_no_action() -> None:
    watcher = node("/watcher", sub("/fib/_action/status", "action_msgs/msg/GoalStatusArray"))
    assert told([node("/watcher")], running(watcher)) == [("RW502", "/watcher", "subscription /fib/_action/status")]
    assert told([watcher], running(watcher)) == []
    client = entity(EntityKind.ACTION_CLIENT, "/fib", "test_msgs/action/Fibonacci")
    both = replace(watcher, entities=(*watcher.entities, client))
    assert told([both], running(both)) == []


@pytest.mark.parametrize(
    ("name", "tool"),
    [
        ("/_ros2cli_1234", "ros2 command line"),
        ("/_ros2cli_daemon_0_5f3a", "ros2 command line"),
        ("/launch_ros_77", "ros2 launch"),
        ("/rviz2", "RViz"),
        ("/rqt_gui_py_node_5", "rqt"),
        ("/rosbag2_recorder", "ros2 bag"),
        ("/rviz2_spy", None),
        ("/launch_ros_spy", None),
    ],
)
def test_tools_are_told_apart_by_name(name: str, tool: str | None) -> None:
    assert tool_of(name) == tool
    result = found([TALKER], TALKER, node(name, pub("/x")))
    assert [t.tool for t in result.tools] == ([tool] if tool else [])
    assert result.clean is (tool is not None)


def test_a_tool_that_the_source_starts_is_a_node_like_any() -> None:
    rviz = node("/rviz2", sub("/scan"))
    assert found([rviz], rviz).tools == ()
    assert told([rviz], running(node("/rviz2", sub("/scan"), pub("/goal")))) == [("RW502", "/rviz2", "publisher /goal")]


def test_endpoints_of_no_node() -> None:
    loose = [{"kind": "publishers", **seen("/spy", "std_msgs/msg/String")}]
    assert told([TALKER], running(TALKER, loose=loose)) == [("RW502", "", "publisher /spy")]


def test_what_is_accepted_is_counted_and_no_difference() -> None:
    live = running(replace(TALKER, entities=(*TALKER.entities, pub("/debug"))), node("/vendor/arm", pub("/x")))
    assert told([TALKER], live, "/vendor/*", "/talker /debug") == []
    assert audit([TALKER], (), live, Accepted(["/vendor/*", "/talker /debug"])).accepted == 2
    assert told([TALKER], live, "/vendor", "/talker /deb") != []


@pytest.mark.parametrize("line", ["talker", "/a b", "/a /b /c", ""])
def test_what_cannot_be_accepted(line: str) -> None:
    with pytest.raises(UnreadableError):
        Accepted([line])


KINDS = st.sampled_from(
    [EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION, EntityKind.SERVICE_SERVER, EntityKind.ACTION_CLIENT]
)
NAMES = st.from_regex(r"(/[a-c_]{1,3}){1,2}", fullmatch=True)
ENTITIES = st.lists(st.builds(lambda k, n: entity(k, n, "std_msgs/msg/String"), KINDS, NAMES), max_size=6)


@given(st.dictionaries(st.from_regex(r"/n[a-c]{1,2}", fullmatch=True), ENTITIES, max_size=4))
def test_a_snapshot_of_the_network_itself_has_no_differences(made: dict[str, list[object]]) -> None:
    nodes = [node(name, *entities) for name, entities in made.items()]  # type: ignore[arg-type]
    assert told(nodes, running(*nodes)) == []


@given(st.dictionaries(st.from_regex(r"/n[a-c]{1,2}", fullmatch=True), ENTITIES, min_size=1, max_size=4), st.data())
def test_each_change_is_told(made: dict[str, list[object]], data: st.DataObject) -> None:
    """One entity more is one RW502, one less is one RW503, whatever there is beside."""
    nodes = [node(name, *entities) for name, entities in made.items()]  # type: ignore[arg-type]
    of = data.draw(st.sampled_from(nodes))
    extra = entity(EntityKind.PUBLISHER, "/x/extra")
    more = [replace(n, entities=(*n.entities, extra)) if n is of else n for n in nodes]
    assert told(nodes, running(*more)) == [("RW502", of.fqn, "publisher /x/extra")]
    assert told(more, running(*nodes)) == [("RW503", of.fqn, "publisher /x/extra")]


@pytest.mark.slow
def test_hostile_patterns_are_refused_in_bounded_time() -> None:
    wild = [pub("/" + "a*" * 100 + str(n), resolution=Resolution.PATTERN, conditional=True) for n in range(500)]
    live = [pub("/" + "a" * 400 + f"b{n}") for n in range(500)]
    start = time.process_time()
    with pytest.raises(UnreadableError, match="too many"):
        told([node("/n", *wild)], running(node("/n", *live)))
    assert time.process_time() - start < 60
