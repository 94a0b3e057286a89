# SPDX-License-Identifier: Apache-2.0
"""Any executor: in any order, with workers that are lost, and with those of a real Dask cluster, which are killed."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from distributed import Client, LocalCluster

import rosward
from rosward.cli import main
from rosward.surveying.apart import OtherRoswardError
from rosward.surveying.executing import Lost, outcomes
from rosward.surveying.repositories import Repository

from .checkouts import NAMES, Surveyed, tables

pytestmark = pytest.mark.slow

TASKS = [(Repository(f"r{n}", f"/r{n}"), str(n)) for n in range(2_500)]


class Losing(Executor):
    """Loses each task so many times; nothing is computed."""

    def __init__(self, times: int, error: BaseException) -> None:
        self.times = times
        self.error = error
        self.attempts: dict[str, int] = {}

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        attempt = self.attempts[args[0]] = self.attempts.get(args[0], 0) + 1
        if attempt <= self.times:
            future.set_exception(self.error)
        else:
            future.set_result(fn(*args, **kwargs))
        return future


@pytest.mark.parametrize("times", [0, 1, 2])
def test_a_lost_task_is_tried_again(times: int) -> None:
    executor = Losing(times, OSError("the machine is gone"))
    found = dict(outcomes(executor, str.encode, TASKS))
    assert found == {repository: text.encode() for repository, text in TASKS}
    assert set(executor.attempts.values()) == {times + 1}


def test_a_task_that_is_always_lost_has_an_outcome() -> None:
    found = list(outcomes(Losing(9, OSError("gone")), str.encode, TASKS[:3]))
    assert [outcome for _, outcome in found] == [Lost("OSError: gone")] * 3


@pytest.mark.parametrize("error", [OtherRoswardError("another one"), ModuleNotFoundError("No module named 'rosward'")])
def test_workers_that_can_do_nothing(error: Exception) -> None:
    with pytest.raises(rosward.SurveyError):
        list(outcomes(Losing(1, error), str.encode, TASKS[:3]))


def test_an_executor_that_takes_no_more() -> None:
    executor = ProcessPoolExecutor(1)
    executor.shutdown()
    with pytest.raises(rosward.LostExecutorError, match="shutdown"):
        list(outcomes(executor, str.encode, TASKS[:3]))


def test_a_pool_of_processes(surveyed: Surveyed, tmp_path: Path) -> None:
    with ProcessPoolExecutor(2) as executor:
        rosward.survey(surveyed.folder, tmp_path / "out", executor=executor, all_launch=True)
    assert tables(tmp_path / "out") == tables(surveyed.output)


@pytest.fixture(scope="module")
def cluster() -> Iterator[LocalCluster]:
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0", host="127.0.0.1", silence_logs=50
    ) as found:
        yield found


def test_workers_are_killed_and_join(surveyed: Surveyed, tmp_path: Path, cluster: LocalCluster) -> None:
    """All workers die after the first result, others join: nothing is lost, nothing is there twice, the tables are the same bits."""
    killed: list[int] = []

    with Client(cluster) as client:

        def kill(_what: str, done: int, _all: int) -> None:
            if done == 1:
                killed.extend(client.run(os.getpid).values())
                for worker in killed:
                    os.kill(worker, signal.SIGKILL)
                cluster.scale(3)

        executor = client.get_executor(pure=False)
        survey = rosward.survey(surveyed.folder, tmp_path / "out", executor=executor, all_launch=True, progress=kill)
        assert not set(killed) & set(client.run(os.getpid).values())
    assert len(killed) == 2
    assert survey.analysed == len(NAMES)
    assert tables(tmp_path / "out") == tables(surveyed.output)


def test_the_command_finds_the_scheduler(surveyed: Surveyed, tmp_path: Path, cluster: LocalCluster) -> None:
    words = ["survey", str(surveyed.folder), "--all-launch", "--scheduler", cluster.scheduler_address]
    assert main([*words, "-o", str(tmp_path / "out"), "-q"]) == 0
    assert tables(tmp_path / "out") == tables(surveyed.output)


def test_no_scheduler_answers(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("rosward.surveying.cluster._PATIENCE", 0.1)
    (tmp_path / "a").mkdir()
    assert main(["survey", str(tmp_path), "--scheduler", "tcp://127.0.0.1:9", "-o", str(tmp_path / "out")]) == 2
    assert "rosward: no Dask scheduler answers at tcp://127.0.0.1:9" in capsys.readouterr().err
    assert main(["survey", str(tmp_path), "--scheduler", "what://x", "-o", str(tmp_path / "out")]) == 2
