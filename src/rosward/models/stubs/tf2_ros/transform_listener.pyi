# SPDX-License-Identifier: Apache-2.0
"""tf2_ros.transform_listener: subscribes to /tf and /tf_static on the node that it is given (no node of its own, unlike in C++).

Read from ros2/geometry2, branches humble (2024-08), iron (2024-08), jazzy (2024-10) and rolling (2024-10).
"""

from _rosward import creator, reads_only

from threading import Thread

from rclpy.executors import SingleThreadedExecutor as SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy as DurabilityPolicy, HistoryPolicy as HistoryPolicy, QoSProfile as QoSProfile
from tf2_msgs.msg import TFMessage

reads_only(__name__)

DEFAULT_TF_TOPIC = "/tf"
DEFAULT_STATIC_TF_TOPIC = "/tf_static"


@creator
class TransformListener:
    def __init__(
        self,
        buffer,
        node,
        *,
        spin_thread=False,
        qos=None,
        static_qos=None,
        tf_topic=DEFAULT_TF_TOPIC,
        tf_static_topic=DEFAULT_STATIC_TF_TOPIC,
    ):
        if qos is None:
            qos = QoSProfile(depth=100, durability=DurabilityPolicy.VOLATILE, history=HistoryPolicy.KEEP_LAST)
        if static_qos is None:
            static_qos = QoSProfile(
                depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST
            )
        self.buffer = buffer
        self.node = node
        self.tf_sub = node.create_subscription(TFMessage, tf_topic, self.callback, qos)
        self.tf_static_sub = node.create_subscription(TFMessage, tf_static_topic, self.static_callback, static_qos)
        if spin_thread:
            self.executor = SingleThreadedExecutor()
            self.executor.add_node(node)
            self.dedicated_listener_thread = Thread(target=self.executor.spin)
            self.dedicated_listener_thread.start()

    def unregister(self) -> None: ...
    def callback(self, data) -> None: ...
    def static_callback(self, data) -> None: ...
