# SPDX-License-Identifier: Apache-2.0
"""What is asked of the analysis of one repository, as a line of text?

It goes to a worker on any machine, and from there to the process that analyses: nothing but text is sent.
"""

from __future__ import annotations

import json

from rosward.records import NamedTuple
from rosward.ros.distro import DEFAULT_DISTRO

__all__ = ["Bounds", "Job", "SurveyOptions", "job_of"]


class SurveyOptions(NamedTuple):
    """How each repository is analysed, in the words of `rosward.extract`; `budget` multiplies the steps."""

    distro: str = DEFAULT_DISTRO
    all_launch: bool = False
    tests: bool = False
    exclude: tuple[str, ...] = ()
    assumed: bool = True
    budget: float = 1.0

    def text(self) -> str:
        """As JSON, the same for the same options."""
        return json.dumps(self._asdict(), sort_keys=True)


class Bounds(NamedTuple):
    """What a repository may take: seconds of processor time, bytes of address space (512 MB of which are a reserved stack)."""

    seconds: int = 600
    memory: int = 4 * 2**30

    @property
    def wall(self) -> float:
        """Seconds after which it is ended even if it computes nothing: it waits for a disk that is gone, or the machine is very busy."""
        return 20.0 * self.seconds + 600.0


class Job(NamedTuple):
    """One repository. `known`: the key of the part that is there already; `identity`: the rosward that has to do it."""

    path: str
    options: SurveyOptions
    bounds: Bounds
    identity: str
    known: str = ""

    def line(self) -> str:
        """As `job_of` reads it."""
        return json.dumps(self)


def job_of(line: str) -> Job:
    """The job of a line."""
    path, options, bounds, identity, known = json.loads(line)
    distro, all_launch, tests, exclude, assumed, budget = options
    return Job(
        path,
        SurveyOptions(distro, all_launch, tests, tuple(exclude), assumed, budget),
        Bounds(*bounds),
        identity,
        known,
    )
