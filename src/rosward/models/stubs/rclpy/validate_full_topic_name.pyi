# SPDX-License-Identifier: Apache-2.0
"""rclpy.validate_full_topic_name.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import refused

from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException

TOPIC_SEPARATOR_STRING = "/"


def validate_full_topic_name(name, *, is_service=False):
    why = refused(name, "full")
    if why:
        raise (InvalidServiceNameException if is_service else InvalidTopicNameException)(name, why, 0)
    return True
