# SPDX-License-Identifier: Apache-2.0
"""What the real launch was seen to do, one fact a test."""

from __future__ import annotations

from deployment.execution import HERE, Run, text, var
from rosward.deployment import tree
from rosward.domain.values import Const

NODE = '<node pkg="p" exec="e"/>'


def node(name: str, **given: object) -> tree.StartNode:
    return tree.StartNode(place=HERE, package=text("p"), executable=text(name), **given)  # type: ignore[arg-type]


# Includes


def test_what_an_include_sets_stays_set() -> None:
    files = {"demo/launch/a.launch.xml": '<launch><arg name="x" default="inner"/></launch>'}
    include = '<include file="$(dirname)/a.launch.xml"/>'
    assert Run(f'{include}<node pkg="p" exec="$(var x)"/>', files).lines == ["p/inner --ros-args"]


def test_a_second_include_gets_the_arguments_of_the_first() -> None:
    files = {"demo/launch/a.launch.xml": '<launch><arg name="x" default="d"/><node pkg="p" exec="$(var x)"/></launch>'}
    path = "$(find-pkg-share demo)/launch/a.launch.xml"
    first = f'<include file="{path}"><arg name="x" value="1"/></include>'
    assert Run(f'{first}<include file="{path}"/>', files).lines == ["p/1 --ros-args", "p/1 --ros-args"]


def test_a_group_around_an_include_keeps_its_arguments_inside() -> None:
    files = {"demo/launch/a.launch.xml": '<launch><arg name="x" default="d"/><node pkg="p" exec="$(var x)"/></launch>'}
    path = "$(find-pkg-share demo)/launch/a.launch.xml"
    first = f'<group><include file="{path}"><arg name="x" value="1"/></include></group>'
    assert Run(f'{first}<include file="{path}"/>', files).lines == ["p/1 --ros-args", "p/d --ros-args"]


# Groups


def test_a_group_forgets_what_was_set_inside() -> None:
    main = '<let name="x" value="1"/><group><let name="x" value="2"/></group><node pkg="p" exec="$(var x)"/>'
    assert Run(main).lines == ["p/1 --ros-args"]


def test_a_group_that_is_not_scoped_leaks() -> None:
    main = '<let name="x" value="1"/><group scoped="false"><let name="x" value="2"/></group><node pkg="p" exec="$(var x)"/>'
    assert Run(main).lines == ["p/2 --ros-args"]


def test_a_group_without_forwarding_knows_only_what_it_keeps() -> None:
    main = """<let name="x" value="1"/><let name="y" value="2"/><push_ros_namespace namespace="a"/>
        <group forwarding="false"><keep name="x" value="$(var x)$(var y)"/>
        <node pkg="p" exec="$(var x)$(var y none)"/></group>"""
    assert Run(main).lines == ["p/12none --ros-args"]


def test_the_configurations_of_a_group_hold_inside_only() -> None:
    group = tree.Group(
        place=HERE, actions=(tree.StartNode(place=HERE, executable=var("x")),), configurations=((text("x"), text("1")),)
    )
    after = tree.StartNode(place=HERE, executable=var("x", "unset"))
    assert Run([group, after]).lines == ["1 --ros-args", "unset --ros-args"]


def test_a_group_scopes_namespace_remaps_parameters_and_environment() -> None:
    main = f"""<group><push_ros_namespace namespace="a"/><set_remap from="x" to="y"/><set_parameter name="n" value="1"/>
        <set_env name="V" value="1"/>{NODE}</group>{NODE}"""
    run = Run(main)
    assert run.lines == ["p/e --ros-args -r __ns:=/a -p n:=1 -r x:=y", "p/e --ros-args"]
    assert [dict(s.configuration.environment) for s in run.started] == [{"V": Const("1")}, {}]


def test_a_rule_added_in_a_group_leaks_where_there_was_one_before() -> None:
    """The group copies the names of launch configurations, not the list of rules that one of them holds."""
    main = f'<set_remap from="a" to="b"/><group><set_remap from="c" to="d"/></group>{NODE}'
    assert Run(main).lines == ["p/e --ros-args -r a:=b -r c:=d"]


# Later


def test_a_timer_runs_when_its_group_is_gone() -> None:
    main = """<let name="x" value="outer"/>
        <group><push_ros_namespace namespace="a"/><let name="x" value="inner"/><set_parameter name="n" value="1"/>
        <timer period="2"><node pkg="p" exec="$(var x)"/></timer><node pkg="p" exec="now"/></group>
        <let name="x" value="later"/>"""
    assert Run(main).lines == ["p/now --ros-args -r __ns:=/a -p n:=1", "p/later --ros-args @timer"]


def test_timers_run_in_the_order_of_their_periods() -> None:
    main = '<timer period="5"><node pkg="p" exec="b"/></timer><timer period="1"><node pkg="p" exec="a"/></timer>'
    assert Run(main).lines == ["p/a --ros-args @timer", "p/b --ros-args @timer"]


def test_a_handler_runs_after_all_and_outside_of_its_group() -> None:
    handler = tree.OnEvent(place=HERE, event="process-exit", actions=(node("late"),))
    push = tree.PushNamespace(place=HERE, namespace=text("a"))
    run = Run([tree.Group(place=HERE, actions=(push, handler, node("in"))), node("out")])
    assert run.lines == ["p/in --ros-args -r __ns:=/a", "p/out --ros-args", "p/late --ros-args @process-exit [maybe]"]


def test_what_a_process_starts_when_it_ends() -> None:
    assert Run([node("a", on_exit=(node("b"),))]).lines == ["p/a --ros-args", "p/b --ros-args @process-exit [maybe]"]


