# SPDX-License-Identifier: Apache-2.0
"""With workers comes out what comes out without; one that dies costs its process, and that is told."""

from __future__ import annotations

import os
import random
import signal
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosward import Result, extract
from rosward.analysis import outcome_form, runner, workers
from rosward.analysis.outcome import Done, Outcome, Outset, Task, outcome_of
from rosward.analysis.outcome_form import ANSWER, ENTRY, OUTCOME, SEEN, Answer
from rosward.analysis.seen import AskedVariable, ClassSeen, Method, Seen
from rosward.cache.codec import Codec, loaded, text
from rosward.cache.results import _written as written
from rosward.cli.amounts import cores
from rosward.effects.entry import Entry
from rosward.engine.budget import Budget
from rosward.findings import Finding
from rosward.rules import RULES
from rosward.source.disk import holds, watching

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="this system cannot fork")

EXAMPLE = Path(__file__).resolve().parent.parent.parent / "examples" / "delivery_robot"

PROGRAM = """
import os
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from demo{package} import shared

class Made{number}(Node):
    def __init__(self):
        super().__init__(f"node_{number}_{{shared.NAME}}")
        self.create_publisher(String, "long" if os.environ["TOPIC_{number}"] == "long" else shared.topic({number}), 10)

    def never(self):
        self.create_publisher(String, "never", 10)

class Unmade{number}(Made{number}):
    pass

def main():
    Made{number}()
"""


@pytest.fixture
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Workers begin with the first process."""
    monkeypatch.setattr(runner, "_MOMENT", -1.0)


def workspace(folder: Path, packages: int = 2, programs: int = 4) -> Path:
    for package in range(packages):
        place = folder / f"demo{package}"
        inner = place / f"demo{package}"
        inner.mkdir(parents=True)
        (place / "package.xml").write_text(
            f"<package format='3'><name>demo{package}</name></package>", encoding="utf-8"
        )
        scripts = [f"p{n} = demo{package}.p{n}:main" for n in range(programs)]
        (place / "setup.py").write_text(
            f"from setuptools import setup\nsetup(name='demo{package}', packages=['demo{package}'],\n"
            f"    entry_points={{'console_scripts': {scripts}}})\n",
            encoding="utf-8",
        )
        (inner / "__init__.py").write_text("", encoding="utf-8")
        (inner / "shared.py").write_text(
            f"NAME = 'of_{package}'\n\n\ndef topic(n):\n    return f'topic_{{n}}'\n", encoding="utf-8"
        )
        for number in range(programs):
            (inner / f"p{number}.py").write_text(PROGRAM.format(number=number, package=package), encoding="utf-8")
        (inner / "alone.py").write_text("import rclpy\nrclpy.create_node('alone')\n", encoding="utf-8")
    (folder / "pump").mkdir()
    (folder / "pump" / "package.xml").write_text("<package format='3'><name>pump</name></package>", encoding="utf-8")
    (folder / "pump" / "CMakeLists.txt").write_text(
        "project(pump)\nadd_executable(one one.cpp)\nadd_executable(two two.cpp)\n"
        'add_library(parts SHARED part.cpp)\nrclcpp_components_register_nodes(parts "demo::Part" "demo::Other")\n',
        encoding="utf-8",
    )
    for name in ("one", "two"):
        (folder / "pump" / f"{name}.cpp").write_text(
            f'#include "rclcpp/rclcpp.hpp"\n#include "name.hpp"\nint main() {{ auto n = rclcpp::Node::make_shared("{name}"); }}\n',
            encoding="utf-8",
        )
    (folder / "pump" / "name.hpp").write_text("\n", encoding="utf-8")
    (folder / "pump" / "part.cpp").write_text(
        '#include "rclcpp/rclcpp.hpp"\nnamespace demo {\n'
        'class Part : public rclcpp::Node { public: explicit Part(const rclcpp::NodeOptions& o) : Node("part", o) {} };\n'
        'class Other : public rclcpp::Node { public: explicit Other(const rclcpp::NodeOptions& o) : Node("other", o) {} };\n}\n',
        encoding="utf-8",
    )
    return folder


def bytes_of(result: Result) -> bytes:
    return text(written(result))


@pytest.mark.usefixtures("at_once")
@pytest.mark.parametrize("flow", [False, True])
@pytest.mark.parametrize("jobs", [2, 3])
def test_the_result_is_the_same(tmp_path: Path, jobs: int, flow: bool) -> None:
    folder, budget = workspace(tmp_path), Budget(flow=flow)
    with watching() as trace:
        alone = extract(folder, budget=budget)
    with watching() as by_workers:
        together = extract(folder, budget=budget, jobs=jobs)
    assert bytes_of(together) == bytes_of(alone)
    assert len(alone.network.nodes) > 12
    assert {f.code for f in alone.findings} >= {"RW205", "RW325"}
    mine = {look: told for look, told in trace.seen.items() if str(folder) in look[1]}
    assert {look: told for look, told in by_workers.seen.items() if str(folder) in look[1]} == mine
    assert holds(by_workers.seen)


@pytest.mark.usefixtures("at_once")
@pytest.mark.slow
def test_the_example_is_the_same() -> None:
    assert bytes_of(extract(EXAMPLE, jobs=2)) == bytes_of(extract(EXAMPLE))
    assert bytes_of(extract(EXAMPLE, jobs=2, assumed=False)) == bytes_of(extract(EXAMPLE, assumed=False))


def test_small_sources_have_no_workers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse() -> int:
        raise AssertionError("forked")

    monkeypatch.setattr(os, "fork", refuse)
    extract(workspace(tmp_path, 1, 2), jobs=8)


@pytest.mark.usefixtures("at_once")
def test_who_cannot_fork_works_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = workspace(tmp_path)
    monkeypatch.setattr(workers, "can_fork", lambda: False)
    assert bytes_of(extract(folder, jobs=2)) == bytes_of(extract(folder))


@pytest.mark.usefixtures("at_once")
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM])
def test_a_worker_that_dies_costs_its_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, how: signal.Signals
) -> None:
    folder = workspace(tmp_path)
    whole = extract(folder)

    def dying(outset: Outset, task: Task) -> Done:
        if task.entry.label == "demo0/p1":
            os.kill(os.getpid(), how)
        return outcome_of(outset, task)

    monkeypatch.setattr(runner, "outcome_of", dying)
    found = extract(folder, jobs=2)
    lost = {n.process for n in whole.network.nodes} - {n.process for n in found.network.nodes}
    assert lost == {"demo0/p1", "class demo0/demo0/p1.py:Unmade1"}
    (told,) = [f for f in found.findings if f.code == "RW201"]
    assert (
        told.message
        == f"demo0/p1 was not analysed: the process that analyses it was killed (it was killed by {how.name})"
    )
    assert told.place.file == "demo0/demo0/p1.py"
    assert not found.complete
    others = {f for f in whole.findings if f.place.file != "demo0/demo0/p1.py" and f.code != "RW325"}
    assert {f for f in found.findings if f.code not in ("RW201", "RW325")} == others


@pytest.mark.usefixtures("at_once")
def test_what_fails_in_a_worker_fails_here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the net, the error is seen as it is without workers."""
    folder = workspace(tmp_path)

    def failing(outset: Outset, task: Task) -> Done:
        if task.entry.label == "demo0/p1":
            raise ZeroDivisionError
        return outcome_of(outset, task)

    monkeypatch.setattr(runner, "outcome_of", failing)
    with pytest.raises(ZeroDivisionError):
        extract(folder, jobs=2, budget=Budget(net=False))


