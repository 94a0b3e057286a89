# SPDX-License-Identifier: Apache-2.0
"""What is behind the path of a parameter file?"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.deployment.execution.rewrites import Rows
    from rosward.domain.unknown import Reason


class Content(NamedTuple):
    """What is behind a path. `rows` None: not known, `reason` says why, and `absent` whether there surely is no such file."""

    rows: Rows | None
    text: str | None = None
    file: str = ""
    reason: Reason | None = None
    absent: bool = False
