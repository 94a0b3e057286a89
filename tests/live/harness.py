# SPDX-License-Identifier: Apache-2.0
"""Which graph does a program really have? `RealRclpy` runs it and gives back what it saw.

    with RealRclpy() as real:
        real.send(Program(folder, "main.py"))
        real.receive().facts    -> {("/talker", "pub", "/chatter", "std_msgs/msg/String"), …}

Between `send` and `receive` there is time to analyse the same program.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

from rosward.source.surroundings import surroundings

Fact = tuple[str, str, str, str]


class Program(NamedTuple):
    """What is to be run: `main.py`, `package.module:function` or `class:module`, in a folder.

    `patience` is how many seconds it may run before it is interrupted; after half as many again it is ended.
    """

    folder: Path
    start: str
    interrupt: bool = False
    path: tuple[str, ...] = (".",)
    arguments: tuple[str, ...] = ()
    environment: tuple[tuple[str, str], ...] = ()
    patience: float = 20.0


class Seen(NamedTuple):
    """What a program did. `end` is 'normal' where its main body came to its end, else the exception that ended it."""

    nodes: frozenset[str]
    facts: frozenset[Fact]
    end: str
    errors: tuple[str, ...]
    output: str

    @property
    def whole(self) -> bool:
        """Whether the main body ran to its end."""
        return self.end == "normal"


class RealRclpy:
    """A process that runs programs one after another."""

    def __init__(self) -> None:
        tests = Path(__file__).parents[1]
        self._process = subprocess.Popen(
            [sys.executable, "-m", "live.server"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, **surroundings("kilted"), "PYTHONPATH": str(tests), "PYTHONDONTWRITEBYTECODE": "1"},
        )

    def __enter__(self) -> RealRclpy:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        self.close()

    def send(self, program: Program) -> None:
        """Start a program."""
        job = {**program._asdict(), "folder": str(program.folder), "environment": dict(program.environment)}
        assert self._process.stdin is not None
        self._process.stdin.write(json.dumps(job) + "\n")
        self._process.stdin.flush()

    def receive(self) -> Seen:
        """What the program did that was sent first and not yet received."""
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError(f"the server has ended ({self._process.wait()})")
        answer: dict[str, Any] = json.loads(line)
        facts = frozenset((node, kind, name, type_) for node, kind, name, type_ in answer["facts"])
        return Seen(frozenset(answer["nodes"]), facts, answer["end"], tuple(answer["errors"]), answer["output"])

    def close(self) -> None:
        """End the process."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.close()
        self._process.wait(timeout=300)
        self._process.stdout.close()
