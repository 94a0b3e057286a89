# SPDX-License-Identifier: Apache-2.0
"""ros2param.api: clients of the parameter services of another node.

Read from the branches humble (one client a call), iron, jazzy and rolling (`AsyncParameterClient`, which makes all six) of ros2cli.
"""
from _rosward import creator, native, reads_only, unknown
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters, SetParameters
from rclpy.parameter_client import AsyncParameterClient

@native
def _since(distro) -> bool:
    """Whether the analysis is for `distro` or a later one."""
@reads_only
def get_value(*, parameter_value): ...
@reads_only
def get_parameter_value(*, string_value): ...
@reads_only
def get_parameter_type_string(parameter_type) -> str: ...
@creator
def load_parameter_file(*, node, node_name, parameter_file, use_wildcard):
    return _call(node, node_name, SetParameters, 'set_parameters')
@creator
def load_parameter_dict(*, node, node_name, parameter_dict):
    return _call(node, node_name, SetParameters, 'set_parameters')
@creator
def call_describe_parameters(*, node, node_name, parameter_names=None):
    return _call(node, node_name, DescribeParameters, 'describe_parameters')
@creator
def call_get_parameters(*, node, node_name, parameter_names):
    return _call(node, node_name, GetParameters, 'get_parameters')
@creator
def call_set_parameters(*, node, node_name, parameters):
    return _call(node, node_name, SetParameters, 'set_parameters')
@creator
def call_list_parameters(*, node, node_name, prefix=None, prefixes=None):
    return _call(node, node_name, ListParameters, 'list_parameters')
def _call(node, name, type_, service):
    if _since('iron'):
        AsyncParameterClient(node, name)
    else:
        node.create_client(type_, f'{name}/{service}')
    return unknown('message', f'answer of {service}')
