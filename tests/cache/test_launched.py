# SPDX-License-Identifier: Apache-2.0
"""Processes of launched systems are known one by one: by what they read, and by how they are started."""

from __future__ import annotations

import os
import random
from pathlib import Path
from typing import Any

import pytest

from cache.running import Running
from rosward import Result, extract
from rosward.analysis import runner
from rosward.analysis.outcome import Done, Outset, Task, outcome_of
from rosward.analysis.outcome_form import TASK, configuration_form
from rosward.cache.codec import loaded, text
from rosward.cache.results import _written as written
from rosward.cache.store import Store
from rosward.deployment.request import Request
from rosward.domain.compound import Tuple
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import Choice, Const, Hole, Ref, Text, Unknown
from rosward.effects.configuration import Configuration, Given
from rosward.effects.entry import Entry
from rosward.engine.libraries.written import NotWrittenError
from rosward.location import Place

LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([{nodes}])
"""
PLAIN = "Node(package='demo', executable='talker', name='left')"
TALKER = "Node(package='demo', executable='talker', name='{0}', parameters=[{{'topic': '{0}_topic'}}])"
PROGRAM = """import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from demo import {shared}


def main():
    node = Node("{name}")
    node.create_publisher(String, node.declare_parameter("topic", "chatter").value, 10)
    node.create_publisher(String, {shared}.NAME, 10)
"""
WORKSPACE = {
    "demo/package.xml": "<package format='3'><name>demo</name></package>",
    "demo/setup.py": "from setuptools import setup\nsetup(name='demo', packages=['demo'],\n"
    "    entry_points={'console_scripts': ['talker = demo.talker:main', 'listener = demo.listener:main']})\n",
    "demo/demo/__init__.py": "",
    "demo/demo/names.py": "NAME = 'names'\n",
    "demo/demo/others.py": "NAME = 'others'\n",
    "demo/demo/talker.py": PROGRAM.format(shared="names", name="talker"),
    "demo/demo/listener.py": PROGRAM.format(shared="others", name="listener"),
    "demo/launch/one.launch.py": LAUNCH.format(
        nodes=f"{PLAIN}, Node(package='demo', executable='listener', name='ears')"
    ),
    "demo/launch/two.launch.py": LAUNCH.format(nodes=f"{PLAIN}, {TALKER.format('right')}"),
}
ALL = Request(all_launch=True)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, content in WORKSPACE.items():
        path = tmp_path / "ws" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
    return tmp_path / "ws"


def same(one: Result, other: Result) -> bool:
    return text(written(one)) == text(written(other))


def test_what_is_started_twice_in_the_same_way_is_interpreted_once(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = Running(None, monkeypatch)
    result = run(folder, request=ALL)
    assert sorted(run.ran) == ["demo/listener", "demo/talker", "demo/talker"]
    assert {n.fqn for n in result.network.nodes} == {"/left", "/right", "/ears"}


def test_only_what_reads_a_changed_file_runs_again(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    warm = Running(Store(str(tmp_path / "cache")), monkeypatch)
    warm(folder, request=ALL)
    for file, more, again in (
        ("demo/demo/names.py", "# more\n", ["demo/talker", "demo/talker"]),
        ("demo/demo/others.py", "NAME = 'changed'\n", ["demo/listener"]),
        ("demo/launch/one.launch.py", "# more\n", []),
        ("demo/package.xml", "<!-- more -->\n", []),
    ):
        with (folder / file).open("a", encoding="utf-8") as opened:
            opened.write(more)
        found = warm(folder, request=ALL)
        assert warm.ran == again, file
        assert same(found, extract(folder, request=ALL)), file
    two = folder / "demo/launch/two.launch.py"
    two.write_text(two.read_text(encoding="utf-8").replace("right_topic", "other_topic"), encoding="utf-8")
    found = warm(folder, request=ALL)
    assert warm.ran == ["demo/talker"]  # it is started in another way
    assert same(found, extract(folder, request=ALL))


def test_what_the_sources_and_launch_files_start_is_told_apart(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A process of the sources has arguments that nobody knows, and a launched one has none."""
    warm = Running(Store(str(tmp_path / "cache")), monkeypatch)
    asked: tuple[dict[str, Any], ...] = ({}, {"request": ALL}, {}, {"launch": "demo:one.launch.py"})
    for options in asked:
        assert same(warm(folder, **options), extract(folder, **options))


