# SPDX-License-Identifier: Apache-2.0
"""Promise: a rule that a flow breaks is told, with how sure that is; one that holds is not; and a rule that protects nothing is told, too."""

from __future__ import annotations

import pytest

from rosward.influence.check import against
from rosward.influence.graph import graph_of
from rosward.influence.policy import PolicyError, read_policy

from .systems import system

ROBOT = (
    "/cam: topic:/camera/image <- device",
    "/detector: topic:/boxes <- topic:/camera/image, control topic:/mode",
    "/up: network <- topic:/boxes, control parameter:on",
    "/planner: topic:/plan <- topic:/boxes",
    "/control: topic:/cmd_vel <- topic:/plan, control topic:/stop, clock, trigger timer",
)


def codes(policy: dict[str, object], *lines: str) -> list[str]:
    return [f.code for f in against(graph_of(system(*lines)), read_policy(policy))]


def rule(**keys: object) -> dict[str, object]:
    return {"rule": [{key.replace("_", "-"): value for key, value in keys.items()}]}


def released(policy: dict[str, object], *through: str) -> dict[str, object]:
    return {**policy, "release": [{"through": list(through), "of": ["/camera/**"], "because": "faces are blurred"}]}


PICTURES = rule(**{"from": ["/camera/**"], "not_to": ["network"]})


@pytest.mark.parametrize(
    ("policy", "expected"),
    [
        (PICTURES, ["RW601"]),
        (rule(**{"from": ["device"], "not_to": ["network"]}), ["RW601"]),
        (rule(**{"from": ["/camera/**"], "not_to": ["file"]}), []),
        (rule(**{"from": ["/mode"], "not_to": ["network"]}), []),
        (rule(**{"from": ["/mode"], "not_to": ["network"], "by": "control"}), ["RW601"]),
        (rule(**{"from": ["node:/cam"], "not_to": ["/cmd_vel"]}), ["RW601"]),
        (rule(to=["/cmd_vel"], only_from=["/plan"]), []),
        (rule(to=["/cmd_vel"], only_from=["device", "/camera/**"]), []),
        (rule(to=["/cmd_vel"], only_from=["/other", "/plan"], by="control"), ["RW603", "RW601"]),
        (rule(to=["/cmd_vel"], only_from=["/plan", "/stop"], by="control"), []),
        (rule(**{"from": ["/camra/**"], "not_to": ["network"]}), ["RW603"]),
        (rule(**{"from": ["parameter:on"], "not_to": ["/parameter_events"]}), ["RW601"]),
        (rule(**{"from": ["parameter:on"], "not_to": ["response:/up/get_parameters"]}), ["RW601"]),
        (rule(**{"from": ["request:/up/set_parameters"], "not_to": ["/parameter_events"]}), ["RW601"]),
        (rule(**{"from": ["/mode"], "not_to": ["/parameter_events"], "by": "control"}), []),
        (released(PICTURES, "/boxes"), ["RW606"]),
        (released(PICTURES, "node:/detector"), ["RW606"]),
        (released(PICTURES, "/nothing"), ["RW601", "RW602"]),
    ],
)
def test_a_rule(policy: dict[str, object], expected: list[str]) -> None:
    found = codes(policy, *ROBOT)
    assert [code for code in found if code != "RW606"] == [code for code in expected if code != "RW606"]


def test_what_is_protected_decides_its_release() -> None:
    lines = ("/gate: topic:/public <- topic:/note, control topic:/camera/image", "/up: network <- topic:/public")
    assert codes(released(PICTURES, "/public"), *lines) == ["RW606"]


def test_a_node_that_was_not_analysed_makes_it_an_assumption() -> None:
    assert codes(PICTURES, "/cam!: topic:/x <- topic:/camera/image", "/up: network <- topic:/x") == ["RW604"]


def test_a_pattern_is_any_name_that_fits() -> None:
    assert codes(PICTURES, "/a: topic:/robot_*/out <- topic:/camera/a", "/b: network <- topic:/robot_1/out") == [
        "RW601"
    ]
    assert codes(PICTURES, "/a: topic:/robot_*/out <- topic:/camera/a", "/b: network <- topic:/robot_1/in") == []


