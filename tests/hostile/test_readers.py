# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="arg-type"
# ruff: noqa: E501  the hostile texts stand in one line each
"""Every reader, with files made to take all time and memory, or to lead it elsewhere: the sound node beside them is found all the same."""

from __future__ import annotations

import os
import socket
from pathlib import Path
from typing import Final

import pytest
from sampling import sample

import rosward
from hostile.apart import Ended, apart
from hostile.fuzz import GOOD, GOOD_CMAKE, GOOD_LAUNCH, GOOD_MANIFEST
from rosward.deployment.execution.yaml_values import as_type, as_yaml
from rosward.deployment.request import Request
from rosward.domain.values import Const
from rosward.ros.arguments import key_fits_node

SECONDS: Final = 50.0
"""Of a machine that does other things as well: each takes a few seconds at most."""

BOMB: Final = (
    "[&a0 [x, x, x, x, x, x, x, x]" + "".join(f", &a{i + 1} [{', '.join([f'*a{i}'] * 8)}]" for i in range(12)) + "]"
)
MANIFEST: Final = GOOD_MANIFEST.replace(">good<", ">bad<")
NODE: Final = GOOD.replace("'good'", "'bad'")
CMAKE: Final = GOOD_CMAKE.replace("good", "bad")


_KEYS: Final = "  k: {type: string_array, default_value: [" + ", ".join(f"k{i}" for i in range(100)) + "]}\n"
ENDLESS_FUNCTION: Final = "from launch import LaunchDescription\nfrom launch.actions import GroupAction, OpaqueFunction\ndef f(context):\n    return [OpaqueFunction(function=f), OpaqueFunction(function=f)]\ndef generate_launch_description():\n    return LaunchDescription([OpaqueFunction(function=f)])\n"
COUNTING_INCLUDE: Final = "<launch><arg name='a' default='0'/><include file='$(dirname)/b.launch.xml'><arg name='a' value=\"$(eval '$(var a) + 1')\"/></include><include file='$(dirname)/b.launch.xml'/></launch>"
MANY_ARGUMENTS: Final = "launch:\n" + "- arg: {name: a}\n" * 25_000
MANY_EXECUTABLES: Final = "executables:\n" + "  a: {}\n" * 30_000
WRONG_DEFAULTS: Final = "bad:\n" + "".join(f"  p{i}: {{type: string, default_value: {i}}}\n" for i in range(6_000))
MANY_PARAMETERS: Final = "bad:\n" + "".join(f"  p{i}: {{type: string, default_value: x}}\n" for i in range(1_400))
MAPS_60_DEEP: Final = (
    "bad:\n" + _KEYS + "".join("  " * n + "__map_k:\n" for n in range(1, 60)) + "  " * 60 + "p: {type: int}"
)
MAPS_9_DEEP: Final = (
    "bad:\n" + _KEYS + "".join("  " * n + "__map_k:\n" for n in range(1, 9)) + "  " * 9 + "p: {type: int}"
)
LONG: Final = frozenset(
    {
        ENDLESS_FUNCTION,
        COUNTING_INCLUDE,
        MANY_ARGUMENTS,
        MANY_EXECUTABLES,
        WRONG_DEFAULTS,
        MANY_PARAMETERS,
        MAPS_60_DEEP,
        MAPS_9_DEEP,
    }
)
"""What takes several seconds, most of it until a bound is reached."""


def marks(text: str) -> list[pytest.MarkDecorator]:
    return [pytest.mark.slow] if text in LONG else []


def workspace(folder: Path) -> Path:
    """A workspace with the sound package, and the beginning of a bad one."""
    ws = folder / "ws"
    for package, node, cmake, manifest in (("good", GOOD, GOOD_CMAKE, GOOD_MANIFEST), ("bad", NODE, CMAKE, MANIFEST)):
        (ws / package / "launch").mkdir(parents=True)
        (ws / package / f"{package}.py").write_text(node)
        (ws / package / "CMakeLists.txt").write_text(cmake)
        (ws / package / "package.xml").write_text(manifest)
    (ws / "good" / "launch" / "good.launch.xml").write_text(GOOD_LAUNCH)
    return ws


