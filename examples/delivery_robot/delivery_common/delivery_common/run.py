# SPDX-License-Identifier: Apache-2.0
"""How every executable of the robot starts and ends."""

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor


def run(node_class, executor_class=SingleThreadedExecutor, args=None):
    """Create a node and spin it until it is told to stop."""
    rclpy.init(args=args)
    node = node_class()
    executor = executor_class()
    executor.add_node(node)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        executor.shutdown()
        node.destroy_node()
        rclpy.try_shutdown()
