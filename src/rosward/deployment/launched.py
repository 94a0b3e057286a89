# SPDX-License-Identifier: Apache-2.0
"""One program of a process that a launch file starts, and which of the ways of analysing it is taken."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.deployment.declared.shapes import Program
    from rosward.deployment.started import Started
    from rosward.effects.configuration import Configuration
    from rosward.effects.entry import Entry


class Launched(NamedTuple):
    """One program of a process. Exactly one of `entry` (interpreted), `program` (declared) and `unknown` (why its interface is not known) is set.

    `process` is what the programs of one process share: a component's is that of its container. `cause` is what several that are unknown
    may have in common.
    """

    process: str
    package: str | None
    executable: str | None
    started: Started
    configuration: Configuration
    conditional: bool
    entry: Entry | None = None
    program: Program | None = None
    unknown: str | None = None
    cause: str = ""
