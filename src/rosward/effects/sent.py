# SPDX-License-Identifier: Apache-2.0
"""What a process sends: messages, requests, responses, goals and their cancelling, feedback, results, each with the value and the call."""

from __future__ import annotations

from typing import Literal

from rosward.domain.values import Value
from rosward.location import Place
from rosward.records import NamedTuple

Sending = Literal["publication", "request", "response", "goal", "cancel", "feedback", "result"]


class SentEffect(NamedTuple):
    """Something is sent: by the entity of that name and type on `node`, at `place` (by the library function `via`).

    `name` and `type` are those with which the entity was created (`EntityEffect`); a `value` on the heap holds what is sent.
    """

    kind: Sending
    node: Value
    name: Value
    type: Value
    value: Value
    place: Place
    via: str | None
