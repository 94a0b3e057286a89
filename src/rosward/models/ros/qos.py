# SPDX-License-Identifier: Apache-2.0
"""What is known of a QoS profile?"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.values import Const, Ref, Value
from rosward.ros.entities import Qos

if TYPE_CHECKING:
    from rosward.models.native import Machine

_POLICIES: Final = ("reliability", "durability", "history")
_NUMBERS: Final = {
    "reliability": {0: "system_default", 1: "reliable", 2: "best_effort", 4: "best_available"},
    "durability": {0: "system_default", 1: "transient_local", 2: "volatile", 4: "best_available"},
    "history": {0: "system_default", 1: "keep_last", 2: "keep_all"},
}


def qos_of(machine: Machine, value: Value | None) -> tuple[Qos | None, bool]:
    """What is known of a QoS profile, and whether the topic keeps the prefix of the ROS name space."""
    if value is None:
        return None, True
    if value.__class__ is Const and isinstance(value.value, int) and not isinstance(value.value, bool):
        return Qos("reliable", "volatile", "keep_last", value.value), True
    if value.__class__ is not Ref or machine.obj(value).kind != "instance":
        return None, True
    words = [_policy(machine, name, _attr(machine, value, name)) for name in _POLICIES]
    depth = _attr(machine, value, "depth")
    known = depth.value if isinstance(depth, Const) and isinstance(depth.value, int) else None
    raw = _attr(machine, value, "avoid_ros_namespace_conventions")
    prefix = not (isinstance(raw, Const) and raw.value is True)
    return Qos(words[0], words[1], words[2], known), prefix


def _attr(machine: Machine, value: Ref, name: str) -> Value | None:
    attrs = machine.obj(value).attrs
    found = attrs.get(name, attrs.get(f"_{name}"))
    return found if found is not None else machine.load_attr(value, name)


def _policy(machine: Machine, name: str, value: Value | None) -> str | None:
    if isinstance(value, Const) and isinstance(value.value, int):
        return _NUMBERS[name].get(value.value)
    if isinstance(value, Ref):
        member = machine.obj(value).attrs
        for key in ("name", "_name_"):
            label = member.get(key)
            if isinstance(label, Const) and isinstance(label.value, str):
                return label.value.lower()
    return None
