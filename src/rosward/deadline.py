# SPDX-License-Identifier: Apache-2.0
"""Has this thread used up its CPU time? Asked often, so it has to be cheap: the system takes up to a millisecond to say how much it was.

end = Deadline(600)      in 600 seconds of this thread's CPU time
end.is_over()
"""

from __future__ import annotations

import time
from typing import final


@final
class Deadline:
    """An amount of CPU time of one thread, from here on.

    No more CPU time than real time passes: while not even that much has gone by, the slow clock need not be asked. What it says alone decides.
    """

    __slots__ = ("_end", "_soonest")

    def __init__(self, seconds: float) -> None:
        self._end = time.thread_time() + seconds
        self._soonest = time.monotonic() + seconds

    def is_over(self) -> bool:
        """Whether it is used up."""
        if time.monotonic() < self._soonest:
            return False
        left = self._end - time.thread_time()
        self._soonest = time.monotonic() + left
        return left < 0
