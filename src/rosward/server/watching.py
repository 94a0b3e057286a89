# SPDX-License-Identifier: Apache-2.0
"""When is a workspace analysed again? When files in it have changed, and have then been left alone for a moment.

    an editor saves talker.py three times within a second    ->    one new result, of the same settings as the last one

What a build writes, hidden files and our own results do not count.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Final, final

from watchfiles import awatch

from rosward.server.jobs import Jobs
from rosward.server.limits import Limits
from rosward.server.places import UploadRefusedError, why_left_out
from rosward.server.results import ENDED, AnalysedSource, Results

__all__ = ["Watches", "changes", "counts"]

_DEBOUNCE: Final = 1_600
"""Milliseconds within which changes are one, at most."""

_QUIET: Final = 150
"""Milliseconds without a change, after which they are told."""

_BUILT: Final = frozenset({"build", "install", "log"})


async def changes(path: Path, own: Path) -> AsyncIterator[None]:
    """Something is yielded whenever sources below a path have changed; `own`: where our results are. Raises OSError, RuntimeError."""
    async for _ in awatch(
        path if path.is_dir() else path.parent,
        watch_filter=lambda _, changed: counts(Path(changed), path, own),
        debounce=_DEBOUNCE,
        step=_QUIET,
        recursive=path.is_dir(),
        ignore_permission_denied=True,
    ):
        yield None


def counts(changed: Path, path: Path, own: Path) -> bool:
    """Whether a change can be one of the sources below a path."""
    if changed == path:
        return True
    if not changed.is_relative_to(path) or changed.resolve().is_relative_to(own):
        return False
    name = changed.relative_to(path).as_posix()
    hidden = why_left_out(f"{name}/")  # also of a folder that has come
    return name.partition("/")[0] not in _BUILT and not hidden and not why_left_out(name) and not name.endswith("~")


@final
class Watches:
    """The workspaces that are watched."""

    def __init__(self, results: Results, jobs: Jobs, limits: Limits, own: Path) -> None:
        self._results = results
        self._jobs = jobs
        self._limits = limits
        self._own = own.resolve()
        self._tasks: dict[str, asyncio.Task[None]] = {}

    def watches(self, source: AnalysedSource) -> bool:
        """Whether a workspace is watched."""
        return source.kind == "workspace" and source.key in self._tasks

    def start(self, source: AnalysedSource) -> None:
        """Watch a workspace. Raises UploadRefusedError where there are too many."""
        if source.kind != "workspace" or source.key in self._tasks:
            return
        if len(self._tasks) >= self._limits.watched:
            raise UploadRefusedError(f"{self._limits.watched} workspaces are already being watched")
        self._tasks[source.key] = asyncio.create_task(self._watch(source))

    async def stop(self, source: AnalysedSource) -> None:
        """Watch it no more."""
        task = self._tasks.pop(source.key, None)
        if task is not None:
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task

    async def close(self) -> None:
        """Watch nothing any more."""
        for key in list(self._tasks):
            await self.stop(AnalysedSource("workspace", key, ""))

    async def _watch(self, source: AnalysedSource) -> None:
        try:
            async for _ in changes(Path(source.key), self._own):
                await self._again(source)
        except (OSError, RuntimeError):  # the folder is gone, or the system watches no more files
            self._tasks.pop(source.key, None)
            self._results.touch()

    async def _again(self, source: AnalysedSource) -> None:
        """Analyse it with the settings of the last result, instead of what is still under way for an earlier change."""
        known = [r for r in self._results.all() if r.source.key == source.key and r.source.kind == "workspace"]
        for result in known:
            if result.automatic and result.state not in ENDED:
                await self._jobs.cancel(result.id)
                self._results.delete(result.id)
        settings = next((r.settings for r in known), None)
        if settings is not None:
            with contextlib.suppress(UploadRefusedError):  # too many wait: the next change comes
                self._jobs.submit(source, settings, automatic=True)
