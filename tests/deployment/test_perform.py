# SPDX-License-Identifier: Apache-2.0
"""Each substitution, as it is written in XML, and the text that it stands for (`*` for what is not known, `|` between alternatives)."""

from __future__ import annotations

import pytest

from deployment.execution import HERE, UNKNOWN, Run, share, shown, text
from rosward.deployment import tree
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Hole, Text
from rosward.ros.distro import Distro

SETTINGS = '<let name="x" value="1"/><let name="t" value="true"/><set_env name="E" value="e"/>'


def performed(written: str) -> tuple[str, list[str]]:
    """The text of a substitution, and the codes of findings."""
    run = Run(f'{SETTINGS}<arg name="a" default="d"/><node pkg="p" exec="{written}"/>')
    return shown(run.started[0].executable), run.codes


KNOWN = [
    ("plain", "plain"),
    ("a$(var x)b", "a1b"),
    ("$(var none other)", "other"),
    ("$(env E)", "e"),
    ("$(env NONE other)", "other"),
    ("$(env HOME)/x", "*/x"),
    ("$(find-pkg-share demo)/a", "*/a"),
    ("$(find-pkg-prefix demo)/a", "*/a"),
    ("of$(exec-in-pkg talker demo)", "of*/lib/demo/talker"),
    ("$(exec-in-pkg talker demo)", "talker"),  # as an executable, it is that of the package
    ("$(find-exec ls)", "*/ls"),
    ("$(dirname)", "*/launch"),
    ("$(filename)", "*/launch/main.launch.xml"),
    ("$(anon talker)", "talker_*"),
    ("$(eval '1 + $(var x)')", "<1 + 1>"),
    ("$(command 'xacro a.xacro')", "*"),
    ("$(not $(var t))", "false"),
    ("$(and true false)", "false"),
    ("$(or $(var t) $(env UNKNOWN))", "true"),
    ("$(and false $(env UNKNOWN))", "false"),
    ("$(and true $(env UNKNOWN))", "*"),
    ("$(any false yes)", "true"),
    ("$(all 1 0)", "false"),
    ("$(equals 1.0 1)", "true"),
    ("$(equals True 1)", "true"),
    ("$(equals a b)", "false"),
    ("$(equals $(env UNKNOWN) b)", "*"),
    ("$(equals a_$(env UNKNOWN) b)", "false"),
    ("$(not-equals a b)", "true"),
    ("$(if $(var t) yes no)", "yes"),
    ("$(if $(env UNKNOWN) yes no)", "yes|no"),
    ("$(launch_log_dir)", "*"),
]


@pytest.mark.parametrize(("written", "found"), KNOWN)
def test_substitutions(written: str, found: str) -> None:
    assert performed(written) == (found, [])


@pytest.mark.parametrize("written", ["$(var none)", "$(param none)", "$(not maybe)", "$(if 7 a b)", "$(var $(var t))"])
def test_substitutions_that_fail(written: str) -> None:
    assert performed(written)[1] == ["RW320"]


def test_alternatives_stay_apart() -> None:
    main = '<arg name="k"><choice value="a"/><choice value="b"/></arg><node pkg="p" exec="x_$(var k)"/>'
    assert shown(Run(main, k="*").started[0].executable) == "x_a|x_b"


def test_a_variable_that_launch_removed() -> None:
    main = '<set_env name="E" value="e"/><unset_env name="E"/><node pkg="p" exec="$(env E gone)"/>'
    assert Run(main).lines == ["p/gone --ros-args"]


def test_variables_that_are_extended() -> None:
    main = """<set_env name="KNOWN" value="a"/><append_env name="KNOWN" value="b"/>
        <append_env name="SHELL_HAS_IT" value="b" prepend="true"/><node pkg="p" exec="e"/>"""
    environment = Run(main).started[0].configuration.environment
    assert {name: shown(value) for name, value in environment.items()} == {"KNOWN": "a:b", "SHELL_HAS_IT": "b|b:*"}


