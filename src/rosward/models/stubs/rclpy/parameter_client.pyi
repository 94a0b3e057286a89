# SPDX-License-Identifier: Apache-2.0
"""rclpy.parameter_client (iron and later): six clients under the name of the remote node, in the namespace of the calling one.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import changes, reads_only, waits

from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

from rclpy.qos import qos_profile_parameter_events, qos_profile_services_default


class AsyncParameterClient:
    def __init__(self, node, remote_node_name, qos_profile=qos_profile_services_default, callback_group=None):
        self.remote_node_name = remote_node_name
        self.node = node
        self._get_parameter_client = node.create_client(
            GetParameters, f"{remote_node_name}/get_parameters", qos_profile=qos_profile, callback_group=callback_group
        )
        self._list_parameter_client = node.create_client(
            ListParameters, f"{remote_node_name}/list_parameters", qos_profile=qos_profile, callback_group=callback_group
        )
        self._set_parameter_client = node.create_client(
            SetParameters, f"{remote_node_name}/set_parameters", qos_profile=qos_profile, callback_group=callback_group
        )
        self._get_parameter_types_client = node.create_client(
            GetParameterTypes,
            f"{remote_node_name}/get_parameter_types",
            qos_profile=qos_profile,
            callback_group=callback_group,
        )
        self._describe_parameters_client = node.create_client(
            DescribeParameters,
            f"{remote_node_name}/describe_parameters",
            qos_profile=qos_profile,
            callback_group=callback_group,
        )
        self._set_parameters_atomically_client = node.create_client(
            SetParametersAtomically,
            f"{remote_node_name}/set_parameters_atomically",
            qos_profile=qos_profile,
            callback_group=callback_group,
        )

    @reads_only
    def services_are_ready(self) -> bool: ...
    @waits
    @reads_only
    def wait_for_services(self, timeout_sec=None) -> bool: ...

    def list_parameters(self, prefixes=None, depth=None, callback=None):
        return _ask(self._list_parameter_client, (prefixes, depth,), callback)

    def get_parameters(self, names, callback=None):
        return _ask(self._get_parameter_client, (names,), callback)

    def set_parameters(self, parameters, callback=None):
        return _ask(self._set_parameter_client, (parameters,), callback)

    def describe_parameters(self, names, callback=None):
        return _ask(self._describe_parameters_client, (names,), callback)

    def get_parameter_types(self, names, callback=None):
        return _ask(self._get_parameter_types_client, (names,), callback)

    def set_parameters_atomically(self, parameters, callback=None):
        return _ask(self._set_parameters_atomically_client, (parameters,), callback)

    def delete_parameters(self, names, callback=None):
        return _ask(self._set_parameter_client, (names,), callback)

    def load_parameter_file(self, parameter_file, use_wildcard=False, callback=None):
        return _ask(self._set_parameter_client, (parameter_file, use_wildcard,), callback)

    def load_parameter_file_atomically(self, parameter_file, use_wildcard=False, callback=None):
        return _ask(self._set_parameters_atomically_client, (parameter_file, use_wildcard,), callback)

    def on_parameter_event(
        self,
        callback,
        qos_profile=qos_profile_parameter_events,
        *,
        callback_group=None,
        event_callbacks=None,
        qos_overriding_options=None,
        raw=False,
    ):
        return self.node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )


@changes("request")
def _fill(request, content) -> None: ...


def _ask(client, content, callback):
    request = client.srv_type.Request()
    _fill(request, content)
    future = client.call_async(request)
    if callback is not None:
        future.add_done_callback(callback)
    return future