BOTH: Final = (False, True)


def nodes(
    ws: Path, *, launched: tuple[bool, ...] = BOTH, models: tuple[Path, ...] = (), params: tuple[str, ...] = ()
) -> list[list[str]]:
    """The nodes of the executables, and of the launch files."""
    found = []
    for each in launched:
        request = Request(all_launch=each, params=params)
        result = rosward.extract(ws, models=models, request=request)
        assert all(f.place.file or f.code in ("RW007", "RW307") for f in result.findings)
        found.append([n.fqn for n in result.network.nodes])
    return found


def sound(ended: Ended) -> None:
    """The good node was found in each way, within the bounds."""
    assert not ended.error, ended.error
    assert ended.value
    assert all("/good" in found for found in ended.value)


HOSTILE: Final = [
    (
        "package.xml",
        '<!DOCTYPE p [<!ENTITY a "aaaaaaaaaa">'
        + "".join(f'<!ENTITY a{i} "{f"&a{i - 1 or str()};" * 10}">' for i in range(1, 9))
        + "]><package><name>&a8;</name></package>",
    ),
    ("package.xml", "<package>" + "<a>" * 100_000),
    ("package.xml", "<package format='3'><name>" + "../" * 30_000 + "</name></package>"),
    ("package.xml", MANIFEST.replace("bad", "../../x")),
    ("package.xml", MANIFEST.replace("bad", "\x1b[2J")),
    (
        "package.xml",
        MANIFEST.replace("<export>", "<depend condition='" + "(" * 150 + "$A" + ")" * 40 + "'>x</depend><export>"),
    ),
    (
        "package.xml",
        MANIFEST.replace("<export>", "".join(f"<depend>d{i}</depend>" for i in range(20_000)) + "<export>"),
    ),
    (
        "setup.py",
        "from setuptools import setup\nx = 'a' * 10**12\ny = [0] * 10**9\nz = 10**10**10\nsetup(name=x, data_files=y, version=z)\n",
    ),
    ("setup.py", "from setuptools import setup\nn = 'x'\n" + "n = n + n\n" * 60 + "setup(name=n)\n"),
    ("setup.py", "from setuptools import setup\nn = ['x']\n" + "n = n + n\n" * 60 + "setup(scripts=n)\n"),
    ("setup.py", "from setuptools import setup\nn = ''\n" + "n = '%s%s' % (n, n) + 'x'\n" * 60 + "setup(name=n)\n"),
    (
        "setup.py",
        "from setuptools import setup\nn = 'x'\n" + "n = n.replace('x', n * 1) + f'{n}{n}'\n" * 60 + "setup(name=n)\n",
    ),
    ("setup.py", "from setuptools import setup\nsetup(name='%1000000000d' % 1, version='{:>999999999}'.format('x'))\n"),
    (
        "setup.py",
        "from setuptools import setup\nL = list(range(300))\nsetup(scripts=[str(a) for a in [1]*300 for b in [1]*300 for c in [1]*300 for d in [1]*300])\n",
    ),
    (
        "setup.py",
        "from setuptools import setup\nfrom glob import glob\nsetup(data_files=[('x', glob('"
        + "**/" * 40
        + "*', recursive=True)), ('y', glob('../../../../**')), ('z', glob('"
        + "*a" * 5_000
        + "'))])\n",
    ),
    ("setup.py", "x = " + "(" * 100_000),
    (
        "setup.cfg",
        "[metadata]\nname = %(name)s\n[options.entry_points]\nconsole_scripts =\n"
        + "  a = "
        + "a." * 400
        + ":"
        + "a." * 90_000
        + "\n",
    ),
    ("setup.cfg", "[options.entry_points]\nconsole_scripts =\n" + "  a = a:a\n" * 20_000),
    ("setup.cfg", "[" * 100_000),
    ("pyproject.toml", "x = " + "[" * 100_000),
    ("pyproject.toml", "x = " + "{a = " * 50_000),
    ("pyproject.toml", "[" + "a." * 50_000 + "a]\n"),
    ("pyproject.toml", "x = " + "9" * 200_000 + "\n"),
    ("CMakeLists.txt", "set(x a)\n" + "set(x ${x}${x})\n" * 100 + "install(PROGRAMS ${x} DESTINATION lib/bad)\n"),
    (
        "CMakeLists.txt",
        "set(x a)\n"
        + "list(APPEND x ${x} ${x})\n" * 60
        + "foreach(a ${x})\nforeach(b ${x})\nendforeach()\nendforeach()\n",
    ),
    ("CMakeLists.txt", "function(f)\nf()\nf()\nendfunction()\nf()\n"),
    ("CMakeLists.txt", "macro(f)\ng()\nendmacro()\nmacro(g)\nf()\nf()\nendmacro()\nf()\n"),
    ("CMakeLists.txt", "include(CMakeLists.txt)\nadd_subdirectory(.)\nadd_subdirectory(launch/..)\n"),
    (
        "CMakeLists.txt",
        "foreach(i RANGE 99999999999)\nendforeach()\nforeach(i RANGE 0 1000000000 1)\nset(x ${i})\nendforeach()\nwhile(1)\nendwhile()\n",
    ),
    (
        "CMakeLists.txt",
        "file(GLOB_RECURSE x /*)\nfile(GLOB y "
        + "*a" * 10_000
        + ")\ninstall(PROGRAMS ${x} ${y} DESTINATION lib/bad)\n",
    ),
    ("CMakeLists.txt", "install(" + "(" * 200_000),
    ("CMakeLists.txt", "set(x " + "${" * 100_000 + "}" * 100_000 + ")"),
    (
        "launch/b.launch.xml",
        '<!DOCTYPE l [<!ENTITY a "a"><!ENTITY b "' + "&a;" * 10_000 + '">]><launch><arg name="&b;&b;&b;"/></launch>',
    ),
    ("launch/b.launch.xml", "<launch>" + "<group>" * 100_000),
    ("launch/b.launch.xml", "<launch>" + "<arg name='a'/>" * 100_000 + "</launch>"),
    ("launch/b.launch.xml", "<launch><include file='$(find-pkg-share bad)/launch/b.launch.xml'/></launch>"),
    (
        "launch/b.launch.xml",
        "<launch><arg name='a' default='x'/><include file='$(find-pkg-share bad)/launch/b.launch.xml'><arg name='a' value='$(var a)$(var a)'/></include></launch>",
    ),
    (
        "launch/b.launch.xml",
        COUNTING_INCLUDE,
    ),
    (
        "launch/b.launch.xml",
        "<launch><let name='a' value='x'/>"
        + "<let name='a' value='$(var a)$(var a)'/>" * 60
        + "<node pkg='bad' exec='bad.py' name='$(var a)'/></launch>",
    ),
    ("launch/b.launch.xml", "<launch><arg name='a' default='" + "$(var " * 5_000 + ")" * 5_000 + "'/></launch>"),
    (
        "launch/b.launch.xml",
        "<launch><arg name='a' default=\"$(eval '10**10**10')$(eval '[0]*10**9')$(eval &quot;'x'*10**12&quot;)\"/><node pkg='bad' exec='bad.py' name='$(var a)'/></launch>",
    ),
    (
        "launch/b.launch.xml",
        "<launch><node pkg='bad' exec='bad.py'><param name='p' value='" + BOMB + "' type='yaml'/></node></launch>",
    ),
    (
        "launch/b.launch.xml",
        "<launch><node pkg='bad' exec='bad.py'><param name='p' value='"
        + "[" * 40_000
        + "'/><param name='q' value='0x"
        + "f" * 50_000
        + "'/></node></launch>",
    ),
    ("launch/b.launch.yaml", "launch:\n- arg: {name: a, default: " + BOMB + "}\n"),
    ("launch/b.launch.yaml", "a: &a [" + "{x: y}, " * 1_000 + "]\nlaunch:\n- group: " + "[*a, *a]\n"),
    ("launch/b.launch.yaml", "launch: &a\n- group: *a\n"),
    ("launch/b.launch.yaml", "launch: " + "[" * 100_000),
    ("launch/b.launch.yaml", "launch:\n- include: {file: $(find-pkg-share bad)/launch/b.launch.yaml}\n"),
    ("launch/b.launch.yaml", MANY_ARGUMENTS),
    (
        "launch/b.launch.py",
        "from launch import LaunchDescription\ndef generate_launch_description():\n    x = []\n    while True:\n        x.append(LaunchDescription(x))\n    return LaunchDescription(x)\n",
    ),
    (
        "launch/b.launch.py",
        "import b\nfrom launch import LaunchDescription\nfrom launch_ros.actions import Node\ndef generate_launch_description():\n    return LaunchDescription([Node(package='bad', executable='bad.py', name='x' * 10**12, parameters=[{'a': [0] * 10**9}])] * 10**6)\n",
    ),
    (
        "launch/b.launch.py",
        ENDLESS_FUNCTION,
    ),
    ("msg/X.msg", "string<=999999999999999999999 x\n" * 20_000),
    ("msg/" + "X" * 200 + ".msg", "\0\0\0"),
]


