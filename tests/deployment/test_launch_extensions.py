# SPDX-License-Identifier: Apache-2.0
"""Promise: substitutions that packages add to launch give what their sources give.

Below each stands what it gives. With a checkout of launch and of the packages at hand, that is held against them:

    ROSWARD_LAUNCH=LAUNCH/launch:NAVIGATION2/nav2_common[:OSRF_PYCOMMON] python -m pytest tests/deployment/test_launch_extensions.py

(`ROSWARD_LIVE_PYTHON` is the Python that runs them, where it is another one; it needs PyYAML.)
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from textwrap import dedent
from typing import Any, Final, NamedTuple

import pytest

from deployment.execution import plain
from deployment.python_tree import HEAD
from rosward.analysis.source_tree import SourceTree
from rosward.deployment.execution.execution import Execution
from rosward.deployment.files import WorkspaceFiles
from rosward.deployment.parameter_files import read_parameter_file
from rosward.deployment.python.code import LaunchPython
from rosward.domain.text import readable
from rosward.domain.values import Const
from rosward.effects.configuration import Given
from rosward.engine.libraries.library import Library
from rosward.models.tables import own_models
from rosward.ros.distro import Distro
from rosward.source.discover import discover

LAUNCH: Final = os.environ.get("ROSWARD_LAUNCH", "")
IMPORTS: Final = "from nav2_common.launch import HasNodeParams, LaunchConfigAsBool, ReplaceString, RewrittenYaml\n"
FILE: Final = """\
amcl:
  ros__parameters:
    base: <robot>base
    rate: 10
    mode: KEEPOUT
    nested: {rate: 1.5, list: [KEEPOUT, SPEED]}
/left/arm:
  ros__parameters: {active: true}
