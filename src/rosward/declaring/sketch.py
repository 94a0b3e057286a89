# SPDX-License-Identifier: Apache-2.0
"""What is known of a program before a person has looked at it.

Sketch("lidar", entities=(SeenEndpoint("publishers", "scan", "sensor_msgs/msg/LaserScan"),), open="…")
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from rosward.records import NamedTuple
from rosward.ros.entities import Qos

__all__ = ["SeenEndpoint", "Sketch", "is_usable", "together"]

_NAME: Final = re.compile(r"(?:/|~/)?[A-Za-z_]\w*(?:/[A-Za-z_]\w*)*", re.ASCII)
_TYPE: Final = re.compile(r"[A-Za-z]\w*/(msg|srv|action)/[A-Z]\w*", re.ASCII)


class SeenEndpoint(NamedTuple):
    """One endpoint. `kind` is the list of a declaration that it belongs in; `at` says where it was seen."""

    kind: str
    name: str
    type: str
    qos: Qos | None = None
    at: str = ""


class Sketch(NamedTuple):
    """What goes into a declaration. `told` are remarks for who completes it; `open` is why it may not be everything."""

    node: str | None = None
    lifecycle: bool = False
    client_library: str = "rclcpp"
    entities: tuple[SeenEndpoint, ...] = ()
    parameters: tuple[tuple[str, str], ...] = ()
    told: tuple[str, ...] = ()
    open: str = ""


def is_usable(seen: SeenEndpoint) -> bool:
    """Whether a declaration can hold it: a name of ROS, and a type of the kind of the endpoint."""
    part = (
        "msg" if seen.kind in ("publishers", "subscriptions") else seen.kind.partition("_")[0].replace("service", "srv")
    )
    found = _TYPE.fullmatch(seen.type)
    fits = found is not None and (
        found[1] == part or (part == "msg" and seen.type.endswith(("_Event", "_FeedbackMessage")))
    )
    return fits and len(seen.name) < 256 and _NAME.fullmatch(seen.name) is not None


def together(sketches: Sequence[Sketch]) -> Sketch:
    """One sketch of several: what any of them says, each endpoint once; names and types of the first that has them."""
    entities: dict[tuple[str, str], SeenEndpoint] = {}
    for each in sketches:
        for seen in each.entities:
            entities.setdefault((seen.kind, seen.name), seen)
    return Sketch(
        node=next((s.node for s in sketches if s.node is not None), None),
        lifecycle=any(s.lifecycle for s in sketches),
        client_library=next((s.client_library for s in sketches), "rclcpp"),
        entities=tuple(entities.values()),
        parameters=tuple({name: (name, type_) for s in reversed(sketches) for name, type_ in s.parameters}.values()),
        told=tuple(dict.fromkeys(text for s in sketches for text in s.told)),
        open="; ".join(dict.fromkeys(s.open for s in sketches if s.open)),
    )
