# SPDX-License-Identifier: Apache-2.0
"""Connections that ask nothing, or half of something: they go, and whoever asks is answered."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rosward.server.app import application
from rosward.server.limits import Limits
from rosward.server.security import Access, Hosts
from rosward.server.server import Server

from .page import PORT, status_of, those_that_end
from .test_run import start

posix = pytest.mark.skipif(sys.platform == "win32", reason="signals")

HALVES = {
    "nothing": b"",
    "half of a head": b"GET / HTTP/1.1\r\nHost: 127.0.0.1",
    "half of a body": b"POST /api/uploads HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 1000\r\n\r\nabc",
    "no request": b"\x16\x03\x01" * 40,
}


@posix
@pytest.mark.parametrize("sent", HALVES.values(), ids=HALVES.keys())
def test_those_who_ask_nothing_keep_nobody_out(tmp_path: Path, sent: bytes) -> None:
    running = start(tmp_path)
    try:

        async def story() -> None:
            host, _, port = running.address.split("/")[2].rpartition(":")
            for _ in range(400):
                with contextlib.suppress(OSError):
                    _, writer = await asyncio.open_connection(host, int(port))
                    silent.append(writer)
                    writer.write(sent)
            status, _ = await asyncio.to_thread(running.get, "/")
            assert status == 200

        silent: list[asyncio.StreamWriter] = []
        asyncio.run(story())
    finally:
        running.process.kill()
        running.process.communicate()


def test_an_upload_too_many_is_told_at_once(tmp_path: Path) -> None:
    """Those that are under way keep nobody waiting."""

    async def story() -> list[int]:
        access = Access(PORT)
        app = application(Server(tmp_path, Limits(uploads=2, silence=60)), access, Hosts({"127.0.0.1"}, PORT))
        asking = [asyncio.create_task(status_of(app, access, "POST", "/api/uploads")) for _ in range(5)]
        done, open_ = await those_that_end(asking, 3)
        for task in open_:
            task.cancel()
        return sorted(task.result() for task in done)

    assert asyncio.run(story()) == [503] * 3


def test_an_upload_that_never_ends_is_given_up(tmp_path: Path) -> None:
    """A byte now and then is not silence."""

    async def story() -> int:
        access = Access(PORT)
        app = application(Server(tmp_path, Limits(sending=0.5, silence=60)), access, Hosts({"127.0.0.1"}, PORT))
        return await asyncio.wait_for(status_of(app, access, "POST", "/api/uploads", b"x"), 60)

    assert asyncio.run(story()) == 400
    assert list((tmp_path / "sources").iterdir()) == []


def test_a_full_disk_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def story() -> int:
        access = Access(PORT)
        server = Server(tmp_path, Limits())

        def full(*_: object) -> tuple[str, Path]:
            raise OSError(28, "No space left on device")

        monkeypatch.setattr(server.results, "new_upload", full)
        return await status_of(
            application(server, access, Hosts({"127.0.0.1"}, PORT)), access, "POST", "/api/uploads", b"x"
        )

    assert asyncio.run(story()) == 507


COMPUTING = """
import re, sys
from rosward.server import worker
from rosward.server.limits import Limits
def analyse(job, teller):
    print("computing", file=sys.stderr, flush=True)
    re.match("(a*)*b", "a" * 60)  # which has the interpreter for itself, for longer than anybody waits
worker.analyse = analyse
worker.read_job = lambda line: type("Job", (), {"limits": Limits()})
worker.main()
"""


@posix
def test_an_analysis_ends_with_the_server_whatever_it_computes() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", COMPUTING], stdin=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    ) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        process.stdin.write(b"{}\n")
        process.stdin.flush()
        assert process.stderr.readline() == b"computing\n"
        process.stdin.close()
        assert process.wait(timeout=120) == -signal.SIGKILL
        for _ in range(1000):  # the other of the two, which nobody waits for, is gone soon
            try:
                os.killpg(process.pid, 0)
            except ProcessLookupError:
                return
            time.sleep(0.05)
    raise AssertionError("a process is left")
