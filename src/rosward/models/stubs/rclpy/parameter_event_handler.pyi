# SPDX-License-Identifier: Apache-2.0
"""rclpy.parameter_event_handler (jazzy and later): a subscription to /parameter_events.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import pure, reads_only, schedule
from rcl_interfaces.msg import Parameter as ParameterMsg, ParameterEvent

from rclpy.qos import qos_profile_parameter_events


@pure
def _parameter_in(event) -> ParameterMsg: ...


class ParameterCallbackHandle:
    def __init__(self, parameter_name, node_name, callback):
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    def __init__(self, callback):
        self.callback = callback


@reads_only
class ParameterEventHandler:
    def __init__(
        self,
        node,
        qos_profile=qos_profile_parameter_events,
        callback_group=None,
        event_callbacks=None,
        qos_overriding_options=None,
        raw=False,
    ):
        self.node = node
        self.qos_profile = qos_profile
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            None,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )

    def destroy(self):
        self.node.destroy_subscription(self.parameter_event_subscription)

    @staticmethod
    def get_parameter_from_event(event, parameter_name, node_name) -> ParameterMsg | None: ...

    @staticmethod
    def get_parameters_from_event(event): ...

    def add_parameter_callback(self, parameter_name, node_name, callback):
        schedule(callback, _parameter_in(self.parameter_event_subscription._taken()), event="parameters")
        return ParameterCallbackHandle(parameter_name, node_name, callback)

    def remove_parameter_callback(self, handle) -> None: ...

    def add_parameter_event_callback(self, callback):
        schedule(callback, self.parameter_event_subscription._taken(), event="parameters")
        return ParameterEventCallbackHandle(callback)

    def remove_parameter_event_callback(self, handle) -> None: ...