@pytest.mark.parametrize("name", ["params", "all"])
def test_parameters_count(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    file = folder / "given.yaml"
    request = Request(params=(str(file),), all_launch=name == "all")
    warm = Running(Store(str(tmp_path / "cache")), monkeypatch)
    for topic in ("one", "two", "one"):
        file.write_text(f"/**:\n  ros__parameters:\n    topic: {topic}\n", encoding="utf-8")
        found = warm(folder, request=request)
        assert same(found, extract(folder, request=request))
        assert f"/{topic}" in {e.name for n in found.network.nodes for e in n.entities}
    warm(folder, request=request)
    assert warm.ran == []


def test_the_stubs_of_the_user_count(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What they say, and what is wrong with them, though nothing is run that reads them."""
    models = tmp_path / "models"
    models.mkdir()
    (models / "broken.pyi").write_text("def f(:\n", encoding="utf-8")
    (folder / "demo/demo/names.py").write_text(
        "import acme\ntry:\n    import broken\nexcept ImportError:\n    pass\nNAME = acme.NAME\n", encoding="utf-8"
    )
    warm = Running(Store(str(tmp_path / "cache")), monkeypatch)
    asked: tuple[dict[str, Any], ...] = ({}, {"request": ALL})
    for name in ("one", "two"):
        (models / "acme.pyi").write_text(f"NAME = '{name}'\n", encoding="utf-8")
        for again in (False, True):
            for options in asked:
                cold = extract(folder, models=[str(models)], **options)
                assert same(warm(folder, models=[str(models)], **options), cold)
                assert bool(warm.ran) is not again
                assert f"/{name}" in {e.name for n in cold.network.nodes for e in n.entities}
                assert any(f.place.file == "models:broken.pyi" for f in cold.findings)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system cannot fork")
def test_workers_take_them(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    alone = extract(folder, request=ALL)
    ran: list[str] = []

    def noted(outset: Outset, task: Task) -> Done:
        ran.append(task.entry.label)  # in a worker, nobody sees that
        return outcome_of(outset, task)

    monkeypatch.setattr(runner, "_MOMENT", -1.0)
    monkeypatch.setattr(runner, "outcome_of", noted)
    assert same(extract(folder, request=ALL, jobs=2), alone)
    assert ran == []


@pytest.mark.parametrize("seed", range(3))
def test_warm_is_cold(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, seed: int) -> None:
    rng = random.Random(f"launched {seed}")
    warm = Running(Store(str(tmp_path / "cache")), monkeypatch)
    files = sorted(WORKSPACE)
    for _ in range(8):
        cold = extract(folder, request=ALL)
        assert same(warm(folder, request=ALL), cold)
        path = folder / rng.choice(files)
        if rng.random() < 0.5:
            path.write_text(WORKSPACE[path.relative_to(folder).as_posix()], encoding="utf-8")
        else:
            content = path.read_text(encoding="utf-8")
            path.write_text(content.replace("left", "middle").replace("NAME = '", "NAME = 'x"), encoding="utf-8")


# The form

REASON = Reason(Cause.ENVIRONMENT, "ROBOT", Place("a.launch.py", 3))
CONFIGURATION = Configuration(
    (
        Const("--ros-args"),
        Const("-r"),
        Text(("__node:=", Hole((REASON,))), frozenset({Origin("launch argument", "name", settled=True)})),
        Choice((Const("a"), Const("b"))),
        Unknown((REASON,), "str", "ROBOT"),
    ),
    {
        "/tmp/params 1": (Given("/**", "rate", Tuple((Const(1), Const(2.5), Const(True))), Place("p.yaml", 2)),),
        "*": None,
    },
    {"*": REASON},
    {"DOMAIN": Const("\udc80"), "HOME": None},
    (Const("-p"),),
)


def test_a_task_is_read_as_it_was_written() -> None:
    task = Task(Entry("a.py", "a"), CONFIGURATION)
    document = text(TASK.write(task))
    again = TASK.read(loaded(document))
    assert text(TASK.write(again)) == document
    assert again.configuration is not None
    for name in ("words", "files", "missing", "environment", "component"):
        assert getattr(again.configuration, name) == getattr(CONFIGURATION, name)
    assert TASK.read(TASK.write(Task(task.entry))) == Task(task.entry)


@pytest.mark.parametrize("value", [Ref(3), Const(10**5000)], ids=["an object", "a long number"])
def test_what_a_line_cannot_say_is_not_known(value: Any) -> None:
    """What stands at an address is not in it."""
    with pytest.raises(NotWrittenError):
        configuration_form(Configuration((value,)))
