# SPDX-License-Identifier: Apache-2.0
"""No result depends on the order in which a folder lists its files, files are read, or processes are interpreted.

What the paths themselves decide stays: which of two files of one name is meant, which of two processes of one label is #2.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any

import pytest
from casefile import Case, read_cases
from sampling import sample

import rosward
from rosward.analysis import read
from rosward.deployment.request import Request
from rosward.network.asked import NOT_TOLD
from rosward.outputs.documents.network_json import network_json
from rosward.source.workspace import Workspace

TESTS = Path(__file__).parent
CASES = [
    c for f in sorted(TESTS.glob("cases/*.md")) for c in read_cases(f) if sum(n.endswith(".py") for n in c.files) > 1
]
EXAMPLE = TESTS.parent / "examples" / "delivery_robot"
SEEDS = (1, 2)


class _Listing:
    """What `os.scandir` gives, in another order."""

    def __init__(self, entries: tuple[Any, ...]) -> None:
        self._rest = iter(entries)

    def __enter__(self) -> _Listing:
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing is open."""

    def __iter__(self) -> _Listing:
        return self

    def __next__(self) -> Any:
        return next(self._rest)

    def close(self) -> None:
        """Nothing is open."""


@contextmanager
def shuffled(seed: int) -> Iterator[None]:
    """Everything that comes in an order comes in another one."""
    random = Random(seed)
    scan, discover, plan = os.scandir, read.discover, read.make_plan  # type: ignore[attr-defined]

    def mixed(items: Any) -> tuple[Any, ...]:
        given = list(items)
        random.shuffle(given)
        return tuple(given)

    def scandir(*path: Any) -> _Listing:
        with scan(*path) as listing:
            return _Listing(mixed(listing))

    def found(*arguments: Any, **options: Any) -> Workspace:
        workspace = discover(*arguments, **options)
        changed: dict[str, Any] = {
            name: mixed(getattr(workspace, name)) for name in ("files", "launch_files", "packages")
        }
        return replace(workspace, **changed)

    def planned(*arguments: Any) -> Any:
        made = plan(*arguments)
        return made._replace(entries=mixed(made.entries), findings=mixed(made.findings))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("os.scandir", scandir)
        patch.setattr("rosward.analysis.read.discover", found)
        patch.setattr("rosward.analysis.read.make_plan", planned)
        yield


def written(*paths: Path, **options: Any) -> str:
    return network_json(rosward.extract(*paths, **options).network)


def answer(*paths: Path, **options: Any) -> str:
    """What came out, without what was asked."""
    network = rosward.extract(*paths, **options).network
    return network_json(replace(network, asked=NOT_TOLD))


@pytest.mark.parametrize("case", sample(CASES, 3), ids=lambda case: case.name)
def test_the_programs_of_several_files(case: Case, tmp_path: Path) -> None:
    for name, text in case.files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    distro = case.options.get("distro", "jazzy")
    expected = written(tmp_path, distro=distro)
    for seed in SEEDS:
        with shuffled(seed):
            assert written(tmp_path, distro=distro) == expected


@pytest.mark.parametrize("all_launch", [False, True])
@pytest.mark.slow
def test_the_example(all_launch: bool) -> None:
    request = Request(all_launch=all_launch)
    expected = written(EXAMPLE, request=request)
    packages = sorted(path for path in EXAMPLE.iterdir() if path.is_dir())
    for seed in SEEDS:
        with shuffled(seed):
            assert written(EXAMPLE, request=request) == expected
            named = Random(seed).sample(packages, len(packages))
            assert answer(*named, request=request) == answer(EXAMPLE, request=request)


def test_the_order_is_another_one(tmp_path: Path) -> None:
    """The test would find something if there were something."""
    for number in range(20):
        (tmp_path / f"f{number}.py").write_text("import rclpy\n")
    orders = set()
    for seed in SEEDS:
        with shuffled(seed):
            workspace = read.discover([tmp_path])  # type: ignore[attr-defined]
            orders.add(tuple(file.relative for file in workspace.files))
    assert len(orders) == len(SEEDS)
