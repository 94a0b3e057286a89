# SPDX-License-Identifier: Apache-2.0
"""rclpy.lifecycle.node: every transition may happen at any time.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import ask, creator, schedule, unknown

from rclpy.lifecycle.managed_entity import ManagedEntity as ManagedEntity
from rclpy.lifecycle.managed_entity import TransitionCallbackReturn as TransitionCallbackReturn
from rclpy.lifecycle.publisher import LifecyclePublisher as LifecyclePublisher
from rclpy.node import Node as Node


class LifecycleState:
    def __init__(self, label, state_id):
        self.label = label
        self.state_id = state_id


class LifecycleNodeMixin(ManagedEntity):
    _rosward_hidden = ("_managed_entities", "_state_machine", "_callbacks")
    _rosward_lifecycle = True

    def __init__(self, *, enable_communication_interface=True, callback_group=None):
        self._managed_entities = []
        ask(self, "get_logger")
        if enable_communication_interface:  # without it, only the node itself triggers transitions
            schedule(self.on_configure, LifecycleState("unconfigured", 1), event="transition")
            schedule(self.on_cleanup, LifecycleState("inactive", 2), event="transition")
            schedule(self.on_shutdown, _some_state(), event="transition")
            schedule(self.on_activate, LifecycleState("inactive", 2), event="transition")
            schedule(self.on_deactivate, LifecycleState("active", 3), event="transition")
        schedule(self.on_error, _some_state(), event="transition")

    def trigger_configure(self):
        return self.on_configure(LifecycleState("unconfigured", 1))

    def trigger_cleanup(self):
        return self.on_cleanup(LifecycleState("inactive", 2))

    def trigger_shutdown(self):
        return self.on_shutdown(_some_state())

    def trigger_activate(self):
        return self.on_activate(LifecycleState("inactive", 2))

    def trigger_deactivate(self):
        return self.on_deactivate(LifecycleState("active", 3))

    def add_managed_entity(self, entity):
        self._managed_entities.append(entity)

    def on_configure(self, state):
        for entity in self._managed_entities:
            entity.on_configure(state)
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state):
        for entity in self._managed_entities:
            entity.on_cleanup(state)
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state):
        for entity in self._managed_entities:
            entity.on_shutdown(state)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        for entity in self._managed_entities:
            entity.on_activate(state)
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state):
        for entity in self._managed_entities:
            entity.on_deactivate(state)
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state):
        for entity in self._managed_entities:
            entity.on_error(state)
        return TransitionCallbackReturn.SUCCESS

    @creator
    def create_lifecycle_publisher(self, msg_type, topic, qos_profile, *, publisher_class=None, **kwargs):
        publisher = Node.create_publisher(
            self, msg_type, topic, qos_profile, publisher_class=LifecyclePublisher, **kwargs
        )
        self._managed_entities.append(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher):
        if publisher in self._managed_entities:
            self._managed_entities.remove(publisher)
        return Node.destroy_publisher(self, publisher)


def _some_state():
    return LifecycleState(unknown("live", "state of the node"), unknown("live", "state of the node"))


class LifecycleNode(LifecycleNodeMixin, Node):
    _rosward_hidden = ()

    def __init__(self, node_name, *, enable_communication_interface=True, **kwargs):
        self._rosward_lifecycle_services = enable_communication_interface
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(self, enable_communication_interface=enable_communication_interface)