def test_nodes_of_the_shutdown_never_start() -> None:
    assert Run([tree.OnEvent(place=HERE, event="shutdown", actions=(node("never"),))]).lines == []


# Names


def test_without_a_namespace_none_is_passed_and_parameters_are_for_all_nodes() -> None:
    main = '<node pkg="p" exec="e" name="n"><param name="a" value="1"/></node>'
    assert Run(main).lines == ["p/e --ros-args -r __node:=n --params-file {/** a=1}"]


def test_an_empty_namespace_is_the_root() -> None:
    main = '<node pkg="p" exec="e" name="n" namespace=""><param name="a" value="1"/></node>'
    assert Run(main).lines == ["p/e --ros-args -r __node:=n -r __ns:=/ --params-file {/n a=1}"]


def test_a_dict_is_for_the_full_name_only_if_launch_knows_it() -> None:
    main = '<node pkg="p" exec="e" namespace="a"><param name="x" value="1"/></node>'
    assert Run(main).lines == ["p/e --ros-args -r __ns:=/a --params-file {/** x=1}"]


def test_relative_namespaces_are_appended_and_absolute_ones_win() -> None:
    main = """<push_ros_namespace namespace="a"/><push_ros_namespace namespace="b"/>
        <node pkg="p" exec="e" namespace="c"/><node pkg="p" exec="e" namespace="/c"/><node pkg="p" exec="e" namespace=""/>"""
    assert [line.split(":=")[1] for line in Run(main).lines] == ["/a/b/c", "/c", "/a/b"]


def test_a_component_gets_the_pushed_namespace_not_that_of_its_container() -> None:
    main = """<push_ros_namespace namespace="top"/>
        <node_container pkg="rclcpp_components" exec="component_container" name="cont" namespace="in">
          <composable_node pkg="p" plugin="p::A" name="a"/>
          <composable_node pkg="p" plugin="p::B" name="b" namespace="own"/>
        </node_container>
        <load_composable_node target="cont"><composable_node pkg="p" plugin="p::C"/></load_composable_node>"""
    assert Run(main).lines == [
        "rclcpp_components/component_container --ros-args -r __node:=cont -r __ns:=/top/in",
        "p/p::A in /top/in/cont --ros-args -r __node:=a -r __ns:=/top",
        "p/p::B in /top/in/cont --ros-args -r __node:=b -r __ns:=/top/own",
        "p/p::C in cont --ros-args -r __ns:=/top",
    ]


# Parameters


def test_what_is_set_for_all_nodes_comes_before_their_own() -> None:
    files = {"demo/all.yaml": "/**: {ros__parameters: {f: 1}}", "demo/own.yaml": "/**: {ros__parameters: {f: 2}}"}
    main = """<set_parameter name="g" value="1"/><set_parameters_from_file filename="$(find-pkg-share demo)/all.yaml"/>
        <set_remap from="a" to="b"/>
        <node pkg="p" exec="e" name="n" args="-v">
          <param from="$(find-pkg-share demo)/own.yaml"/><param name="x" value="1"/><remap from="c" to="d"/></node>"""
    assert Run(main, files).lines == [
        "p/e -v --ros-args -r __node:=n -p g:=1 --params-file */all.yaml --params-file */own.yaml"
        " --params-file {/** x=1} -r a:=b -r c:=d"
    ]


def test_what_is_set_for_all_nodes_acts_on_containers_and_components() -> None:
    main = """<set_parameter name="g" value="1"/><set_remap from="a" to="b"/>
        <node_container pkg="c" exec="c" name="cont" namespace="">
          <composable_node pkg="p" plugin="P" name="a"><param name="x" value="2"/></composable_node></node_container>"""
    assert Run(main).lines == [
        "c/c --ros-args -r __node:=cont -r __ns:=/ -p g:=1 -r a:=b",
        "p/P in /cont --ros-args -r a:=b -r __node:=a --params-file {/** g=1, /** x=2}",
    ]


def test_a_parameter_file_that_is_not_there_is_left_out() -> None:
    run = Run('<node pkg="p" exec="e"><param from="$(find-pkg-share demo)/none.yaml"/></node>')
    assert (run.lines, run.codes) == (["p/e --ros-args"], ["RW315"])


def test_a_missing_include_is_told_and_the_rest_goes_on() -> None:
    run = Run(f'<include file="$(find-pkg-share nav2_bringup)/launch/x.launch.py"/>{NODE}')
    assert (run.lines, run.codes) == (["p/e --ros-args"], ["RW311"])
    assert "the package 'nav2_bringup' is not among the sources" in run.messages


# Conditions


def test_words_of_a_condition() -> None:
    for word, starts in (("true", 1), (" TRUE ", 1), ("1", 1), ("False", 0), ("0", 0)):
        assert len(Run(f'<node pkg="p" exec="e" if="{word}"/>').lines) == starts
    run = Run('<node pkg="p" exec="e" if="yes"/>')
    assert (run.lines, run.codes) == (["p/e --ros-args [maybe]"], ["RW320", "RW316"])


def test_configuration_equals_on_a_name_that_is_not_set() -> None:
    def when(kind: str, name: str) -> tree.StartNode:
        return node(f"{kind}-{name}", condition=tree.Condition(kind, (text(name), text("v")), HERE))

    actions = [
        tree.SetConfiguration(place=HERE, name=text("set"), value=text("v")),
        *(when(kind, name) for kind in ("equals", "not-equals") for name in ("set", "unset")),
    ]
    assert Run(actions).lines == ["p/equals-set --ros-args", "p/not-equals-unset --ros-args"]
