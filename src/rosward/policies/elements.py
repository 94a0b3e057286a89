# SPDX-License-Identifier: Apache-2.0
"""What does a policy of SROS2 call the right to have an endpoint of a kind?

EntityKind.SERVICE_SERVER   ->  <services reply="ALLOW"><service>…</service></services>
"""

from __future__ import annotations

from typing import Final

from rosward.records import NamedTuple
from rosward.ros.entities import EntityKind

__all__ = ["ELEMENTS", "Words"]


class Words(NamedTuple):
    """The element, its attribute, and the element of one name in it."""

    outer: str
    verb: str
    inner: str


ELEMENTS: Final = {
    EntityKind.ACTION_CLIENT: Words("actions", "call", "action"),
    EntityKind.ACTION_SERVER: Words("actions", "execute", "action"),
    EntityKind.SERVICE_SERVER: Words("services", "reply", "service"),
    EntityKind.SERVICE_CLIENT: Words("services", "request", "service"),
    EntityKind.PUBLISHER: Words("topics", "publish", "topic"),
    EntityKind.SUBSCRIPTION: Words("topics", "subscribe", "topic"),
}
"""In the order of a policy."""
