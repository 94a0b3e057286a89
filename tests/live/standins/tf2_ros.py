# SPDX-License-Identifier: Apache-2.0
"""Stands in for tf2_ros: the publishers and subscriptions of /tf and /tf_static. tf2_msgs/msg/TFMessage is test_msgs/msg/Nested."""
# mypy: ignore-errors

from __future__ import annotations

from typing import Any, Final

from geometry_msgs.msg import TransformStamped
from rclpy.qos import DurabilityPolicy, QoSProfile
from test_msgs.msg import Nested

_LATCHED: Final = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class TransformException(Exception):  # noqa: N818
    """A transform is not known."""


class Buffer:
    """Knows every transform: there is none."""

    def lookup_transform(self, _target: str, _source: str, _time: Any) -> Any:
        """Where one frame is in another."""
        return TransformStamped()


class TransformListener:
    """Hears of transforms."""

    def __init__(self, _buffer: Buffer, node: Any) -> None:
        node.create_subscription(Nested, "/tf", self._on_transforms, 100)
        node.create_subscription(Nested, "/tf_static", self._on_transforms, _LATCHED)

    def _on_transforms(self, _transforms: Any) -> None:
        """Nothing is kept."""


class TransformBroadcaster:
    """Tells of transforms that change."""

    def __init__(self, node: Any) -> None:
        self._publisher = node.create_publisher(Nested, "/tf", 100)

    def sendTransform(self, _transform: Any) -> None:  # noqa: N802
        """Tell of a transform."""
        self._publisher.publish(Nested())


class StaticTransformBroadcaster:
    """Tells of transforms that never change."""

    def __init__(self, node: Any) -> None:
        self._publisher = node.create_publisher(Nested, "/tf_static", _LATCHED)

    def sendTransform(self, _transforms: Any) -> None:  # noqa: N802
        """Tell of transforms."""
        self._publisher.publish(Nested())
