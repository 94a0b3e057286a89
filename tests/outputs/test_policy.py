# SPDX-License-Identifier: Apache-2.0
"""The SROS2 policy: valid by its grammar, no more than the source needs, and inert whatever the names are."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from importlib import resources
from typing import Any

import pytest
import xmlschema
from hypothesis import given
from hypothesis import strategies as st

from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.policies.policy import policies, policy_xml
from rosward.ros.entities import EntityKind, Resolution

from .networks import entity, fleet, node, pub, sub, talker_and_listener

SCHEMA = xmlschema.XMLSchema10(str(resources.files("rosward.outputs") / "schemas" / "policy.xsd"))


def valid(text: str) -> str:
    SCHEMA.validate(text)
    return text


def rules(text: str) -> list[str]:
    """`/a publish /x` for each rule."""
    return [
        f"{profile.get('ns')} {profile.get('node')} {attribute} {name.text}"
        for profile in ET.fromstring(text).iter("profile")
        for element in profile
        for attribute in element.attrib
        for name in element
    ]


def one(*entities: Any, **more: Any) -> Network:
    return connect("jazzy", [node("/ns/a", *entities, system=False, **more)])


def test_the_whole_of_a_small_policy() -> None:
    network = one(
        pub("/x", line=20),
        sub("/r_*/y", line=21, resolution=Resolution.PATTERN, conditional=True),
        pub("/ns/*", line=22, resolution=Resolution.UNKNOWN, reasons=("sys.argv[1] is not known",)),
        pub("/tf", "tf2_msgs/msg/TFMessage", line=23, via="tf2_ros.TransformBroadcaster"),
        entity(EntityKind.ACTION_CLIENT, "/dock", "demo/action/Dock", 24),
        pub("/rosout", system=True, created_at=()),
    )
    assert (
        valid(policy_xml(network))
        == """\
<?xml version="1.0" encoding="UTF-8"?>
<!-- Written by rosward from the source of the system. -->
<!-- The comment after each rule says where it comes from; a rule without a comment is needed by the client library. -->
<policy version="0.2.0">
  <enclaves>
    <enclave path="/ns/a">
      <profiles>
        <profile ns="/ns" node="a">
          <!-- Not granted: publisher /ns/* at src/demo/demo/node.py:22: unknown name; sys.argv[1] is not known -->
          <actions call="ALLOW">
            <action>/dock</action>  <!-- src/demo/demo/node.py:24 -->
          </actions>
          <topics publish="ALLOW">
            <topic>/rosout</topic>
            <topic>/tf</topic>  <!-- src/demo/demo/node.py:23, by tf2_ros.TransformBroadcaster -->
            <topic>/x</topic>  <!-- src/demo/demo/node.py:20 -->
          </topics>
          <topics subscribe="ALLOW">
            <topic>/r_*/y</topic>  <!-- src/demo/demo/node.py:21, conditional, partially known name: * also matches / -->
          </topics>
        </profile>
      </profiles>
    </enclave>
  </enclaves>
</policy>
"""
    )


def test_an_unknown_name_may_be_any_name() -> None:
    """The wildcard has to hold an absolute name too, so it is not confined to the namespace."""
    network = one(pub("/ns/*", resolution=Resolution.UNKNOWN))
    assert rules(valid(policy_xml(network))) == []
    assert rules(valid(policy_xml(network, unknown="wildcard"))) == ["/ns a publish /*"]


@pytest.mark.parametrize(
    "name", ["/a[bc]", "/a?", "relative", "/a//b", "/a/", "/1a", "/a b", "", "~/x", "/x\n/y", "/é"]
)
def test_no_rule_for_a_name_that_ros_cannot_hold(name: str) -> None:
    text = valid(policy_xml(one(pub(name))))
    assert rules(text) == []
    assert "not a valid name in ROS" in text


def test_no_rule_outside_the_ros_names() -> None:
    text = valid(policy_xml(one(pub("/x", ros_prefix=False))))
    assert rules(text) == []
    assert "Not granted: publisher /x" in text


def test_two_nodes_of_one_name_share_one_profile() -> None:
    network = connect(
        "jazzy",
        [
            node("/a", pub("/x"), system=False, process="p"),
            node("/a", sub("/y"), pub("/x"), system=False, process="q", defined_at=Place("other.py", 3)),
        ],
    )
    text = valid(policy_xml(network))
    assert rules(text) == ["/ a publish /x", "/ a subscribe /y"]
    assert text.count("<profile ") == 1
    assert "2 nodes have this full name" in text


def test_nodes_of_one_enclave_are_profiles_of_it() -> None:
    network = connect("jazzy", [node("/b", enclave="/e"), node("/a", enclave="/e")])
    root = ET.fromstring(valid(policy_xml(network)))
    assert [e.get("path") for e in root.iter("enclave")] == ["/e"]
    assert len(list(root.iter("profiles"))) == 1
    assert [p.get("node") for p in root.iter("profile")] == ["a", "b"]


def test_a_node_with_a_hole_in_its_name() -> None:
    network = connect("jazzy", [node("/robot_*/a", pub("/robot_*/a/x", resolution=Resolution.PATTERN), system=False)])
    text = valid(policy_xml(network))
    assert rules(text) == ["/robot_* a publish /robot_*/a/x"]
    assert 'path="/robot_unknown/a"' in text
    assert "ROS_SECURITY_ENCLAVE_OVERRIDE=/robot_unknown/a in its environment" in text


def test_an_enclave_alone() -> None:
    network = talker_and_listener()
    alone = valid(policy_xml(network, "/robot1/talker"))
    assert 'node="talker"' in alone
    assert 'node="listener"' not in alone
    assert policies(network) == {path: policy_xml(network, path) for path in ("/robot1/listener", "/robot1/talker")}
    with pytest.raises(ValueError, match="no enclave '/other'"):
        policy_xml(network, "/other")


def test_a_node_with_nothing_has_an_empty_profile() -> None:
    assert '<profile ns="/ns" node="a"/>' in valid(policy_xml(one()))


def test_each_element_has_one_attribute_and_all_names_are_absolute() -> None:
    root = ET.fromstring(valid(policy_xml(fleet(2))))
    for profile in root.iter("profile"):
        for element in profile:
            assert len(element.attrib) == 1
            names = [name.text or "" for name in element]
            assert names == sorted(set(names))
            assert all(name.startswith("/") for name in names)


ANY = st.text(alphabet=st.characters(), max_size=12) | st.sampled_from(
    ["-->", "--", "-", "]]>", "<!--", "&#0;", "\x00", "\ud800", '"']
)


@given(ANY, ANY, ANY, ANY)
def test_any_text_gives_a_valid_policy(name: str, namespace: str, topic: str, reason: str) -> None:
    hostile = node(
        "/a",
        pub(topic, reasons=(reason,), via=reason, created_at=(Place(reason, 1),)),
        pub("/ok", created_at=(Place(reason, 1),), via=reason),
        namespace=namespace,
        name=name,
        enclave=namespace,
        defined_at=Place(reason, 2),
    )
    text = policy_xml(connect("jazzy", [hostile, hostile]))
    text.encode()
    valid(text)
    expected = {"/ok", "/rosout", "/parameter_events"}
    assert expected <= {rule.rpartition(" ")[2] for rule in rules(text) if " publish " in rule}
