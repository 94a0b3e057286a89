# SPDX-License-Identifier: Apache-2.0
"""What do the server and the process that analyses say to each other? One line of JSON each.

    server -> process    {"root": "/…/tree", "archive": "/…/upload.zip", "output": "/…/out", "settings": {…}, …}     its first line
    process -> server    {"what": "reading", "done": 3, "all": 20}     any number
                         {"end": "done"}   or   {"end": "failed", "message": "there is no Python file in it"}

The process ends when its input does: that is how it notices that the server is gone.
"""

from __future__ import annotations

import json
from typing import Final

from rosward.records import NamedTuple
from rosward.server.limits import Limits
from rosward.server.settings import Settings, read_settings

__all__ = ["Job", "JobEnd", "JobStep", "line_of_end", "line_of_step", "read_job", "read_line"]

LONGEST_LINE: Final = 60_000


class Job(NamedTuple):
    """One analysis: of the folder `root`, which is unpacked from `archive` first where there is one.

    `notes` is the file that says what was left out of an upload. `earlier` is the network to compare with.
    """

    root: str
    output: str
    settings: Settings = Settings()
    archive: str | None = None
    notes: str | None = None
    earlier: str | None = None
    limits: Limits = Limits()

    def line(self) -> str:
        """As `read_job` reads it."""
        return json.dumps({**self._asdict(), "settings": self.settings.document(), "limits": list(self.limits)})


class JobStep(NamedTuple):
    """Progress: what is being done, how much of it is done, of how much."""

    what: str
    done: int
    all: int


class JobEnd(NamedTuple):
    """How it ended: `done`, or `failed` with a message for the user."""

    end: str
    message: str = ""


def read_job(line: str) -> Job:
    """The job of a line that a server wrote."""
    document = json.loads(line)
    settings = read_settings(document.pop("settings"))
    return Job(**document | {"settings": settings, "limits": Limits(*document["limits"])})


def line_of_step(step: JobStep) -> str:
    """A line of progress."""
    return json.dumps(step._asdict())


def line_of_end(end: JobEnd) -> str:
    """The last line."""
    return json.dumps(end._asdict())


def read_line(line: bytes) -> JobStep | JobEnd | None:
    """What a line of the process says; None where it says nothing."""
    try:
        document = json.loads(line)
        if "end" in document:
            return JobEnd(str(document["end"]), str(document.get("message", ""))[:2_000])
        return JobStep(str(document["what"])[:80], int(document["done"]), int(document["all"]))
    except (ValueError, KeyError, TypeError):
        return None
