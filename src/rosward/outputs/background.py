# SPDX-License-Identifier: Apache-2.0
"""What does the report tell beside the network? Light to import, for who hands it on and may never write a report."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from rosward.enclaves.grants import NOT_WIDENED
from rosward.enclaves.widened import Widenings
from rosward.findings import Finding
from rosward.network.launch_tree import LaunchSystem
from rosward.records import NamedTuple

__all__ = ["Background"]


class Background(NamedTuple):
    """What the report tells beyond the network: the sources below `root`, and what launch files start.

    `loose` are the loose ends to tell, for who has taken away what is to be ignored; without it, the report tells all. `widened` are patterns
    that the policies have in place of names. `flow`: the analysis followed what flows where, and the report shows it.
    """

    root: Path | None = None
    systems: tuple[LaunchSystem, ...] = ()
    loose: Sequence[Finding] | None = None
    widened: Widenings = NOT_WIDENED
    flow: bool = False