@pytest.mark.parametrize(
    ("name", "text"), sample([pytest.param(n, t, id=f"{n}: {t[:40]!r}"[:70], marks=marks(t)) for n, t in HOSTILE], 6)
)
def test_no_file_costs_the_others(tmp_path: Path, name: str, text: str) -> None:
    ws = workspace(tmp_path)
    path = ws / "bad" / name
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
    sound(apart(lambda: nodes(ws, launched=(name.startswith("launch"),)), seconds=SECONDS))


PARAMS: Final = [
    "/**:\n  ros__parameters:\n    p: " + BOMB,
    "/**:\n  ros__parameters:\n    p: " + "[" * 100_000,
    "a: " * 50_000,
    "{a: " * 50_000,
    "/**:\n  ros__parameters:\n    p: 0x" + "f" * 400_000,
    "/**:\n  ros__parameters:\n    p: " + "9" * 400_000,
    "/**:\n  ros__parameters:\n    p: 1e" + "9" * 400_000,
    "/**:\n  ros__parameters:\n" + "".join(f"    p{i}: {i}\n" for i in range(60_000)),
    "/**/a" * 60 + ":\n  ros__parameters: {p: 1}\n",
    "/**" * 60 + "/zz:\n  ros__parameters: {p: 1}\n",
    "!!python/object/apply:os.system [x]: 1",
    "\0\x01\x02",
    "",
]


