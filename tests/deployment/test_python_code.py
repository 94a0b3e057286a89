# SPDX-License-Identifier: Apache-2.0
"""Python launch files, run by the engine: which entities `generate_launch_description()` and the functions of launch give."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from deployment.python_tree import Files, Launch, values
from rosward.deployment.tree import Opaque, StartNode
from rosward.domain.text import pattern
from rosward.domain.values import Const

BUILDING = {
    "a list": (
        """
        def generate_launch_description():
            return LaunchDescription([Node(package='demo', executable='talker', name=['t_', LaunchConfiguration('id')])])
        """,
        "StartNode package=demo executable=talker name=t_$(var id)",
    ),
    "one after the other": (
        """
        def generate_launch_description():
            ld = LaunchDescription()
            ld.add_action(Node(package='demo', executable='a'))
            ld.add_entity(LogInfo(msg='hello'))
            ld.entities.append(Node(package='demo', executable='b'))
            return ld
        """,
        """
        StartNode package=demo executable=a
        Inert kind=LogInfo
        StartNode package=demo executable=b
        """,
    ),
    "loops and sums": (
        """
        def nodes(names):
            return [Node(package='demo', executable='talker', name=n) for n in names]
        def generate_launch_description():
            more = []
            for i in range(2):
                more += [Node(package='demo', executable='talker', name=f'n{i}')]
            return LaunchDescription(nodes(['a', 'b']) + more + [PushRosNamespace('x')])
        """,
        """
        StartNode package=demo executable=talker name=a
        StartNode package=demo executable=talker name=b
        StartNode package=demo executable=talker name=n0
        StartNode package=demo executable=talker name=n1
        PushNamespace namespace=x
        """,
    ),
    "a list that changes after it was given": (
        """
        def generate_launch_description():
            ld = LaunchDescription()
            rules = []
            for name in ('a', 'b'):
                rules.append((name, name + '1'))
                ld.add_action(Node(package='demo', executable='talker', remappings=rules))
            return ld
        """,
        """
        StartNode package=demo executable=talker remappings=[[a, a1]]
        StartNode package=demo executable=talker remappings=[[a, a1], [b, b1]]
        """,
    ),
    "a class of the launch file": (
        """
        class Talker(Node):
            def __init__(self, name, **kwargs):
                super().__init__(package='demo', executable='talker', name=name, **kwargs)
        def generate_launch_description():
            return LaunchDescription([Talker('t', namespace='left')])
        """,
        "StartNode package=demo executable=talker name=t namespace=left",
    ),
    "an action of the launch file": (
        """
        class Pair(Action):
            def __init__(self, name, **kwargs):
                super().__init__(**kwargs)
                self.name = name
            def execute(self, context):
                return [Node(package='demo', executable=self.name + e) for e in ('1', '2')]
        class Late(TimerAction):
            def execute(self, context):
                context.launch_configurations['late'] = 'yes'
                return super().execute(context)
        def generate_launch_description():
            return LaunchDescription([Pair('a', condition=IfCondition('true')), Late(period=1.0, actions=[LogInfo(msg='')])])
        """,
        """
        Opaque condition=if(true)
          StartNode package=demo executable=a1
          StartNode package=demo executable=a2
        Opaque
          Timer period=1.0
            Inert kind=LogInfo
        """,
    ),
    "LaunchConfiguration is no str": (
        """
        def generate_launch_description():
            mode = LaunchConfiguration('mode', default='sim')
            if mode == 'sim':
                return LaunchDescription([Node(package='demo', executable='never')])
            return LaunchDescription([Node(package='demo', executable='always')] if mode else [])
        """,
        "StartNode package=demo executable=always",
    ),
}


@pytest.mark.parametrize("case", BUILDING)
def test_building(case: str, tmp_path: Path) -> None:
    text, wanted = BUILDING[case]
    assert Files(tmp_path, text).shown(Launch()) == dedent(wanted).strip()


DOUBTS = {
    "appended on a condition that is not known": (
        """
        def generate_launch_description():
            nodes = [Node(package='demo', executable='a')]
            if os.path.exists('/dev/video0'):
                nodes.append(Node(package='demo', executable='camera'))
            nodes.append(Node(package='demo', executable='z'))
            return LaunchDescription([Node(package='demo', executable='0')] + nodes)
        """,
        """
        StartNode package=demo executable=0
        StartNode package=demo executable=a
        Maybe why=unknown condition in Python
          StartNode package=demo executable=camera
        StartNode package=demo executable=z
        """,
    ),
    "an early return": (
        """
        def generate_launch_description():
            ld = LaunchDescription([Node(package='demo', executable='a')])
            if 'GAZEBO' in os.environ:
                return ld
            ld.add_action(Node(package='demo', executable='b'))
            return ld
        """,
        """
        StartNode package=demo executable=a
        Maybe why=unknown condition in Python
          StartNode package=demo executable=b
        """,
    ),
    "two descriptions": (
        """
        def generate_launch_description():
            common = Node(package='demo', executable='a')
            if os.environ.get('GAZEBO'):
                return LaunchDescription([common, Node(package='demo', executable='b')])
            return LaunchDescription([common, Node(package='demo', executable='c')])
        """,
        """
        StartNode package=demo executable=a
        Maybe why=unknown condition in Python
          StartNode package=demo executable=b
          StartNode package=demo executable=c
        """,
    ),
    "one of two": (
        """
        def generate_launch_description():
            here = os.path.exists('/dev/video0')
            node = Node(package='demo', executable='b') if here else Node(package='demo', executable='c')
            return LaunchDescription([node, Node(package='demo', executable='d' if here else 'e')])
        """,
        """
        Maybe why=unknown condition in Python
          StartNode package=demo executable=b
          StartNode package=demo executable=c
        StartNode package=demo executable=d | e
        """,
    ),
    "from a module that nobody knows": (
        """
        from somewhere import generate_robot
        def generate_launch_description():
            return LaunchDescription([generate_robot('r')])
        """,
        "Unread why=unmodelled call: somewhere.generate_robot (main.launch.py:14)",
    ),
}


@pytest.mark.parametrize("case", DOUBTS)
def test_doubts(case: str, tmp_path: Path) -> None:
    text, wanted = DOUBTS[case]
    assert Files(tmp_path, text).shown(Launch()) == dedent(wanted).strip()


MISTAKES = {
    "a keyword of an early release still says what was meant": (
        """
        def generate_launch_description():
            return LaunchDescription([Node(package='demo', node_executable='talker', node_name='t')])
        """,
        """
        StartNode package=demo executable=talker name=t
        RW320: Node() got unexpected keyword arguments: 'node_executable', 'node_name'
        """,
    ),
    "an exception": (
        """
        def generate_launch_description():
            raise RuntimeError('not on this robot')
        """,
        "RW320: generate_launch_description() raises an exception",
    ),
    "the end of the program": (
        """
        def generate_launch_description():
            sys.exit(1)
        """,
        "RW320: generate_launch_description() raises an exception",
    ),
    "an exception when the file is loaded": (
        """
        raise ImportError('nothing here')
        """,
        "RW320: this launch file raises an exception when it is loaded",
    ),
    "no function": ("x = 1", "RW310: this launch file has no function generate_launch_description"),
    "a list in place of a description": (
        """
        def generate_launch_description():
            return [Node(package='demo', executable='talker')]
        """,
        """
        StartNode package=demo executable=talker
        RW320: generate_launch_description() does not return a LaunchDescription
        """,
    ),
    "a number in place of a text": (
        """
        def generate_launch_description():
            return LaunchDescription([Node(package='demo', executable='talker', name=5)])
        """,
        """
        StartNode package=demo executable=talker name=5
        RW320: launch requires a str or a substitution here, not 5
        """,
    ),
    "no Python": (
        "def generate_launch_description(:",
        """
        Unread why=the launch file cannot be read
        RW310: the file cannot be read
        """,
    ),
}


@pytest.mark.parametrize("case", MISTAKES)
def test_mistakes(case: str, tmp_path: Path) -> None:
    text, wanted = MISTAKES[case]
    assert Files(tmp_path, text).shown(Launch()) == dedent(wanted).strip()


CONTEXT = {
    "performed": (
        """
        def setup(context, suffix):
            name = LaunchConfiguration('robot').perform(context) + suffix
            side = context.perform_substitution(LaunchConfiguration('side', default='left'))
            return [Node(package='demo', executable='talker', name=name, namespace=side)]
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup, args=['_x'])])
        """,
        """
        Opaque
          StartNode package=demo executable=talker name=r2_x namespace=left
        """,
    ),
    "configurations": (
        """
        def setup(context):
            given = context.launch_configurations
            given['more'] = given.get('none', 'nothing')
            if 'robot' in given and given['robot'] == 'r2':
                return [Node(package='demo', executable=given['more'], name=k) for k in given.keys()]
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup)])
        """,
        """
        Opaque
          StartNode package=demo executable=nothing name=robot
          StartNode package=demo executable=nothing name=more
        """,
    ),
    "a condition that is evaluated": (
        """
        def setup(context):
            if IfCondition(PythonExpression(["'", LaunchConfiguration('robot'), "' == 'r2'"])).evaluate(context):
                return [Node(package='demo', executable='a')]
            return [Node(package='demo', executable='b')]
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup)])
        """,
        """
        Opaque
          StartNode package=demo executable=a
        """,
    ),
    "a configuration that is not set": (
        """
        def setup(context):
            return [Node(package='demo', executable=context.launch_configurations['none'])]
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup)])
        """,
        """
        Opaque
          StartNode package=demo executable=*
        RW320: the launch configuration 'none' is not set
        """,
    ),
    "the environment": (
        """
        def generate_launch_description():
            os.environ['SIDE'] = 'left'
            return LaunchDescription([OpaqueFunction(function=setup)])
        def setup(context):
            return [Node(package='demo', executable='a', name=context.environment['SIDE'])]
        """,
        """
        Opaque
          StartNode package=demo executable=a name=left
        """,
    ),
    "a substitution of the launch file": (
        """
        class Upper(Substitution):
            def __init__(self, inner):
                self.inner = inner
            def perform(self, context):
                return self.inner.perform(context).upper()
        def setup(context):
            return [Node(package='demo', executable='a', name=Upper(LaunchConfiguration('robot')).perform(context))]
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup)])
        """,
        """
        Opaque
          StartNode package=demo executable=a name=R2
        """,
    ),
    "a function for an event": (
        """
        def generate_launch_description():
            first = Node(package='demo', executable='a')
            again = lambda event, context: [Node(package='demo', executable='b')]
            return LaunchDescription([
                first,
                RegisterEventHandler(OnProcessExit(target_action=first, on_exit=again)),
                RegisterEventHandler(OnProcessStart(target_action=first, on_start=[LogInfo(msg='')])),
            ])
        """,
        """
        StartNode package=demo executable=a
        OnEvent event=process-exit
          StartNode package=demo executable=b
        OnEvent event=process-start
          Inert kind=LogInfo
        """,
    ),
}


@pytest.mark.parametrize("case", CONTEXT)
def test_context(case: str, tmp_path: Path) -> None:
    """Here the launch configuration `robot` is r2."""
    text, wanted = CONTEXT[case]
    launch = Launch(values(robot="r2"))
    assert Files(tmp_path, text).shown(launch) == dedent(wanted).strip()


def test_what_a_function_asks_is_asked_anew(tmp_path: Path) -> None:
    """launch_configurations may have changed between two calls of one function."""
    files = Files(
        tmp_path,
        """
        def side(context):
            return LaunchConfiguration('side').perform(context)
        def setup(context):
            return [Node(package='demo', executable=side(context))]
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup), OpaqueFunction(function=setup)])
        """,
    )
    launch = Launch(values(side="left"))
    first, second, *_ = files.read(launch).actions
    assert list(files.lines([first], launch, "")) == ["Opaque", "  StartNode package=demo executable=left"]
    launch.values.update(values(side="right"))
    assert list(files.lines([second], launch, "")) == ["Opaque", "  StartNode package=demo executable=right"]


def test_a_file_is_run_anew_with_each_include(tmp_path: Path) -> None:
    """Variables of the file start again; a helper module keeps what it holds."""
    files = Files(
        tmp_path,
        """
        from demo.count import following
        names = []
        def generate_launch_description():
            names.append('x')
            return LaunchDescription([Node(package='demo', executable=f'a{len(names)}', name=following())])
        """,
        {
            "demo/__init__.py": "",
            "demo/count.py": """
            used = []
            def following():
                used.append(1)
                return f'n{len(used)}'
            """,
        },
    )
    launch = Launch()
    assert files.shown(launch) == "StartNode package=demo executable=a1 name=n1"
    assert files.shown(launch) == "StartNode package=demo executable=a1 name=n2"


def test_the_command_line(tmp_path: Path) -> None:
    """Launch files look for an argument in sys.argv."""
    files = Files(
        tmp_path,
        """
        def generate_launch_description():
            usv = None
            for word in sys.argv:
                if word.startswith('usv:='):
                    usv = word.split(':=')[1]
            return LaunchDescription([Node(package='demo', executable='sim' if 'vrx' in usv else 'real')])
        """,
    )
    assert files.shown(Launch(words=["usv:=vrx_roboboat"])) == "StartNode package=demo executable=sim"


def test_the_file_of_a_launch_file_is_in_the_share_folder(tmp_path: Path) -> None:
    files = Files(
        tmp_path,
        "",
        {
            "demo/package.xml": "<package><name>demo</name></package>",
            "demo/launch/a.launch.py": """
            import os
            from launch import LaunchDescription
            from launch_ros.actions import Node
            def generate_launch_description():
                here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
                return LaunchDescription([Node(package='demo', executable='a', parameters=[os.path.join(here, 'a.yaml')])])
            """,
        },
    )
    (node,) = files.read(Launch(), "demo/launch/a.launch.py").actions
    assert isinstance(node, StartNode)
    (source,) = node.parameters
    (path,) = source.path  # type: ignore[union-attr]
    assert pattern(path) == "*/a.yaml"  # type: ignore[arg-type]
    assert path.parts[0].reasons[0].cause.name == "SHARE"  # type: ignore[union-attr]
    assert path.parts[0].reasons[0].subject == "demo"  # type: ignore[union-attr]


ANSWERS = {
    "Condition()": "True",
    "IfCondition('TRUE ')": "True",
    "UnlessCondition(LaunchConfiguration('robot'))": "*",
    "LaunchConfigurationEquals('robot', 'r2')": "True",
    "LaunchConfigurationNotEquals('robot', 'r2')": "False",
    "LaunchConfigurationEquals('none', 'r2')": "False",
    "Condition(predicate=lambda context: context.launch_configurations['robot'] == 'r2')": "True",
    "Always()": "False",
    "LaunchConfiguration('robot')": "*",
}


@pytest.mark.parametrize("text", ANSWERS)
def test_conditions(text: str, tmp_path: Path) -> None:
    """Here the launch configuration `robot` is r2; `*` is not known, since launch raises an exception."""
    files = Files(
        tmp_path,
        f"""
        class Always(Condition):
            def __init__(self): pass
            def evaluate(self, context): return 'robot' not in context.launch_configurations
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=print, args=[{text}])])
        """,
    )
    launch = Launch(values(robot="r2"))
    action, *_ = files.read(launch).actions
    assert isinstance(action, Opaque)
    answer = files.python.test(action.args[0], launch)
    assert (str(answer.value) if isinstance(answer, Const) else "*") == ANSWERS[text]


EXPRESSIONS = {
    "1 + 1": "2",
    "'a' == 'b'": "False",
    "not true": "*",
    " 'x' if 3 > 2 else 'y'": "x",
    "math.pi > 3 and floor(2.5)": "2",
    "[1, 'a', None]": "[1, 'a', None]",
    "1 +": "*",
    "__import__('os').system('true')": "*",
    "0.1 + 0.2": "0.30000000000000004",
}


def test_expressions(tmp_path: Path) -> None:
    """PythonExpression is interpreted, never evaluated; what is no expression is not known."""
    files, launch = Files(tmp_path, ""), Launch()
    for text, wanted in EXPRESSIONS.items():
        found = files.python.evaluate(values(x=text)["x"], ["math"], launch)
        assert pattern(found) == wanted, text
