# SPDX-License-Identifier: Apache-2.0
"""rclpy.wait_for_message: a subscription for a while. `time_to_wait` is positional up to iron, by keyword later.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import creator, either


@creator
def wait_for_message(msg_type, node, topic, time_to_wait=-1, *, qos_profile=1):
    subscription = node.create_subscription(msg_type, topic, None, qos_profile=qos_profile)
    found = subscription._taken()
    node.destroy_subscription(subscription)
    return either((True, found), (False, None))
