# SPDX-License-Identifier: Apache-2.0
"""rclpy.type_description_service (iron and later): made by every node (a row of the table of implicit entities).

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import ask, reads_only
from rcl_interfaces.msg import ParameterDescriptor, ParameterType

reads_only(__name__)

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"


class TypeDescriptionService:
    def __init__(self, node):
        ask(node, "get_name")
        if not node.has_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM):
            descriptor = ParameterDescriptor(
                name=START_TYPE_DESCRIPTION_SERVICE_PARAM, type=ParameterType.PARAMETER_BOOL, read_only=True
            )
            node.declare_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM, True, descriptor)
        node.get_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM)
        ask(node, "get_logger")

    def destroy(self) -> None: ...
