# SPDX-License-Identifier: Apache-2.0
"""rclpy.validate_parameter_name.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from rclpy.exceptions import InvalidParameterException


def validate_parameter_name(name):
    if not name:
        raise InvalidParameterException(name)
    return True
