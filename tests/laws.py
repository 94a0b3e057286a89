# SPDX-License-Identifier: Apache-2.0
"""How many examples is a law tried with? `ROSWARD_EXAMPLES=2000` tries each one longer; .ci/run does more than is done by default.

@settings(max_examples=examples(2))     twice as many as other laws: the examples are small
"""

from __future__ import annotations

import os
from typing import Final

EXAMPLES: Final = int(os.environ.get("ROSWARD_EXAMPLES", "20"))
"""Those of a law that says nothing else."""


def examples(times: float) -> int:
    """So many times the usual ones."""
    return max(1, round(EXAMPLES * times))
