# SPDX-License-Identifier: Apache-2.0
"""`rosward serve` as a process: what it prints, what it answers, and what is left of it when it ends."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from http.client import HTTPConnection
from pathlib import Path
from typing import Final, NamedTuple
from urllib.parse import urlsplit

import pytest

from .page import TALKER

_ADDRESS: Final = re.compile(r"http://\S+")
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals")


class Running(NamedTuple):
    """A server, and the address that it has printed."""

    process: subprocess.Popen[str]
    address: str
    temporary: Path

    def get(self, path: str) -> tuple[int, str]:
        """Ask, with the token."""
        parts = urlsplit(self.address)
        connection = HTTPConnection(parts.hostname or "", parts.port, timeout=300)
        connection.request("GET", f"{path}?{parts.query}")
        answer = connection.getresponse()
        return answer.status, answer.read().decode()

    def end(self, number: signal.Signals) -> tuple[int, str]:
        """Its exit status and the rest of what it has printed."""
        self.process.send_signal(number)
        assert self.process.stdout is not None
        rest = self.process.stdout.read()
        return self.process.wait(timeout=300), rest


ROSWARD: Final = ("-m", "rosward")
PATIENT: Final = (
    "-c",
    "import rosward.server.run as run; run._SECONDS_TO_END = 120; from rosward.cli import main; main()",
)
"""A server that waits two minutes for whoever still listens, and then says so."""


def start(tmp_path: Path, *arguments: str, program: Sequence[str] = ROSWARD) -> Running:
    temporary = tmp_path / "tmp"
    temporary.mkdir()
    process = subprocess.Popen(
        [sys.executable, *program, "serve", "--port", "0", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "TMPDIR": str(temporary)},
        cwd=tmp_path,
    )
    assert process.stdout is not None
    for line in process.stdout:
        found = _ADDRESS.search(line)
        if found:
            return Running(process, found[0], temporary)
    raise AssertionError(f"it ended with {process.wait()}")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    (tmp_path / "ws").mkdir()
    (tmp_path / "ws/talker.py").write_text(TALKER, encoding="utf-8")
    return tmp_path / "ws"


@pytest.fixture
def server(tmp_path: Path, workspace: Path) -> Iterator[Running]:
    with running(tmp_path, workspace) as started:
        yield started


@pytest.fixture
def patient(tmp_path: Path, workspace: Path) -> Iterator[Running]:
    with running(tmp_path, workspace, PATIENT) as started:
        yield started


@contextlib.contextmanager
def running(tmp_path: Path, workspace: Path, program: Sequence[str] = ROSWARD) -> Iterator[Running]:
    started = start(tmp_path, str(workspace), program=program)
    yield started
    started.process.kill()
    started.process.wait()
    if started.process.stdout is not None:
        started.process.stdout.close()


def test_it_opens_the_workspace_and_ends_without_a_trace(server: Running) -> None:
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/results/[0-9a-f]{16}\?token=\S{43}", server.address)
    end = time.monotonic() + 300
    while json.loads(server.get("/api/results")[1])[0]["state"] != "done" and time.monotonic() < end:
        time.sleep(0.05)
    status, page = server.get(urlsplit(server.address).path)
    assert (status, "policies/talker/policy.xml" in page) == (200, True)
    assert [p.name.startswith("rosward-serve-") for p in server.temporary.iterdir()] == [True]
    status, rest = server.end(signal.SIGINT)
    assert (status, rest.splitlines()[-1]) == (0, "rosward: stopped")
    assert "Traceback" not in rest
    assert list(server.temporary.iterdir()) == []


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_other_ends_leave_no_trace_either(server: Running, number: signal.Signals) -> None:
    """While the analysis may still run."""
    assert server.end(number)[0] == 0
    assert list(server.temporary.iterdir()) == []


def test_an_open_stream_of_news_does_not_keep_it(patient: Running) -> None:
    parts = urlsplit(patient.address)
    connection = HTTPConnection(parts.hostname or "", parts.port, timeout=300)
    connection.request("GET", f"/api/news?{parts.query}")
    answer = connection.getresponse()
    assert answer.headers["content-type"].startswith("text/event-stream")
    assert answer.readline().startswith(b"data: [{")
    status, rest = patient.end(signal.SIGINT)
    assert (status, "exceeded" in rest) == (0, False)


def test_results_are_kept_where_the_user_says(tmp_path: Path, workspace: Path) -> None:
    running = start(tmp_path, str(workspace), "--results", "kept")
    end = time.monotonic() + 300
    while not list(tmp_path.glob("kept/results/*/out/summary.json")) and time.monotonic() < end:
        time.sleep(0.05)
    assert running.end(signal.SIGINT)[0] == 0
    assert list(tmp_path.glob("kept/results/*/out/report.html"))


def test_a_port_that_is_taken(tmp_path: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        done = subprocess.run(
            [sys.executable, "-m", "rosward", "serve", "--port", port],
            capture_output=True, text=True, check=False, timeout=300, cwd=tmp_path,
        )  # fmt: skip
    assert (done.returncode, done.stdout) == (2, "")
    assert f"rosward: cannot listen on 127.0.0.1, port {port}" in done.stderr


def test_it_listens_on_this_machine_alone(server: Running) -> None:
    port = urlsplit(server.address).port or 0
    with socket.socket() as other, pytest.raises(OSError, match="refused"):
        other.connect(("127.0.0.2", port))


def test_for_other_machines_it_warns(tmp_path: Path) -> None:
    running = start(tmp_path, "--host", "0.0.0.0")
    assert running.address.startswith("http://127.0.0.1:")
    assert "WARNING: listening on 0.0.0.0" in running.end(signal.SIGINT)[1]
