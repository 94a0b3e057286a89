# SPDX-License-Identifier: Apache-2.0
"""The queue, and the process that analyses: what runs, what waits, and how it ends when it takes too much or somebody cancels."""

from __future__ import annotations

import asyncio
import os
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from rosward.server.job import Job, JobEnd, JobStep, read_job, read_line
from rosward.server.jobs import Jobs
from rosward.server.limits import Limits
from rosward.server.places import UploadRefusedError
from rosward.server.results import AnalysedSource, Results
from rosward.server.settings import Settings
from rosward.server.workers import run_job

from .page import DEFAULT, TALKER

SOURCE = AnalysedSource("workspace", "/nowhere", "nowhere")


class Slow:
    """Analyses that end when they are let go."""

    def __init__(self) -> None:
        self.running = 0
        self.most = 0
        self.go = asyncio.Event()

    async def run(self, job: Job, tell: Callable[[JobStep], None]) -> JobEnd:
        self.running += 1
        self.most = max(self.most, self.running)
        tell(JobStep("reading", 1, 2))
        try:
            await self.go.wait()
        finally:
            self.running -= 1
        (Path(job.output) / "summary.json").write_text("{}", encoding="utf-8")
        return JobEnd("done")


async def until(state: Callable[[], bool]) -> None:
    for _ in range(30_000):
        if state():
            return
        await asyncio.sleep(0.01)
    raise AssertionError("it never came")


def test_two_run_and_the_others_wait(tmp_path: Path) -> None:
    async def story() -> None:
        slow, limits = Slow(), Limits(waiting=2)
        results = Results(tmp_path, limits, lambda: None)
        jobs = Jobs(results, limits, slow.run)
        for _ in range(4):
            jobs.submit(SOURCE, Settings())
        await until(lambda: slow.running == 2)
        assert sorted(r.state for r in results.all()) == ["running", "running", "waiting", "waiting"]
        assert {r.step for r in results.all()} == {JobStep("reading", 1, 2), None}
        with pytest.raises(UploadRefusedError, match="waiting"):
            jobs.submit(SOURCE, Settings())
        slow.go.set()
        await until(lambda: all(r.state == "done" for r in results.all()))
        assert slow.most == 2

    asyncio.run(story())


def test_what_waits_and_what_runs_can_be_cancelled(tmp_path: Path) -> None:
    async def story() -> None:
        slow, limits = Slow(), Limits(workers=1)
        results = Results(tmp_path, limits, lambda: None)
        jobs = Jobs(results, limits, slow.run)
        first, second, third = (jobs.submit(SOURCE, Settings()).id for _ in range(3))
        await until(lambda: slow.running == 1)
        await jobs.cancel(second)
        await jobs.cancel(first)
        await until(lambda: slow.running == 1)
        states = {r.id: r.state for r in results.all()}
        assert (states[first], states[second]) == ("cancelled", "cancelled")
        await jobs.close()
        assert (slow.running, {r.state for r in results.all()}) == (0, {"cancelled"})
        del third

    asyncio.run(story())


# The process


def run(job: Job, tell: Callable[[JobStep], None] = lambda _: None) -> JobEnd:
    Path(job.output).mkdir(parents=True, exist_ok=True)
    return asyncio.run(run_job(job, tell))


def job_of(tmp_path: Path, text: str = TALKER, limits: Limits = DEFAULT) -> Job:
    (tmp_path / "ws").mkdir()
    (tmp_path / "ws/talker.py").write_text(text, encoding="utf-8")
    return Job(str(tmp_path / "ws"), str(tmp_path / "result/out"), limits=limits)


def test_it_tells_how_far_it_is_and_leaves_its_outputs(tmp_path: Path) -> None:
    steps: list[JobStep] = []
    assert run(job_of(tmp_path), steps.append) == JobEnd("done")
    assert list(dict.fromkeys(s.what for s in steps)) == ["reading", "analysing", "writing"]
    names = {p.name for p in (tmp_path / "result/out").iterdir()}
    assert names >= {
        "report.html",
        "policy.xml",
        "policies",
        "permissions",
        "network.json",
        "findings.txt",
        "outputs.zip",
    }


def test_too_little_memory_is_told(tmp_path: Path) -> None:
    end = run(job_of(tmp_path, limits=Limits(memory=200 * 2**20)))
    assert end.end == "failed"
    assert "memory" in end.message or "analysis" in end.message


def test_too_little_time_ends_it(tmp_path: Path) -> None:
    assert run(job_of(tmp_path, limits=Limits(seconds=0.05))) == JobEnd(
        "failed", "The analysis took more than 0.05 seconds."
    )


@pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc")
def test_cancelling_kills_the_process(tmp_path: Path) -> None:
    job = job_of(tmp_path)
    Path(job.output).mkdir(parents=True)

    async def story() -> None:
        begun = asyncio.Event()
        task = asyncio.create_task(run_job(job, lambda _: begun.set()))
        await asyncio.wait_for(begun.wait(), 300)
        assert _children()
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        assert not _children()

    asyncio.run(story())


def _children() -> list[str]:
    """The processes of this thread that still run."""
    return Path(f"/proc/{os.getpid()}/task/{threading.get_native_id()}/children").read_text(encoding="ascii").split()


def test_a_module_of_the_current_folder_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The server may be started in the workspace, whose files are called as they like."""
    job = job_of(tmp_path)
    for name in ("jinja2", "yaml", "json", "rosward", "asyncio"):
        (tmp_path / "ws" / f"{name}.py").write_text("raise SystemExit('executed')\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path / "ws")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path / "ws"))
    monkeypatch.syspath_prepend(str(tmp_path / "ws"))
    assert run(job) == JobEnd("done")


def test_a_package_above_an_upload_is_not_looked_at(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>above</name></package>", encoding="utf-8")
    results = Results(tmp_path / "results", Limits(), lambda: None)
    _, folder = results.new_upload()
    (folder / "tree").mkdir()
    (folder / "tree/talker.py").write_text(TALKER, encoding="utf-8")
    output = tmp_path / "result/out"
    assert run(Job(str(folder / "tree"), str(output))) == JobEnd("done")
    assert "above" not in (output / "network.json").read_text(encoding="utf-8")


def test_a_job_and_its_lines_come_back_as_they_were() -> None:
    settings = Settings("humble", "wildcard", "node", True, ("a.launch.py",), False, (("x", "1"),), flows=True)
    job = Job("/a", "/b", settings, "/c.zip", "/d.json", "/e.json", Limits(seconds=1.5))
    assert read_job(job.line()) == job
    assert read_line(b'{"what": "reading", "done": 1, "all": 2}') == JobStep("reading", 1, 2)
    assert read_line(b'{"end": "failed", "message": "x"}') == JobEnd("failed", "x")
    assert [
        read_line(line) for line in (b"", b"x", b"[]", b"{}", b'{"what": 1}', b'{"what": "a", "done": "b", "all": 1}')
    ] == [None] * 6
