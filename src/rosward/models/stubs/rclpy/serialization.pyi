# SPDX-License-Identifier: Apache-2.0
"""rclpy.serialization.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import message as _message, reads_only

reads_only(__name__)


def serialize_message(message) -> bytes: ...


def deserialize_message(serialized_message, message_type):
    return _message(message_type, "serialized message")
