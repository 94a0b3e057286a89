# SPDX-License-Identifier: Apache-2.0
"""Nothing of the input runs, and nothing outside of the output folder is touched: wherever code can stand, it touches a canary.

Each run is under the eye of an audit hook (`guard.py`), so that not only the canary counts, but each attempt.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Final

import pytest
from sampling import sample

from hostile.fuzz import GOOD, GOOD_CMAKE, GOOD_LAUNCH, GOOD_MANIFEST
from hostile.guard import Watched, harmless, watched

TOUCH: Final = "import os, pathlib, socket, subprocess\nos.system('touch {canary}')\npathlib.Path('{canary}').touch()\n"
BEHIND: Final = (
    "subprocess.run(['touch', '{canary}'])\nexec(\"open('{canary}', 'w')\")\neval(\"open('{canary}', 'w')\")\n"
)
EVAL: Final = "__import__('os').system('touch {canary}')"

LAUNCH_PY: Final = """\
{touch}
from launch import LaunchDescription
from launch.actions import ExecuteProcess, OpaqueFunction
from launch.substitutions import Command, EnvironmentVariable, PythonExpression
from launch_ros.actions import Node

os.system('touch {canary}')
__import__('subprocess').call(['touch', '{canary}'])


def setup(context):
    os.system('touch {canary}')
    open('{canary}', 'w').write('x')
    subprocess.check_output('touch {canary}', shell=True)
    return [Node(package='good', executable='good.py', name=Command(['touch {canary}']).perform(context))]


def generate_launch_description():
    return LaunchDescription([
        OpaqueFunction(function=setup),
        ExecuteProcess(cmd=['touch', '{canary}'], shell=True),
        Node(package='good', executable='good.py', name=PythonExpression(["{expression}"])),
        Node(package='good', executable='good.py', namespace=Command('touch {canary}')),
        Node(package='good', executable='good.py', parameters=[{{'robot_description': Command(['xacro ', '{canary}.xacro'])}}]),
    ])
"""
LAUNCH_XML: Final = """\
<launch>
  <arg name="a" default="$(eval &quot;{expression}&quot;)"/>
  <let name="b" value="$(command 'touch {canary}')"/>
  <executable cmd="touch {canary}" shell="true"/>
  <node pkg="good" exec="good.py" name="$(var b)" if="$(eval &quot;{expression} == 0&quot;)"/>
  <node pkg="good" exec="good.py" namespace="$(var a)" launch-prefix="touch {canary};">
    <param name="p" value="$(command 'xacro {canary}')" type="str"/>
  </node>
  <include file="$(command 'touch {canary}')"/>
