# SPDX-License-Identifier: Apache-2.0
"""rclpy.logging_service: made by a node with enable_logger_service (a row of the table of implicit entities).

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import raises_nothing

from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

from rclpy.qos import qos_profile_services_default

raises_nothing(__name__)


class LoggingService:
    def __init__(self, node):
        name = node.get_name()
        qos = qos_profile_services_default
        node.create_service(GetLoggerLevels, f"{name}/get_logger_levels", self._get_logger_levels, qos_profile=qos)
        node.create_service(SetLoggerLevels, f"{name}/set_logger_levels", self._set_logger_levels, qos_profile=qos)

    def _get_logger_levels(self, request, response):
        return response

    def _set_logger_levels(self, request, response):
        return response
