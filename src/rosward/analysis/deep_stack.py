# SPDX-License-Identifier: Apache-2.0
"""Where does code that nests deeply run? In a thread with a deep stack of its own (reserved, not used), so that nesting is no special case."""

from __future__ import annotations

import gc
import sys
import threading
from collections.abc import Callable
from typing import Final, TypeVar

_T = TypeVar("_T")

_STACK: Final = 512 * 1024 * 1024
_RECURSION: Final = 60_000


def with_deep_stack(work: Callable[[], _T]) -> _T:
    """Run `work` in such a thread; what it raises is raised here."""
    outcome: list[_T] = []
    failure: list[BaseException] = []

    def body() -> None:
        collecting = gc.isenabled()
        gc.disable()  # most of what is made here lives to the end
        limit = sys.getrecursionlimit()
        sys.setrecursionlimit(_RECURSION)
        try:
            outcome.append(work())
        except BaseException as error:
            failure.append(error)
        finally:
            sys.setrecursionlimit(limit)
            if collecting:
                gc.enable()

    before = threading.stack_size(_STACK)
    try:
        thread = threading.Thread(target=body, name="rosward")
        thread.start()
    finally:
        threading.stack_size(before)
    thread.join()
    if failure:
        raise failure[0]
    return outcome[0]
