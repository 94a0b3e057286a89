# SPDX-License-Identifier: Apache-2.0
"""How is work done by several processes at once, so that one which dies costs its own piece alone?

    with Workers(work, 4) as workers:
        workers.all([b"a", b"b"])      ->  [work(b"a"), Lost("killed by SIGKILL")]

Workers are forked: they find everything as it is here, and give nothing back but the bytes of their answers, in the order of the tasks. Nothing
else is shared. A piece at which `work` raises is None: whoever asked does it again, and sees the error.
"""

from __future__ import annotations

import os
import selectors
import signal
import struct
import threading
import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from types import TracebackType
from typing import Final, NamedTuple, NoReturn, final

__all__ = ["Lost", "Workers", "can_fork"]

_LENGTH: Final = struct.Struct("<BQ")
"""Whether there is an answer, and its length."""

_CHUNK: Final = 1 << 20


class Lost(NamedTuple):
    """A piece of work whose worker died; `why` in words."""

    why: str


def can_fork() -> bool:
    """Whether this process may fork: the system can, and nobody else runs here who may hold a lock. One other thread waits for this one."""
    return hasattr(os, "fork") and os.name == "posix" and threading.active_count() <= 2


class _Worker:
    """One process: what it is doing, and what has arrived of its answer."""

    __slots__ = ("answers", "arrived", "number", "pid", "tasks")

    def __init__(self, pid: int, tasks: int, answers: int) -> None:
        self.pid = pid
        self.tasks = tasks
        self.answers = answers
        self.number: int | None = None
        self.arrived = bytearray()


@final
class Workers:
    """So many processes, each forked when there is work for it."""

    def __init__(self, work: Callable[[bytes], bytes], number: int) -> None:
        self._work = work
        self._most = number
        self._workers: list[_Worker] = []

    def __enter__(self) -> Workers:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        for worker in list(self._workers):
            with suppress(OSError):
                os.kill(worker.pid, signal.SIGKILL)  # it holds nothing that could be left half done
            self._end(worker)

    def all(self, tasks: Sequence[bytes], done: Callable[[int], None] | None = None) -> list[bytes | Lost | None]:
        """The answers to tasks, in their order; `done` is told how many there are so far."""
        found: dict[int, bytes | Lost | None] = {}
        waiting = list(range(len(tasks)))[::-1]
        with selectors.DefaultSelector() as selector:
            for worker in self._workers:
                selector.register(worker.answers, selectors.EVENT_READ, worker)
            while len(found) < len(tasks):
                self._hand_out(tasks, waiting, selector)
                for key, _ in selector.select():
                    worker = key.data
                    answer = self._receive(worker)
                    if isinstance(answer, Lost):
                        selector.unregister(worker.answers)
                        answer = self._end(worker)
                        if worker.number is None:
                            continue
                    elif answer is False:
                        continue
                    assert worker.number is not None
                    found[worker.number], worker.number = answer, None  # type: ignore[assignment]
                    if done is not None:
                        done(len(found))
        return [found[number] for number in range(len(tasks))]

    def _hand_out(self, tasks: Sequence[bytes], waiting: list[int], selector: selectors.BaseSelector) -> None:
        while waiting:
            worker = next((w for w in self._workers if w.number is None), None)
            if worker is None:
                if len(self._workers) >= self._most:
                    return
                worker = self._start()
                selector.register(worker.answers, selectors.EVENT_READ, worker)
            worker.number = waiting.pop()
            with suppress(OSError):  # it died meanwhile: that is seen when it is asked for its answer
                _send(worker.tasks, tasks[worker.number])

    def _receive(self, worker: _Worker) -> bytes | Lost | bool | None:
        """The answer of a worker; False while it is not whole."""
        try:
            data = os.read(worker.answers, _CHUNK)
        except OSError:
            data = b""
        if not data:
            return Lost("")
        worker.arrived += data
        if len(worker.arrived) < _LENGTH.size:
            return False
        there, length = _LENGTH.unpack_from(worker.arrived)
        if len(worker.arrived) < _LENGTH.size + length:
            return False
        answer = bytes(worker.arrived[_LENGTH.size :]) if there else None
        worker.arrived = bytearray()
        return answer

    # Processes

    def _start(self) -> _Worker:
        tasks, to_give = os.pipe()
        to_take, answers = os.pipe()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # of threads: `can_fork` has looked
            pid = os.fork()
        if pid == 0:
            for each in (to_give, to_take, *(fd for w in self._workers for fd in (w.tasks, w.answers))):
                os.close(each)
            _serve(self._work, tasks, answers)
        os.close(tasks)
        os.close(answers)
        worker = _Worker(pid, to_give, to_take)
        self._workers.append(worker)
        return worker

    def _end(self, worker: _Worker) -> Lost:
        self._workers.remove(worker)
        os.close(worker.tasks)
        os.close(worker.answers)
        try:
            _, status = os.waitpid(worker.pid, 0)
        except ChildProcessError:
            return Lost("it ended")
        code = os.waitstatus_to_exitcode(status)
        return Lost(f"it was killed by {_name_of(-code)}" if code < 0 else f"it ended with status {code}")


def _name_of(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def _serve(work: Callable[[bytes], bytes], tasks: int, answers: int) -> NoReturn:
    """The life of a worker: it ends when nobody is there any more who gives it tasks. Nothing of its parent is flushed or closed by it."""
    status = 1
    try:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # its parent is interrupted as well, and ends it
        while (task := _received(tasks)) is not None:
            try:
                answer: bytes | None = work(task)
            except Exception:
                answer = None
            _send(answers, answer)
        status = 0
    finally:
        os._exit(status)


def _send(descriptor: int, message: bytes | None) -> None:
    head = _LENGTH.pack(message is not None, len(message or b""))
    view = memoryview(head + (message or b""))
    while view:
        view = view[os.write(descriptor, view) :]


def _received(descriptor: int) -> bytes | None:
    head = _exactly(descriptor, _LENGTH.size)
    return None if head is None else _exactly(descriptor, _LENGTH.unpack(head)[1])


def _exactly(descriptor: int, length: int) -> bytes | None:
    parts: list[bytes] = []
    while length:
        part = os.read(descriptor, min(length, _CHUNK))
        if not part:
            return None
        parts.append(part)
        length -= len(part)
    return b"".join(parts)
