# SPDX-License-Identifier: Apache-2.0
"""`parameters=[…]` as launch_ros reads them, and text of substitutions."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from deployment.python_tree import Files, Launch, shown
from rosward.deployment.tree import StartNode

PARAMETERS = {
    "{'i': 1, 'f': 2.5, 'b': True, 's': 'true'}": "{i: 1, f: 2.5, b: True, s: 'true'}",
    "{'a': {'b': {'c': 1}, LaunchConfiguration('k'): 2}}": "{a.b.c: 1, a.$(var k): 2}",
    "{'v': LaunchConfiguration('v'), 'w': ['x', LaunchConfiguration('v')]}": "{v: yaml $(var v), w: yaml x$(var v)}",
    "{'n': [1, 2], 'm': [1, 2.0], 's': ['a', 'b'], 't': (True, False)}": (
        "{n: [1, 2], m: [1.0, 2.0], s: ['a', 'b'], t: [True, False]}"
    ),
    "{'l': [[LaunchConfiguration('a')], ['b', LaunchConfiguration('c')]]}": "{l: [yaml $(var a), yaml b$(var c)]}",
    "{'p': ParameterValue(LaunchConfiguration('p'), value_type=str), 'q': ParameterValue('1')}": (
        "{p: yaml $(var p) as str, q: '1'}"
    ),
    "{'p': ParameterValue(LaunchConfiguration('p'), value_type=list[str])}": "{p: yaml $(var p) as List[…]}",
    "{'p': ParameterValue(LaunchConfiguration('p'), value_type=typing.List[int])}": "{p: yaml $(var p) as List[…]}",
    "'a.yaml'": "file a.yaml",
    "[FindPackageShare('p'), '/a.yaml']": "file $(find-pkg-share p)/a.yaml",
    "PathJoinSubstitution([FindPackageShare('p'), 'a.yaml'])": "file $(path-join $(find-pkg-share p) a.yaml)",
    "Path('/etc') / 'a.yaml'": "file /etc/a.yaml",
    "ParameterFile('a.yaml', allow_substs=True)": "file a.yaml with substitutions",
    "Parameter('rate', 5)": "-p rate:=5",
    "yaml.safe_load('{a: {b: [1, 2]}, c: x}')": "{a.b: [1, 2], c: 'x'}",
    "unheard_of()": "file *",
    "{'a': 1, 'b': unheard_of()}": "{a: 1, b: *}",
    "{'a': 1, **unheard_of()}": "{a: 1 | *}, file *",
    "{'a': 1 if os.path.exists('/x') else 2}": "{a: 1 | 2}",
    "{'a': 1} if os.path.exists('/x') else {'a': 2}": "file *",
    "RewrittenYaml('a.yaml', root_key='r', param_rewrites={'x': LaunchConfiguration('x')}, convert_types=True)": (
        "file $(rewritten-yaml a.yaml r True {x: $(var x)})"
    ),
    "ParameterFile(ReplaceString(source_file='a.yaml', replacements={'<r>': 'x'}))": "file $(replace-string a.yaml {<r>: x})",
}


@pytest.mark.parametrize("text", PARAMETERS)
def test_parameters(text: str, tmp_path: Path) -> None:
    files = Files(
        tmp_path,
        f"""
        import typing, yaml
        from pathlib import Path
        from nav2_common.launch import ReplaceString, RewrittenYaml
        from launch_ros.descriptions import Parameter, ParameterFile, ParameterValue
        from somewhere import unheard_of
        def generate_launch_description():
            return LaunchDescription([Node(package='p', executable='e', parameters=[{text}])])
        """,
    )
    (node,) = files.read(Launch()).actions
    assert isinstance(node, StartNode)
    assert ", ".join(map(shown, node.parameters)) == PARAMETERS[text]
    assert not files.python.findings


REFUSED = {
    "{'a': None}": "launch_ros does not accept None as a parameter value",
    "{'a': []}": "launch_ros does not accept an empty list as a parameter value",
}


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str, tmp_path: Path) -> None:
    body = f"""
        def generate_launch_description():
            return LaunchDescription([Node(package='p', executable='e', parameters=[{text}])])
        """
    assert Files(tmp_path, body).shown(Launch()).endswith(f"RW320: {REFUSED[text]}")


TEXTS = {
    "'a'": "a",
    "['a', TextSubstitution(text='b'), LaunchConfiguration('c', default='d')]": "ab$(var c d)",
    "LaunchConfiguration(['a', LaunchConfiguration('b')])": "$(var a$(var b))",
    "EnvironmentVariable('A', default_value='b')": "$(env A b)",
    "FindExecutable(name='x')": "$(find-exec x)",
    "[ThisLaunchFileDir(), ThisLaunchFile(), LaunchLogDir()]": "$(dirname)$(filename)$(launch-log-dir)",
    "AnonName('a')": "$(anon a)",
    "PythonExpression(['1 + ', LaunchConfiguration('a')])": "$(eval 1 + $(var a) math)",
    "PythonExpression('os.sep', python_modules=['os', 'math'])": "$(eval os.sep os math)",
    "Command(['xacro ', 'a.xacro'], on_stderr='warn')": "$(command xacro a.xacro warn)",
    "FileContent('a')": "$(file-content a)",
    "StringJoinSubstitution(['a', 'b'], delimiter='-')": "$(string-join - a b)",
    "NotSubstitution(AndSubstitution('true', OrSubstitution('a', 'b')))": "$(not $(and true $(or a b)))",
    "AnySubstitution('a', 'b')": "$(any a b)",
    "AllSubstitution(['a', LaunchConfiguration('b')], 'c')": "$(all a$(var b) c)",
    "EqualsSubstitution(LaunchConfiguration('a'), 1)": "$(equals $(var a) 1)",
    "NotEqualsSubstitution('a', 'b')": "$(not-equals a b)",
    "IfElseSubstitution(LaunchConfiguration('a'), 'x', 'y')": "$(if $(var a) x y)",
    "LocalSubstitution('event.reason')": "$(local event.reason)",
    "ExecutableInPackage('e', 'p')": "$(exec-in-pkg e p)",
    "FindPackagePrefix('p')": "$(find-pkg-prefix p)",
    "HasNodeParams(source_file='a.yaml', node_name='n')": "$(has-node-params a.yaml n)",
    "f'{1}_{os.sep}'": "1_/",
    "'a' if os.path.exists('/x') else LaunchConfiguration('b')": "$(python)",
}


@pytest.mark.parametrize("text", TEXTS)
def test_texts(text: str, tmp_path: Path) -> None:
    body = f"""
        from launch.substitutions.string_join_substitution import StringJoinSubstitution
        from launch_ros.substitutions import ExecutableInPackage, FindPackagePrefix
        from nav2_common.launch import HasNodeParams
        def generate_launch_description():
            return LaunchDescription([PushRosNamespace({text})])
        """
    files = Files(tmp_path, dedent(body))
    assert files.shown(Launch()) == f"PushNamespace namespace={TEXTS[text]}"
