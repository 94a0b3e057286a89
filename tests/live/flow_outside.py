# SPDX-License-Identifier: Apache-2.0
"""The world outside of ROS, as a program meets it when its flows are observed: nothing of it is real, all of it is noted.

open("/tmp/log", "a").write(text)      noted as what goes into a file
socket.socket().recv(100)              the content of `network`
threading.Thread(target=f).start()     f runs when the schedule says so
"""

from __future__ import annotations

import builtins
import pathlib
import queue
import socket
import subprocess
import sys
import threading
import time
import types
from collections.abc import Callable
from typing import Any, Protocol


class IdleError(BaseException):
    """A thread has nothing left to do."""


class Here(Protocol):
    """The run in which a program meets the world."""

    def sent(self, sink: str, what: object, *, by_line: bool = False) -> None:
        """Something leaves."""

    def comes(self, source: str, like: Any) -> Any:
        """Something comes."""

    def thread(self, target: Callable[[], object]) -> None:
        """A thread starts."""


def surrounded(here: Here) -> dict[str, Any]:
    """The builtins of a program: what is imported and opened is not the real thing."""
    modules = {
        "socket": _module(socket, socket=_socket(here)),
        "subprocess": _module(subprocess, **_processes(here)),
        "time": _module(time, sleep=lambda _: None, **dict.fromkeys(("time", "monotonic"), _clock(here))),
        "threading": _module(threading, Thread=_thread(here)),
        "queue": _module(queue, Queue=_Queue),
        "pathlib": _module(pathlib, Path=_path(here)),
    }

    def load(name: str, *arguments: Any, **options: Any) -> Any:
        return modules.get(name) or builtins.__import__(name, *arguments, **options)

    def say(*values: object, **_: object) -> None:
        here.sent("stdout", values, by_line=True)

    def open_(_name: str, mode: str = "r", **_: object) -> _File:
        return _File(here, mode)

    return {**vars(builtins), "__import__": load, "print": say, "open": open_}


def _module(real: types.ModuleType, **changed: Any) -> types.ModuleType:
    found = types.ModuleType(real.__name__)
    vars(found).update({**vars(real), **changed})
    return found


class _File:
    """A file that is not there."""

    def __init__(self, here: Here, mode: str) -> None:
        self._here, self._mode = here, mode

    def __enter__(self) -> _File:
        return self

    def __exit__(self, *_: object) -> None:
        return None

    def write(self, text: str) -> int:
        """Note it."""
        self._here.sent("file", text, by_line=True)
        return len(text)

    def read(self, *_: object) -> str:
        """What stands in it."""
        return str(self._here.comes("file", ""))

    readline = read

    def close(self) -> None:
        """Nothing."""


def _path(here: Here) -> Any:
    class Path(type(pathlib.Path())):  # type: ignore[misc]  # the class depends on the system
        def write_text(self, text: str, *_: object, **__: object) -> int:
            here.sent("file", text, by_line=True)
            return len(text)

        def read_text(self, *_: object, **__: object) -> str:
            return str(here.comes("file", ""))

    return Path


def _socket(here: Here) -> Any:
    class Socket:
        def __init__(self, *_: object, **__: object) -> None:
            """Nothing is opened."""

        def sendto(self, data: bytes, *_: object) -> None:
            here.sent("network", data, by_line=True)

        send = sendall = sendto

        def recv(self, _size: int) -> bytes:
            return str(here.comes("network", "")).encode()

        def __getattr__(self, _name: str) -> Callable[..., None]:
            return lambda *_, **__: None

    return Socket


def _processes(here: Here) -> dict[str, Any]:
    def run(command: object, *_: object, **__: object) -> Any:
        here.sent("process", command, by_line=True)
        output = str(here.comes("process", ""))
        return types.SimpleNamespace(stdout=output, stderr="", returncode=0)

    return {"run": run, "check_output": lambda *a, **k: run(*a, **k).stdout}


def _clock(here: Here) -> Callable[[], float]:
    return lambda: float(here.comes("clock", 0.0)) + 100.0


def _thread(here: Here) -> Any:
    class Thread:
        def __init__(self, target: Any = None, args: Any = (), kwargs: Any = None, **_: object) -> None:
            self._run = lambda: target(*args, **(kwargs or {}))

        def start(self) -> None:
            here.thread(self._run)

        def join(self, *_: object) -> None:
            """It has ended."""

        def is_alive(self) -> bool:
            return True

    return Thread


class _Queue(queue.Queue[Any]):
    """Whoever waits for something that is not there has nothing left to do."""

    def get(self, block: bool = True, timeout: float | None = None) -> Any:
        """What is there."""
        if self.empty() and block and timeout is None:
            raise IdleError
        return super().get(block=False)


def line_of(file: str) -> int:
    """The line of a program that is running."""
    frame = sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename != file:
        frame = frame.f_back
    return frame.f_lineno
