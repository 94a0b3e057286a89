# SPDX-License-Identifier: Apache-2.0
"""rclpy.service.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import create, message, reads_only, resolve_name, schedule, sends, stops

from rclpy.service_introspection import ServiceIntrospectionState

reads_only(__name__)


class Service:
    def __init__(self, service_impl, srv_type, srv_name, callback, callback_group, qos_profile):
        self._node = service_impl  # the node stands for the handle, which no program sees
        self.srv_type = srv_type
        self.srv_name = srv_name
        self._callback = callback
        self.callback_group = callback_group
        self.qos_profile = qos_profile

    @property
    def callback(self):
        return self._callback

    @callback.setter
    def callback(self, value):
        self._callback = value
        schedule(value, message(self.srv_type.Request, "request"), self.srv_type.Response(), event="request")

    @sends("response", "response", "_node", "srv_name", "srv_type.Response")
    def send_response(self, response, header) -> None: ...

    def configure_introspection(self, clock, service_event_qos_profile, introspection_state):
        if introspection_state != ServiceIntrospectionState.OFF:
            create(
                "service_server",  # of which the event publisher is recorded
                self._node,
                self.srv_name,
                self.srv_type,
                qos=service_event_qos_profile,
                introspection=True,
            )

    @property
    def handle(self): ...

    @property
    def service_name(self):
        return resolve_name(self._node, self.srv_name, "service")

    @property
    def logger_name(self) -> str: ...

    @stops
    def destroy(self) -> None: ...

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...
