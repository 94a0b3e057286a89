# SPDX-License-Identifier: Apache-2.0
"""Workers give each answer once, in the order of the tasks, whatever becomes of one of them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rosward.analysis.workers import Lost, Workers, can_fork
from rosward.cli.amounts import cores

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="this system cannot fork")


def _work(task: bytes) -> bytes:
    if task == b"raise":
        raise ValueError
    if task == b"kill":
        os.kill(os.getpid(), signal.SIGKILL)
    if task == b"exit":
        os._exit(7)
    if task == b"memory":
        raise MemoryError
    if task == b"large":
        return b"x" * 3_000_000
    if task == b"slow":
        time.sleep(0.2)
    return task.upper()


@pytest.mark.parametrize("number", [1, 2, 5])
def test_answers_are_in_the_order_of_the_tasks(number: int) -> None:
    tasks = [b"slow", *(b"t%d" % n for n in range(40)), b"large", b"raise", b"slow", b"last"]
    with Workers(_work, number) as workers:
        assert workers.all(tasks) == [None if task == b"raise" else _work(task) for task in tasks]
        assert workers.all([b"again"]) == [b"AGAIN"]
        assert workers.all([]) == []


def test_who_dies_costs_one_piece() -> None:
    tasks = [b"a", b"kill", b"b", b"exit", b"c", b"kill", b"memory", b"d"]
    with Workers(_work, 2) as workers:
        killed, ended = Lost("it was killed by SIGKILL"), Lost("it ended with status 7")
        assert workers.all(tasks) == [b"A", killed, b"B", ended, b"C", killed, None, b"D"]
        assert workers.all([b"kill", b"kill", b"kill", b"e"]) == [killed, killed, killed, b"E"]


def test_work_sees_what_is_there_and_changes_nothing() -> None:
    seen: list[bytes] = [b"before"]

    def work(task: bytes) -> bytes:
        seen.append(task)
        return b",".join(seen)

    with Workers(work, 1) as workers:
        assert workers.all([b"x", b"y"]) == [b"before,x", b"before,x,y"]
    assert seen == [b"before"]


def test_nobody_is_left() -> None:
    with Workers(_work, 3) as workers:
        workers.all([b"a", b"b", b"c"])
        before = [worker.pid for worker in workers._workers]
    for pid in before:
        with pytest.raises(ProcessLookupError):
            os.kill(pid, 0)
    assert workers.all([b"a"]) == [b"A"]
    workers.__exit__(None, None, None)


PARENT = """
import os, sys
from rosward.analysis.workers import Workers
def work(task):
    return str(os.getpid()).encode()
workers = Workers(work, 2)
print(*(a.decode() for a in workers.all([b'a', b'b'])), flush=True)
sys.stdin.read()
"""


def test_workers_end_with_their_parent(tmp_path: Path) -> None:
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT], stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=tmp_path
    )
    assert parent.stdout is not None
    pids = {int(pid) for pid in parent.stdout.readline().split()}
    parent.kill()
    parent.wait()
    for _ in range(100):
        there = [pid for pid in pids if _is_running(pid)]
        if not there:
            return
        time.sleep(0.05)
    pytest.fail(f"still running: {there}")


def _is_running(pid: int) -> bool:
    try:
        return "State:\tZ" not in Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    except OSError:
        return False


def test_there_is_a_core() -> None:
    assert cores() >= 1
    assert can_fork() in (True, False)
