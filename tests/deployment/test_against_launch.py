# SPDX-License-Identifier: Apache-2.0
"""Small launch files whose results were seen to be those of the real launch 3.7.1 and launch_ros 0.28.0.

Each stands for a family of files that were made at random and executed by both; `starts` is what both start, in our plain form.
"""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from deployment.execution import line
from deployment.python_tree import HEAD
from rosward.analysis.source_tree import SourceTree
from rosward.deployment.execution.execution import Execution
from rosward.deployment.files import WorkspaceFiles
from rosward.deployment.python.code import LaunchPython
from rosward.engine.libraries.library import Library
from rosward.findings import Finding
from rosward.models.tables import own_models
from rosward.ros.distro import Distro
from rosward.source.discover import discover

IMPORTS = (
    HEAD
    + "import copy\nfrom launch_ros.parameter_descriptions import Parameter, ParameterValue\nfrom typing import List\n"
    + "from launch_ros.substitutions import ExecutableInPackage, FindPackagePrefix\n"
)

MARKUP = {
    "mathematics need no import in an expression": (
        """<launch><node pkg="demo" exec="talker" args="$(eval 'math.floor(math.pi) + ceil(0.5)')"/></launch>""",
        "demo/talker 4 --ros-args",
        "",
    ),
    "a path in a package is no other text": (
        """
        <launch>
          <node pkg="demo" exec="talker" if="$(equals $(find-pkg-share demo)/a left)"/>
          <node pkg="demo" exec="talker" if="$(equals $(find-pkg-share demo)/a $(find-pkg-share demo)/b)"/>
          <node pkg="demo" exec="same" if="$(equals $(find-pkg-share demo)/a $(find-pkg-share demo)/a)"/>
        </launch>
        """,
        "demo/same --ros-args",
        "",
    ),
    "a list may be empty": (
        """
        <launch>
          <arg name="open" default="[]"/>
          <node pkg="demo" exec="talker"><param name="a" value="[]"/><param name="b" value="$(var open)"/></node>
        </launch>
        """,
        "demo/talker --ros-args --params-file {/** a=[]} --params-file {/** b=[]}",
        "",
    ),
    "an expression that is none ends the launch": (
        """<launch><let name="a" value="it's"/><node pkg="demo" exec="talker" args="$(eval &quot;'$(var a)'&quot;)"/></launch>""",
        "demo/talker * --ros-args",
        "RW320",
    ),
    "a model of Gazebo": (
        """<launch><gz_spawn_model file="a.sdf" x="1" if="true"/></launch>""",
        "",
        "RW311",
    ),
}

