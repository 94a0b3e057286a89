# SPDX-License-Identifier: Apache-2.0
"""rclpy.topic_endpoint_info.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from enum import IntEnum

from rclpy.qos import QoSPresetProfiles
from rclpy.type_hash import TypeHash


class TopicEndpointTypeEnum(IntEnum):
    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    def __init__(
        self,
        node_name="",
        node_namespace="",
        topic_type="",
        topic_type_hash=TypeHash(),
        endpoint_type=TopicEndpointTypeEnum.INVALID,
        endpoint_gid=[],
        qos_profile=QoSPresetProfiles.UNKNOWN.value,
    ):
        self.node_name = node_name
        self.node_namespace = node_namespace
        self.topic_type = topic_type
        self.topic_type_hash = topic_type_hash
        self.endpoint_type = endpoint_type
        self.endpoint_gid = endpoint_gid
        self.qos_profile = qos_profile