empty: {}
"""


class Case(NamedTuple):
    """A substitution, the launch configurations, and what it gives: a text, or the parameters of a file."""

    expression: str
    gives: str | tuple[str, ...]
    arguments: dict[str, str] = {}  # noqa: RUF012  # nobody writes to it


def _as_bool(word: str, gives: str) -> Case:
    return Case("LaunchConfigAsBool('a')", gives, {"a": word})


SAME: Final = (
    "amcl base='<robot>base'",
    "amcl mode='KEEPOUT'",
    "amcl nested.list=['KEEPOUT', 'SPEED']",
    "amcl nested.rate=1.5",
    "amcl rate=10",
    "left/arm active=True",
)


def _but(*lines: str) -> tuple[str, ...]:
    """The parameters of the file, of which these are others."""
    new = {line.partition("=")[0]: line for line in lines}
    return tuple(sorted({**{line.partition("=")[0]: line for line in SAME}, **new}.values()))


CASES: Final = {
    "True": _as_bool("True", "True"),
    "yes": _as_bool(" yes ", "True"),
    "on": _as_bool("ON", "True"),
    "1": _as_bool("1", "True"),
    "false": _as_bool("false", "False"),
    "2": _as_bool("2", "False"),
    "empty": _as_bool("", "False"),
    "a node of the file": Case("HasNodeParams(source_file=FILE, node_name='amcl')", "True"),
    "a node with a namespace": Case("HasNodeParams(source_file=FILE, node_name='/left/arm')", "True"),
    "a node without parameters": Case("HasNodeParams(source_file=FILE, node_name='empty')", "True"),
    "no node of the file": Case("HasNodeParams(source_file=FILE, node_name='base')", "False"),
    "a node of a file that is written": Case(
        "HasNodeParams(source_file=RewrittenYaml(source_file=FILE, param_rewrites={}), node_name='amcl')", "True"
    ),
    "the name of a node is no substitution": Case("HasNodeParams(FILE, '$(var a)')", "False", {"a": "amcl"}),
    "nothing is rewritten": Case("RewrittenYaml(source_file=FILE, param_rewrites={})", SAME),
    "by the last key": Case(
        "RewrittenYaml(source_file=FILE, param_rewrites={'rate': LaunchConfiguration('a')})",
        _but("amcl rate='20'", "amcl nested.rate='20'"),
        {"a": "20"},
    ),
    "with types": Case(
        "RewrittenYaml(source_file=FILE, param_rewrites={'rate': '20', 'base': '1.5'}, convert_types=True)",
        _but("amcl rate=20", "amcl nested.rate=20", "amcl base=1.5"),
    ),
    "bools are always bools": Case(
        "RewrittenYaml(source_file=FILE, param_rewrites={'rate': 'TRUE'})",
        _but("amcl rate=True", "amcl nested.rate=True"),
    ),
    "by the whole path": Case(
        "RewrittenYaml(source_file=FILE, param_rewrites={'amcl.ros__parameters.rate': 'x'})", _but("amcl rate='x'")
    ),
    "a path that is new": Case(
        "RewrittenYaml(source_file=FILE, param_rewrites={'amcl.ros__parameters.new.one': 'x', 'other': 'y'})",
        _but("amcl new.one='x'"),
    ),
    "keys": Case(
        "RewrittenYaml(source_file=FILE, param_rewrites={}, key_rewrites={'amcl': 'loc', 'rate': 'speed'})",
        tuple(sorted(line.replace("amcl", "loc").replace("rate", "speed") for line in SAME)),
    ),
    "a root": Case(
        "RewrittenYaml(FILE, {}, root_key=LaunchConfiguration('a'), key_rewrites={'/left/arm': 'arm'})",
        tuple(sorted(f"r1/{line.replace('left/arm', 'arm')}" for line in SAME)),
        {"a": "r1"},
    ),
    "an empty root": Case("RewrittenYaml(FILE, {}, root_key=LaunchConfiguration('a'))", SAME, {"a": ""}),
    "values": Case(
        "RewrittenYaml(FILE, {}, value_rewrites={'KEEPOUT': LaunchConfigAsBool('a'), 'SPEED': 'False', '10': 'ten', 'True': '7'}, "
        "convert_types=True)",
        _but("amcl mode=True", "amcl nested.list=[True, False]", "amcl rate='ten'", "left/arm active=7"),
        {"a": "on"},
    ),
    "text is replaced": Case(
        "ReplaceString(source_file=FILE, replacements={'<robot>': LaunchConfiguration('a'), 'amcl': 'loc'})",
        tuple(sorted(line.replace("<robot>", "r/").replace("amcl", "loc") for line in SAME)),
        {"a": "r/"},
    ),
    "text is replaced where a condition holds": Case(
        "ReplaceString(FILE, {'<robot>': 'r/'}, condition=IfCondition(LaunchConfiguration('a')))",
        _but("amcl base='r/base'"),
        {"a": "true"},
    ),
    "nothing is replaced where it does not": Case(
        "ReplaceString(FILE, {'<robot>': 'r/'}, condition=UnlessCondition(LaunchConfiguration('a')))",
        SAME,
        {"a": "true"},
    ),
    "a configuration that is another": Case(
        "ReplaceString(FILE, {'<robot>': 'r/'}, condition=LaunchConfigurationEquals('a', 'left'))", SAME, {"a": "right"}
    ),
}


def _rows(rows: tuple[Given, ...]) -> tuple[str, ...]:
    return tuple(sorted(f"{row.node.strip('/')} {row.name}={plain(row.value)}" for row in rows))


@pytest.mark.parametrize("name", CASES)
def test_gives(name: str, tmp_path: Path) -> None:
    """What stands beside a substitution is what rosward makes of it."""
    case = CASES[name]
    folder = tmp_path / "demo"
    folder.mkdir()
    (folder / "package.xml").write_text('<package format="3"><name>demo</name></package>', encoding="utf-8")
    (folder / "a.yaml").write_text(FILE, encoding="utf-8")
    given = "arguments" if isinstance(case.gives, str) else "parameters"
    (folder / "main.launch.py").write_text(
        f"{HEAD}{IMPORTS}FILE = [FindPackageShare('demo'), '/a.yaml']\n"
        "def generate_launch_description():\n"
        f"    return LaunchDescription([Node(package='demo', executable='talker', {given}=[{case.expression}])])\n",
        encoding="utf-8",
    )
    tree = SourceTree(discover([tmp_path]))
    files, python = WorkspaceFiles(tree.files), LaunchPython(Library(tree, own_models()))
    execution = Execution(files, python, Distro.JAZZY, {n: Const(v) for n, v in case.arguments.items()})
    (started,) = execution.run("demo/main.launch.py", files.place_value("demo/main.launch.py"))
    assert [f.code for f in execution.findings] == []
    if isinstance(case.gives, str):
        assert readable(started.configuration.words[0]) == case.gives
    else:
        (rows,) = started.configuration.files.values()
        assert _rows(rows or ()) == case.gives


RUN: Final = f"""\
import json, os, sys
from launch import LaunchContext
from launch.conditions import *
from launch.substitutions import *
{IMPORTS}
FILE, cases = sys.argv[1], json.load(sys.stdin)
for expression, arguments in cases:
    context = LaunchContext()
    context.launch_configurations.update(arguments)
    text = eval(expression).perform(context)
    print(json.dumps([text, open(text).read() if os.path.isfile(text) else None]))
"""


@pytest.mark.skipif(not LAUNCH, reason="ROSWARD_LAUNCH names no checkout of launch and nav2_common")
def test_the_real_ones_give_the_same(tmp_path: Path) -> None:
    """And it is what the packages make of it in the real launch."""
    (tmp_path / "a.yaml").write_text(FILE, encoding="utf-8")
    cases = [[case.expression, case.arguments] for case in CASES.values()]
    done = subprocess.run(
        [os.environ.get("ROSWARD_LIVE_PYTHON", sys.executable), "-c", dedent(RUN), str(tmp_path / "a.yaml")],
        input=json.dumps(cases),
        env={**os.environ, "PYTHONPATH": LAUNCH, "TMPDIR": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    seen: list[list[Any]] = [json.loads(line) for line in done.stdout.splitlines()]
    given = {
        name: text if content is None else _rows(read_parameter_file(content, "a.yaml")[0])
        for name, (text, content) in zip(CASES, seen, strict=True)
    }
    assert given == {name: case.gives for name, case in CASES.items()}