PYTHON = {
    "a parameter description keeps its text": (
        """Node(package='demo', executable='talker', parameters=[
            Parameter('a', '1'), {'b': ParameterValue('true'), 'c': ParameterValue(['1', LaunchConfiguration('m', default='2')])}])""",
        "demo/talker --ros-args -p a:='1'\n --params-file {/** b='true', /** c=12}",
        "",
    ),
    "a value that is not of its type ends the launch": (
        "Node(package='demo', executable='talker', parameters=[{'a': ParameterValue('1', value_type=int)}])",
        "demo/talker --ros-args --params-file {/** a='1'}",
        "RW320",
    ),
    "a process has started before any timer": (
        """SetRemap('a', 'first'), n := Node(package='demo', executable='talker'),
        TimerAction(period=1.0, actions=[SetRemap('a', 'second'), Node(package='demo', executable='timed')]),
        RegisterEventHandler(OnProcessStart(target_action=n, on_start=[Node(package='demo', executable='handled')])),
        RegisterEventHandler(OnProcessExit(target_action=n, on_exit=[Node(package='demo', executable='last')]))""",
        """
        demo/talker --ros-args -r a:=first
        demo/handled --ros-args -r a:=first @process-start
        demo/timed --ros-args -r a:=first -r a:=second @timer
        demo/last --ros-args -r a:=first -r a:=second @process-exit [maybe]
        """,
        "",
    ),
    "the time of launch itself": (
        "SetUseSimTime(True), Node(package='demo', executable='talker')",
        "demo/talker --ros-args",
        "",
    ),
    "a loop over rows": (
        "ForEach('{n: a}; ;{n: b, k: 2}', function=lambda n, k=1: [Node(package='demo', executable=n, arguments=[str(k)])])",
        "demo/a 1 --ros-args\ndemo/b 2 --ros-args",
        "",
    ),
    "an object starts one process": (
        """n := Node(package='demo', executable='talker'), n,
        *[GroupAction([m], condition=IfCondition(c)) for m in [Node(package='demo', executable='other')] for c in ('true', 'false')],
        *[Node(package='demo', executable=f'e{i}') for i in range(2)]""",
        "demo/talker --ros-args\ndemo/other --ros-args\ndemo/e0 --ros-args\ndemo/e1 --ros-args",
        "RW320",
    ),
    "a function that is called again makes other objects": (
        """*[OpaqueFunction(function=lambda context, i: [Node(package='demo', executable=f'e{i}')], args=[i]) for i in range(2)]""",
        "demo/e0 --ros-args\ndemo/e1 --ros-args",
        "",
    ),
    "a program by its path": (
        """ExecuteProcess(cmd=[ExecutableInPackage('talker', 'demo'), '--ros-args', '-r', 'a:=b']),
        ExecuteProcess(cmd=[FindPackagePrefix('demo'), '/lib/demo/talker']),
        ExecuteProcess(cmd=[[FindPackagePrefix('demo'), '/lib/demo/other'], 'x'])""",
        "demo/talker --ros-args -r a:=b\n* /lib/demo/talker\ndemo/other x",
        "",
    ),
    "a function reads what is set for all nodes": (
        """SetParameter('front', 1.5), SetParameter('name', 'x'), SetRemap('a', 'b'),
        OpaqueFunction(function=lambda context: [
            Node(package='demo', executable=n, arguments=[str(v)]) for n, v in context.launch_configurations['global_params']]),
        OpaqueFunction(function=lambda context: [Node(package='demo', executable='sum', arguments=[
            str(dict(context.launch_configurations.get('global_params', {}))['front'] + 1), *sorted(context.launch_configurations)],
            remappings=[(y, x) for x, y in context.launch_configurations['ros_remaps']])])""",
        """
        demo/front 1.5 --ros-args -p front:=1.5 -p name:=x -r a:=b
        demo/name x --ros-args -p front:=1.5 -p name:=x -r a:=b
        demo/sum 2.5 global_params ros_remaps --ros-args -p front:=1.5 -p name:=x -r a:=b -r b:=a
        """,
        "",
    ),
    "a function sets what is set for all nodes": (
        """SetParameter('front', 1.5),
        OpaqueFunction(function=lambda context: context.launch_configurations.update(
            global_params=[('rear', 2), '/a.yaml'], ros_remaps=[('c', 'd')])),
        GroupAction([Node(package='demo', executable='set'),
            OpaqueFunction(function=lambda context: context.launch_configurations['global_params'].append(('more', 5))),
            OpaqueFunction(function=lambda context: context.launch_configurations.setdefault('ros_remaps', []).extend([('e', 'f')]))]),
        Node(package='demo', executable='added'),
        OpaqueFunction(function=lambda context: context.launch_configurations.pop('global_params') and []),
        Node(package='demo', executable='removed')""",
        """
        demo/set --ros-args -p rear:=2 --params-file /a.yaml -r c:=d
        demo/added --ros-args -p rear:=2 --params-file /a.yaml -p more:=5 -r c:=d -r e:=f
        demo/removed --ros-args -r c:=d -r e:=f
        """,
        "",
    ),
    "a function changes in place what is set for all nodes": (
        """SetParameter('a', 1), SetParameter('b', 2), SetRemap('x', 'y'),
        GroupAction([
            OpaqueFunction(function=lambda context: context.launch_configurations['global_params'].insert(0, ('first', 0))),
            OpaqueFunction(function=lambda context: context.launch_configurations['global_params'].remove(('b', 2))),
            OpaqueFunction(function=lambda context: context.launch_configurations['ros_remaps'].__setitem__(0, ('x', 'z')))]),
        Node(package='demo', executable='changed'),
        OpaqueFunction(function=lambda context: [
            Node(package='demo', executable=context.launch_configurations['global_params'].pop()[0])]),
        OpaqueFunction(function=lambda context: context.launch_configurations['ros_remaps'].clear()),
        Node(package='demo', executable='less')""",
        """
        demo/changed --ros-args -p first:=0 -p a:=1 -r x:=z
        demo/a --ros-args -p first:=0 -r x:=z
        demo/less --ros-args -p first:=0
        """,
        "",
    ),
    "a function changes a copy of what is set for all nodes": (
        """SetParameter('a', 1),
        OpaqueFunction(function=lambda context: copy.deepcopy(context.launch_configurations['global_params']).append(('b', 2))),
        OpaqueFunction(function=lambda context: copy.copy(context.launch_configurations['global_params']).clear()),
        Node(package='demo', executable='talker')""",
        "demo/talker --ros-args -p a:=1",
        "",
    ),
    "what a function sets for all nodes is not known": (
        """OpaqueFunction(function=lambda context: context.launch_configurations.update(
            global_params=eval(input()), ros_remaps=[eval(input())])),
        Node(package='demo', executable='talker')""",
        "demo/talker --ros-args --params-file * -r *:=*",
        "RW203",
    ),
    "a list may be empty where it is described": (
        """Node(package='demo', executable='talker', parameters=[
            {'a': ParameterValue([]), 'b': ParameterValue(LaunchConfiguration('m', default='[]'))}]),
        Node(package='demo', executable='other', parameters=[{'a': LaunchConfiguration('m', default='[]')}])""",
        "demo/talker --ros-args --params-file {/** a=[], /** b=[]}\ndemo/other --ros-args --params-file {/** a=?}",
        "RW320",
    ),
    "a dict for all nodes": (
        """SetParameter('x', {'a': 1, 'b': {LaunchConfiguration('k', default='c'): LaunchConfiguration('v', default='2')}}),
        SetParameter('y', {}), Node(package='demo', executable='talker')""",
        "demo/talker --ros-args -p x.a:=1 -p x.b.c:=2",
        "",
    ),
    "a node by the path of its program": (
        """Node(executable=ExecutableInPackage('talker', 'demo'), name='a'),
        Node(executable=PathJoinSubstitution([FindPackagePrefix('demo'), 'lib', 'demo', 'talker']), arguments=['-v']),
        Node(executable=[FindPackagePrefix('demo'), '/lib/other/talker'])""",
        "demo/talker --ros-args -r __node:=a\ndemo/talker -v --ros-args\n*/lib/other/talker --ros-args",
        "",
    ),
    "a path is the program whatever the package is": (
        """Node(package='other', executable=[FindPackagePrefix('demo'), '/lib/demo/talker']),
        Node(package='demo', executable='/usr/bin/ls')""",
        "demo/talker --ros-args\n/usr/bin/ls --ros-args",
        "",
    ),
    "a counted loop": (
        "ForLoop('2', function=lambda i: [Node(package='demo', executable='e' + str(i))])",
        "demo/e0 --ros-args\ndemo/e1 --ros-args",
        "",
    ),
}


