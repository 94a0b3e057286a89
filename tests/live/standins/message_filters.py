# SPDX-License-Identifier: Apache-2.0
"""Stands in for message_filters: a subscription for each input, one call for a message of each."""
# mypy: ignore-errors

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any


class Subscriber:
    """One input."""

    def __init__(self, node: Any, msg_type: type, topic: str, *, qos_profile: Any = 10) -> None:
        self.callbacks: list[Callable[[Any], None]] = []
        self.subscription = node.create_subscription(msg_type, topic, self._on_message, qos_profile)

    def _on_message(self, message: Any) -> None:
        for callback in self.callbacks:
            callback(message)


class ApproximateTimeSynchronizer:
    """Takes whatever came last of each input, whenever it was."""

    def __init__(self, inputs: Sequence[Subscriber], queue_size: int, slop: float) -> None:
        del queue_size, slop
        self._callbacks: list[Callable[..., None]] = []
        self._last: dict[int, Any] = {}
        self._inputs = len(inputs)
        for number, each in enumerate(inputs):
            each.callbacks.append(lambda message, number=number: self._on_message(number, message))

    def registerCallback(self, callback: Callable[..., None]) -> None:  # noqa: N802
        """Call this with a message of each input."""
        self._callbacks.append(callback)

    def _on_message(self, number: int, message: Any) -> None:
        self._last[number] = message
        if len(self._last) == self._inputs:
            for callback in self._callbacks:
                callback(*(self._last[n] for n in range(self._inputs)))
