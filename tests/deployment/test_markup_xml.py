# SPDX-License-Identifier: Apache-2.0
"""XML launch files and the actions that they are."""

from __future__ import annotations

import pytest

from deployment.markup_tree import expected, xml
from rosward.deployment.markup.xml import read_xml

CASES = {
    "nodes": (
        """
        <launch>
          <arg name="id" default="1" description="which one"/>
          <node pkg="demo" exec="talker" name="talker_$(var id)" namespace="left" if="$(var run)"
                args="--file $(find-pkg-share demo)/a.txt 'two words'" ros_args="--log-level debug" output="screen"
                launch-prefix="xterm -e" respawn="true" respawn_delay="2.0" cwd="/" exec_name="t" on_exit="shutdown">
            <remap from="chatter" to="/chatter"/>
            <env name="A" value="$(env B c)"/>
          </node>
          <lifecycle_node pkg="demo" exec="arm" name="arm" namespace="" autostart="true" unless="false"/>
          <executable cmd="ros2 bag record $(var topic)s" shell="true" name="bag" output="log"/>
        </launch>
        """,
        """
        2: Declare name=id default=1 description=which one
        3: StartNode condition=if[$(var <run>)] package=demo executable=talker name=talker_$(var <id>) namespace=left
                remappings=[[chatter, /chatter]] arguments=[--file, $(find-pkg-share <demo>)/a.txt, two words] ros_arguments=[--log-level,
                debug] exec_name=t prefix=xterm -e environment=[[A, $(env <B> <c>)]]
            3: Inert kind='shutdown'
        9: StartNode condition=unless[false] kind=lifecycle package=demo executable=arm name=arm namespace=
        10: StartProcess command=[ros2, bag, record, $(var <topic>)s] shell=True
        """,
    ),
    "components": (
        """
        <launch>
          <node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
            <composable_node pkg="demo" plugin="demo::Talker" name="talker" namespace="left" if="$(var talk)">
              <remap from="chatter" to="news"/>
              <param name="rate" value="10"/>
              <extra_arg name="use_intra_process_comms" value="true"/>
            </composable_node>
          </node_container>
          <load_composable_node target="/$(var box)">
            <composable_node pkg="demo" plugin="demo::Listener" name="listener"/>
            <composable_lifecycle_node pkg="demo" plugin="demo::Arm" name="arm" autostart="true"/>
          </load_composable_node>
        </launch>
        """,
        """
        2: StartNode kind=container package=rclcpp_components executable=component_container name=box namespace=
            3: Component package=demo plugin=demo::Talker name=talker namespace=left remappings=[[chatter, news]] condition=if[$(var
                        <talk>)]
                5: rate = 10
                3: use_intra_process_comms = typed[true]
        9: LoadComponents target=/$(var <box>)
            10: Component package=demo plugin=demo::Listener name=listener
            11: Component package=demo plugin=demo::Arm name=arm
        """,
    ),
    "arguments and configurations": (
        """
        <launch>
          <arg name="mode"><choice value="fast"/><choice value="slow"/></arg>
          <arg name="empty" default=""/>
          <let name="twice" value="$(var mode)$(var mode)" unless="$(var off false)"/>
          <unset name="twice"/>
          <include file="$(dirname)/other.launch.py" if="true">
            <arg name="mode" value="fast"/>
            <let name="id" value="2"/>
          </include>
          <reset><keep name="mode" value="$(var mode)"/></reset>
        </launch>
        """,
        """
        2: Declare name=mode choices=[fast, slow]
        3: Declare name=empty default=
        4: SetConfiguration condition=unless[$(var <off> <false>)] name=twice value=$(var <mode>)$(var <mode>)
        5: SetConfiguration name=twice
        6: Include condition=if[true] path=$(dirname)/other.launch.py arguments=[[mode, fast], [id, 2]]
        10: ScopeChange what='configurations' how='reset' configurations=[[mode, $(var <mode>)]]
        """,
    ),
    "groups, timers and loops": (
        """
        <launch>
          <group scoped="false" if="$(var go)">
            <push_ros_namespace namespace="left"/>
            <group forwarding="0">
              <keep name="id" value="1"/>
              <push-ros-namespace namespace="arm"/>
            </group>
          </group>
          <timer period="2.5"><shutdown reason="over"/></timer>
          <ros_timer period="$(var wait)"><log message="now" level="DEBUG"/></ros_timer>
          <for_each values="{name: a};{name: b}">
            <node pkg="demo" exec="talker" name="$(for-var name)"/>
          </for_each>
          <for len="$(var n)" name="i"><log_info message="$(index i)"/></for>
        </launch>
        """,
        """
        2: Group condition=if[$(var <go>)] scoped=False
            3: PushNamespace namespace=left
            4: Group forwarding=False configurations=[[id, 1]]
                6: PushNamespace namespace=arm
        9: Timer period=2.5
            9: Inert kind='shutdown'
        10: Timer period=$(var <wait>)
            10: Inert kind='log'
        11: ForEach values={name: a};{name: b}
            12: StartNode package=demo executable=talker name=$(for-var <name>)
        14: ForEach values=$(var <n>) count=True index_name='i'
            14: Inert kind='log_info'
        """,
    ),
    "environment": (
        """
        <launch>
          <set_env name="A" value="b"/>
          <unset_env name="A"/>
          <append_env name="PATH" value="/opt"/>
          <append_env name="PATH" value="/opt" prepend="true" separator=","/>
          <append_env name="PATH" value="/opt" prepend="$(var first)"/>
          <reset_env/>
        </launch>
        """,
        """
        2: Environ how='set' name=A value=b
        3: Environ how='unset' name=A
        4: Environ how='append' name=PATH value=/opt separator=:
        5: Environ how='prepend' name=PATH value=/opt separator=,
        6: Group scoped=False
            6: Environ condition=if[$(var <first>)] how='prepend' name=PATH value=/opt separator=:
            6: Environ condition=unless[$(var <first>)] how='append' name=PATH value=/opt separator=:
        7: ScopeChange what='environment' how='reset'
        """,
    ),
    "what holds for the nodes that follow": (
        """
        <launch>
          <set_remap from="scan" to="/scan"/>
          <set_parameter name="rate" value="10"/>
          <set_parameters_from_file filename="$(var file)"/>
          <set_use_sim_time value="true"/>
          <set_ros_log_dir new_log_dir="/tmp/log"/>
        </launch>
        """,
        """
        2: SetRemap source=scan target=/scan
        3: SetParameter parameter=3:{rate: typed[10]}
        4: SetParameter parameter=4:file[$(var <file>)]
        5: Inert kind='set_use_sim_time'
        6: Inert kind='set_ros_log_dir'
        """,
    ),
    "parameters: XML values are YAML, and stay text where they are quoted": (
        """
        <launch>
          <node pkg="demo" exec="talker">
            <param name="whole" value="010"/>
            <param name="part" value="1e3"/>
            <param name="exact" value="1.5"/>
            <param name="flag" value="yes"/>
            <param name="text" value="hello"/>
            <param name="quoted" value="'1'"/>
            <param name="none" value=""/>
            <param name="list" value="[1, 2]"/>
            <param name="words" value="[a, $(var b)]"/>
            <param name="cut" value="1;2" value-sep=";"/>
            <param name="open" value="$(var x)"/>
          </node>
        </launch>
        """,
        """
        2: StartNode package=demo executable=talker
            3: whole = 8
            4: part = '1e3'
            5: exact = 1.5
            6: flag = True
            7: text = 'hello'
            8: quoted = '1'
            9: none = ''
            10: list = [1, 2]
            11: words = several['a', typed[$(var <b>)] as yaml]
            12: cut = [1, 2]
            13: open = typed[$(var <x>)] as yaml
        """,
    ),
    "parameters with a type": (
        """
        <launch>
          <node pkg="demo" exec="talker">
            <param name="text" value="1" type="str"/>
            <param name="open" value="$(var x)" type="str"/>
            <param name="exact" value="1" type="float"/>
            <param name="flag" value="1" type="bool"/>
            <param name="words" value="[a, '1']" type="list_of_str"/>
            <param name="whole" value="[1, $(var x)]" type="list_of_int"/>
            <param name="any" value="3" type="yaml"/>
          </node>
        </launch>
        """,
        """
        2: StartNode package=demo executable=talker
            3: text = '1'
            4: open = typed[$(var <x>)] as str
            5: exact = 1.0
            6: flag = True
            7: words = ['a', '1']
            8: whole = several[1, typed[$(var <x>)] as int]
            9: any = 3
        """,
    ),
    "nested parameters and files, in order": (
        """
        <launch>
          <node pkg="demo" exec="talker">
            <param name="pid">
              <param name="p" value="0.5"/>
              <param name="$(var k)"><param name="max" value="1"/></param>
            </param>
            <param from="$(find-pkg-share demo)/p.yaml" allow_substs="true"/>
            <param from="q.yaml"/>
          </node>
        </launch>
        """,
        """
        2: StartNode package=demo executable=talker
            3: pid.p = 0.5
            3: pid.$(var <k>).max = 1
            7:file[$(find-pkg-share <demo>)/p.yaml] with substitutions
            8:file[q.yaml]
        """,
    ),
    "what launch refuses is told, and the rest is read": (
        """
        <launch version="1">
          <node pkg="demo" exec="talker" nmae="t" node-name="u"><parma name="a" value="1"/></node>
          <node pkg="demo"><remap from="a"/></node>
          <node pkg="demo" exec="a" if="1" unless="0" respawn_delay="$(var d)" args="it's"/>
          <node pkg="$(find demo)" exec="$(var a" name="$(env)"/>
          <let name="a" value="$(var a)"><arg name="b"/></let>
          <include/>
          <node pkg="demo" exec="a"><param/><param name="a"/><param name="b" value="1" type="double"/></node>
          <node pkg="demo" exec="a"><param name="b" value="{c: d}"/><param name="c" value="a" type="int"/></node>
          <node pkg="demo" exec="a"><param name="b" value="$(var x)" type="list_of_int"/><param name="c" value="[1, a]"/></node>
          <group scoped="5"><timer period="soon"/></group>
        </launch>
        """,
        """
        2: StartNode package=demo executable=talker
        3: StartNode package=demo executable=$(unknown <exec>) remappings=[[a, $(unknown <to>)]]
        4: StartNode condition=if[$(unknown <if and unless>)] package=demo executable=a arguments=[it's]
        5: StartNode package=$(unknown <find>) executable=$(unknown <$(var a>) name=$(unknown <$(env)>)
        6: SetConfiguration name=a value=$(var <a>)
        7: Include path=$(unknown <file>)
        8: StartNode package=demo executable=a
            8: b = 1
        9: StartNode package=demo executable=a
            9: b = typed[{c: d}]
            9: c = 'a'
        10: StartNode package=demo executable=a
            10: b = typed[$(var <x>)] as List[int]
            10: c = [1, 'a']
        11: Group
            11: Timer period=soon
        RW320 2: Unexpected attribute 'nmae' of <node>.
        RW320 2: Unexpected attribute 'node-name' of <node>.
        RW320 2: Unexpected nested tag <parma> in <node>.
        RW320 3: <node> has no attribute 'exec', which launch requires.
        RW320 3: <remap> has no attribute 'to', which launch requires.
        RW320 4: <node> has both 'if' and 'unless', which launch does not accept together.
        RW320 4: "it's" is not a valid command line: No closing quotation.
        RW320 4: 'respawn_delay' of <node> must be a non-negative float; substitutions are not allowed.
        RW320 5: launch has no substitution $(find …).
        RW320 5: '$(var a' is not a valid launch string: a substitution is not closed, or its arguments are not separated by one space (at the end).
        RW320 5: '$(env)' is not a valid launch string: $(env …) does not take 0 arguments (at the end).
        RW320 6: Unexpected nested tag <arg> in <let>.
        RW320 7: <include> has no attribute 'file', which launch requires.
        RW320 8: <param> has neither 'name' nor 'from'.
        RW320 8: <param> has neither a 'value' nor nested parameters.
        RW320 8: launch has no parameter type 'double'.
        RW320 9: The value of <param> is not a valid parameter value.
        RW320 9: 'a' in <param> is not of type int.
        RW320 10: The value of <param> is not a list, which List[int] requires.
        RW320 10: The list in <param> has elements of several types.
        RW320 11: 'scoped' of <group> is of type int, but launch requires true or false.
        RW320 11: 'period' of <timer> is not a number.
        """,
    ),
    "a tag that is not known may start anything": (
        """
        <launch>
          <my_robot arms="2" if="$(var sim)"><node pkg="a" exec="b"/></my_robot>
          <log message="on"/>
        </launch>
        """,
        """
        2: Unread condition=if[$(var <sim>)] why='The tag <my_robot> is unknown.'
        3: Inert kind='log'
        """,
    ),
    "empty": ("<launch/>", ""),
}


@pytest.mark.parametrize(("text", "tree"), CASES.values(), ids=CASES)
def test_actions(text: str, tree: str) -> None:
    assert xml(text) == expected(tree)


def test_the_column_is_that_of_the_tag() -> None:
    """Two tags in one line are two places."""
    description, _ = read_xml('<launch><log message="a"/><log message="b"/></launch>', "f.xml")
    assert [(each.place.line, each.place.column) for each in description.actions] == [(1, 9), (1, 27)]
