# SPDX-License-Identifier: Apache-2.0
"""rclpy.validate_namespace.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import refused

from rclpy.exceptions import InvalidNamespaceException


def validate_namespace(namespace):
    why = refused(namespace, "namespace")
    if why:
        raise InvalidNamespaceException(namespace, why, 0)
    return True