@pytest.mark.parametrize("text", sample(PARAMS, 3), ids=[repr(t[:50]) for t in PARAMS])
def test_parameter_files(tmp_path: Path, text: str) -> None:
    ws = workspace(tmp_path)
    file = tmp_path / "p.yaml"
    file.write_text(text)
    sound(apart(lambda: nodes(ws, params=(str(file),)), seconds=SECONDS))


DESCRIPTIONS: Final = [
    "bad:\n  p: " + BOMB,
    "bad: " + "[" * 50_000,
    "bad: " + "{a: " * 20_000,
    "bad:\n" + "".join(f"{' ' * n}g{n}:\n" for n in range(1, 90)) + " " * 90 + "p: {type: int}",
    WRONG_DEFAULTS,
    MANY_PARAMETERS,
    MAPS_9_DEEP,
    MAPS_60_DEEP,
    f"bad:\n  p: {{type: int, default_value: 0x{'f' * 200_000}}}",
    "bad:\n  p: {type: string_fixed_" + "9" * 5_000 + "}",
    "bad:\n  p: {type: string, default_value: !!python/object/apply:os.system [id]}",
    "'bad:\n  import os': {p: {type: int}}",
    "\0",
]


@pytest.mark.parametrize("text", sample([pytest.param(t, id=repr(t[:50]), marks=marks(t)) for t in DESCRIPTIONS], 3))
def test_descriptions_of_parameters(tmp_path: Path, text: str) -> None:
    ws = workspace(tmp_path)
    (ws / "bad" / "bad.yaml").write_text(text)
    (ws / "bad" / "CMakeLists.txt").write_text(CMAKE + "generate_parameter_module(parameters bad.yaml)\n")
    listener = "from bad.parameters import bad as described\n"
    program = NODE.replace("import rclpy\n", "import rclpy\n" + listener, 1)
    (ws / "bad" / "bad.py").write_text(program.replace("rclpy.spin", "described.ParamListener(bad)\nrclpy.spin"))
    sound(apart(lambda: nodes(ws, launched=(False,)), seconds=SECONDS))


