# SPDX-License-Identifier: Apache-2.0
"""py_trees_ros.utilities.

Read from splintered-reality/py_trees_ros, branch devel (2023-04, 2.3).
"""

from _rosward import resolve_name as _resolve_name
from py_trees_ros_interfaces.srv import IntrospectPublishers, IntrospectServices, IntrospectSubscribers
from rclpy.qos import QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy


def qos_profile_latched():
    return QoSProfile(
        history=QoSHistoryPolicy.KEEP_LAST,
        depth=1,
        durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
        reliability=QoSReliabilityPolicy.RELIABLE,
    )


def qos_profile_unlatched():
    return QoSProfile(
        history=QoSHistoryPolicy.KEEP_LAST,
        depth=1,
        durability=QoSDurabilityPolicy.VOLATILE,
        reliability=QoSReliabilityPolicy.RELIABLE,
    )


def resolve_name(node, name):
    return _resolve_name(node, name, "topic")


class Publishers:
    def __init__(self, node, publisher_details, introspection_topic_name="publishers"):
        for name, topic_name, publisher_type, latched in publisher_details:
            qos = qos_profile_latched() if latched else qos_profile_unlatched()
            setattr(self, name, node.create_publisher(msg_type=publisher_type, topic=topic_name, qos_profile=qos))
        self.introspection_service = node.create_service(
            IntrospectPublishers, "~/introspection/" + introspection_topic_name, self.introspection_callback
        )

    def introspection_callback(self, unused_request, response):
        return response


class Subscribers:
    def __init__(self, node, subscriber_details, introspection_topic_name="subscribers"):
        for name, topic_name, subscriber_type, latched, callback in subscriber_details:
            qos = qos_profile_latched() if latched else qos_profile_unlatched()
            subscription = node.create_subscription(
                msg_type=subscriber_type, topic=topic_name, callback=callback, qos_profile=qos
            )
            setattr(self, name, subscription)
        self.introspection_service = node.create_service(
            IntrospectSubscribers, "~/introspection/" + introspection_topic_name, self.introspection_callback
        )

    def introspection_callback(self, unused_request, response):
        return response


class Services:
    def __init__(self, node, service_details, introspection_topic_name="services"):
        for name, service_name, service_type, callback in service_details:
            setattr(self, name, node.create_service(srv_type=service_type, srv_name=service_name, callback=callback))
        self.introspection_service = node.create_service(
            IntrospectServices, "~/introspection/" + introspection_topic_name, self.introspection_callback
        )

    def introspection_callback(self, unused_request, response):
        return response
