# SPDX-License-Identifier: Apache-2.0
"""Functions, loops, timers and event handlers: what they start, when, and with which state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import pytest

from deployment.execution import HERE, UNKNOWN, Run, plain, text, var
from rosward.deployment import tree
from rosward.deployment.performer import Performer
from rosward.domain.values import Const, Value


def node(name: str, **given: object) -> tree.StartNode:
    return tree.StartNode(place=HERE, package=text("p"), executable=text(name), **given)  # type: ignore[arg-type]


def let(name: str, value: str) -> tree.SetConfiguration:
    return tree.SetConfiguration(place=HERE, name=text(name), value=text(value))


def test_a_function_sees_and_changes_the_context() -> None:
    def setup(performer: Performer, _kwargs: Mapping[str, Value]) -> Sequence[tree.LaunchAction]:
        assert performer.text(var("x")) == Const("1")
        performer.set_configuration("y", Const("2"))
        return [tree.StartNode(place=HERE, executable=var("y"))]

    opaque = tree.Opaque(place=HERE, function=Const("setup"))
    assert Run([let("x", "1"), opaque], functions={"setup": setup}).lines == ["2 --ros-args"]


def test_a_handler_with_a_function() -> None:
    def late(_performer: Performer, _kwargs: Mapping[str, Value]) -> Sequence[tree.LaunchAction]:
        return [tree.StartNode(place=HERE, executable=var("x"))]

    handler = tree.OnEvent(place=HERE, event="process-start", function=Const("late"))
    assert Run([let("x", "1"), handler, let("x", "2")], functions={"late": late}).lines == [
        "2 --ros-args @process-start"
    ]


def test_a_handler_waits_for_its_target() -> None:
    """The handler of a node that is not started never runs; that of one that a handler starts runs then."""
    one, two, three = Const("node one"), Const("node two"), Const("node three")
    never = tree.Condition("if", (text("false"),), HERE)
    actions = [
        tree.OnEvent(place=HERE, event="process-exit", actions=(node("after-one"),), target=one),
        tree.OnEvent(place=HERE, event="process-exit", actions=(node("after-two"),), target=two),
        tree.OnEvent(place=HERE, event="process-exit", actions=(node("two", identity=two),), target=three),
        node("one", identity=one, condition=never),
        node("three", identity=three),
    ]
    assert Run(actions).lines == [
        "p/three --ros-args",
        "p/two --ros-args @process-exit [maybe]",
        "p/after-two --ros-args @process-exit [maybe]",
    ]


def test_the_handler_of_a_node_that_may_be_started() -> None:
    one = Const("node one")
    maybe = tree.Condition("if", ((UNKNOWN,),), HERE)
    handler = tree.OnEvent(place=HERE, event="process-exit", actions=(node("after"),), target=one)
    run = Run([handler, node("one", identity=one, condition=maybe)])
    assert run.lines == ["p/one --ros-args [maybe]", "p/after --ros-args @process-exit [maybe]"]


def test_events_that_need_not_come() -> None:
    run = Run([tree.OnEvent(place=HERE, event=event, actions=(node(event),)) for event in ("lifecycle", "process-io")])
    assert run.lines == ["p/lifecycle --ros-args @lifecycle [maybe]", "p/process-io --ros-args @process-io [maybe]"]


def test_timers_within_timers() -> None:
    inner = tree.Timer(place=HERE, period=text("1"), actions=(node("inner"),))
    outer = tree.Timer(place=HERE, period=text("2.0"), actions=(node("outer"), inner))
    between = tree.Timer(place=HERE, period=text("2.5"), actions=(node("between"),))
    assert Run([outer, between]).lines == [f"p/{n} --ros-args @timer" for n in ("outer", "between", "inner")]


def test_a_timer_knows_its_launch_file_a_handler_does_not() -> None:
    main = '<timer period="1"><node pkg="p" exec="$(filename)"/></timer>'
    assert Run(main).lines == ["p/*/launch/main.launch.xml --ros-args @timer"]
    filename = (tree.Substitution("filename", (), HERE),)
    handler = tree.OnEvent(place=HERE, event="process-exit", actions=(tree.StartNode(place=HERE, executable=filename),))
    assert Run([handler]).codes == ["RW320"]


@pytest.mark.parametrize("values", ["{name: a, id: 1};{name: b, id: 2}", " ; {name: a, id: 1}; ;name: b\nid: 2;"])
def test_for_each(values: str) -> None:
    seen: list[str] = []

    def body(_performer: Performer, kwargs: Mapping[str, Value]) -> Sequence[tree.LaunchAction]:
        seen.append(", ".join(f"{k}={plain(v)}" for k, v in kwargs.items()))
        return [node("n")]

    run = Run([tree.ForEach(place=HERE, values=text(values), function=Const("body"))], functions={"body": body})
    assert seen == ["name='a', id=1", "name='b', id=2"]
    assert len(run.lines) == 2


def test_a_loop_with_a_body() -> None:
    index = (tree.Substitution("index", (text("i"),), HERE),)
    loop = tree.ForEach(
        place=HERE, values=text("3"), count=True, index_name="i", body=(tree.StartNode(place=HERE, executable=index),)
    )
    assert Run([loop]).lines == ["0 --ros-args", "1 --ros-args", "2 --ros-args"]


def test_a_loop_of_unknown_length() -> None:
    index = (tree.Substitution("index", (text("i"),), HERE),)
    loop = tree.ForEach(
        place=HERE, values=(UNKNOWN,), count=True, index_name="i", body=(tree.StartNode(place=HERE, executable=index),)
    )
    run = Run([loop])
    assert (run.lines, run.codes) == (["* --ros-args [maybe]"], ["RW313"])


def test_a_file_that_includes_itself_ends() -> None:
    run = Run('<include file="$(find-pkg-share demo)/launch/main.launch.xml"/><node pkg="p" exec="e"/>')
    assert "RW201" in run.codes
    assert len(run.lines) == 41


def test_a_file_that_includes_itself_twice_ends() -> None:
    include = '<include file="$(find-pkg-share demo)/launch/main.launch.xml"/>'
    assert "RW201" in Run(include + include).codes


def test_handlers_that_start_each_other_end() -> None:
    def again(_performer: Performer, _kwargs: Mapping[str, Value]) -> Sequence[tree.LaunchAction]:
        return [tree.OnEvent(place=HERE, event="process-exit", function=Const("again"))]

    run = Run([tree.OnEvent(place=HERE, event="process-exit", function=Const("again"))], functions={"again": again})
    assert run.codes == ["RW201"]


def test_timers_that_start_each_other_end() -> None:
    def again(_performer: Performer, _kwargs: Mapping[str, Value]) -> Sequence[tree.LaunchAction]:
        return [tree.Timer(place=HERE, period=text("1"), actions=(tree.Opaque(place=HERE, function=Const("again")),))]

    run = Run([tree.Opaque(place=HERE, function=Const("again"))], functions={"again": again})
    assert run.codes == ["RW201"]


def test_deep_groups_end() -> None:
    inner: tree.LaunchAction = node("e")
    for _ in range(300):
        inner = tree.Group(place=HERE, actions=(inner,))
    assert Run([inner]).codes == ["RW201"]