MODELS: Final = [
    ("nodes/foreign.yaml", "nodl_version: 2\npackage: foreign\nexecutables: " + BOMB),
    ("nodes/foreign.yaml", "[" * 100_000),
    ("nodes/foreign.yaml", MANY_EXECUTABLES),
    ("nodes/foreign.yaml", "nodl_version: 2\npackage: foreign\nexecutables:\n  x: {same_as: y}\n  y: {same_as: x}\n"),
    (
        "nodes/foreign.yaml",
        "nodl_version: 2\npackage: foreign\ninterfaces:\n  a: {include: [a, b]}\n  b: {include: [a, a]}\nexecutables:\n  x: {node: x, include: [a]}\n",
    ),
    ("std_msgs/__init__.pyi", "def (:"),
    ("std_msgs/msg.pyi", "while True:\n    pass\n"),
    ("std_msgs/msg.pyi", "def f(n):\n    return f(n + 1) + f(n + 2)\nf(0)\nx = 'x' * 10**12\n"),
    ("rclpy/__init__.pyi", "\0"),
    ("rclpy.pyi", "\xff\xfe"),
    ("os.pyi", "(" * 10_000),
    ("lib.pyi", "from lib import *\nimport lib.lib.lib\n"),
]


@pytest.mark.parametrize(
    ("name", "text"), sample([pytest.param(n, t, id=f"{n}: {t[:30]!r}", marks=marks(t)) for n, t in MODELS], 3)
)
def test_models_of_the_user(tmp_path: Path, name: str, text: str) -> None:
    ws = workspace(tmp_path)
    (ws / "good" / "launch" / "f.launch.xml").write_text("<launch><node pkg='foreign' exec='x'/></launch>")
    (ws / "bad" / "bad.py").write_text(NODE.replace("import rclpy\n", "import rclpy\nimport lib\nimport os\n"))
    models = tmp_path / "models"
    (models / name).parent.mkdir(parents=True)
    (models / name).write_text(text, encoding="latin-1")
    sound(apart(lambda: nodes(ws, models=(models,)), seconds=SECONDS))


def test_a_stub_that_cannot_be_read_is_told_and_ours_stands_in(tmp_path: Path) -> None:
    ws = workspace(tmp_path)
    (tmp_path / "models" / "rclpy").mkdir(parents=True)
    (tmp_path / "models" / "rclpy" / "__init__.pyi").write_text("x = 1\ndef (:\n")
    result = rosward.extract(ws, models=[tmp_path / "models"])
    assert {n.fqn for n in result.network.nodes} == {"/good", "/bad"}
    assert [(f.code, f.place.line) for f in result.findings if f.place.file.endswith(".pyi")] == [("RW001", 2)]


# What is no file


SPECIAL: Final = ("bad.py", "package.xml", "setup.py", "setup.cfg", "pyproject.toml", "CMakeLists.txt", "launch/b.launch.xml",
                  "launch/b.launch.yaml", "launch/b.launch.py", "msg/X.msg")  # fmt: skip


