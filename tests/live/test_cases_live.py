# SPDX-License-Identifier: Apache-2.0
"""Promise: every Python program of `tests/cases` has, under the real rclpy, the graph that rosward says it has.

Each is run twice: once spinning returns, once it is interrupted as by Ctrl-C. All that the real graph shows must be covered, and what
is not conditional must be there where the main body came to its end. Programs in C++ are compiled and run in `tests/cpp`.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Final, NamedTuple

import pytest

pytest.importorskip("rclpy")

from casefile import Case, read_cases

import rosward
from rosward.source.walk import CPP_SOURCES

from .agreement import judge
from .casebook import programs_of, runnable
from .harness import RealRclpy


def _in_python(case: Case) -> bool:
    """Whether rclpy can run all of a case: not where a part of it is in C++."""
    return any(name.endswith(".py") for name in case.files) and not any(n.endswith(CPP_SOURCES) for n in case.files)


CASES: Final = [
    case
    for file in sorted((Path(__file__).parents[1] / "cases").glob("*.md"))
    for case in read_cases(file)
    if _in_python(case)
]
LEAST: Final = 150
"""How many programs have to run at least, besides the generated ones."""

NOT_RUN: Final = {
    "relative_imports: A file of a package that is not wholly there": "its package is not there",
    "enumerations: Members in paths, up to Python 3.11": "it is about a distribution before that of the rclpy here",
    "loops: Loops that compute much": "runs for longer than a test may",
    "inputs: The content of a file": "reads a file outside of the project",
    "called_from_outside: A plugin of Webots": "Webots alone makes it",
    "called_from_outside: An environment that nothing makes": "nothing makes it",
    "messages: Interfaces of the workspace": "its interfaces are not built",
    "messages: An interface package with a module of its own": "its interfaces are not built",
    "messages: What a message of the workspace does not have": "its interfaces are not built",
    "import_path: Folders without a file in a package": "its package is not installed",
    "modules: A package that names itself, beside a program": "its program is in a folder",
    "invalid: Packages for ROS 1": "its packages are for ROS 1",
    "invalid: A package for both": "its package is not built",
    "run_by_library: What the wrapper of curses calls": "there is no terminal",
    "partial: A class whose parameters nobody gives": "nothing gives the arguments that it needs",
}
"""Cases that cannot run here, and why; those that need a library of which there is no wheel are skipped with its name."""

NEED_FRAMEWORKS: Final = frozenset({"called_from_outside"})
"""Documents whose programs import a framework that a stand-in replaces."""

NEED_INSTALL: Final = frozenset({"data_files"})
"""Documents whose programs ask for the share folders of installed packages."""

FAILS: Final = {
    "found: Topic and type in the order of ROS 1": "TypeError",
    "found: A topic whose default is empty": "InvalidTopicNameException",
    "alternatives: One of two functions does not fit": "TypeError",
    "containers: One of several containers": "TypeError",
    "introspection: An attribute that a str has not": "AttributeError",
    "iteration: Generators made in a loop": "EOFError",
    "invalid: A node name with a slash": "InvalidNodeNameException",
    "other_texts: A list that rcl refuses": "RCLError",
    "other_texts: A list of two kinds of numbers": "RCLError",
    "ros_arguments: Refused for the node": "RCLInvalidROSArgsError",
    "characters: A star in a remap rule": "RCLError",
    "characters: A star on the left of a rule": "RCLError",
    "characters: A star in the namespace rule": "RCLError",
    "characters: A star in the name rule": "RCLError",
    "characters: A star in the enclave": "RCLError",
    "characters: A star in the namespace of a node": "InvalidNamespaceException",
    "characters: A question mark in the namespace of a node": "InvalidNamespaceException",
    "characters: A set in the namespace of a node": "InvalidNamespaceException",
    "characters: A star in the name of a node": "InvalidNodeNameException",
    "characters: A question mark in the name of a node": "InvalidNodeNameException",
    "characters: A set in the name of a node": "InvalidNodeNameException",
    "invalid: Assigning to a property of Node": "AttributeError",
    "imports_by_name: A module at a path that nobody knows": "IndexError",
}
"""Cases about programs that fail, and how the real ones do."""


class Input(NamedTuple):
    """What a case needs from outside; the program is the same as far as names are known."""

    arguments: tuple[str, ...] = ()
    environment: tuple[tuple[str, str], ...] = ()


INPUTS: Final = {
    "inputs: An environment variable": Input(environment=(("ROBOT", "r1"),)),
    "inputs: argparse": Input(arguments=("walle",)),
    "inputs: The command line": Input(arguments=("7",)),
    "loops: A loop of unknown length": Input(arguments=("--ros-args", "-p", "count:=2")),
    "parameters: A parameter without a default": Input(arguments=("--ros-args", "-p", "robot:=r1")),
}


@pytest.fixture(scope="module")
def real() -> Iterator[RealRclpy]:
    with RealRclpy() as server:
        yield server


def _case(case: Case) -> object:
    marks = []
    if case.name in NOT_RUN:
        marks.append(pytest.mark.skip(reason=NOT_RUN[case.name]))
    elif case.file.stem in NEED_INSTALL:
        marks.append(pytest.mark.skip(reason="needs an installed package"))
    if case.known:
        marks.append(pytest.mark.xfail(reason=case.known, strict=True))
    return pytest.param(case, marks=marks, id=case.name)


@pytest.mark.parametrize("case", [_case(case) for case in CASES])
def test_case(case: Case, real: RealRclpy, tmp_path: Path) -> None:
    """What runs is what is written beside the program."""
    files = runnable(case.files)
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    given = INPUTS.get(case.name, Input())
    programs = [p._replace(**given._asdict()) for p in programs_of(files, tmp_path)]
    if case.file.stem in NEED_FRAMEWORKS:
        programs = [p._replace(path=(*p.path, str(Path(__file__).parent / "standins"))) for p in programs]
    assert programs
    for program in programs:
        real.send(program)
        real.send(program._replace(interrupt=True))
    result = rosward.extract(tmp_path, distro="kilted")
    seen = [(real.receive(), real.receive()) for _ in programs]
    returned, interrupted = [first for first, _ in seen], [second for _, second in seen]
    if missing := [run.end for run in returned if run.end.startswith("ModuleNotFoundError")]:
        pytest.skip(missing[0])
    for run in returned:
        assert run.end.split(":")[0] == (case.fails or FAILS.get(case.name, "normal")), run.output
    for runs in (returned, interrupted):
        verdict = judge(result, runs)
        assert verdict.told or verdict.uncovered == ()
    assert judge(result, returned).missing == ()


def test_enough_programs() -> None:
    """The tables speak of cases that exist, and enough of the cases run."""
    names = {case.name for case in CASES}
    assert not ({*NOT_RUN, *FAILS, *INPUTS} - names)
    assert len([c for c in CASES if c.name not in NOT_RUN and c.file.stem not in NEED_INSTALL]) >= LEAST
