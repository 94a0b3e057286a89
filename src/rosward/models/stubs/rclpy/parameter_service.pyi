# SPDX-License-Identifier: Apache-2.0
"""rclpy.parameter_service: made by every node (rows of the table of implicit entities).

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import ask, message, unknown
from rcl_interfaces.msg import SetParametersResult
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameters


class ParameterService:
    def __init__(self, node):
        self._node = node
        name = node.get_name()
        qos = qos_profile_parameters
        node.create_service(
            DescribeParameters, f"{name}/describe_parameters", self._describe_parameters_callback, qos_profile=qos
        )
        node.create_service(GetParameters, f"{name}/get_parameters", self._get_parameters_callback, qos_profile=qos)
        node.create_service(
            GetParameterTypes, f"{name}/get_parameter_types", self._get_parameter_types_callback, qos_profile=qos
        )
        node.create_service(ListParameters, f"{name}/list_parameters", self._list_parameters_callback, qos_profile=qos)
        node.create_service(SetParameters, f"{name}/set_parameters", self._set_parameters_callback, qos_profile=qos)
        node.create_service(
            SetParametersAtomically,
            f"{name}/set_parameters_atomically",
            self._set_parameters_atomically_callback,
            qos_profile=qos,
        )

    # Who asks may name any parameters. What the node itself would answer changes nothing.

    def _describe_parameters_callback(self, request, response):
        ask(self._node, "describe_parameter", _name())
        ask(self._node, "describe_parameters", [])
        return response

    def _get_parameters_callback(self, request, response):
        ask(self._node, "get_parameter", _name())
        ask(self._node, "get_parameters", [])
        return response

    def _get_parameter_types_callback(self, request, response):
        ask(self._node, "get_parameter_type", _name())
        ask(self._node, "get_parameter_types", [])
        return response

    def _list_parameters_callback(self, request, response):
        ask(self._node, "list_parameters", request.prefixes, request.depth)
        return response

    def _set_parameters_callback(self, request, response):
        ask(self._node, "set_parameters_atomically", [_parameter()])
        return response

    def _set_parameters_atomically_callback(self, request, response):
        ask(self._node, "set_parameters_atomically", [_parameter() for _ in request.parameters])
        return response


def _name():
    return unknown("message", "name of a parameter", "str")


def _parameter():
    return Parameter(_name(), None, unknown("message", "value of a parameter"))
