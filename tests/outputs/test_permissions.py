# SPDX-License-Identifier: Apache-2.0
"""DDS permissions: what sros2 would make of the same policy, in the order of the specification."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from rosward.enclaves.size import size_findings
from rosward.network.connect import connect
from rosward.outputs.policies.permissions import permissions, permissions_xml
from rosward.ros.entities import Entity, EntityKind, Resolution

from .networks import entity, node, pub, sub, system_entities, talker_and_listener

KIND = EntityKind


def granted(*entities: Entity) -> tuple[list[str], list[str]]:
    network = connect("jazzy", [node("/a", *entities, system=False)])
    root = ET.fromstring(permissions_xml(network, "/a", ros_discovery_info=False))
    return tuple([t.text or "" for t in root.iterfind(f".//{way}/topics/topic")] for way in ("publish", "subscribe"))  # type: ignore[return-value]


@pytest.mark.parametrize(
    ("made", "publish", "subscribe"),
    [
        (pub("/x"), ["rt/x"], []),
        (sub("/x"), [], ["rt/x"]),
        (pub("/r_*/x", resolution=Resolution.PATTERN), ["rt/r_*/x"], []),
        (pub("/x", ros_prefix=False), ["/x"], []),
        (entity(KIND.SERVICE_SERVER, "/s"), ["rr/sReply"], ["rq/sRequest"]),
        (entity(KIND.SERVICE_CLIENT, "/s"), ["rq/sRequest"], ["rr/sReply"]),
        (
            entity(KIND.ACTION_CLIENT, "/d"),
            ["rq/d/_action/cancel_goalRequest", "rq/d/_action/get_resultRequest", "rq/d/_action/send_goalRequest"],
            [
                "rr/d/_action/cancel_goalReply",
                "rr/d/_action/get_resultReply",
                "rr/d/_action/send_goalReply",
                "rt/d/_action/feedback",
                "rt/d/_action/status",
            ],
        ),
        (
            entity(KIND.ACTION_SERVER, "/d"),
            [
                "rr/d/_action/cancel_goalReply",
                "rr/d/_action/get_resultReply",
                "rr/d/_action/send_goalReply",
                "rt/d/_action/feedback",
                "rt/d/_action/status",
            ],
            ["rq/d/_action/cancel_goalRequest", "rq/d/_action/get_resultRequest", "rq/d/_action/send_goalRequest"],
        ),
        (pub("/*", resolution=Resolution.UNKNOWN), [], []),
        (pub("/a[b]"), [], []),
    ],
)
def test_what_each_kind_needs(made: Entity, publish: list[str], subscribe: list[str]) -> None:
    assert granted(made) == (publish, subscribe)


def test_the_whole_of_small_permissions() -> None:
    network = connect("jazzy", [node("/a", pub("/x"), pub("/x", "a/msg/B"), system=False)])
    assert (
        permissions_xml(network, "/a", 5, not_before="2024-01-01T00:00:00", not_after="2025-01-01T00:00:00")
        == """\
<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" \
xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd">
  <permissions>
    <grant name="/a">
      <subject_name>CN=/a</subject_name>
      <validity>
        <not_before>2024-01-01T00:00:00</not_before>
        <not_after>2025-01-01T00:00:00</not_after>
      </validity>
      <allow_rule>
        <domains>
          <id>5</id>
        </domains>
        <publish>
          <topics>
            <topic>rt/x</topic>
          </topics>
        </publish>
      </allow_rule>
      <allow_rule>
        <domains>
          <id>5</id>
        </domains>
        <publish>
          <topics>
            <topic>ros_discovery_info</topic>
          </topics>
        </publish>
        <subscribe>
          <topics>
            <topic>ros_discovery_info</topic>
          </topics>
        </subscribe>
      </allow_rule>
      <default>DENY</default>
    </grant>
  </permissions>
</dds>
"""
    )


def test_each_enclave_has_its_own() -> None:
    network = talker_and_listener()
    assert permissions(network) == {
        path: permissions_xml(network, path) for path in ("/robot1/listener", "/robot1/talker")
    }
    with pytest.raises(ValueError, match="no enclave"):
        permissions_xml(network, "/other")


def test_what_the_handshake_cannot_carry() -> None:
    """Sixty nodes of the usual kind fill one enclave beyond what is safe, ten do not."""

    def crowd(number: int) -> list[str]:
        nodes = [
            node(
                f"/node_{n}",
                pub("/out_a"),
                pub("/out_b"),
                sub("/in"),
                entity(KIND.ACTION_SERVER, f"/node_{n}/do"),
                *system_entities(f"/node_{n}"),
                system=False,
                enclave="/all",
            )
            for n in range(number)
        ]
        return [finding.code for finding in size_findings(connect("jazzy", nodes).nodes)]

    assert crowd(10) == []
    assert crowd(60) == ["RW304"]
