# SPDX-License-Identifier: Apache-2.0
"""Where does code that nests deeply run? In a thread with a deep stack of its own (reserved, not used), so that nesting is no special case."""

from __future__ import annotations

import gc
import sys
import threading
from collections.abc import Callable
from contextvars import copy_context
from types import FunctionType
from typing import Final, TypeVar

_T = TypeVar("_T")

_STACK: Final = 512 * 1024 * 1024
_RECURSION: Final = 60_000
_SLOTS: Final = (1 << 22) + 1
"""CPython keeps the frames of a thread in chunks of 16 KB, and gives a chunk back whenever calls return across its beginning, which costs a
quarter of the time of a deep analysis. The frame of a function that says to need so many slots of 8 bytes begins a chunk of the next power of
two; the frames of all that it calls have the other half of it. No slot is touched before it is used."""


def _call(work: Callable[[], _T]) -> _T:
    return work()


_in_one_chunk: Final = FunctionType(_call.__code__.replace(co_stacksize=_SLOTS), {})


def with_deep_stack(work: Callable[[], _T]) -> _T:
    """Run `work` in such a thread, in a copy of this context; what it raises is raised here."""
    context = copy_context()
    outcome: list[_T] = []
    failure: list[BaseException] = []

    def body() -> None:
        collecting = gc.isenabled()
        gc.disable()  # most of what is made here lives to the end
        limit = sys.getrecursionlimit()
        sys.setrecursionlimit(_RECURSION)
        try:
            outcome.append(context.run(_in_one_chunk, work))
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