def test_an_anonymous_name_is_the_same_each_time() -> None:
    one, two = Run('<node pkg="p" exec="$(anon a)"/><node pkg="p" exec="$(anon a)"/>').started
    assert one.executable == two.executable
    assert isinstance(one.executable, Text)
    hole = one.executable.parts[1]
    assert isinstance(hole, Hole)
    assert (hole.shape, hole.reasons[0].cause) == ("word", Cause.RANDOM)


def test_the_folder_of_an_included_file() -> None:
    """An include changes it before its arguments are performed, and it does not change back."""
    files = {"other/sub/a.launch.xml": '<launch><arg name="x"/><node pkg="p" exec="$(var x)"/></launch>'}
    main = """<include file="$(find-pkg-share other)/sub/a.launch.xml"><arg name="x" value="$(dirname)"/></include>
        <node pkg="p" exec="$(dirname)"/>"""
    assert Run(main, files).lines == ["p/*/sub --ros-args", "p/*/sub --ros-args"]


def test_the_pushed_namespace_is_a_launch_configuration() -> None:
    main = """<push_ros_namespace namespace="a"/><node pkg="p" exec="in$(var ros_namespace)"/>
        <let name="ros_namespace" value="/b"/><node pkg="p" exec="e"/>"""
    assert Run(main).lines == ["p/in/a --ros-args -r __ns:=/a", "p/e --ros-args -r __ns:=/b"]


def test_the_content_of_a_file() -> None:
    path = (share("demo", "/x.txt"),)
    start = tree.StartNode(place=HERE, executable=(tree.Substitution("file-content", (path,), HERE),))
    assert Run([start], {"demo/x.txt": "inside"}).lines == ["inside --ros-args"]
    assert Run([start]).lines == ["* --ros-args"]


@pytest.mark.parametrize(
    ("parts", "path"),
    [
        (("a", "b"), "a/b"),
        (("a/", "b"), "a/b"),
        (("a", "/b"), "/b"),
        ((share("demo", "/a"), "b"), "*/a/b"),
        (("/x", share("demo", "/a")), "*/a"),
    ],
)
def test_joined_paths(parts: tuple[object, ...], path: str) -> None:
    pieces = tuple(text(p) if isinstance(p, str) else (p,) for p in parts)
    start = tree.StartNode(place=HERE, executable=(tree.Substitution("path-join", pieces, HERE),))  # type: ignore[arg-type]
    assert Run([start]).lines == [f"{path} --ros-args"]


def test_joined_strings_and_python() -> None:
    joined = tree.Substitution("string-join", (text("-"), text("a"), (UNKNOWN,), text("b")), HERE)
    own = tree.Substitution("python", (), HERE, Const("performed"))
    run = Run([tree.StartNode(place=HERE, executable=(s,)) for s in (joined, own)])
    assert run.lines == ["a-*-b --ros-args", "performed --ros-args"]


def test_substitutions_that_humble_lacks() -> None:
    run = Run('<node pkg="p" exec="e" if="$(equals a a)"/>', distro=Distro.HUMBLE)
    assert (run.lines, run.codes) == (["p/e --ros-args"], ["RW320"])


def test_substitutions_that_are_not_known_or_lack_arguments() -> None:
    kinds = ("nonsense", "var", "equals", "if", "rewritten-yaml", "replace-string", "eval", "string-join")
    run = Run([tree.StartNode(place=HERE, executable=(tree.Substitution(kind, (), HERE),)) for kind in kinds])
    assert set(run.lines) == {"* --ros-args"}
    assert set(run.codes) == {"RW320", "RW321"}


def test_deep_substitutions_end() -> None:
    inner: tree.Template = text("true")
    for _ in range(400):
        inner = (tree.Substitution("not", (inner,), HERE),)
    assert Run([tree.StartNode(place=HERE, executable=inner)]).codes == ["RW201"]
