# SPDX-License-Identifier: Apache-2.0
"""What is not known is executed both ways: nothing that may be started is left out, nothing that surely is becomes doubtful."""

from __future__ import annotations

from deployment.execution import HERE, UNKNOWN, Run, shown, text, var
from rosward.deployment import tree
from rosward.domain.unknown import Origin
from rosward.domain.values import Const

NODE = '<node pkg="p" exec="e"/>'


def node(name: str, **given: object) -> tree.StartNode:
    return tree.StartNode(place=HERE, package=text("p"), executable=text(name), **given)  # type: ignore[arg-type]


def test_a_default_decides_a_condition() -> None:
    main = '<arg name="sim" default="false"/><node pkg="p" exec="a" if="$(var sim)"/><node pkg="p" exec="b" unless="$(var sim)"/>'
    assert Run(main).lines == ["p/b --ros-args"]
    assert Run(main, sim="true").lines == ["p/a --ros-args"]


def test_a_star_leaves_an_argument_open() -> None:
    main = '<arg name="sim" default="false"/><node pkg="p" exec="a" if="$(var sim)"/>'
    run = Run(main, sim="*")
    assert (run.lines, run.codes) == (["p/a --ros-args [maybe]"], ["RW316"])
    assert run.started[0].why == ("launch argument without a value: sim",)


def test_choices_are_the_alternatives_of_an_open_argument() -> None:
    main = '<arg name="kind"><choice value="a"/><choice value="b"/></arg><node pkg="p" exec="$(var kind)"/>'
    assert Run(main, kind="*").lines == ["p/a|b --ros-args"]
    assert Run(main, kind="c").codes == ["RW320"]
    assert Run(main).codes == ["RW312"]


def test_the_default_of_an_environment_variable_may_be_another() -> None:
    main = '<node pkg="p" exec="a" if="$(env SIM false)"/>'
    run = Run(main)
    assert (run.lines, run.codes) == (["p/a --ros-args [maybe]"], [])  # RW325 tells it of the whole system


def test_a_variable_that_launch_set_is_known() -> None:
    assert Run('<set_env name="SIM" value="true"/><node pkg="p" exec="a" if="$(env SIM false)"/>').lines == [
        "p/a --ros-args"
    ]


def test_a_configuration_set_under_an_unknown_condition_has_both_values() -> None:
    main = '<let name="x" value="1"/><let name="x" value="2" if="$(env E)"/><node pkg="p" exec="$(var x)"/>'
    assert Run(main).lines == ["p/1|2 --ros-args"]


def test_a_namespace_pushed_under_an_unknown_condition() -> None:
    """A node has one namespace or the other; below a group that is scoped nothing is left of it."""
    main = f'<push_ros_namespace namespace="a" if="$(env E)"/>{NODE}<group if="$(env E)"><push_ros_namespace namespace="b"/></group>'
    assert Run(main).lines == ["p/e --ros-args [maybe]", "p/e --ros-args -r __ns:=/a [maybe]"]


def test_what_surely_holds_stays_sure_behind_an_unknown_condition() -> None:
    main = f'<group if="$(env E)"><push_ros_namespace namespace="a"/>{NODE}</group>{NODE}'
    assert Run(main).lines == ["p/e --ros-args -r __ns:=/a [maybe]", "p/e --ros-args"]


def test_actions_that_python_may_or_may_not_give() -> None:
    maybe = tree.Maybe(
        place=HERE,
        actions=(tree.SetConfiguration(place=HERE, name=text("x"), value=text("2")), node("m")),
        why="a file",
    )
    first = tree.SetConfiguration(place=HERE, name=text("x"), value=text("1"))
    run = Run([first, maybe, tree.StartNode(place=HERE, executable=var("x"))])
    assert run.lines == ["p/m --ros-args [maybe]", "1|2 --ros-args"]


def test_a_configuration_that_may_be_unset() -> None:
    main = '<let name="x" value="1" if="$(env E)"/><node pkg="p" exec="$(var x other)"/>'
    assert Run(main).lines == ["p/1|other --ros-args"]


def test_an_unknown_namespace_keeps_its_slash() -> None:
    assert Run('<node pkg="p" exec="e" namespace="$(env NS)"/>').lines == ["p/e --ros-args -r __ns:=/*"]


def test_an_include_of_one_of_several_files() -> None:
    files = {f"demo/launch/{n}.launch.xml": f'<launch><node pkg="p" exec="{n}"/></launch>' for n in "ab"}
    main = '<arg name="k"><choice value="a"/><choice value="b"/></arg><include file="$(find-pkg-share demo)/launch/$(var k).launch.xml"/>'
    assert Run(main, files, k="*").lines == ["p/a --ros-args [maybe]", "p/b --ros-args [maybe]"]


def test_an_include_that_is_not_known_is_told() -> None:
    run = Run(f'<include file="$(env WHERE)/a.launch.xml"/>{NODE}')
    assert (run.lines, run.codes) == (["p/e --ros-args"], ["RW311"])
    assert "environment variable: WHERE" in run.messages


def test_values_carry_what_they_come_from() -> None:
    main = '<arg name="a" default="x"/><arg name="b" default="$(var a)y"/><node pkg="p" exec="$(var b)"/>'
    (started,) = Run(main, a="z").started
    given, default = (
        Origin("launch argument", "a", settled=True, given=True),
        Origin("launch argument", "b", settled=True),
    )
    assert started.executable == Const("zy", frozenset((given, default)))


def test_a_typed_parameter_keeps_its_origin() -> None:
    main = '<arg name="rate" default="10"/><node pkg="p" exec="e"><param name="rate" value="$(var rate)"/></node>'
    (started,) = Run(main).started
    assert started.settings[0].value == Const(10, frozenset((Origin("launch argument", "rate", settled=True),)))


def test_arguments_that_nothing_asks_for() -> None:
    assert Run(NODE, typo="1").unread == ("typo",)
    assert Run('<node pkg="p" exec="$(var read)"/>', read="1").unread == ()


def test_an_argument_that_is_required() -> None:
    run = Run('<arg name="x"/><node pkg="p" exec="e" name="$(var x)"/>')
    assert (run.lines, run.codes) == (["p/e --ros-args -r __node:=*"], ["RW312"])


def test_a_configuration_that_nobody_sets() -> None:
    run = Run('<node pkg="p" exec="e" name="$(var x)"/>')
    assert (run.lines, run.codes) == (["p/e --ros-args -r __node:=*"], ["RW320"])


def test_unread_parts_are_told() -> None:
    run = Run([tree.Unread(place=HERE, why="a list that is not known"), node("e")])
    assert (run.lines, run.codes) == (["p/e --ros-args"], ["RW321"])


def test_many_unknown_pushes_are_bounded() -> None:
    main = "".join(f'<push_ros_namespace namespace="n{i}" if="$(env E{i})"/>' for i in range(6)) + NODE
    run = Run(main)
    assert len(run.lines) == 8
    assert "RW201" in run.codes


def test_a_condition_of_python() -> None:
    def when(value: Const | object) -> tree.Condition:
        return tree.Condition("python", (), HERE, value)  # type: ignore[arg-type]

    run = Run(
        [
            node("a", condition=when(Const(True))),
            node("b", condition=when(Const(False))),
            node("c", condition=when(UNKNOWN)),
        ]
    )
    assert run.lines == ["p/a --ros-args", "p/c --ros-args [maybe]"]
    assert shown(run.started[1].executable) == "c"
