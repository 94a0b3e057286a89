# SPDX-License-Identifier: Apache-2.0
"""Launch files that never end, contain themselves or are made to do harm end in a result, soon."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from deployment.python_tree import Files, Launch
from rosward.analysis.deep_stack import with_deep_stack
from rosward.domain.values import Const, Unknown

HOSTILE = {
    "a description that contains itself": (
        """
        def generate_launch_description():
            ld = LaunchDescription()
            ld.add_action(GroupAction([ld]))
            return ld
        """,
        "contains itself",
    ),
    "a list that contains itself": (
        """
        def generate_launch_description():
            nodes = []
            nodes.append(nodes)
            return LaunchDescription(nodes)
        """,
        "contains itself",
    ),
    "parameters that contain themselves": (
        """
        def generate_launch_description():
            table = {'a': 1}
            table['b'] = table
            return LaunchDescription([Node(package='p', executable='e', parameters=[table])])
        """,
        "StartNode",
    ),
    "a text that contains itself": (
        """
        def generate_launch_description():
            name = ['a']
            name.append(name)
            return LaunchDescription([Node(package='p', executable=name)])
        """,
        "StartNode",
    ),
    "a text that doubles": (
        """
        def generate_launch_description():
            name = ['a', 'b']
            name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]
            name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]
            name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]
            name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]; name = [name, name]
            return LaunchDescription([Node(package='p', executable='e', name=name, parameters=[{'a': name}])])
        """,
        "StartNode",
    ),
    "groups that double": (
        """
        def generate_launch_description():
            actions = [Node(package='p', executable='e')]
            for i in range(20):
                actions = [GroupAction(actions), GroupAction(actions)]
            return LaunchDescription(actions)
        """,
        "entities",
    ),
    "a loop without an end": (
        """
        def generate_launch_description():
            ld = LaunchDescription()
            while True:
                ld.add_action(Node(package='p', executable='e'))
            return ld
        """,
        "",
    ),
    "a loop of unknown length": (
        """
        def generate_launch_description():
            ld = LaunchDescription()
            for name in os.listdir('/dev'):
                ld.add_action(Node(package='p', executable='e', name=name))
            return ld
        """,
        "Maybe",
    ),
    "a substitution that performs itself": (
        """
        class Again(Substitution):
            def perform(self, context):
                return context.perform_substitution(self)
        def setup(context):
            return [Node(package='p', executable=Again().perform(context))]
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup)])
        """,
        "StartNode",
    ),
    "code in an expression": (
        """
        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup)])
        def setup(context):
            bad = PythonExpression(["open('", os.sep, "tmp/rosward-was-here', 'w').write('x')"]).perform(context)
            return [Node(package='p', executable=bad), Node(package='p', executable=eval("__import__('os').getcwd()"))]
        """,
        "StartNode",
    ),
}


@pytest.mark.parametrize("case", HOSTILE)
def test_hostile(case: str, tmp_path: Path) -> None:
    text, part = HOSTILE[case]
    files = Files(tmp_path, text)
    start = time.process_time()
    assert part in with_deep_stack(lambda: files.shown(Launch()))
    assert time.process_time() - start < 20
    assert not Path("/tmp/rosward-was-here").exists()


def test_a_deep_expression_is_not_known(tmp_path: Path) -> None:
    deep = "(" * 3000 + "1" + ")" * 3000
    files = Files(tmp_path, "")
    assert isinstance(with_deep_stack(lambda: files.python.evaluate(Const(deep), ["math"], Launch())), Unknown)