@pytest.mark.parametrize("kind", ["pipe", "folder", "socket", "zero", "loop", "nowhere", "memory"])
def test_what_is_no_regular_file_is_never_waited_for(
    tmp_path: Path, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    ws = workspace(tmp_path)
    for name in SPECIAL:
        path = ws / "bad" / name
        path.parent.mkdir(exist_ok=True)
        path.unlink(missing_ok=True)
        match kind:
            case "pipe":
                os.mkfifo(path)
            case "folder":
                path.mkdir()
            case "socket":
                monkeypatch.chdir(path.parent)  # the path of a socket is short
                socket.socket(socket.AF_UNIX).bind(path.name)
            case _:
                target = {
                    "zero": "/dev/zero",
                    "loop": path.name,
                    "nowhere": "/no/such/file",
                    "memory": "/proc/self/mem",
                }[kind]
                path.symlink_to(target)
    for file in ("p.yaml", "models/rclpy.pyi", "models/nodes/bad.yaml"):
        path = tmp_path / file
        path.parent.mkdir(parents=True, exist_ok=True)
        os.mkfifo(path)
    (ws / "good" / "launch" / "p.launch.xml").write_text(
        f"<launch><node pkg='good' exec='good.py'><param from='{tmp_path / 'p.yaml'}'/><param from='/dev/zero'/></node>"
        "<include file='/dev/zero'/><include file='$(find-pkg-share bad)/launch/b.launch.xml'/></launch>"
    )
    sound(apart(lambda: nodes(ws, models=(tmp_path / "models",)), seconds=SECONDS))


def test_thousands_of_files_and_deep_folders(tmp_path: Path) -> None:
    ws = workspace(tmp_path)
    many = ws / "many"
    many.mkdir()
    for number in range(2_000):
        (many / f"f{number}.py").write_text(f"import f{number + 1}\nfrom f{number - 1} import *\n")
    deep = ws
    for _ in range(300):
        deep /= "d"
    deep.mkdir(parents=True)
    (deep / "x.py").write_text(NODE)
    (deep / "back").symlink_to(ws)
    sound(apart(lambda: nodes(ws), seconds=SECONDS))


@pytest.mark.slow
def test_includes_in_a_circle_with_changing_arguments(tmp_path: Path) -> None:
    ws = workspace(tmp_path)
    for one, other in (("a", "b"), ("b", "a")):
        (ws / "bad" / "launch" / f"{one}.launch.xml").write_text(
            f"<launch><arg name='n' default='x'/><include file='$(dirname)/{other}.launch.xml'><arg name='n' value='$(var n)_'/></include>"
            f"<include file='$(dirname)/{other}.launch.xml'><arg name='n' value='$(var n){one}'/></include></launch>"
        )
    sound(apart(lambda: nodes(ws), seconds=SECONDS))


# Single questions


@pytest.mark.parametrize(
    "text",
    sample(
        [
            BOMB,
            "&a [*a]",
            "&a {x: *a}",
            "{" * 50_000,
            "[" * 50_000,
            "- " * 40_000,
            "0x" + "f" * 90_000,
            ":".join(["1"] * 40_000),
        ],
        3,
    ),
)
def test_yaml_in_a_value_is_bounded(text: str) -> None:
    def refused(_: str) -> None:
        """What launch would refuse is not the question here."""

    def work() -> list[str]:
        values = (
            as_yaml(Const(text), refused),
            as_type(Const(text), "yaml", refused),
            as_type(Const(text), "List[yaml]", refused),
        )
        return [str(value) for value in values]

    ended = apart(work, seconds=SECONDS)
    assert not ended.error, ended.error
    assert all(len(value) < 10_000 for value in ended.value)


@pytest.mark.parametrize(
    ("key", "name", "fits"),
    [
        ("/**", "/a/b", True),
        ("/**/b", "/b", True),
        ("/**/b", "/a/a/b", True),
        ("/**/b", "/a/b/c", False),
        ("/*/b", "/a/b", True),
        ("/*/b", "/a/a/b", False),
        ("/*", "/a", True),
        ("/a/**", "/a", True),
        ("/a**", "/ab", False),
        ("/**/**/**", "/a", True),
        ("/*b", "/aab", True),
        ("b", "/b", True),
        ("/", "/b", False),
    ],
)
def test_keys_with_wildcards(key: str, name: str, fits: bool) -> None:
    assert key_fits_node(key, name) is fits


def test_a_key_of_many_wildcards_is_matched_soon() -> None:
    ended = apart(lambda: key_fits_node("/**" * 60 + "/zz", "/a" * 120), seconds=SECONDS)
    assert ended.value is False
    assert ended.seconds < 5
