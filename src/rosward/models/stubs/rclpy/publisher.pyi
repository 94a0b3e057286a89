# SPDX-License-Identifier: Apache-2.0
"""rclpy.publisher.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import reads_only, resolve_name, sends, waits

from rclpy.duration import Duration

reads_only(__name__)


class Publisher:
    def __init__(self, publisher_impl, msg_type, topic, qos_profile, event_callbacks, callback_group):
        self._node = publisher_impl  # the node stands for the handle, which no program sees
        self.msg_type = msg_type
        self.topic = topic
        self.qos_profile = qos_profile

    @sends("publication", "msg", "_node", "topic", "msg_type")
    def publish(self, msg) -> None: ...
    def get_subscription_count(self) -> int: ...

    @property
    def topic_name(self):
        return resolve_name(self._node, self.topic, "topic")

    @property
    def handle(self): ...

    @property
    def logger_name(self) -> str: ...

    def destroy(self) -> None: ...
    def assert_liveliness(self) -> None: ...
    @waits
    def wait_for_all_acked(self, timeout=Duration(seconds=-1)) -> bool: ...

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...
