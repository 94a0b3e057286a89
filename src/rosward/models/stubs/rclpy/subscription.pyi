# SPDX-License-Identifier: Apache-2.0
"""rclpy.subscription.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from enum import Enum

from _rosward import message, reads_only, resolve_name, schedule, stops

from rclpy.subscription_content_filter_options import ContentFilterOptions

reads_only(__name__)


class MessageInfo: ...


class Subscription:
    class CallbackType(Enum):
        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self, subscription_impl, msg_type, topic, callback, callback_group, qos_profile, raw, event_callbacks
    ):
        self._node = subscription_impl  # the node stands for the handle, which no program sees
        self._callback = callback
        self.msg_type = msg_type
        self.topic = topic
        self.callback_group = callback_group
        self.qos_profile = qos_profile
        self.raw = raw

    def _taken(self):
        return message(self.msg_type, "message")

    def get_publisher_count(self) -> int: ...

    @property
    def handle(self): ...

    @stops
    def destroy(self) -> None: ...

    @property
    def topic_name(self):
        return resolve_name(self._node, self.topic, "topic")

    @property
    def callback(self):
        return self._callback

    @callback.setter
    def callback(self, value):
        self._callback = value
        schedule(value, self._taken(), event="message")

    @property
    def logger_name(self) -> str: ...

    @property
    def is_cft_enabled(self) -> bool: ...

    def set_content_filter(self, filter_expression, expression_parameters) -> None: ...
    def get_content_filter(self) -> ContentFilterOptions: ...

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...
