# SPDX-License-Identifier: Apache-2.0
"""Which analyses run, which wait, and how is one cancelled?

    jobs.submit(source, settings)    ->    a Result that waits, runs, and is done, failed or cancelled

A few run at a time, each in a process of its own (`workers.py`); further ones wait, a bounded number.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Awaitable, Callable
from typing import final

from rosward.server.job import Job, JobEnd, JobStep
from rosward.server.limits import Limits
from rosward.server.places import UploadRefusedError
from rosward.server.results import ENDED, AnalysedSource, Results, StoredResult
from rosward.server.settings import Settings
from rosward.server.workers import run_job

__all__ = ["Jobs"]

Runner = Callable[[Job, Callable[[JobStep], None]], Awaitable[JobEnd]]


@final
class Jobs:
    """The queue."""

    def __init__(self, results: Results, limits: Limits, run: Runner = run_job) -> None:
        self._results = results
        self._limits = limits
        self._run = run
        self._turn = asyncio.Semaphore(limits.workers)
        self._tasks: dict[str, asyncio.Task[None]] = {}

    def submit(self, source: AnalysedSource, settings: Settings, *, automatic: bool = False) -> StoredResult:
        """Analyse something soon. Raises UploadRefusedError where too much waits already."""
        if len(self._tasks) >= self._limits.workers + self._limits.waiting:
            raise UploadRefusedError("too many analyses are waiting: try again later")
        earlier = self._earlier(source)
        result = self._results.add(source, settings, automatic=automatic)
        task = asyncio.create_task(self._work(result, earlier))
        self._tasks[result.id] = task
        task.add_done_callback(lambda _: self._tasks.pop(result.id, None))
        return result

    async def cancel(self, identifier: str) -> None:
        """End an analysis; its process is gone when this returns."""
        task = self._tasks.get(identifier)
        if task is not None:
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task
            self._results.end(identifier, "cancelled", "Cancelled.")  # a task that never ran could not say so

    async def close(self) -> None:
        """End all."""
        await asyncio.gather(*(self.cancel(identifier) for identifier in list(self._tasks)))

    def _earlier(self, source: AnalysedSource) -> str | None:
        """The network of the last result of the same sources."""
        done = (r for r in self._results.all() if r.source == source and r.state == "done")
        last = next(done, None)
        return None if last is None else str(self._results.output(last) / "network.json")

    async def _work(self, result: StoredResult, earlier: str | None) -> None:
        async with self._turn:
            self._results.step(result.id, JobStep("starting", 0, 0))
            try:
                end = await self._run(self._job(result, earlier), lambda step: self._results.step(result.id, step))
            except OSError as error:  # no process, no memory, no folder
                end = JobEnd("failed", f"The analysis cannot be started: {error.strerror or error}.")
            self._results.end(result.id, end.end, end.message)
        if result.automatic:
            self._forget_before(result)

    def _job(self, result: StoredResult, earlier: str | None) -> Job:
        source = result.source
        upload = self._results.upload(source)
        uploaded = source.kind != "workspace"
        return Job(
            root=str(self._results.root(source)),
            output=str(self._results.output(result)),
            settings=result.settings,
            archive=str(upload / "upload.zip") if source.zipped else None,
            notes=str(upload / "left_out.json") if uploaded else None,
            earlier=earlier,
            limits=self._limits,
        )

    def _forget_before(self, result: StoredResult) -> None:
        """What a change of the workspace asked for is of no use once the next one is there."""
        for other in self._results.all():
            if (
                other.automatic
                and other.state in ENDED
                and other.group == result.group
                and other.created < result.created
            ):
                self._results.delete(other.id)
