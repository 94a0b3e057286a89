# SPDX-License-Identifier: Apache-2.0
"""How much may it take? Numbers on the command line, and their bounds."""

from __future__ import annotations

import argparse
import os
from contextlib import suppress
from typing import Final

__all__ = ["MOST_BUDGET", "MOST_JOBS", "cores", "factor", "jobs"]

MOST_BUDGET: Final = 1_000
MOST_JOBS: Final = 256


def factor(text: str) -> float:
    """How many times the usual steps."""
    try:
        found = float(text)
    except ValueError:
        found = 0.0
    if not 0 < found <= MOST_BUDGET:
        raise argparse.ArgumentTypeError(f"{text!r} must be a number above 0 and at most {MOST_BUDGET}")
    return found


def jobs(text: str) -> int:
    """How many processes."""
    if not text.isascii() or not text.isdigit() or not 0 < int(text) <= MOST_JOBS:
        raise argparse.ArgumentTypeError(f"{text!r} must be a number from 1 to {MOST_JOBS}")
    return int(text)


def cores() -> int:
    """How many processes can run at once."""
    with suppress(AttributeError, OSError):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
