# SPDX-License-Identifier: Apache-2.0
"""What flows through one process: each of its sinks, and the sources that stand in it."""

from __future__ import annotations

from typing import NamedTuple

from rosward.flow.marks import Source
from rosward.flow.sinks import Sink


class Flow(NamedTuple):
    """One sink of a process: what is in it, what decides it, what it waits for; `complete`: no limit was reached."""

    sink: Sink
    data: frozenset[Source]
    control: frozenset[Source]
    trigger: frozenset[Source]


class ProcessFlows(NamedTuple):
    """All sinks of a process."""

    flows: tuple[Flow, ...] = ()
    complete: bool = True
