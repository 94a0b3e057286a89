# SPDX-License-Identifier: Apache-2.0
"""The graph of the whole: what is merged, what meets, and that no order of input shows in it."""

from __future__ import annotations

import itertools
import random

from hypothesis import given
from hypothesis import strategies as st
from outputs.networks import entity, fleet, node, pub, sub, talker_and_listener

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect, with_findings
from rosward.ros.entities import Entity, EntityKind, Parameter, Qos, Resolution, replace


def test_ends_of_one_name_meet() -> None:
    network = connect("jazzy", [node("/b", sub("/x"), system=False), node("/a", pub("/x"), system=False)])
    (topic,) = network.topics
    assert (topic.name, topic.publishers, topic.subscriptions) == ("/x", ("/a",), ("/b",))
    assert topic.types == ("std_msgs/msg/String",)
    assert [n.fqn for n in network.nodes] == ["/a", "/b"]


def test_equal_entities_of_a_node_are_one() -> None:
    """It is surely there if one of them is, and the surest way to its name counts."""
    first = pub(
        "/x", line=9, conditional=True, depends_on=("p",), resolution=Resolution.DEFAULT, qos=Qos("reliable", depth=1)
    )
    second = pub("/x", line=3, depends_on=("a",), qos=Qos("reliable", depth=5))
    (merged,) = connect("jazzy", [node("/a", first, second, system=False)]).nodes[0].entities
    assert merged.created_at == (Place("src/demo/demo/node.py", 3, 9), Place("src/demo/demo/node.py", 9, 9))
    assert merged.depends_on == ("a", "p")
    assert not merged.conditional
    assert merged.resolution is Resolution.EXACT
    assert merged.qos == Qos("reliable")


def test_two_callbacks_of_one_subscription_are_both_told() -> None:
    (merged,) = (
        connect("jazzy", [node("/a", sub("/x", callback="b"), sub("/x", callback="a"), system=False)]).nodes[0].entities
    )
    assert merged.callback == "a, b"


def test_what_the_user_also_makes_is_not_system() -> None:
    own = pub("/rosout", "rcl_interfaces/msg/Log", line=4)
    network = connect("jazzy", [node("/a", own), node("/b")])
    rosout = next(topic for topic in network.topics if topic.name == "/rosout")
    assert not rosout.system
    assert next(topic for topic in network.topics if topic.name == "/parameter_events").system


def test_types_and_prefix_keep_entities_apart() -> None:
    plain = pub("/x", ros_prefix=False)
    network = connect("jazzy", [node("/a", pub("/x"), pub("/x", "a/msg/B"), plain, system=False)])
    assert len(network.nodes[0].entities) == 3


def test_parameters_are_sorted_and_told_once() -> None:
    place = Place("a.py", 1)
    parameters = (Parameter("z", None, None, None, place), Parameter("a", "string", "x", "x", place))
    network = connect("jazzy", [node("/a", parameters=parameters * 2)])
    assert [parameter.name for parameter in network.nodes[0].parameters] == ["a", "z"]


def test_findings_are_sorted_and_told_once() -> None:
    late, early = Finding("RW101", "x", Place("b.py", 1)), Finding("RW102", "y", Place("a.py", 9))
    network = with_findings(connect("jazzy", [], [late, early, late]), [early])
    assert network.findings == (early, late)


def test_no_order_of_input_shows() -> None:
    base = fleet(3)
    expected = connect("jazzy", base.nodes, base.findings)
    shuffler = random.Random(7)
    for _ in range(5):
        nodes = [
            replace(n, entities=tuple(shuffler.sample(n.entities, len(n.entities))))
            for n in shuffler.sample(base.nodes, len(base.nodes))
        ]
        findings = shuffler.sample(base.findings, len(base.findings))
        assert connect("jazzy", nodes, findings) == expected


NAMES = st.sampled_from(["/a", "/b", "/ns/a", "/ns/*"])
ENTITIES = st.builds(
    entity,
    st.sampled_from(EntityKind),
    NAMES,
    st.sampled_from([None, "p/msg/A", "p/msg/B"]),
    st.integers(1, 3),
    conditional=st.booleans(),
    system=st.booleans(),
    resolution=st.sampled_from(Resolution),
    callback=st.sampled_from([None, "f", "g"]),
    qos=st.sampled_from([None, Qos(depth=1), Qos("reliable")]),
    via=st.sampled_from([None, "tf2_ros.Buffer", "tf2_ros.TransformListener"]),
)


@given(st.lists(ENTITIES, max_size=4))
def test_any_order_of_entities_gives_one_result(entities: list[Entity]) -> None:
    results = {connect("jazzy", [node("/n", *order, system=False)]) for order in itertools.permutations(entities)}
    assert len(results) == 1


@given(st.lists(ENTITIES, max_size=6))
def test_connecting_again_changes_nothing(entities: list[Entity]) -> None:
    once = connect("jazzy", [node("/n", *entities, system=False)])
    assert connect("jazzy", once.nodes, once.findings) == once


def test_each_entity_is_an_end_of_one_meeting() -> None:
    network = talker_and_listener()
    ends = sum(len(t.publishers) + len(t.subscriptions) for t in network.topics)
    ends += sum(len(service.servers) + len(service.clients) for service in network.services)
    ends += sum(len(action.servers) + len(action.clients) for action in network.actions)
    assert ends == sum(len(n.entities) for n in network.nodes)