@pytest.mark.usefixtures("at_once")
def test_the_order_in_which_workers_end_does_not_matter(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = workspace(tmp_path)

    def slowly(outset: Outset, task: Task) -> Done:
        import time

        time.sleep(random.Random(task.entry.label + str(os.getpid())).random() / 20)
        return outcome_of(outset, task)

    alone = bytes_of(extract(folder))
    monkeypatch.setattr(runner, "outcome_of", slowly)
    for _ in range(3):
        assert bytes_of(extract(folder, jobs=3)) == alone


# The form of what is sent

st.register_type_strategy(str, st.text(st.characters(), max_size=5))
st.register_type_strategy(Finding, st.builds(Finding, code=st.sampled_from(sorted(RULES))))
st.register_type_strategy(
    Outcome, st.builds(Outcome, nodes=st.just(()))
)  # nodes have a law of their own in tests/cache
QUESTIONS = st.lists(st.lists(st.text(max_size=3) | st.integers(), min_size=1, max_size=3).map(tuple), max_size=3).map(
    tuple
)
st.register_type_strategy(Answer, st.builds(Answer, questions=QUESTIONS))
FORMS: dict[type[Any], Codec[Any]] = {
    Entry: ENTRY,
    ClassSeen: outcome_form.CLASS,
    Method: outcome_form.METHOD,
    AskedVariable: outcome_form.VARIABLE,
    Seen: SEEN,
    Outcome: OUTCOME,
    Answer: ANSWER,
}


@pytest.mark.parametrize("kind", FORMS, ids=lambda kind: kind.__name__)
def test_what_is_sent_arrives(kind: type[Any]) -> None:
    form = FORMS[kind]

    @given(st.from_type(kind))
    def law(value: Any) -> None:
        document = text(form.write(value))
        assert form.read(loaded(document)) == value
        assert text(form.write(form.read(loaded(document)))) == document

    law()


def test_there_is_a_worker_for_each_core() -> None:
    assert cores() >= 1
