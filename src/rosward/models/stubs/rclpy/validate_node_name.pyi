# SPDX-License-Identifier: Apache-2.0
"""rclpy.validate_node_name.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import refused

from rclpy.exceptions import InvalidNodeNameException


def validate_node_name(node_name):
    why = refused(node_name, "node")
    if why:
        raise InvalidNodeNameException(node_name, why, 0)
    return True
