# SPDX-License-Identifier: Apache-2.0
"""Functions of the client library that compute a type or a name from text.

get_interface('std_msgs/msg/String')               std_msgs.msg.String
expand_topic_name('{node}/cmd', 'arm', '/left')    '/left/arm/cmd'
"""

from __future__ import annotations

from typing import Final

from rosward.domain.choice import lift
from rosward.domain.compound import External
from rosward.domain.unknown import Cause
from rosward.domain.values import Const, Value
from rosward.holes import literal
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import native, origins, spread, text_of, unknown_from
from rosward.ros import names
from rosward.source.definitions import PARTS


def _get_interface(call: NativeCall) -> Value:
    """The type of a constant text of three parts."""

    def one(value: Value) -> Value:
        parts = (text_of(value) or "").split("/")
        if len(parts) == 3 and parts[1] in PARTS:
            return External(".".join(parts))
        return call.machine.unknown(Cause.CALL, "interface type")

    return lift(one, call.args[0])


def _get_message(call: NativeCall) -> Value:
    """`get_message('pkg/msg/Name')`, and the same of services and actions: the type of a constant text, which may lack the middle part."""

    def one(value: Value) -> Value:
        parts = (text_of(value) or "").split("/")
        if len(parts) == 2:
            parts.insert(1, call.name.rpartition("_")[2].replace("message", "msg").replace("service", "srv"))
        return External(".".join(parts)) if len(parts) == 3 else call.machine.unknown(Cause.CALL, "interface type")

    return lift(one, call.args[0])


def _expand_topic_name(call: NativeCall) -> Value:
    """The absolute name, before remapping."""

    def one(topic: Value, node: Value, namespace: Value) -> Value:
        texts = [text_of(v) for v in (topic, node, namespace)]
        topic_text, node_text, space = texts
        if topic_text is None or node_text is None or space is None:
            return unknown_from(call.machine, call.name, "str", topic, node, namespace)
        try:
            return Const(
                names.expand(literal(topic_text), literal(node_text), literal(space)), origins(topic, node, namespace)
            )
        except names.InvalidName:
            return call.machine.unknown(Cause.ERROR, f"invalid name {topic_text}", "str")

    return spread(one, *call.args[:3])


NATIVES: Final[dict[str, NativeFunction]] = {
    "rosidl_runtime_py.utilities.get_interface": native(_get_interface, 1),
    "rosidl_runtime_py.utilities.get_message": _get_message,
    "rosidl_runtime_py.utilities.get_service": _get_message,
    "rosidl_runtime_py.utilities.get_action": _get_message,
    "rclpy.expand_topic_name.expand_topic_name": native(_expand_topic_name, 3),
}
