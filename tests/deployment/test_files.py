# SPDX-License-Identifier: Apache-2.0
"""Promise: a path of a launch file leads to the file that it would lead to once the workspace is installed."""

from __future__ import annotations

from pathlib import Path

import pytest
from source.trees import manifest, write

from rosward.deployment.files import WorkspaceFiles
from rosward.domain.choice import join
from rosward.domain.text import concat, make
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Hole, Unknown, Value
from rosward.location import Place
from rosward.source.discover import discover
from rosward.source.installed import Installed

SETUP = (
    "from setuptools import setup\nsetup(name='demo', data_files=[('share/demo/launch', ['start/left.launch.py'])])\n"
)


def folder(cause: Cause, subject: str, line: int = 1) -> Value:
    return Unknown((Reason(cause, subject, Place("x.launch.py", line)),), "str")


SHARE, PREFIX, SOURCES = folder(Cause.SHARE, "demo"), folder(Cause.PREFIX, "demo"), folder(Cause.SOURCES, "")


def path(start: Value, rest: str) -> Value:
    return concat((start, Const(rest)))


@pytest.fixture
def files(tmp_path: Path) -> WorkspaceFiles:
    root = write(
        tmp_path,
        {
            "demo/package.xml": manifest("demo"),
            "demo/setup.py": SETUP,
            "demo/start/left.launch.py": "def generate_launch_description(): ...\n",
            "demo/config/a.yaml": "a: 1\n",
            "extra/top.launch.py": "def generate_launch_description(): ...\n",
            "big.yaml": "x" * 1_000_001,
        },
    )
    return WorkspaceFiles(Installed(discover([root])))


def test_find(files: WorkspaceFiles) -> None:
    assert files.find(path(SHARE, "/launch/left.launch.py")) == "demo/start/left.launch.py"
    assert files.find(path(PREFIX, "/share/demo/launch/left.launch.py")) == "demo/start/left.launch.py"
    assert files.find(path(SHARE, "/launch/../config/a.yaml")) == "demo/config/a.yaml"
    assert files.find(path(SOURCES, "/extra/top.launch.py")) == "extra/top.launch.py"
    assert files.text("demo/config/a.yaml") == "a: 1\n"


@pytest.mark.parametrize(
    "value",
    [
        Const("/etc/passwd"),
        Const("demo/config/a.yaml"),
        SHARE,
        path(SHARE, "/config"),
        path(SHARE, "config/a.yaml"),
        path(SHARE, "/../demo/config/a.yaml"),
        path(PREFIX, "/lib/demo/left.launch.py"),
        path(PREFIX, "/share/other/a.yaml"),
        path(SOURCES, "/../x"),
        path(folder(Cause.SHARE, "other"), "/config/a.yaml"),
        path(folder(Cause.SHARE, "*"), "/config/a.yaml"),
        path(folder(Cause.PARAMETER, "demo"), "/config/a.yaml"),
        concat((SHARE, Const("/config/"), folder(Cause.PARAMETER, "x"))),
        concat((SHARE, Const("/config/a.yaml"), folder(Cause.PARAMETER, "x"))),
        make(
            (Hole((Reason(Cause.SHARE, "demo", Place("")), Reason(Cause.SHARE, "other", Place("")))), "/config/a.yaml")
        ),
        join(path(SHARE, "/config/a.yaml"), Const("/x")),
    ],
    ids=repr,
)
def test_no_file(files: WorkspaceFiles, value: Value) -> None:
    assert files.find(value) is None


def test_one_folder_named_at_several_places(files: WorkspaceFiles) -> None:
    reasons = tuple(Reason(Cause.SHARE, "demo", Place("x.launch.py", line)) for line in (1, 2))
    assert files.find(make((Hole(reasons), "/config/a.yaml"))) == "demo/config/a.yaml"


def test_text_of_what_is_none(files: WorkspaceFiles) -> None:
    assert files.find(path(SOURCES, "/big.yaml")) == "big.yaml"
    assert files.text("big.yaml") is None
    assert files.text("/etc/passwd") is None
    assert files.text("absent") is None


def test_show(files: WorkspaceFiles) -> None:
    unknown = folder(Cause.PARAMETER, "x")
    assert files.show(path(SHARE, "/a.yaml")) == "$(find-pkg-share demo)/a.yaml"
    assert files.show(path(PREFIX, "/lib")) == "$(find-pkg-prefix demo)/lib"
    assert files.show(concat((Const("/tmp/"), unknown, Const(".yaml")))) == "/tmp/*.yaml"
    assert files.show(join(Const("/a"), path(SHARE, "/b"))) == "/a | $(find-pkg-share demo)/b"


@pytest.mark.parametrize("name", ["demo/start/left.launch.py", "demo/config/a.yaml", "extra/top.launch.py"])
def test_place_value(files: WorkspaceFiles, name: str) -> None:
    assert files.find(files.place_value(name)) == name


def test_packages(files: WorkspaceFiles) -> None:
    assert files.has_package("demo")
    assert not files.has_package("demo/..")
    assert files.show(files.place_value("demo/start/left.launch.py")) == "$(find-pkg-share demo)/launch/left.launch.py"
