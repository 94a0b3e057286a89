# SPDX-License-Identifier: Apache-2.0
"""Stands in for diagnostic_updater: its publisher, its two parameters and its timer."""
# mypy: ignore-errors

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus


class Status:
    """What a task fills in."""

    def __init__(self, name: str, hardware_id: str) -> None:
        self.told = DiagnosticStatus(name=name, hardware_id=hardware_id)

    def summary(self, level: bytes, text: str) -> None:
        """Say how it is."""
        self.told.level, self.told.message = level, text

    def add(self, key: str, value: str) -> None:
        """Say more."""
        self.told.values.append((key, value))


class Updater:
    """Runs its tasks when its timer fires, and publishes what they say."""

    def __init__(self, node: Any, period: float = 1.0) -> None:
        self._publisher = node.create_publisher(DiagnosticArray, "/diagnostics", 1)
        self._tasks: list[tuple[str, Callable[[Status], Status]]] = []
        self._hardware_id = ""
        node.create_timer(node.declare_parameter("diagnostic_updater.period", period).value, self._update)
        node.declare_parameter("diagnostic_updater.use_fqn", False)

    def setHardwareID(self, hardware_id: str) -> None:  # noqa: N802
        """Name the hardware."""
        self._hardware_id = hardware_id

    def add(self, name: str, task: Callable[[Status], Status]) -> None:
        """Add a task."""
        self._tasks.append((name, task))

    def _update(self) -> None:
        told = [task(Status(name, self._hardware_id)).told for name, task in self._tasks]
        self._publisher.publish(DiagnosticArray(status=told))