def run(folder: Path, name: str, text: str) -> tuple[str, set[str]]:
    """What a launch file of the package demo starts, and which failures are told."""
    launch = folder / "demo/launch"
    launch.mkdir(parents=True, exist_ok=True)
    (folder / "demo/package.xml").write_text('<package format="3"><name>demo</name></package>', encoding="utf-8")
    (launch / name).write_text(text, encoding="utf-8")
    tree = SourceTree(discover([folder]))
    files, python = WorkspaceFiles(tree.files), LaunchPython(Library(tree, own_models()))
    execution = Execution(files, python, Distro.KILTED, {})
    file = f"demo/launch/{name}"
    started = execution.run(file, files.place_value(file))
    return "\n".join(line(each) for each in started), told(execution.findings)


def told(findings: tuple[Finding, ...]) -> set[str]:
    return {f.code for f in findings}


@pytest.mark.parametrize("name", MARKUP)
def test_markup(name: str, tmp_path: Path) -> None:
    text, starts, codes = MARKUP[name]
    assert run(tmp_path, "main.launch.xml", dedent(text).strip()) == (dedent(starts).strip(), set(codes.split()))


@pytest.mark.parametrize("name", PYTHON)
def test_python(name: str, tmp_path: Path) -> None:
    text, starts, codes = PYTHON[name]
    program = f"{IMPORTS}\ndef generate_launch_description():\n    return LaunchDescription([{text}])\n"
    assert run(tmp_path, "main.launch.py", program) == (dedent(starts).strip(), set(codes.split()))


INNER = (
    "def generate_launch_description():\n"
    "    return LaunchDescription([Node(package='demo', executable=LaunchConfiguration('n'))])\n"
)


@pytest.mark.parametrize(("sources", "starts", "codes"), [("s, s", "demo/0", "RW320"), ("s, t", "demo/0\ndemo/1", "")])
def test_a_source_is_loaded_once(sources: str, starts: str, codes: str, tmp_path: Path) -> None:
    (tmp_path / "demo/launch").mkdir(parents=True)
    (tmp_path / "demo/launch/inner.launch.py").write_text(f"{IMPORTS}\n{INNER}", encoding="utf-8")
    program = f"""{IMPORTS}
def generate_launch_description():
    s, t = (PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/inner.launch.py']) for _ in range(2))
    arguments = [{{'n': str(i)}}.items() for i in range(2)]
    return LaunchDescription([IncludeLaunchDescription(x, launch_arguments=a) for x, a in zip(({sources}), arguments)])
"""
    found, told_codes = run(tmp_path, "main.launch.py", program)
    assert [each.split()[0] for each in found.splitlines()] == starts.split()
    assert told_codes == set(codes.split())


