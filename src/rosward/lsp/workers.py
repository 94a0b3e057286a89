# SPDX-License-Identifier: Apache-2.0
"""How does the server have a workspace analysed? Two processes for each folder: one for the sources, and a slower one for the launched systems.

Changes that come within a moment are one. A process that dies is started again, a few times; what it knew, it finds out anew.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import Callable, Sequence
from typing import Any, Final, final

from rosward.lsp.records import MalformedError, View, read

__all__ = ["Crew", "Hands"]

_LINE: Final = 1 << 28
_MOST_STARTS: Final = 5


@final
class Hands:
    """One process that analyses one folder; `told` is given what it says."""

    def __init__(self, command: Sequence[str], pause: float, told: Callable[[dict[str, Any]], None]) -> None:
        self._command = tuple(command)
        self._pause = pause
        self._told = told
        self._process: asyncio.subprocess.Process | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._reader: asyncio.Task[None] | None = None
        self._starts = 0
        self._number = 0
        self._shown: dict[str, str] = {}
        self._sent: dict[str, str] = {}
        self._changed: set[str] | None = None
        self.busy = False

    @property
    def number(self) -> int:
        """Of the newest question."""
        return self._number

    def show(self, path: str, text: str | None) -> None:
        """What an open file holds; None where it was closed."""
        if text is None:
            self._shown.pop(path, None)
        else:
            self._shown[path] = text
        self.change([path])

    def change(self, paths: Sequence[str] | None) -> None:
        """Files have changed; None: anything."""
        if paths is None:
            self._changed = None
        elif self._changed is not None:
            self._changed |= set(paths)
        if self._timer is not None:
            self._timer.cancel()
        self.busy = True
        self._timer = asyncio.get_running_loop().call_later(self._pause, self._ask)

    def _ask(self) -> None:
        self._timer = None
        self._asking = asyncio.ensure_future(self._send())

    async def _send(self) -> None:
        if self._process is None or self._process.returncode is not None:
            if self._starts >= _MOST_STARTS or not await self._start():
                self.busy = False
                return
        texts: dict[str, str | None] = {p: t for p, t in self._shown.items() if self._sent.get(p) is not t}
        texts.update(dict.fromkeys(self._sent.keys() - self._shown.keys()))
        self._number += 1
        changed = None if self._changed is None else sorted(self._changed)
        question = {"renew": self._number, "texts": texts, "changed": changed}
        self._sent, self._changed = dict(self._shown), set()
        self._told({"asked": self._number, "texts": self._sent})
        process = self._process
        if process is not None and process.stdin is not None:
            with contextlib.suppress(ConnectionError, RuntimeError):
                process.stdin.write(json.dumps(question).encode("ascii") + b"\n")
                await process.stdin.drain()

    async def _start(self) -> bool:
        self._starts += 1
        self._sent, self._changed = {}, None
        try:
            self._process = await asyncio.create_subprocess_exec(
                *self._command,
                stdin=asyncio.subprocess.PIPE,
                stdout=asyncio.subprocess.PIPE,
                stderr=asyncio.subprocess.PIPE,
                limit=_LINE,
            )
        except OSError as error:
            self._told({"log": f"the analysis cannot be started: {error}"})
            return False
        self._reader = asyncio.ensure_future(self._listen(self._process))
        return True

    async def _listen(self, process: asyncio.subprocess.Process) -> None:
        complaints = asyncio.ensure_future(self._complaints(process))
        while process.stdout is not None:
            try:
                line = await process.stdout.readline()
            except ValueError:  # longer than any answer
                process.kill()
                break
            if not line:
                break
            self._take(line)
        status = await process.wait()
        await complaints
        if process is self._process:
            self._process = None
            self._told({"log": f"the analysis has ended (status {status}) and is started again"})
            self.change(None)

    async def _complaints(self, process: asyncio.subprocess.Process) -> None:
        while process.stderr is not None:
            with contextlib.suppress(ValueError):
                line = await process.stderr.readline()
                if not line:
                    return
                self._told({"log": line.decode("utf-8", "replace").rstrip()})

    def _take(self, line: bytes) -> None:
        try:
            document = json.loads(line)
            if not isinstance(document, dict):
                raise MalformedError("no object")
            if "view" in document:
                document["view"] = read(View, document["view"])
        except (ValueError, TypeError, MalformedError, RecursionError):
            self._told({"log": "the analysis sent something that is no answer"})
            return
        if document.get("done") == self._number:
            self.busy = False
            self._starts = min(self._starts, 1)
        self._told(document)

    async def end(self) -> None:
        """There are no more questions."""
        process, self._process = self._process, None
        if self._timer is not None:
            self._timer.cancel()
        if process is not None and process.returncode is None:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            await process.wait()


@final
class Crew:
    """The processes of one folder."""

    def __init__(
        self, commands: Sequence[tuple[Sequence[str], float]], told: Callable[[int, dict[str, Any]], None]
    ) -> None:
        self._hands = [
            Hands(command, pause, lambda document, index=index: told(index, document))  # type: ignore[misc]
            for index, (command, pause) in enumerate(commands)
        ]

    @property
    def busy(self) -> bool:
        """Whether an answer is awaited."""
        return any(each.busy for each in self._hands)

    def show(self, path: str, text: str | None) -> None:
        """See `Hands`."""
        for each in self._hands:
            each.show(path, text)

    def change(self, paths: Sequence[str] | None) -> None:
        """See `Hands`."""
        for each in self._hands:
            each.change(paths)

    async def end(self) -> None:
        """See `Hands`."""
        for each in self._hands:
            await each.end()
