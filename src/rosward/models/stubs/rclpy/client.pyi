# SPDX-License-Identifier: Apache-2.0
"""rclpy.client: what a service client can do; `call*` answer with an unknown response of its type.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import create, either, message, reads_only, resolve_name, sends, waits

from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.task import Future

reads_only(__name__)


class Client:
    def __init__(self, context, client_impl, srv_type, srv_name, qos_profile, callback_group):
        self._node = client_impl  # the node stands for the handle, which no program sees
        self.context = context
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.qos_profile = qos_profile
        self.callback_group = callback_group

    @waits
    @sends("request", "request", "_node", "srv_name", "srv_type.Request")
    def call(self, request, timeout_sec=None):
        return message(self.srv_type.Response, "response")

    @sends("request", "request", "_node", "srv_name", "srv_type.Request")
    def call_async(self, request):
        future = Future()
        future._result = either(None, message(self.srv_type.Response, "response"))
        return future

    def get_pending_request(self, sequence_number) -> Future: ...
    def remove_pending_request(self, future) -> None: ...
    @waits
    def service_is_ready(self) -> bool: ...
    @waits
    def wait_for_service(self, timeout_sec=None) -> bool: ...

    def configure_introspection(self, clock, service_event_qos_profile, introspection_state):
        if introspection_state != ServiceIntrospectionState.OFF:
            create(
                "service_client",  # of which the event publisher is recorded
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

    def destroy(self) -> None: ...

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...