def test_a_launch_file_imports_another_one(tmp_path: Path) -> None:
    (tmp_path / "demo/more").mkdir(parents=True)
    other = "from launch_ros.actions import Node\ndef more(name): return [Node(package='demo', executable=name)]\n"
    (tmp_path / "demo/more/other_launch.py").write_text(
        f"{other}def generate_launch_description(): pass\n", encoding="utf-8"
    )
    program = f"{IMPORTS}sys.path.append(os.path.join(os.path.dirname(__file__), '../more'))\nimport other_launch\n"
    program += "def generate_launch_description():\n    return LaunchDescription(other_launch.more('talker'))\n"
    assert run(tmp_path, "main.launch.py", program) == ("demo/talker --ros-args", set())


def test_a_launch_file_of_any_name_imports_another_one(tmp_path: Path) -> None:
    (tmp_path / "demo/launch").mkdir(parents=True)
    (tmp_path / "demo/examples").mkdir()
    other = "from launch_ros.actions import Node\ndef more(name): return [Node(package='demo', executable=name)]\n"
    (tmp_path / "demo/launch/other_launch.py").write_text(
        f"{other}def generate_launch_description(): pass\n", encoding="utf-8"
    )
    program = f"""{IMPORTS}
sys.path.append(os.path.join(get_package_share_directory('demo'), 'launch'))
import other_launch

def generate_launch_description():
    return LaunchDescription(other_launch.more('talker'))
"""
    (tmp_path / "demo/examples/bag.py").write_text(program, encoding="utf-8")
    include = "IncludeLaunchDescription(PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/../examples/bag.py']))"
    main = f"{IMPORTS}\ndef generate_launch_description():\n    return LaunchDescription([{include}])\n"
    assert run(tmp_path, "main.launch.py", main) == ("demo/talker --ros-args", set())


PERHAPS = """
import socket

def generate_launch_description():
    arguments, remappings, environment, words = {'n': '3'}, [('x', 'y')], {}, ['--a']
    if socket.gethostname() == 'robot':
        arguments['who'] = 'special'
        remappings.append(('chatter', 'other'))
        remappings.append(('z', 'second'))
        environment['E'] = '1'
        words.append('--b')
    remappings.append(('z', 'first'))
    return LaunchDescription([
        Node(package='demo', executable='talker', remappings=remappings, additional_env=environment, arguments=words),
        GroupAction([Node(package='demo', executable='group', name=LaunchConfiguration('who', default='nobody'))],
                    launch_configurations=arguments),
        IncludeLaunchDescription([ThisLaunchFileDir(), '/inner.launch.py'], launch_arguments=arguments.items()),
    ])
"""


def test_what_is_perhaps_in_a_list_or_dict_is_not_certain(tmp_path: Path) -> None:
    (tmp_path / "demo/launch").mkdir(parents=True)
    inner = INNER.replace(
        "LaunchConfiguration('n')", "LaunchConfiguration('n'), name=LaunchConfiguration('who', default='inner')"
    )
    (tmp_path / "demo/launch/inner.launch.py").write_text(f"{IMPORTS}\n{inner}", encoding="utf-8")
    talker, group, included = run(tmp_path, "main.launch.py", IMPORTS + PERHAPS)[0].splitlines()
    assert talker == (
        "demo/talker --a --b|* --ros-args -r x:=y -r chatter:=other|chatter:=chatter -r z:=second|z:=* -r z:=first|z:=z"
    )
    assert group == "demo/group --ros-args -r __node:=special|__node:=*"
    assert included == "demo/3 --ros-args -r __node:=special|__node:=*"


PERHAPS_IN_TEXTS = """
import socket

def made(context, who='nobody'):
    return [Node(package='demo', executable='made', name=who)]

def generate_launch_description():
    name, parts, named, given = ['a'], ['/x'], {}, []
    if socket.gethostname() == 'robot':
        name.append('_robot')
        parts.append('more')
        named['who'] = 'somebody'
        given.append('anybody')
    return LaunchDescription([
        Node(package='demo', executable='talker', name=name, namespace=PathJoinSubstitution(parts)),
        OpaqueFunction(function=made, kwargs=named),
        OpaqueFunction(function=made, args=given),
    ])
"""


def test_what_is_perhaps_in_a_text_or_call_is_not_certain(tmp_path: Path) -> None:
    assert run(tmp_path, "main.launch.py", IMPORTS + PERHAPS_IN_TEXTS)[0].splitlines() == [
        "demo/talker --ros-args -r __node:=a_robot|__node:=a* -r __ns:=/*",
        "demo/made --ros-args -r __node:=somebody|__node:=*",
        "demo/made --ros-args -r __node:=anybody|__node:=*",
    ]
