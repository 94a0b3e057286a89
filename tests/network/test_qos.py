# SPDX-License-Identifier: Apache-2.0
"""RW309: which publisher and subscription can never talk because of their QoS, and what proves nothing."""

from __future__ import annotations

import pytest
from outputs.networks import node, pub, sub

from rosward.network.connect import connect
from rosward.ros.entities import Node, Qos

BEST = Qos("best_effort", "volatile", "keep_last", 5)
SURE = Qos("reliable", "volatile", "keep_last", 10)
LATCHED = Qos("reliable", "transient_local", "keep_last", 1)


def found(*nodes: Node) -> list[str]:
    network = connect("jazzy", nodes)
    return [f"{f.place}: {f.message}" for f in network.findings if f.code == "RW309"]


def test_the_subscription_wants_more_than_is_offered() -> None:
    assert found(node("/driver", pub("/scan", qos=BEST, line=3)), node("/viewer", sub("/scan", qos=SURE, line=5))) == [
        "src/demo/demo/node.py:5: topic /scan: subscription in /viewer requests reliable, "
        "publisher in /driver offers best_effort: they exchange no messages"
    ]
    assert found(node("/server", pub("/map", qos=SURE, line=3)), node("/viewer", sub("/map", qos=LATCHED, line=5))) == [
        "src/demo/demo/node.py:5: topic /map: subscription in /viewer requests transient_local, "
        "publisher in /server offers volatile: they exchange no messages"
    ]


def test_both_policies_are_told() -> None:
    assert len(found(node("/a", pub("/x", qos=BEST)), node("/b", sub("/x", qos=LATCHED)))) == 2


@pytest.mark.parametrize(
    ("offered", "requested"),
    [
        (SURE, SURE),
        (SURE, BEST),
        (LATCHED, SURE),
        (BEST, BEST),
        (None, SURE),
        (BEST, None),
        (Qos(None, "volatile"), SURE),
        (BEST, Qos(None, "volatile")),
        (Qos("system_default", "system_default"), LATCHED),
        (BEST, Qos("best_available", "best_available")),
        (BEST, Qos("system_default", "system_default")),
    ],
    ids=str,
)
def test_what_fits_or_is_not_known(offered: Qos | None, requested: Qos | None) -> None:
    assert not found(node("/a", pub("/x", qos=offered)), node("/b", sub("/x", qos=requested)))


def test_one_finding_for_a_topic_and_who_can_talk_is_not_named() -> None:
    talkers = [node(f"/t{n}", pub("/x", qos=BEST)) for n in range(5)]
    (text,) = found(
        *talkers, node("/sure", pub("/x", qos=SURE)), node("/v", sub("/x", qos=SURE)), node("/w", sub("/x", qos=BEST))
    )
    assert "subscription in /v requests reliable, publisher in /t0, /t1, /t2 and 2 more offers best_effort" in text


def test_ends_that_do_not_meet_anyway() -> None:
    viewer = node("/v", sub("/x", qos=SURE))
    assert not found(node("/a", pub("/x", "p/msg/Other", qos=BEST)), viewer)  # RW306 tells of these
    assert not found(node("/a", pub("/x", qos=BEST, ros_prefix=False)), viewer)
    assert not found(node("/a", pub("/*", qos=BEST)), node("/v", sub("/*", qos=SURE)))
    assert not found(node("/a", pub("/x", qos=BEST, system=True)), viewer)
    assert found(node("/a", pub("/x", None, qos=BEST)), viewer)


def test_alternatives_of_one_node() -> None:
    """`if simulated: publish … else: subscribe …` has never both."""
    either = pub("/x", qos=BEST, conditional=True), sub("/x", qos=SURE, conditional=True)
    assert not found(node("/a", *either))
    assert found(node("/a", *either), node("/b", sub("/x", qos=SURE, conditional=True)))
    assert found(node("/a", pub("/x", qos=BEST), sub("/x", qos=SURE, conditional=True)))
