# SPDX-License-Identifier: Apache-2.0
"""Each class of launch and launch_ros, as the tree has it."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

import pytest

from deployment.python_tree import Files, Launch
from rosward.deployment.tree import LoadComponents, OnEvent, StartNode

ACTIONS = {
    "arguments": (
        "DeclareLaunchArgument('a'), DeclareLaunchArgument('b', default_value=['x', LaunchConfiguration('a')], choices=['x', 'y'])",
        """
        Declare name=a
        Declare name=b default=x$(var a) choices=[x, y]
        """,
    ),
    "configurations": (
        "SetLaunchConfiguration('a', 'x'), UnsetLaunchConfiguration('a'), PushLaunchConfigurations(), ResetLaunchConfigurations({'a': 'b'})",
        """
        SetConfiguration name=a value=x
        SetConfiguration name=a
        ScopeChange what=configurations how=push
        ScopeChange what=configurations how=reset configurations=[[a, b]]
        """,
    ),
    "environment": (
        """SetEnvironmentVariable(name='A', value='1'), UnsetEnvironmentVariable('A'), AppendEnvironmentVariable('P', '/x'),
        AppendEnvironmentVariable('P', '/x', prepend=True), PopEnvironment()""",
        """
        Environ how=set name=A value=1
        Environ how=unset name=A
        Environ how=append name=P value=/x separator=:
        Environ how=prepend name=P value=/x separator=:
        ScopeChange what=environment how=pop
        """,
    ),
    "process": (
        "ExecuteProcess(cmd=['ros2', 'bag', ['rec', LaunchConfiguration('x')]], shell=True, additional_env={'A': 'b'}, on_exit=Shutdown())",
        """
        StartProcess command=[ros2, bag, rec$(var x)] shell=True environment=[[A, b]]
          Inert kind=Shutdown
        """,
    ),
    "process of one text: launch takes each character for a word": (
        "ExecuteProcess(cmd='ls')",
        "StartProcess command=[l, s]",
    ),
    "node": (
        """Node(package='p', executable='e', namespace='n', exec_name='x', arguments=['-d', LaunchConfiguration('f')],
        ros_arguments=['--log-level', 'debug'], remappings=[('a', 'b'), (LaunchConfiguration('c'), 'd')], prefix='xterm -e',
        output='screen', respawn=True, env={'A': 'b'})""",
        "StartNode package=p executable=e namespace=n remappings=[[a, b], [$(var c), d]] arguments=[-d, $(var f)]"
        " ros_arguments=[--log-level, debug] exec_name=x prefix=xterm -e environment=[[A, b]] replaces_environment=True",
    ),
    "an executable by its path": ("Node(executable='/bin/e')", "StartNode executable=/bin/e"),
    "containers": (
        """LifecycleNode(package='p', executable='e', name='l', namespace=''),
        ComposableNodeContainer(package='rclcpp_components', executable='component_container', name='c', namespace='/n',
            composable_node_descriptions=[ComposableNode(package='p', plugin='p::A', name='a', parameters=[{'x': 1}],
                extra_arguments=[{'use_intra_process_comms': True}], condition=UnlessCondition('false'))])""",
        """
        StartNode kind=NodeKind.LIFECYCLE package=p executable=e name=l namespace=
        StartNode kind=NodeKind.CONTAINER package=rclcpp_components executable=component_container name=c namespace=/n
          Component package=p plugin=p::A name=a parameters=[{x: 1}] extra_arguments=[{use_intra_process_comms: True}]\
 condition=unless(false)
        """,
    ),
    "loaded": (
        "LoadComposableNodes(target_container='c', composable_node_descriptions=[ComposableNode(package='p', plugin='p::A')])",
        """
        LoadComponents target=c
          Component package=p plugin=p::A
        """,
    ),
    "ROS state": (
        """PushRosNamespace(namespace=LaunchConfiguration('n')), PushROSNamespace('m'), SetRemap('a', 'b'), SetRemap(src='c', dst='d'),
        SetParameter('use_sim_time', LaunchConfiguration('s')), SetUseSimTime(True), SetParametersFromFile('f.yaml')""",
        """
        PushNamespace namespace=$(var n)
        PushNamespace namespace=m
        SetRemap source=a target=b
        SetRemap source=c target=d
        SetParameter parameter={use_sim_time: yaml $(var s)}
        Inert kind=SetUseSimTime
        SetParameter parameter=file f.yaml
        """,
    ),
    "groups and times": (
        """GroupAction([PushRosNamespace('a'), GroupAction(actions=[LogInfo(msg='x')], scoped=False, forwarding=False)],
            launch_configurations={'b': 'c'}, condition=IfCondition(LaunchConfiguration('g'))),
        TimerAction(period=2.5, actions=[LogInfo(msg='x')]), RosTimer(period=LaunchConfiguration('t'), actions=[])""",
        """
        Group condition=if($(var g)) configurations=[[b, c]]
          PushNamespace namespace=a
          Group scoped=False forwarding=False
            Inert kind=LogInfo
        Timer period=2.5
          Inert kind=LogInfo
        Timer period=$(var t)
        """,
    ),
    "includes": (
        """IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare('p'), '/a.launch.py']),
            launch_arguments={'x': 'y', 'z': LaunchConfiguration('z')}.items()),
        IncludeLaunchDescription(AnyLaunchDescriptionSource('a.launch.xml'), launch_arguments=[('x', 'y')]),
        IncludeLaunchDescription('b.launch.yaml'),
        IncludeLaunchDescription(LaunchDescriptionSource(LaunchDescription([LogInfo(msg='x')])))""",
        """
        Include path=$(find-pkg-share p)/a.launch.py format=python arguments=[[x, y], [z, $(var z)]]
        Include path=a.launch.xml arguments=[[x, y]]
        Include path=b.launch.yaml
        Include
          Inert kind=LogInfo
        """,
    ),
    "functions": (
        """OpaqueFunction(function=lambda context, a, b=1: [Node(package='p', executable=f'{a}{b}')], args=['x'], kwargs={'b': 2}),
        ForLoop('2', function=lambda i: [], name='i'), ForEach('{n: a}; {n: b}', function=lambda n: [])""",
        """
        Opaque
          StartNode package=p executable=x2
        ForEach values=2 count=True index_name=i
        ForEach values={n: a}; {n: b}
        """,
    ),
    "conditions": (
        """LogInfo(msg='', condition=LaunchConfigurationEquals('a', 'b')),
        LogInfo(msg='', condition=LaunchConfigurationNotEquals('a', ['b', 'c'])),
        LogInfo(msg='', condition=Condition(predicate=lambda context: True))""",
        """
        Inert condition=equals(a b) kind=LogInfo
        Inert condition=not-equals(a bc) kind=LogInfo
        Inert condition=python() kind=LogInfo
        """,
    ),
    "descriptions in descriptions": (
        "LaunchDescription([LogInfo(msg='')]), EmitEvent(event=None)",
        """
        Inert kind=LogInfo
        Inert kind=EmitEvent
        """,
    ),
}


@pytest.mark.parametrize("case", ACTIONS)
def test_actions(case: str, tmp_path: Path) -> None:
    text, wanted = ACTIONS[case]
    body = f"from launch import LaunchDescriptionSource\ndef generate_launch_description():\n{indent(f'return LaunchDescription([{text}])', ' ')}"
    assert Files(tmp_path, body).shown(Launch()) == dedent(wanted).strip()


def test_a_target_is_the_action_that_it_names(tmp_path: Path) -> None:
    """Event handlers and LoadComposableNodes name an action of the description."""
    files = Files(
        tmp_path,
        """
        def generate_launch_description():
            node = ComposableNodeContainer(package='p', executable='e', name='c', namespace='')
            return LaunchDescription([
                node,
                RegisterEventHandler(OnProcessExit(target_action=node, on_exit=[])),
                LoadComposableNodes(target_container=node, composable_node_descriptions=[]),
            ])
        """,
    )
    node, handler, load = files.read(Launch()).actions
    assert isinstance(handler, OnEvent)
    assert isinstance(load, LoadComponents)
    assert isinstance(load.target, StartNode)
    assert handler.target == node.identity == load.target.identity


def test_what_launch_cannot_execute_starts_nothing(tmp_path: Path) -> None:
    """An event, or a substitution, where an action is expected: launch fails there, and nothing is missing."""
    files = Files(
        tmp_path,
        "from launch.events import Shutdown as Event\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='p', executable='e', on_exit=Event()), LaunchConfiguration('x')])",
    )
    found = files.read(Launch())
    assert not [a for a in found.actions if not isinstance(a, (StartNode, OnEvent))]
    assert sorted(f"{f.code} {f.message.partition(':')[0]}" for f in files.python.findings) == [
        "RW320 launch.events.Shutdown is not a launch entity",
        "RW320 launch.substitutions.LaunchConfiguration is not a launch entity",
    ]


def test_the_place_is_that_of_the_call(tmp_path: Path) -> None:
    """Where a helper function makes a node, the helper is the place."""
    files = Files(
        tmp_path,
        "from demo.nodes import talker\ndef generate_launch_description(): return LaunchDescription([talker()])",
        {
            "demo/__init__.py": "",
            "demo/nodes.py": "from launch_ros.actions import Node\n\ndef talker():\n    return Node(\n        package='p', executable='e')\n",
        },
    )
    (node,) = files.read(Launch()).actions
    assert str(node.place) == "demo/nodes.py:4"
