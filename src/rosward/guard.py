# SPDX-License-Identifier: Apache-2.0
"""What if rosward itself fails on one piece of input? That costs this piece, is told as a finding (RW299), and the rest goes on.

    read = guarded(lambda: lower(text), Place("robot.py"), "what this file creates is missing", net=True)
    isinstance(read, Finding)        ->  it failed; else it is what `lower` gave

The net is no excuse: whatever is caught is a defect. `net=False` lets it through, for tests and for whoever looks for such defects.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Final, TypeVar

from rosward.findings import INTERNAL_ERROR, Finding
from rosward.source.location import Place

__all__ = ["guarded", "internal_error", "where"]

_T = TypeVar("_T")
_PACKAGE: Final = Path(__file__).parent


def guarded(work: Callable[[], _T], place: Place, missing: str, *, net: bool) -> _T | Finding:
    """What `work` gives; a finding where it fails in a way that nobody foresaw."""
    if not net:
        return work()
    try:
        return work()
    except Exception as error:
        return internal_error(error, place, missing)


def internal_error(error: Exception, place: Place, missing: str) -> Finding:
    """What is told of a failure: its type and the place in rosward where it arose. Its message may quote anything, so that is left out."""
    message = f"rosward itself failed here ({type(error).__name__} in {where(error)}): {missing}. Please report this."
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