def test_names_do_not_flow_into_one_another_through_a_pattern() -> None:
    """Who publishes on any name reaches all that listen; who listens to one name is not reached by who publishes another one."""
    lines = ("/a: topic:/one <- topic:/camera/a", "/b: topic:/* <- topic:/note", "/c: network <- topic:/two")
    assert codes(PICTURES, *lines) == []


def test_a_cycle_ends() -> None:
    lines = ("/a: topic:/x <- topic:/y", "/b: topic:/y <- topic:/x, topic:/camera/a", "/c: network <- topic:/x")
    assert codes(PICTURES, *lines) == ["RW601"]


def test_parameters_are_reached_through_their_service() -> None:
    lines = (
        "/web: request:/cam/set_parameters <- network",
        "/cam: topic:/camera/image <- parameter:rate",
        "/other: topic:/stay <- parameter:rate",
    )
    assert codes(rule(**{"from": ["network"], "not_to": ["/camera/image"]}), *lines) == ["RW601"]
    assert codes(rule(**{"from": ["network"], "not_to": ["/stay"]}), *lines) == []


def test_logging_reaches_who_listens_to_rosout() -> None:
    assert codes(PICTURES, "/a: log <- topic:/camera/a", "/b: network <- topic:/rosout") == ["RW601"]


def test_rules_that_contradict_each_other() -> None:
    policy: dict[str, object] = {
        "rule": [
            {"name": "a", "to": ["/cmd_vel"], "only-from": ["/camera/image"]},
            {"name": "b", "from": ["/camera/image"], "not-to": ["/cmd_vel"]},
        ]
    }
    assert "RW607" in codes(policy, *ROBOT)


def test_a_thousand_nodes_with_any_name() -> None:
    lines = [f"/n{n}: topic:/* <- topic:/*, topic:/in_{n}" for n in range(1_000)]
    assert codes(rule(**{"from": ["/in_7"], "not_to": ["network"]}), *lines, "/up: network <- topic:/x") == ["RW601"]


@pytest.mark.parametrize(
    ("table", "why"),
    [
        ({"rules": []}, "tables"),
        ({"rule": [{"from": ["/a"]}]}, "either `from` and `not-to`"),
        ({"rule": [{"from": ["/a"], "not-to": ["/b"], "to": ["/c"]}]}, "either `from` and `not-to`"),
        ({"rule": [{"from": [1], "not-to": ["/b"]}]}, "list of names in `from`"),
        ({"rule": [{"from": ["/a"], "not-to": ["colour:/b"]}]}, "'colour' in `not-to` is no kind"),
        ({"rule": [{"from": ["/a"], "not-to": ["/b"], "by": "magic"}]}, "`by` one of"),
        ({"rule": [{"from": ["/a"], "not-to": ["/b"], "colour": 1}]}, "without 'colour'"),
        ({"rule": [{"name": "x", "from": ["/a"], "not-to": ["/b"]}] * 2}, "two rules of the name 'x'"),
        ({"release": [{"through": ["/a"], "of": ["/b"]}]}, "`because`"),
        ({"release": [{"through": ["/a"], "because": "x"}]}, "`through` and `of`"),
    ],
)
def test_a_rule_that_nobody_can_follow(table: dict[str, object], why: str) -> None:
    with pytest.raises(PolicyError, match=why.replace("`", ".")):
        read_policy(table)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (("/a: topic:/camera/small <- topic:/camera/image",), ["RW601"]),
        (("/a: topic:/x <- topic:/camera/image", "/b: topic:/camera/small <- topic:/x"), ["RW601"]),
        (
            (
                "/a: topic:/x <- topic:/camera/small, topic:/y",
                "/b: topic:/camera/small <- topic:/x",
                "/c: topic:/y <- topic:/camera/image",
            ),
            ["RW601"],
        ),
        (("/a: topic:/x <- topic:/camera/small", "/b: topic:/camera/small <- topic:/x"), []),
    ],
)
def test_one_of_the_sources_may_be_forbidden_to_the_others(lines: tuple[str, ...], expected: list[str]) -> None:
    assert codes(rule(**{"from": ["/camera/**"], "not_to": ["/camera/small", "network"]}), *lines) == expected
