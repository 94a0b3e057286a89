# SPDX-License-Identifier: Apache-2.0
"""What belongs to one running server: its results, its queue, what it watches, and who may ask it."""

from __future__ import annotations

import asyncio
import contextlib
import os
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import final

from rosward.server.examples import Example, examples, write_example
from rosward.server.jobs import Jobs, Runner
from rosward.server.limits import Limits
from rosward.server.news import News
from rosward.server.pages import Pages
from rosward.server.places import UploadRefusedError
from rosward.server.results import AnalysedSource, Results, StoredResult
from rosward.server.settings import Settings
from rosward.server.watching import Watches
from rosward.server.workers import run_job

__all__ = ["Server", "workspace_at"]


@final
class Server:
    """All parts, and what takes several of them. `names_paths`: pages may name workspaces of this machine."""

    def __init__(self, folder: Path, limits: Limits, *, names_paths: bool = True, run: Runner = run_job) -> None:
        self.limits = limits
        self.names_paths = names_paths
        self.news = News()
        self.results = Results(folder, limits, self.news.tell)
        self.jobs = Jobs(self.results, limits, run)
        self.watches = Watches(self.results, self.jobs, limits, folder)
        self.pages = Pages(limits)
        self.examples: dict[str, Example] = {example.name: example for example in examples()}
        self.uploading = asyncio.Semaphore(limits.uploads)
        self.streaming = asyncio.Semaphore(limits.streams)

    @contextlib.asynccontextmanager
    async def lifespan(self, begin: Callable[[], None] | None = None) -> AsyncIterator[None]:
        """While the server runs; behind it, no process and no watch is left."""
        try:
            if begin is not None:
                begin()
            yield
        finally:
            await self.close()

    async def close(self) -> None:
        """End all that runs."""
        self.news.close()
        await self.watches.close()
        await self.jobs.close()

    def open_workspace(self, path: str, settings: Settings, *, watch: bool) -> StoredResult:
        """Analyse a workspace of this machine. Raises UploadRefusedError."""
        source = workspace_at(path)
        if watch:
            self.watches.start(source)
        return self.jobs.submit(source, settings)

    def open_example(self, example: Example) -> StoredResult:
        """Analyse an example. Raises UploadRefusedError."""
        known = (r.source for r in self.results.all())
        title = example.title
        source = next((s for s in known if s.kind == "example" and s.title == title), None)
        if source is not None:
            return self.jobs.submit(source, example.settings)
        key, folder = self.results.new_upload()
        write_example(example, folder)
        return self._submit(AnalysedSource("example", key, title), example.settings)

    def _submit(self, source: AnalysedSource, settings: Settings) -> StoredResult:
        """Analyse what was uploaded; where that is refused, it is removed."""
        try:
            return self.jobs.submit(source, settings)
        except UploadRefusedError:
            self.results.drop_upload(source.key)
            raise

    def open_upload(self, key: str, title: str, settings: Settings, *, zipped: bool) -> StoredResult:
        """Analyse an upload. Raises UploadRefusedError."""
        return self._submit(AnalysedSource("upload", key, title, zipped), settings)

    def again(self, result: StoredResult, settings: Settings) -> StoredResult:
        """Analyse the same sources with other settings. Raises UploadRefusedError."""
        if result.source.kind == "workspace":
            workspace_at(result.source.key)
        return self.jobs.submit(result.source, settings)

    async def remove(self, result: StoredResult) -> None:
        """Remove a result, and cancel it where it runs."""
        await self.jobs.cancel(result.id)
        self.results.delete(result.id)

    def example_of(self, result: StoredResult) -> Example | None:
        """The example that a result is of."""
        same = (e for e in self.examples.values() if result.source.kind == "example" and e.title == result.source.title)
        return next(same, None)


def workspace_at(path: str) -> AnalysedSource:
    """A workspace by a path that the user wrote. Raises UploadRefusedError."""
    if not path.strip() or "\0" in path or len(path) > 4_000:
        raise UploadRefusedError("enter a folder or a file")
    absolute = Path(os.path.abspath(os.path.expanduser(path.strip())))  # noqa: PTH100, PTH111
    try:
        there = absolute.is_dir() or absolute.is_file()
    except OSError:
        there = False
    if not there:
        raise UploadRefusedError(f"there is no folder or file {absolute}")
    return AnalysedSource("workspace", str(absolute), absolute.name or str(absolute))
