# SPDX-License-Identifier: Apache-2.0
"""RW331 to RW334: what has only one end, and what is said where the other end may be there."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from outputs.networks import entity, node, pub, sub

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.holes import NameIndex, may_be, may_meet
from rosward.network.loose_ends import LOOSE_ENDS, loose_ends
from rosward.ros.entities import Entity, EntityKind, Node, Resolution

NAMES = st.text("ab*/", max_size=5).map("/{}".format)
PATTERN, UNKNOWN = Resolution.PATTERN, Resolution.UNKNOWN


def found(*nodes: Node, findings: tuple[Finding, ...] = ()) -> list[str]:
    return [f"{f.place.line} {f.code} {f.message}" for f in loose_ends(connect("jazzy", nodes, findings))]


def client(name: str, **more: object) -> Entity:
    return entity(EntityKind.SERVICE_CLIENT, name, "p/srv/Do", **more)  # type: ignore[arg-type]


def test_each_kind() -> None:
    action = entity(EntityKind.ACTION_CLIENT, "/drive", "p/action/Drive", 8)
    assert found(node("/a", pub("/out", line=5), sub("/in", line=6), client("/do", line=7), action)) == [
        "6 RW331 topic /in: subscription in /a, but no publisher",
        "5 RW332 topic /out: publisher in /a, but no subscription",
        "7 RW333 service /do: service client in /a, but no server",
        "8 RW334 action /drive: action client in /a, but no server",
    ]


def test_nothing_is_loose_where_both_ends_are_there() -> None:
    """Also in some executions only, in one node, or of another type (of which RW306 tells)."""
    assert not found(node("/a", pub("/x")), node("/b", sub("/x", conditional=True)))
    assert not found(node("/a", pub("/x"), sub("/x")))
    assert not found(node("/a", pub("/x", "p/msg/A")), node("/b", sub("/x", "p/msg/B")))


def test_a_server_needs_no_client() -> None:
    kind = EntityKind
    assert not found(node("/a", entity(kind.SERVICE_SERVER, "/do"), entity(kind.ACTION_SERVER, "/drive")))


def test_one_finding_for_a_name() -> None:
    nodes = [node(f"/n{n}", sub("/in")) for n in range(5)]
    assert found(*nodes) == ["1 RW331 topic /in: subscription in /n0, /n1, /n2 and 2 more, but no publisher"]


def test_what_the_client_library_makes_needs_no_other_end_and_can_be_one() -> None:
    assert not found(node("/a"))
    assert not found(node("/a"), node("/b", sub("/rosout"), client("/a/set_parameters")))
    assert len(found(node("/b", client("/gone/set_parameters")))) == 1


@pytest.mark.parametrize("name", ["/tf", "/tf_static", "/diagnostics", "/rosout"])
def test_what_tools_read_needs_no_subscription(name: str) -> None:
    assert not found(node("/a", pub(name), system=False))


def test_what_comes_from_outside_needs_no_publisher() -> None:
    assert not found(node("/a", sub("/clock")))
    assert len(found(node("/a", sub("/tf")))) == 1  # without anybody who publishes transforms, nothing works


def test_a_partly_known_name_may_be_the_other_end() -> None:
    watcher = node("/w", sub("/robot_*/scan", resolution=PATTERN))
    assert not found(node("/a", pub("/robot_1/scan")), watcher)
    assert [text.split(":")[0] for text in found(node("/a", pub("/arm/scan")), watcher)] == [
        "1 RW332 topic /arm/scan",
        "1 RW331 topic /robot_*/scan",
    ]
    assert not found(node("/a", pub("/*/scan", resolution=PATTERN)), watcher)


def test_an_unknown_name_may_be_the_other_end_if_its_type_fits() -> None:
    subscription = node("/a", sub("/in", "p/msg/A"))
    assert found(subscription, node("/b", pub("/*", None, resolution=UNKNOWN))) == [
        "1 RW331 topic /in: subscription in /a, but no publisher that is known; one of unknown name in /b may match"
    ]
    assert found(subscription, node("/b", pub("/*", "p/msg/B", resolution=UNKNOWN))) == [
        "1 RW331 topic /in: subscription in /a, but no publisher"
    ]


def test_a_node_of_unknown_interface_may_have_the_other_end() -> None:
    place = Place("launch/robot.launch.py", 9, 5)
    driver = node("/driver", defined_at=place)
    assert found(node("/a", sub("/in")), driver, findings=(Finding("RW314", "C++", place),)) == [
        "1 RW331 topic /in: subscription in /a, but no publisher that is known; /driver, whose interface is unknown, may have it"
    ]


def test_topics_with_and_without_the_prefix_of_ros_are_two() -> None:
    assert len(found(node("/a", pub("/x", ros_prefix=False)), node("/b", sub("/x")))) == 2


def test_they_are_not_told_unless_somebody_asks() -> None:
    network = connect("jazzy", [node("/a", sub("/in"))])
    assert not LOOSE_ENDS & {f.code for f in network.findings}


@pytest.mark.parametrize(
    ("one", "other", "meet"),
    [
        ("/a/b", "/a/b", True),
        ("/a/b", "/a/c", False),
        ("/robot_1/scan", "/robot_*/scan", True),
        ("/robot_1/front/scan", "/robot_*/scan", True),
        ("/robot_*/scan", "/*/front/scan", True),
        ("/robot_*/scan", "/arm_*/scan", False),
        ("/*/scan", "/*/image", False),
        ("/a*", "/ab*", True),
        ("/*a", "/*ba", True),
        ("/*x*/b", "/a/*", True),
        ("/a/a", "/a*/a", True),
        ("/aa", "/a*a", True),
        ("/a", "/a*a", False),
    ],
)
def test_names_with_holes(one: str, other: str, meet: bool) -> None:
    assert may_meet(one, other) is may_meet(other, one) is meet
    if "*" not in one:
        assert may_be(one, other) is meet


@given(st.lists(NAMES, max_size=6), NAMES)
def test_many_names_answer_as_each_of_them(names: list[str], asked: str) -> None:
    """But that a name without holes is not asked for itself: whoever asks knows that it is not there."""
    expected = any(may_meet(asked, name) for name in names if "*" in asked or "*" in name)
    assert NameIndex(names).meet(asked) is expected
