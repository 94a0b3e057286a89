# SPDX-License-Identifier: Apache-2.0
"""rclpy.qos_overriding_options: declares a parameter for each policy, named after the resolved topic.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import ask, schedule

from rcl_interfaces.msg import ParameterDescriptor

from rclpy.duration import Duration
from rclpy.qos import QoSPolicyEnum, QoSPolicyKind as QoSPolicyKind, QoSProfile as QoSProfile


class InvalidQosOverridesError(Exception): ...


class QoSOverridingOptions:
    def __init__(self, policy_kinds, *, callback=None, entity_id=None):
        self._policy_kinds = policy_kinds
        self._callback = callback
        self._entity_id = entity_id

    @property
    def policy_kinds(self):
        return self._policy_kinds

    @property
    def callback(self):
        return self._callback

    @property
    def entity_id(self):
        return self._entity_id

    @classmethod
    def with_default_policies(cls, *, callback=None, entity_id=None):
        return cls(
            policy_kinds=(QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY),
            callback=callback,
            entity_id=entity_id,
        )


def _declare_qos_parameters(entity_type, node, topic_name, qos, options):
    """Here `entity_type` is the word 'publisher' or 'subscription', and `qos` may be a depth."""
    profile = QoSProfile(depth=qos) if isinstance(qos, int) else qos
    suffix = "" if options.entity_id is None else f"_{options.entity_id}"
    for policy in options.policy_kinds:
        if policy == QoSPolicyKind.LIFESPAN and entity_type == "subscription":
            continue
        policy_name = policy.name.lower()
        value = getattr(profile, policy_name)
        if isinstance(value, QoSPolicyEnum):
            value = value.name.lower()
        elif isinstance(value, Duration):
            value = value.nanoseconds
        name = f"qos_overrides.{topic_name}.{entity_type}{suffix}.{policy_name}"
        node.declare_parameter(name, value, ParameterDescriptor(read_only=True))
        ask(node, "get_parameter", name)
    if options.callback is not None:
        schedule(options.callback, profile, event="qos override")
