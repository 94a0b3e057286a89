# SPDX-License-Identifier: Apache-2.0
"""rclpy.event_handler: callbacks for QoS events may run at any time.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from enum import IntEnum

from _rosward import calls, reads_only

from rclpy.waitable import Waitable

reads_only(__name__)


class QoSPublisherEventType(IntEnum):
    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(IntEnum):
    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


class QoSRequestedDeadlineMissedInfo: ...


class QoSLivelinessChangedInfo: ...


class QoSMessageLostInfo: ...


class QoSRequestedIncompatibleQoSInfo: ...


class QoSSubscriptionMatchedInfo: ...


class QoSOfferedDeadlineMissedInfo: ...


class QoSLivelinessLostInfo: ...


class QoSPublisherMatchedInfo: ...


class IncompatibleTypeInfo: ...


QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo


class UnsupportedEventTypeError(Exception): ...


class EventHandler(Waitable):
    @calls("callback", event="qos event", args=("unknown",))
    def __init__(self, *, callback_group, callback, event_type, parent_impl) -> None: ...
    def is_ready(self, wait_set) -> bool: ...
    def take_data(self): ...
    def execute(self, taken_data) -> None: ...
    def get_num_entities(self): ...
    def add_to_wait_set(self, wait_set) -> None: ...

    def __enter__(self):
        return self

    def __exit__(self, t, v, tb) -> None: ...
    def destroy(self) -> None: ...


class QoSEventHandler(EventHandler):
    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)


class SubscriptionEventCallbacks:
    @calls("deadline", event="qos event", args=("unknown",))
    @calls("incompatible_qos", event="qos event", args=("unknown",))
    @calls("liveliness", event="qos event", args=("unknown",))
    @calls("message_lost", event="qos event", args=("unknown",))
    @calls("incompatible_type", event="qos event", args=("unknown",))
    @calls("matched", event="qos event", args=("unknown",))
    def __init__(
        self,
        *,
        deadline=None,
        incompatible_qos=None,
        liveliness=None,
        message_lost=None,
        incompatible_type=None,
        matched=None,
        use_default_callbacks=True,
    ) -> None: ...
    def create_event_handlers(self, callback_group, subscription, topic_name) -> list: ...


class PublisherEventCallbacks:
    @calls("deadline", event="qos event", args=("unknown",))
    @calls("liveliness", event="qos event", args=("unknown",))
    @calls("incompatible_qos", event="qos event", args=("unknown",))
    @calls("incompatible_type", event="qos event", args=("unknown",))
    @calls("matched", event="qos event", args=("unknown",))
    def __init__(
        self,
        *,
        deadline=None,
        liveliness=None,
        incompatible_qos=None,
        incompatible_type=None,
        matched=None,
        use_default_callbacks=True,
    ) -> None: ...
    def create_event_handlers(self, callback_group, publisher, topic_name) -> list: ...
