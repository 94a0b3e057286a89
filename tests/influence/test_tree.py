# SPDX-License-Identifier: Apache-2.0
"""Promise: a tree of what something is made of has each part once, with all that makes it, whatever cycles the system has."""

from __future__ import annotations

from rosward.influence.graph import graph_of
from rosward.influence.search import at_least, upstream
from rosward.influence.select import Selection, meant
from rosward.influence.tree import Tree
from rosward.outputs.terminal.flow_text import tree_text

from .systems import system


def tree(name: str, *lines: str, by: str = "control") -> list[str]:
    """The tree of one name: `{indent}{strength} {source}`, with `+` where more stands above."""
    graph = graph_of(system(*lines))
    made = Tree(graph, at_least(by))
    told = []
    for root in made.roots(meant([Selection(name)], graph.vertices)):
        told.append(str(root))
        for step in made.steps(root):
            more = " +" if step.above else ""
            told.append(f"{' ' * step.depth}{step.edge.strength} {step.edge.source.end}{more}")
    return told


CHAIN = (
    "/planner: topic:/plan <- topic:/map, control request:/mode",
    "/control: topic:/cmd_vel <- topic:/plan, trigger timer",
)


def test_what_each_part_is_made_of_stands_below_it() -> None:
    assert tree("/cmd_vel", *CHAIN) == ["/cmd_vel", " data topic:/plan", "  data topic:/map", "  control request:/mode"]
    assert tree("/cmd_vel", *CHAIN, by="data") == ["/cmd_vel", " data topic:/plan", "  data topic:/map"]
    assert " trigger timer" in tree("/cmd_vel", *CHAIN, by="trigger")


def test_a_cycle_ends() -> None:
    lines = ("/a: topic:/x <- topic:/y, topic:/in", "/b: topic:/y <- topic:/x")
    assert tree("/x", *lines) == ["/x", " data topic:/y", "  data topic:/x +", " data topic:/in"]


def test_a_part_of_two_things_is_told_in_full_once() -> None:
    lines = (
        "/a: topic:/x <- topic:/left, topic:/right",
        "/l: topic:/left <- topic:/base",
        "/r: topic:/right <- topic:/base",
        "/m: topic:/base <- topic:/in",
    )
    assert tree("/x", *lines).count("   data topic:/in") == 1
    assert "  data topic:/base +" in tree("/x", *lines)


def test_a_topic_that_is_also_read_stands_once() -> None:
    """What is sent and what arrives under one name is one thing."""
    lines = ("/a: topic:/x <- topic:/in", "/b: topic:/y <- topic:/x")
    assert tree("/x", *lines) == ["/x", " data topic:/in"]


def test_a_sender_of_a_name_that_may_be_this_one_counts_where_it_arrives() -> None:
    lines = ("/a: topic:/x <- topic:/in", "/b: topic:/* <- topic:/other", "/c: topic:/y <- topic:/x")
    assert {" data topic:/in", " data topic:/other"} <= set(tree("topic:/x", *lines))


def test_a_very_long_chain() -> None:
    lines = [f"/n{n}: topic:/t{n} <- topic:/t{n + 1}" for n in range(3_000)]
    assert len(tree("/t0", *lines)) == 3_001


def test_the_text_of_a_tree_has_a_bound() -> None:
    lines = [f"/n{i}: topic:/* <- topic:/*, topic:/a{i}" for i in range(60)]
    graph = graph_of(system(*lines))
    targets = meant([Selection("**")], graph.vertices)
    passing = at_least("control")
    told = tree_text(graph, targets, upstream(graph, targets, passing), passing).splitlines()
    assert told[-1] == "…  (use --format json for everything)"
    assert len(told) == 2_001