</launch>
"""
LAUNCH_YAML: Final = """\
launch:
- let: {{name: a, value: !!python/object/apply:os.system ['touch {canary}']}}
- executable: {{cmd: 'touch {canary}'}}
- node: {{pkg: good, exec: good.py, name: "$(command 'touch {canary}')"}}
- arg: {{name: b, default: "$(eval \\"{expression}\\")"}}
"""
PARAMS: Final = "/**:\n  ros__parameters:\n    p: !!python/object/apply:os.system ['touch {canary}']\n"
ENTITIES: Final = """\
<!DOCTYPE launch [<!ENTITY secret SYSTEM "file:///etc/passwd"><!ENTITY % net SYSTEM "http://127.0.0.1:9/x.dtd"> %net;]>
<launch><arg name="a" default="&secret;"/><node pkg="good" exec="good.py" name="&secret;"/></launch>
"""
MANIFEST: Final = """\
<!DOCTYPE package [<!ENTITY secret SYSTEM "file:///etc/passwd">]>
<package format="3"><name>&secret;</name></package>
"""
CMAKE: Final = """\
project(bad)
execute_process(COMMAND touch {canary})
file(WRITE {canary} x)
file(DOWNLOAD http://127.0.0.1:9/ {canary})
include({canary}.cmake)
configure_file(package.xml {canary})
add_custom_target(x ALL COMMAND touch {canary})
install(CODE "execute_process(COMMAND touch {canary})")
install(PROGRAMS ../../../../etc/passwd ${{CMAKE_CURRENT_SOURCE_DIR}}/../../x DESTINATION lib/bad)
"""
PROJECT: Final = """\
[build-system]
requires = ["setuptools"]
build-backend = "backend"
backend-path = ["."]
[project]
name = "bad"
dynamic = ["version"]
[project.scripts]
bad = "bad:main"
[tool.setuptools.dynamic]
version = {{attr = "bad.canary"}}
"""


def write(folder: Path, name: str, text: str) -> None:
    """One file of a workspace."""
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def sound(folder: Path) -> None:
    """A sound package, whose node must be found."""
    for name, text in (
        ("good.py", GOOD),
        ("launch/good.launch.xml", GOOD_LAUNCH),
        ("CMakeLists.txt", GOOD_CMAKE),
        ("package.xml", GOOD_MANIFEST),
    ):
        write(folder / "good", name, text)


@pytest.fixture
def trap(tmp_path: Path) -> tuple[Path, Path]:
    """A workspace full of code that touches a canary, and the canary."""
    canary = tmp_path / "canary"
    workspace = tmp_path / "ws"
    words = {"canary": str(canary), "expression": EVAL.format(canary=canary)}
    code = (TOUCH + BEHIND).format(canary=canary)
    texts = {
        "bad/setup.py": f"{code}\nfrom setuptools import setup\nsetup(name='bad', version={EVAL.format(canary=canary)},"
        " entry_points={'console_scripts': ['bad = bad:main']})\n",
        "bad/setup.cfg": "[metadata]\nname = bad\nversion = attr: bad.canary\n[options.entry_points]\nconsole_scripts =\n  x = bad:main\n",
        "bad/pyproject.toml": PROJECT.format(),
        "bad/backend.py": code,
        "bad/conftest.py": code,
        "bad/sitecustomize.py": code,
        "bad/yaml.py": code,
        "bad/package.xml": MANIFEST,
        "bad/CMakeLists.txt": CMAKE.format(**words),
        "bad/bad/__init__.py": code + GOOD.replace("'good'", "'bad'") + "def main(): pass\n",
        "bad/bad/__main__.py": code,
        "bad/bad/data.py": f"import pickle, yaml\npickle.loads(b\"cos\\nsystem\\n(S'touch {canary}'\\ntR.\")\n"
        f"yaml.load('!!python/object/apply:os.system [touch {canary}]', Loader=yaml.UnsafeLoader)\nimport rclpy\n",
        "bad/launch/a.launch.py": LAUNCH_PY.format(touch=code, **words),
        "bad/launch/b.launch.xml": LAUNCH_XML.format(**words),
        "bad/launch/c.launch.yaml": LAUNCH_YAML.format(**words),
        "bad/launch/d.launch.xml": ENTITIES,
        "bad/config/p.yaml": PARAMS.format(**words),
        "bad/msg/X.msg": f"string x `touch {canary}` $(touch {canary})\n",
        "yaml.py": code,
        "jinja2.py": code,
    }
    for name, text in texts.items():
        write(workspace, name, text)
    sound(workspace)
    models = tmp_path / "models"
    write(models, "lib.pyi", code)
    write(models, "nodes/bad.yaml", f"nodl_version: 2\npackage: !!python/object/apply:os.system ['touch {canary}']\n")
    return workspace, canary


@pytest.mark.parametrize(
    "options",
    sample(
        [
            pytest.param(["extract", "--all-launch"], id="launch"),
            pytest.param(["extract"], id="extract"),
            pytest.param(["launch-tree"], id="launch-tree"),
            pytest.param(["nodl", "good/good.py"], id="nodl"),
        ],
        2,
    ),
)
def test_no_canary_is_touched(tmp_path: Path, trap: tuple[Path, Path], options: list[str]) -> None:
    workspace, canary = trap
    out = tmp_path / "out"
    command, *rest = options
    arguments = [command, *rest, str(workspace), "--models", str(tmp_path / "models")]
    if command == "extract":
        arguments += ["-o", str(out), "--params", str(workspace / "bad" / "config" / "p.yaml")]
    run = harmless(watched(arguments, inputs=workspace, outputs=out, folder=workspace))
    assert not canary.exists()
    assert "root:" not in run.stdout + run.stderr
    if command == "extract":
        network = json.loads((out / "network.json").read_bytes())
        assert "/good" in {n["fqn"] for n in network["nodes"]}
        for path in out.rglob("*"):
            assert path.is_dir() or b"root:x:" not in path.read_bytes()


@pytest.mark.parametrize(
    "option",
    sample(
        [
            ["--launch", "../../../etc/passwd"],
            ["--launch", "/dev/zero"],
            ["--launch", "good:../../x"],
            ["--launch", "good:launch/good.launch.xml,x:=$(eval \"__import__('os').system('touch canary')\")"],
            ["--launch", "good:launch/good.launch.xml", "--arg", "x:=$(command 'touch canary')"],
            ["--launch", "good:launch/good.launch.xml", "--arg", ":=:=:="],
            ["--launch", ""],
            ["--launch", "\x1b[2J"],
            ["--node", "../../x/y"],
            ["--node", "good/../../x:../../y"],
            ["--node", "good/good.py:../../../x"],
            ["--node", "good/\x1b[2Jx\n"],
            ["--node", "good/good.py:" + "a" * 5_000],
            ["--node", "a" * 100_000 + "/b"],
            ["--params", "/dev/zero"],
            ["--params", "/dev/null"],
        ],
        4,
    ),
)
def test_what_a_command_line_asks_for_is_read_or_refused(tmp_path: Path, option: list[str]) -> None:
    sound(tmp_path / "ws")
    out = tmp_path / "deep" / "out"
    arguments = ["extract", str(tmp_path / "ws"), "-o", str(out), *option]
    run = harmless(watched(arguments, inputs=tmp_path / "ws", outputs=out.parent, folder=tmp_path / "ws"))
    assert "\x1b" not in run.stdout + run.stderr
    assert {p.name for p in tmp_path.iterdir()} <= {"ws", "deep"}
    assert not (tmp_path / "ws" / "canary").exists()


def corpus() -> list[Path]:
    """Checkouts of real repositories, where there are any: folders below $ROSWARD_CORPUS."""
    folder = os.environ.get("ROSWARD_CORPUS")
    return sorted(Path(folder).iterdir()) if folder else []


@pytest.mark.skipif(not corpus(), reason="ROSWARD_CORPUS names no folder of checkouts")
@pytest.mark.parametrize("repository", corpus(), ids=lambda p: p.name)
@pytest.mark.parametrize("options", [[], ["--all-launch"]], ids=["run", "launch"])
def test_real_repositories_run_nothing(tmp_path: Path, repository: Path, options: list[str]) -> None:
    before = _listing(repository)
    arguments = ["extract", "-q", *options, str(repository), "-o", str(tmp_path / "out")]
    run: Watched = watched(arguments, inputs=repository, outputs=tmp_path / "out", seconds=600, folder=repository)
    harmless(run)
    assert _listing(repository) == before


def _listing(folder: Path) -> list[tuple[str, int, int]]:
    found = []
    for path in sorted(folder.rglob("*")):
        status = path.lstat()
        found.append((str(path), status.st_size, status.st_mtime_ns))
    return found
