# SPDX-License-Identifier: Apache-2.0
"""rclpy.lifecycle.publisher.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import reads_only, sends

from rclpy.lifecycle.managed_entity import SimpleManagedEntity
from rclpy.publisher import Publisher

reads_only(__name__)


class LifecyclePublisher(SimpleManagedEntity, Publisher):
    def __init__(self, *args, **kwargs):
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)

    @sends("publication", "msg", "_node", "topic", "msg_type")
    def publish(self, msg) -> None: ...
