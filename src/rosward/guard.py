# SPDX-License-Identifier: Apache-2.0
"""What if rosward itself fails on one piece of input? That costs this piece, is told as a finding (RW299), and the rest goes on.

    read = guarded(lambda: lower(text), Place("robot.py"), "what this file creates is missing", net=True)
    isinstance(read, Finding)        ->  it failed; else it is what `lower` gave

    steps = Steps()
    drawn = steps(lambda: draw(graph), "", "the graph is not drawn")    ->  "" where it failed; then it is told in `steps.findings`

The net is no excuse: whatever is caught is a defect. `net=False` lets it through, for tests and for whoever looks for such defects.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Final, TypeVar, final

from rosward.findings import Finding
from rosward.location import Place
from rosward.rules import INTERNAL_ERROR

__all__ = ["Steps", "guarded", "internal_error", "where"]

_T = TypeVar("_T")
_PACKAGE: Final = Path(__file__).parent
_EVERYTHING: Final = Place("", 0)


def guarded(work: Callable[[], _T], place: Place, missing: str, *, net: bool) -> _T | Finding:
    """What `work` gives; a finding where it fails in a way that nobody foresaw."""
    if not net:
        return work()
    try:
        return work()
    except BrokenPipeError:  # the reader of our output has gone: nothing failed, and `cli/` ends the run
        raise
    except Exception as error:
        return internal_error(error, place, missing)


@final
class Steps:
    """Steps on the way of everything: where one fails, the way goes on with something plainer."""

    def __init__(self, *, net: bool = True) -> None:
        self.findings: list[Finding] = []
        self._net = net

    def __call__(self, work: Callable[[], _T], instead: _T, missing: str, place: Place = _EVERYTHING) -> _T:
        """What `work` gives, or what is given instead of it."""
        found = guarded(work, place, missing, net=self._net)
        if not isinstance(found, Finding):
            return found
        self.findings.append(found)
        return instead


def internal_error(error: Exception, place: Place, missing: str) -> Finding:
    """What is told of a failure: its type and the place in rosward where it arose. Its message may quote anything, so that is left out."""
    message = f"rosward failed here ({type(error).__name__} in {where(error)}): {missing}. Please report this."
    return Finding(INTERNAL_ERROR, message, place)


def where(error: BaseException) -> str:
    """The innermost place in rosward from which an error came, relative to the package: no path of the machine."""
    found = "rosward"
    step: TracebackType | None = error.__traceback__
    while step is not None:
        file = Path(step.tb_frame.f_code.co_filename)
        if file.is_relative_to(_PACKAGE):
            found = f"rosward/{file.relative_to(_PACKAGE).as_posix()}:{step.tb_lineno}"
        step = step.tb_next
    return found
